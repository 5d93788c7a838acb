#include "core/motion/trapezoid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

using namespace camwright;

namespace {

/// A fixed sequence of numbers, the same on every machine.
class Sequence {
public:
    explicit Sequence(std::uint64_t seed) : m_state(seed) {}
    double between(double low, double high)
    {
        m_state ^= m_state << 13;
        m_state ^= m_state >> 7;
        m_state ^= m_state << 17;
        return low + (high - low) * (static_cast<double>(m_state >> 11) / 9007199254740992.0);
    }
    /// Many magnitudes: each step doubles or leaves it.
    double scaled(double low, double high)
    {
        double value = low * between(1, 2);
        while (value * 2 < high && between(0, 1) < 0.85)
            value *= 2;
        return std::min(value, high);
    }

private:
    std::uint64_t m_state;
};

MotionLimits someLimits(Sequence& sequence)
{
    return {sequence.scaled(0.1, 1e6), sequence.scaled(0.5, 1e7), sequence.scaled(0.5, 1e7)};
}

constexpr double kSlack = 1 + 1e-9;

struct Watch {
    double previousPosition = 0;
    double previousVelocity = 0;

    /// One step of the motion; the velocity may fall from above the limit, never rise above it.
    void step(TrapezoidMotion& motion, Time span, const MotionLimits& limits, double allowedVelocity)
    {
        previousPosition = motion.position();
        previousVelocity = motion.velocity();
        motion.advance(span);
        const double dt = seconds(span);
        const double rate = std::max(limits.acceleration, limits.deceleration);
        ASSERT_LE(std::abs(motion.velocity()), allowedVelocity * kSlack);
        ASSERT_LE(std::abs(motion.acceleration()), rate * kSlack);
        ASSERT_LE(std::abs(motion.velocity() - previousVelocity), rate * dt * kSlack + 1e-9 * allowedVelocity);
        const double reach = std::max(std::abs(motion.velocity()), std::abs(previousVelocity)) * dt + rate * dt * dt;
        ASSERT_LE(std::abs(motion.position() - previousPosition), reach + 1e-9 * (1 + std::abs(motion.position())));
    }
};

double optimalFromRest(double distance, const MotionLimits& limits)
{
    const double a = limits.acceleration;
    const double d = limits.deceleration;
    const double peak = std::min(limits.velocity, std::sqrt(2 * distance * a * d / (a + d)));
    const double ramps = peak * peak / (2 * a) + peak * peak / (2 * d);
    return peak / a + peak / d + (distance - ramps) / peak;
}

} // namespace

TEST(TrapezoidTest, namesTheBadLimit)
{
    EXPECT_EQ(invalidLimit({1, 1, 1}), nullptr);
    EXPECT_STREQ(invalidLimit({0, 1, 1}), "velocity");
    EXPECT_STREQ(invalidLimit({1, -1, 1}), "acceleration");
    EXPECT_STREQ(invalidLimit({1, 1, std::nan("")}), "deceleration");
}

TEST(TrapezoidTest, movesByTheTextbook)
{
    TrapezoidMotion motion;
    motion.reset(10);
    motion.moveTo(40, {10, 5, 10});
    EXPECT_DOUBLE_EQ(motion.duration(), 2 + 1.5 + 1);
    motion.advance(2s);
    EXPECT_DOUBLE_EQ(motion.position(), 20);
    EXPECT_DOUBLE_EQ(motion.velocity(), 10);
    motion.advance(2s);
    EXPECT_DOUBLE_EQ(motion.position(), 38.75);
    EXPECT_DOUBLE_EQ(motion.velocity(), 5);
    EXPECT_DOUBLE_EQ(motion.acceleration(), -10);
    motion.advance(500ms);
    EXPECT_EQ(motion.position(), 40);
    EXPECT_FALSE(motion.isMoving());
}

TEST(TrapezoidTest, movesFromRestKeepLimitsEndAtTheTargetAndAreOptimal)
{
    Sequence sequence(2026);
    for (int i = 0; i < 2000; ++i) {
        const MotionLimits limits = someLimits(sequence);
        const double start = sequence.between(-1e5, 1e5);
        const double target = start + sequence.between(-1, 1) * sequence.scaled(0.01, 1e6);
        SCOPED_TRACE(testing::Message() << "case " << i << ": " << start << " to " << target << ", v " << limits.velocity << " a "
                                        << limits.acceleration << " d " << limits.deceleration);
        TrapezoidMotion motion;
        motion.reset(start);
        motion.moveTo(target, limits);
        const double optimum = optimalFromRest(std::abs(target - start), limits);
        ASSERT_NEAR(motion.duration(), optimum, 1e-6 * optimum + 1e-9);
        const Time span(static_cast<std::int64_t>(motion.duration() * 1e9 / 97) + 1);
        Watch watch;
        for (int step = 0; step < 98; ++step) {
            watch.step(motion, span, limits, limits.velocity);
            if (HasFatalFailure())
                return;
        }
        ASSERT_EQ(motion.position(), target);
        ASSERT_EQ(motion.velocity(), 0);
        ASSERT_FALSE(motion.isMoving());
    }
}

TEST(TrapezoidTest, newTargetsOnTheFlyKeepLimitsAndEndAtTheLastOne)
{
    Sequence sequence(7);
    for (int i = 0; i < 500; ++i) {
        MotionLimits limits = someLimits(sequence);
        TrapezoidMotion motion;
        motion.reset(0);
        const double reach = limits.velocity * limits.velocity / std::min(limits.acceleration, limits.deceleration) + 1;
        const Time span(static_cast<std::int64_t>(std::max(1e-6, reach / limits.velocity / 50) * 1e9));
        double target = 0;
        Watch watch;
        for (int command = 0; command < 8; ++command) {
            const double before = motion.velocity();
            const double position = motion.position();
            if (sequence.between(0, 1) < 0.3)
                limits.velocity *= sequence.between(0.5, 1.5);
            const double allowed = std::max(limits.velocity, std::abs(before));
            target = sequence.between(-3, 3) * reach;
            if (command == 3)
                motion.moveAt(sequence.between(-2, 2) * limits.velocity, limits);
            else if (command == 5)
                motion.stop(limits.deceleration);
            else
                motion.moveTo(target, limits);
            ASSERT_EQ(motion.velocity(), before);
            ASSERT_EQ(motion.position(), position);
            const int steps = static_cast<int>(sequence.between(1, 120));
            for (int step = 0; step < steps; ++step) {
                watch.step(motion, span, limits, allowed);
                if (HasFatalFailure()) {
                    ADD_FAILURE() << "case " << i << " command " << command << " v " << limits.velocity << " a " << limits.acceleration
                                  << " d " << limits.deceleration;
                    return;
                }
            }
        }
        motion.moveTo(target, limits);
        motion.advance(Time(static_cast<std::int64_t>(motion.duration() * 1e9) + 1));
        ASSERT_EQ(motion.position(), target) << "case " << i;
        ASSERT_FALSE(motion.isMoving());
    }
}

TEST(TrapezoidTest, theSameTargetAgainInEveryCycleChangesNothing)
{
    const MotionLimits limits{1000, 3000, 7000};
    TrapezoidMotion once;
    TrapezoidMotion often;
    once.reset(3);
    often.reset(3);
    once.moveTo(777.7, limits);
    const double duration = once.duration();
    double elapsed = 0;
    while (once.isMoving()) {
        often.moveTo(777.7, limits);
        once.advance(1ms);
        often.advance(1ms);
        elapsed += 1e-3;
        ASSERT_NEAR(once.position(), often.position(), 1e-6);
    }
    EXPECT_NEAR(elapsed, duration, 2e-3);
    EXPECT_EQ(often.position(), 777.7);
}

TEST(TrapezoidTest, velocityModeReversesThroughRest)
{
    TrapezoidMotion motion;
    motion.reset(0);
    motion.moveAt(10, {20, 10, 5});
    motion.advance(3s);
    EXPECT_EQ(motion.velocity(), 10);
    EXPECT_DOUBLE_EQ(motion.position(), 25);
    motion.moveAt(-10, {20, 10, 5});
    motion.advance(2s);
    EXPECT_DOUBLE_EQ(motion.velocity(), 0);
    motion.advance(1s);
    EXPECT_EQ(motion.velocity(), -10);
    EXPECT_TRUE(motion.profileDone());
    EXPECT_TRUE(motion.isMoving());
    motion.stop(100);
    motion.advance(100ms);
    EXPECT_EQ(motion.velocity(), 0);
    EXPECT_EQ(motion.position(), motion.restPosition());
    EXPECT_FALSE(motion.isMoving());
}

TEST(TrapezoidTest, velocityIsHeldToItsLimit)
{
    TrapezoidMotion motion;
    motion.reset(0);
    motion.moveAt(-1e9, {5, 10, 10});
    motion.advance(10s);
    EXPECT_EQ(motion.velocity(), -5);
}

TEST(TrapezoidTest, aTargetTooNearIsOvershotAndReached)
{
    TrapezoidMotion motion;
    motion.reset(0);
    motion.moveAt(10, {10, 10, 10});
    motion.advance(2s);
    const double start = motion.position();
    motion.moveTo(start + 1, {10, 10, 10});
    motion.advance(1s);
    EXPECT_NEAR(motion.position(), start + 5, 1e-9);
    EXPECT_NEAR(motion.velocity(), 0, 1e-9);
    motion.advance(10s);
    EXPECT_EQ(motion.position(), start + 1);
}

TEST(TrapezoidTest, restoredMotionGoesOnBitForBit)
{
    TrapezoidMotion motion;
    motion.reset(1.5);
    motion.moveTo(-400.25, {33, 77, 55});
    motion.advance(1234567us);
    ByteWriter writer;
    motion.save(writer);
    TrapezoidMotion other;
    ByteReader reader(writer.bytes());
    other.restore(reader);
    ASSERT_TRUE(reader.ok() && reader.atEnd());
    for (int i = 0; i < 2000; ++i) {
        motion.advance(10ms);
        other.advance(10ms);
        ASSERT_EQ(motion.position(), other.position());
        ASSERT_EQ(motion.velocity(), other.velocity());
    }
    EXPECT_EQ(other.position(), -400.25);
}

TEST(TrapezoidTest, brokenBytesAreRefused)
{
    TrapezoidMotion motion;
    const Bytes bytes(200, 0xFF);
    ByteReader reader(bytes);
    motion.restore(reader);
    EXPECT_FALSE(reader.ok());
    motion.advance(1s);
    EXPECT_EQ(motion.position(), 0);
}
