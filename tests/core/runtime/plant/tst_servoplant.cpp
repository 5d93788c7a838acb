#include "core/runtime/plant/servoplant.h"

#include "core/motion/trapezoid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace camwright;

namespace {

/// Follows a move and gives the largest following error.
double worstError(ServoPlant& plant, const ServoGains& gains, double velocity)
{
    TrapezoidMotion motion;
    motion.reset(0);
    motion.moveTo(100000, {velocity, 200000, 200000});
    double worst = 0;
    for (int i = 0; i < 30000 && (motion.isMoving() || plant.velocity() != 0); ++i) {
        motion.advance(1ms);
        plant.follow(motion.position(), motion.velocity(), gains);
        worst = std::max(worst, std::abs(motion.position() - plant.position()));
    }
    return worst;
}

} // namespace

TEST(ServoPlantTest, followsWithALagThatGrowsWithSpeedAndInertia)
{
    ServoPlant light(10000, 1, 1);
    ServoPlant heavy(10000, 20, 1);
    const double slow = worstError(light, {}, 10000);
    light.reset(0);
    const double fast = worstError(light, {}, 50000);
    const double heavyFast = worstError(heavy, {}, 50000);
    EXPECT_GT(slow, 5);
    EXPECT_LT(slow, 40);
    EXPECT_GT(fast, 2 * slow);
    EXPECT_GT(heavyFast, fast);
}

TEST(ServoPlantTest, comesToRestAtTheReference)
{
    for (const double inertia : {0.0, 1.0, 5.0, 30.0}) {
        ServoPlant plant(10000, inertia, 1);
        worstError(plant, {}, 50000);
        for (int i = 0; i < 1000; ++i)
            plant.follow(100000, 0, {});
        EXPECT_EQ(plant.position(), 100000) << inertia;
        EXPECT_EQ(plant.velocity(), 0) << inertia;
    }
}

TEST(ServoPlantTest, theTorqueStaysWithinItsLimit)
{
    ServoPlant plant(10000, 1, 1);
    ServoGains gains;
    gains.torqueLimit = 0.1;
    double worst = 0;
    for (int i = 0; i < 300; ++i) {
        plant.follow(1e6, 0, gains);
        worst = std::max(worst, std::abs(plant.torque()));
    }
    EXPECT_NEAR(worst, 0.1, 0.005);
}

TEST(ServoPlantTest, accelerationNeedsTorqueInProportionToInertia)
{
    const auto torqueFor = [](double inertia) {
        ServoPlant plant(10000, inertia, 1);
        TrapezoidMotion motion;
        motion.reset(0);
        motion.moveAt(100000, {100000, 400000, 400000});
        double sum = 0;
        for (int i = 0; i < 200; ++i) {
            motion.advance(1ms);
            plant.follow(motion.position(), motion.velocity(), {});
            sum += i >= 100 ? plant.torque() : 0;
        }
        return sum / 100;
    };
    EXPECT_NEAR(torqueFor(3) / torqueFor(1), 2, 0.35); // friction is the same for both
}

TEST(ServoPlantTest, aFreeShaftRunsOut)
{
    ServoPlant plant(10000, 1, 1);
    TrapezoidMotion motion;
    motion.reset(0);
    motion.moveAt(100000, {100000, 1e6, 1e6});
    for (int i = 0; i < 500; ++i) {
        motion.advance(1ms);
        plant.follow(motion.position(), motion.velocity(), {});
    }
    const double speed = plant.velocity();
    plant.coast();
    EXPECT_LT(plant.velocity(), speed);
    EXPECT_GT(plant.velocity(), 0.9 * speed);
    for (int i = 0; i < 5000; ++i)
        plant.coast();
    EXPECT_EQ(plant.velocity(), 0);
    EXPECT_EQ(plant.torque(), 0);
}

TEST(ServoPlantTest, aBlockedShaftPushesButStands)
{
    ServoPlant plant(10000, 1, 1);
    plant.setBlocked(true);
    for (int i = 0; i < 10; ++i)
        plant.follow(100000, 0, {});
    EXPECT_EQ(plant.position(), 0);
    EXPECT_NEAR(plant.torque(), 3, 0.01);
}

TEST(ServoPlantTest, theSeedMakesTheRippleAndTheBytesRepeatIt)
{
    const auto run = [](ServoPlant& plant, int steps) {
        for (int i = 0; i < steps; ++i)
            plant.follow(plant.position() + 10, 10000, {});
    };
    ServoPlant first(10000, 1, 1);
    ServoPlant second(10000, 1, 2);
    run(first, 100);
    run(second, 100);
    EXPECT_NE(first.position(), second.position());
    ByteWriter writer;
    first.save(writer);
    ByteReader reader(writer.bytes());
    second.restore(reader);
    EXPECT_TRUE(reader.ok() && reader.atEnd());
    run(first, 100);
    run(second, 100);
    EXPECT_EQ(first.position(), second.position());
    EXPECT_EQ(first.torque(), second.torque());
}
