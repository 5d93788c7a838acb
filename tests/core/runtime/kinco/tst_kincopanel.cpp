#include "tests/core/runtime/kinco/kincobench.h"

#include <gtest/gtest.h>

#include <cmath>

namespace camwright {
namespace {

class KincoPanelTest : public testing::Test {
protected:
    KincoPanelTest()
    {
        bench.call("MC_POWER", {"%M0.0", "1", "%M0.1", "%M0.2", "%MB1"});
        bench.addHomingMethod();
        bench.call("MC_MABS", {"%M2.0", "1", "%VR0", "%VR4", "0", "%VW8", "%M2.1", "%M2.2", "%MB3", "%M2.3"});
    }

    /// In STOP, axis 1 enabled and armed by the panel.
    void enabled()
    {
        ASSERT_TRUE(bench.engine().load(bench.imageBytes()));
        ASSERT_TRUE(bench.stepUntil([&] { return status().online; }, 2s));
        ASSERT_TRUE(bench.panel(AxisCommandKind::Enable));
        ASSERT_TRUE(bench.stepUntil([&] { return bench.state() == 2; }, 1s));
        ASSERT_TRUE(bench.panel(AxisCommandKind::Arm));
        bench.beat();
    }
    void running()
    {
        bench.start();
        bench.setBit("%M0.0");
        ASSERT_TRUE(bench.stepUntil([&] { return bench.bit("%M0.1"); }, 1s));
        bench.set("%VR4", 6000);
    }
    AxisStatus status() const { return const_cast<KincoBench&>(bench).engine().status().axes[0]; }
    double velocity() const { return bench.number("axis.Feed.velocity"); }

    KincoBench bench;
};

TEST_F(KincoPanelTest, JogsAtTheCommandedSpeedWhileHeartbeatsCome)
{
    enabled();
    ASSERT_TRUE(bench.panel(AxisCommandKind::Jog, 0, 30));
    EXPECT_TRUE(status().moving);
    bench.stepBeating(2s);
    EXPECT_NEAR(velocity(), 30, 1);
    EXPECT_EQ(bench.state(), 4);
    EXPECT_NEAR(bench.number("plant.Feed.velocity"), 30, 2);
    ASSERT_TRUE(bench.panel(AxisCommandKind::Jog, 0, -10)); // the other key
    bench.stepBeating(2s);
    EXPECT_NEAR(velocity(), -10, 1);
    ASSERT_TRUE(bench.panel(AxisCommandKind::Stop));
    bench.stepBeating(1s);
    EXPECT_FALSE(status().moving);
    EXPECT_EQ(bench.state(), 2);
    EXPECT_TRUE(status().panelArmed);
}

// C19: within 100 ms plus one motion cycle of the last valid heartbeat the stop command is at the bus; power stays on
TEST_F(KincoPanelTest, WithoutHeartbeatTheStopIsAtTheBusInTime)
{
    enabled();
    ASSERT_TRUE(bench.panel(AxisCommandKind::Jog, 0, 30));
    bench.stepBeating(1s);
    bench.beat();
    const std::uint64_t lastBeat = bench.engine().cycle();
    bench.step(1s);
    const auto stops = bench.logged(Code::DeadManStop);
    ASSERT_EQ(stops.size(), 1u);
    EXPECT_EQ(stops[0].message.arguments[1], std::to_string(lastBeat));
    const std::uint64_t atBus = std::stoull(stops[0].message.arguments[2]);
    EXPECT_GE(atBus, lastBeat + 100);
    EXPECT_LE(atBus, lastBeat + 101);
    EXPECT_FALSE(status().moving);
    EXPECT_FALSE(status().panelArmed);
    EXPECT_TRUE(status().enabled) << "power stays on";
    EXPECT_NEAR(velocity(), 0, 0.5);
}

// C19: stop frames bypass inhibit times, whatever those are
TEST_F(KincoPanelTest, TheStopDoesNotWaitForTheInhibitTime)
{
    bench.axis(0).inhibitTimeMs = 200;
    enabled();
    ASSERT_TRUE(bench.panel(AxisCommandKind::Jog, 0, 30));
    bench.stepBeating(2s);
    const double before = bench.number("plant.Feed.velocity");
    EXPECT_NEAR(before, 30, 2);
    bench.beat();
    bench.step(103ms);
    EXPECT_LT(bench.number("plant.Feed.velocity"), before - 0.1) << "the drive decelerates already";
    ASSERT_EQ(bench.logged(Code::DeadManStop).size(), 1u);
}

// C19: a heartbeat older than 100 ms is dropped
TEST_F(KincoPanelTest, HeartbeatsThatHaveSeenNothingNewDoNotCount)
{
    enabled();
    bench.beat();
    const std::uint64_t seen = bench.engine().cycle();
    ASSERT_TRUE(bench.panel(AxisCommandKind::Jog, 0, 30));
    for (int i = 0; i < 300; ++i) {
        ASSERT_TRUE(bench.engine().apply(input::Heartbeat{seen}));
        bench.step(1ms);
    }
    const auto stops = bench.logged(Code::DeadManStop);
    ASSERT_EQ(stops.size(), 1u);
    EXPECT_LE(std::stoull(stops[0].message.arguments[1]), seen + 100);
}

TEST_F(KincoPanelTest, HeartbeatsFromTheFutureDoNotCount)
{
    enabled();
    ASSERT_TRUE(bench.panel(AxisCommandKind::Jog, 0, 30));
    for (int i = 0; i < 300; ++i) {
        ASSERT_TRUE(bench.engine().apply(input::Heartbeat{bench.engine().cycle() + 1000}));
        bench.step(1ms);
    }
    EXPECT_EQ(bench.logged(Code::DeadManStop).size(), 1u);
}

TEST_F(KincoPanelTest, MotionNeedsArmingAndPower)
{
    ASSERT_TRUE(bench.engine().load(bench.imageBytes()));
    EXPECT_EQ(bench.panel(AxisCommandKind::Enable).error().code, Code::PanelAxisOffline);
    ASSERT_TRUE(bench.stepUntil([&] { return status().online; }, 2s));
    EXPECT_EQ(bench.panel(AxisCommandKind::Jog, 0, 10).error().code, Code::PanelNotArmed);
    ASSERT_TRUE(bench.panel(AxisCommandKind::Arm));
    EXPECT_EQ(bench.panel(AxisCommandKind::Jog, 0, 10).error().code, Code::PanelAxisNotEnabled);
    EXPECT_EQ(bench.panel(AxisCommandKind::Jog, 0, std::nan("")).error().code, Code::PanelBadNumber);
    EXPECT_EQ(bench.panel(AxisCommandKind::MoveAbsolute, 10, 0).error().code, Code::PanelBadNumber);
    EXPECT_EQ(bench.panel(AxisCommandKind::MoveAbsolute, 1e12, 10).error().code, Code::PanelBadNumber);
    EXPECT_TRUE(bench.panel(AxisCommandKind::Stop));
    EXPECT_EQ(bench.panel(AxisCommandKind::Stop, 0, 0, 7).error().code, Code::NoSuchAxis);
}

TEST_F(KincoPanelTest, MovesAbsoluteAndRelative)
{
    enabled();
    ASSERT_TRUE(bench.panel(AxisCommandKind::MoveAbsolute, 40, 100));
    bench.stepBeating(2s);
    EXPECT_FALSE(status().moving);
    EXPECT_NEAR(status().position, 40, 0.5);
    ASSERT_TRUE(bench.panel(AxisCommandKind::MoveRelative, -15, 100));
    EXPECT_EQ(bench.panel(AxisCommandKind::MoveRelative, -15, 100).error().code, Code::PanelStillMoving);
    bench.stepBeating(2s);
    EXPECT_NEAR(status().position, 25, 0.5);
}

TEST_F(KincoPanelTest, Homes)
{
    running();
    bench.writeHomingMethod();
    ASSERT_TRUE(bench.panel(AxisCommandKind::Arm));
    bench.beat();
    EXPECT_FALSE(status().homed);
    ASSERT_TRUE(bench.panel(AxisCommandKind::Home));
    bench.stepBeating(200ms);
    EXPECT_EQ(bench.state(), 5);
    for (int i = 0; i < 60 && !status().homed; ++i)
        bench.stepBeating(1s);
    EXPECT_TRUE(status().homed);
    EXPECT_EQ(bench.state(), 2);
}

TEST_F(KincoPanelTest, JogSpeedsAreClamped)
{
    enabled();
    ASSERT_TRUE(bench.panel(AxisCommandKind::Jog, 0, 1e9));
    bench.stepBeating(300ms);
    ASSERT_TRUE(bench.panel(AxisCommandKind::Stop));
    EXPECT_LE(velocity(), 3000.0 / 60 * 100 * 1.01);
}

TEST_F(KincoPanelTest, DisarmingStopsTheMotion)
{
    enabled();
    ASSERT_TRUE(bench.panel(AxisCommandKind::Velocity, 0, 30));
    bench.stepBeating(500ms);
    ASSERT_TRUE(bench.panel(AxisCommandKind::Disarm));
    bench.step(1s);
    EXPECT_FALSE(status().moving);
    EXPECT_TRUE(status().enabled);
    EXPECT_TRUE(bench.logged(Code::DeadManStop).empty());
}

// C20: while the panel is armed, program motion ends with ERRID 3; afterwards nothing moves until a new edge
TEST_F(KincoPanelTest, AnArmedPanelKeepsTheProgramFromMoving)
{
    running();
    ASSERT_TRUE(bench.panel(AxisCommandKind::Arm));
    bench.set("%VR0", 100);
    bench.setBit("%M2.0");
    bench.stepBeating(10ms);
    EXPECT_EQ(bench.number("%MB3"), 3);
    ASSERT_TRUE(bench.panel(AxisCommandKind::Disarm));
    bench.step(1s);
    EXPECT_EQ(bench.state(), 2);
    EXPECT_NEAR(status().position, 0, 0.5) << "a held EXEC moves nothing";
    bench.setBit("%M2.0", false);
    bench.step(5ms);
    bench.setBit("%M2.0");
    EXPECT_TRUE(bench.stepUntil([&] { return bench.state() == 3; }, 100ms));
}

// C28: a running MC call refuses the panel, except for stop
TEST_F(KincoPanelTest, ARunningCallRefusesThePanelButNotItsStop)
{
    running();
    bench.set("%VR0", 1000);
    bench.setBit("%M2.0");
    bench.step(500ms);
    EXPECT_EQ(bench.panel(AxisCommandKind::Arm).error().code, Code::PanelRefusedByProgram);
    ASSERT_TRUE(bench.panel(AxisCommandKind::Stop));
    bench.step(5ms);
    EXPECT_TRUE(bench.bit("%M2.1"));
    EXPECT_EQ(bench.number("%MB3"), 3);
    bench.step(1s);
    EXPECT_NEAR(velocity(), 0, 0.5);
    EXPECT_EQ(bench.state(), 2);
    EXPECT_EQ(status().lastCause, "stopped by command");
}

TEST_F(KincoPanelTest, StopAllAxesNeedsNothing)
{
    running();
    bench.set("%VR0", 1000);
    bench.setBit("%M2.0");
    bench.step(500ms);
    ASSERT_TRUE(bench.engine().apply(input::StopAllAxes{}));
    bench.step(1s);
    EXPECT_NEAR(velocity(), 0, 0.5);
    EXPECT_TRUE(status().enabled);
    EXPECT_EQ(bench.logged(Code::AllAxesStopped).size(), 1u);
}

// C20: enable is program OR panel
TEST_F(KincoPanelTest, TheAxisKeepsPowerWhileProgramOrPanelWantsIt)
{
    running();
    ASSERT_TRUE(bench.panel(AxisCommandKind::Enable));
    bench.setBit("%M0.0", false);
    bench.step(500ms);
    EXPECT_TRUE(status().enabled);
    EXPECT_TRUE(bench.bit("%M0.1"));
    ASSERT_TRUE(bench.panel(AxisCommandKind::Disable));
    bench.step(500ms);
    EXPECT_FALSE(status().enabled);
}

// C20: enabled by the panel until RUN
TEST_F(KincoPanelTest, RunTakesThePanelsPowerBack)
{
    enabled();
    ASSERT_TRUE(bench.panel(AxisCommandKind::Jog, 0, 30));
    bench.stepBeating(500ms);
    ASSERT_TRUE(bench.engine().apply(input::Run{}));
    ASSERT_TRUE(bench.stepUntil([&] { return bench.engine().status().state == RunState::Run; }, 3s));
    EXPECT_FALSE(status().enabled);
    EXPECT_NEAR(velocity(), 0, 0.5) << "stopped before it was released";
}

// C20: RUN to STOP stops every axis first and then releases it
TEST_F(KincoPanelTest, StopStopsTheAxisBeforeItReleasesIt)
{
    running();
    bench.set("%VR0", 1000);
    bench.setBit("%M2.0");
    bench.step(1s);
    EXPECT_GT(bench.number("plant.Feed.velocity"), 90);
    ASSERT_TRUE(bench.engine().apply(input::Stop{}));
    double atRelease = -1;
    for (int i = 0; i < 3000 && atRelease < 0; ++i) {
        bench.step(1ms);
        if (!status().enabled)
            atRelease = std::abs(bench.number("plant.Feed.velocity"));
    }
    EXPECT_GE(atRelease, 0);
    EXPECT_LT(atRelease, 1);
    EXPECT_TRUE(bench.engine().isQuiet());
}

TEST_F(KincoPanelTest, ResetClearsAnAlarmAndLeavesTheAxisReleased)
{
    enabled();
    ASSERT_TRUE(bench.engine().apply(input::InjectFault{0, input::InjectedFault::DriveAlarm}));
    ASSERT_TRUE(bench.stepUntil([&] { return bench.state() == 1; }, 1s));
    EXPECT_EQ(bench.panel(AxisCommandKind::Enable).error().code, Code::PanelAxisInError);
    ASSERT_TRUE(bench.panel(AxisCommandKind::Reset));
    ASSERT_TRUE(bench.stepUntil([&] { return bench.state() == 0; }, 3s));
    EXPECT_TRUE(bench.panel(AxisCommandKind::Enable));
    EXPECT_TRUE(bench.stepUntil([&] { return bench.state() == 2; }, 1s));
}

} // namespace
} // namespace camwright
