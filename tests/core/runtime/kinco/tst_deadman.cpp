#include "tests/core/runtime/kinco/kincobench.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace camwright {
namespace {

/// Uniform numbers without std distributions, the same everywhere.
class Random {
public:
    explicit Random(std::uint32_t seed) : m_engine(seed) {}
    std::uint32_t below(std::uint32_t limit) { return m_engine() % limit; }
    double real(double from, double to) { return from + (to - from) * (m_engine() % 100001) / 100000.0; }

private:
    std::mt19937 m_engine;
};

struct BusCase {
    const char* name;
    std::uint32_t baudrate;
    std::uint16_t inhibitMs;
    std::uint16_t eventMs;
};

void PrintTo(const BusCase& c, std::ostream* out)
{
    *out << c.name;
}

class DeadManTest : public testing::TestWithParam<BusCase> {
protected:
    void enableBoth()
    {
        bench.image().configuration.network.baudrate = GetParam().baudrate;
        for (std::size_t i : {0, 1}) {
            bench.axis(i).inhibitTimeMs = GetParam().inhibitMs;
            bench.axis(i).eventTimerMs = GetParam().eventMs;
            bench.axis(i).lowerLimitSwitch = -1e6;
            bench.axis(i).upperLimitSwitch = 1e6;
        }
        ASSERT_TRUE(bench.engine().load(bench.imageBytes()));
        bench.step(2s);
        for (std::uint16_t i : {0, 1})
            ASSERT_TRUE(bench.panel(AxisCommandKind::Enable, 0, 0, i));
        bench.step(2s);
    }
    double speed(int axis) const { return std::abs(bench.number("plant." + std::to_string(axis) + ".velocity")); }

    KincoBench bench;
};

// C19, RELIABILITY section 4: whatever the moment the heartbeats end, the stop is at the bus within 100 ms and one cycle
TEST_P(DeadManTest, TheStopIsAlwaysInTime)
{
    enableBoth();
    Random random(20);
    for (int round = 0; round < 25; ++round) {
        for (std::uint16_t i : {0, 1}) {
            ASSERT_TRUE(bench.panel(AxisCommandKind::Arm, 0, 0, i)) << round;
            ASSERT_TRUE(bench.panel(AxisCommandKind::Jog, 0, random.real(-40, 40), i)) << round;
        }
        const std::uint32_t beats = 1 + random.below(20);
        for (std::uint32_t i = 0; i < beats; ++i) {
            bench.beat();
            bench.step(std::chrono::milliseconds(1 + random.below(90)));
        }
        bench.beat();
        const std::uint64_t last = bench.engine().cycle();
        const std::size_t before = bench.logged(Code::DeadManStop).size();
        bench.step(101ms);
        const auto stops = bench.logged(Code::DeadManStop);
        ASSERT_EQ(stops.size(), before + 2) << round;
        for (std::size_t i : {before, before + 1}) {
            EXPECT_EQ(stops[i].message.arguments[1], std::to_string(last));
            EXPECT_LE(std::stoull(stops[i].message.arguments[2]), last + 101);
        }
        bench.step(1s);
        EXPECT_LT(speed(1), 0.5) << round;
        EXPECT_LT(speed(2), 0.5) << round;
        EXPECT_TRUE(bench.engine().status().axes[0].enabled);
    }
}

INSTANTIATE_TEST_SUITE_P(Buses, DeadManTest,
    testing::Values(BusCase{"fast", 1000000, 10, 0}, BusCase{"crowded", 250000, 2, 5}, BusCase{"slow", 125000, 50, 0}),
    [](const testing::TestParamInfo<BusCase>& info) { return info.param.name; });

/// No run-on: whatever panels, programs and buses did, three seconds after the last heartbeat nothing turns any more.
class RunOnTest : public testing::Test {
protected:
    RunOnTest()
    {
        bench.call("MC_POWER", {"%M0.0", "1", "%M0.1", "%M0.2", "%MB1"});
    }
    void randomInput(Random& random)
    {
        const auto axis = static_cast<std::uint16_t>(random.below(2));
        static constexpr AxisCommandKind kinds[]{AxisCommandKind::Arm, AxisCommandKind::Disarm, AxisCommandKind::Enable,
            AxisCommandKind::Disable, AxisCommandKind::Reset, AxisCommandKind::Home, AxisCommandKind::MoveAbsolute,
            AxisCommandKind::MoveRelative, AxisCommandKind::Velocity, AxisCommandKind::Jog, AxisCommandKind::Stop, AxisCommandKind::Arm,
            AxisCommandKind::Enable, AxisCommandKind::Jog};
        switch (random.below(24)) {
        case 0: (void)bench.engine().apply(input::StopAllAxes{}); break;
        case 1: (void)bench.engine().apply(input::InjectFault{axis, input::InjectedFault::DriveAlarm}); break;
        case 2: (void)bench.engine().apply(input::Run{}); break;
        case 3: (void)bench.engine().apply(input::Stop{}); break;
        case 4: (void)bench.engine().apply(input::Heartbeat{bench.engine().cycle() - random.below(300)}); break;
        case 5: bench.setBit("%M0.0", random.below(2)); break;
        default:
            (void)bench.panel(kinds[random.below(std::size(kinds))], random.real(-200, 200), random.real(-100, 100), axis);
        }
        const auto state = bench.state(axis + 1);
        EXPECT_TRUE(state >= 0 && state <= 5);
    }

    KincoBench bench;
};

TEST_F(RunOnTest, NothingTurnsThreeSecondsAfterTheLastHeartbeat)
{
    for (std::size_t i : {0, 1}) {
        bench.axis(i).lowerLimitSwitch = -1e6;
        bench.axis(i).upperLimitSwitch = 1e6;
    }
    bench.start();
    Random random(77);
    for (int round = 0; round < 60; ++round) {
        const std::uint32_t inputs = 5 + random.below(60);
        for (std::uint32_t i = 0; i < inputs; ++i) {
            randomInput(random);
            bench.beat();
            bench.step(std::chrono::milliseconds(random.below(80)));
        }
        bench.step(3s);
        for (const char* axis : {"1", "2"})
            ASSERT_LT(std::abs(bench.number("plant." + std::string(axis) + ".velocity")), 0.5) << "round " << round << " axis " << axis;
    }
}

} // namespace
} // namespace camwright
