#include "tests/core/runtime/kinco/kincobench.h"

#include <gtest/gtest.h>

namespace camwright {
namespace {

class KincoPowerTest : public testing::Test {
protected:
    KincoPowerTest()
    {
        bench.call("MC_POWER", {"%M0.0", "1", "%M0.1", "%M0.2", "%MB1"});
        bench.call("MC_RESET", {"%M2.0", "1", "%M2.1", "%M2.2", "%MB3"});
        bench.call("MC_POWER", {"%M4.0", "%MW6", "%M4.1", "%M4.2", "%MB5"});
        bench.call("MC_JOG", {"%M10.0", "1", "%VR0", "0", "%M10.1", "%M10.2", "%MB11", "%M10.3"});
        bench.call("MC_STATE", {"1", "%M20.0", "%M20.1", "%M20.2", "%M20.3", "%M20.4", "%M20.5", "%MW22", "%M20.6", "%MW24", "%VR40",
                                   "%VR44", "%MB26"});
    }
    void alarm()
    {
        ASSERT_TRUE(bench.engine().apply(input::InjectFault{0, input::InjectedFault::DriveAlarm}));
        ASSERT_TRUE(bench.stepUntil([&] { return bench.state() == 1; }, 1s));
    }

    KincoBench bench;
};

// KS-MC-16, KS-MC-27 note 5
TEST_F(KincoPowerTest, RisingEdgeLocksTheAxis)
{
    bench.start();
    EXPECT_EQ(bench.state(), 0);
    bench.setBit("%M0.0");
    EXPECT_TRUE(bench.stepUntil([&] { return bench.bit("%M0.1"); }, 1s));
    EXPECT_FALSE(bench.bit("%M0.2"));
    EXPECT_EQ(bench.number("%MB1"), 0);
    EXPECT_EQ(bench.state(), 2);
    EXPECT_TRUE(bench.bit("%M20.4")); // RUN
}

// KS-MC-16, KS-MC-27 note 2
TEST_F(KincoPowerTest, FallingEdgeReleasesIt)
{
    bench.start();
    bench.setBit("%M0.0");
    ASSERT_TRUE(bench.stepUntil([&] { return bench.bit("%M0.1"); }, 1s));
    bench.setBit("%M0.0", false);
    bench.step(3ms);
    EXPECT_FALSE(bench.bit("%M0.1"));
    EXPECT_TRUE(bench.stepUntil([&] { return bench.bit("%M0.1"); }, 1s));
    EXPECT_FALSE(bench.bit("%M0.2"));
    EXPECT_EQ(bench.state(), 0);
}

// KS-MC-10 ERRID 1, KS-MC-09
TEST_F(KincoPowerTest, AnAxisThatIsNotInTheNetworkGivesErrorOne)
{
    bench.start();
    bench.set("%MW6", 3);
    bench.setBit("%M4.0");
    bench.step(5ms);
    EXPECT_TRUE(bench.bit("%M4.1"));
    EXPECT_TRUE(bench.bit("%M4.2"));
    EXPECT_EQ(bench.number("%MB5"), 1);
}

// KS-MC-08, KS-MC-10 ERRID 1
TEST_F(KincoPowerTest, AnOfflineAxisGivesErrorOneAndMcStateSaysSo)
{
    bench.start();
    EXPECT_EQ(bench.number("%MB26"), 0);
    ASSERT_TRUE(bench.engine().apply(input::InjectFault{0, input::InjectedFault::NodeLoss}));
    ASSERT_TRUE(bench.stepUntil([&] { return bench.number("%MB26") == 1; }, 10s));
    EXPECT_EQ(bench.state(), 1);
    EXPECT_EQ(bench.number("axis.Feed.error"), 0x8130);
    bench.setBit("%M0.0");
    bench.step(5ms);
    EXPECT_EQ(bench.number("%MB1"), 1);
    // Nothing reconnects by itself.
    ASSERT_TRUE(bench.engine().apply(input::InjectFault{0, input::InjectedFault::None}));
    bench.step(5s);
    EXPECT_EQ(bench.number("%MB26"), 1);
    EXPECT_EQ(bench.logged(Code::AxisLost).size(), 1u);
}

// KS-MC-27 note 1, KS-MC-16: 5 s supervision, ERRID 7
TEST_F(KincoPowerTest, AnAlarmedAxisIsNotLockedAndMcPowerGivesErrorSevenAfterFiveSeconds)
{
    bench.start();
    alarm();
    EXPECT_TRUE(bench.bit("%M20.5")); // FAULT
    EXPECT_NE(bench.number("%MW24"), 0);
    bench.setBit("%M0.0");
    bench.step(4990ms);
    EXPECT_FALSE(bench.bit("%M0.1"));
    bench.step(20ms);
    EXPECT_TRUE(bench.bit("%M0.1"));
    EXPECT_TRUE(bench.bit("%M0.2"));
    EXPECT_EQ(bench.number("%MB1"), 7);
}

// KS-MC-05, KS-MC-17, KS-MC-27 note 3, KS-MC-28: released after a reset, MC_POWER needs a new edge
TEST_F(KincoPowerTest, AfterAResetTheAxisIsReleasedUntilMcPowerSeesANewEdge)
{
    bench.start();
    bench.setBit("%M0.0");
    ASSERT_TRUE(bench.stepUntil([&] { return bench.state() == 2; }, 1s));
    alarm();
    bench.setBit("%M2.0");
    ASSERT_TRUE(bench.stepUntil([&] { return bench.bit("%M2.1"); }, 2s));
    EXPECT_EQ(bench.number("%MB3"), 0);
    EXPECT_TRUE(bench.bit("%M0.1")) << "MC_RESET leaves the outputs of other calls alone";
    bench.step(500ms);
    EXPECT_EQ(bench.state(), 0);
    bench.setBit("%M0.0", false);
    bench.step(20ms);
    bench.setBit("%M0.0");
    EXPECT_TRUE(bench.stepUntil([&] { return bench.state() == 2; }, 1s));
}

// KS-MC-02: the running call wins
TEST_F(KincoPowerTest, ResetDuringAMotionGivesErrorThree)
{
    bench.start();
    bench.setBit("%M0.0");
    ASSERT_TRUE(bench.stepUntil([&] { return bench.state() == 2; }, 1s));
    bench.set("%VR0", 600);
    bench.setBit("%M10.0");
    ASSERT_TRUE(bench.stepUntil([&] { return bench.state() == 4; }, 1s));
    bench.setBit("%M2.0");
    bench.step(5ms);
    EXPECT_EQ(bench.number("%MB3"), 3);
    EXPECT_EQ(bench.state(), 4);
}

// KS-MC-27 note 2: any state, released by MC_POWER; the motion ends with ERRID 2
TEST_F(KincoPowerTest, ReleasingAMovingAxisEndsItsMotion)
{
    bench.start();
    bench.setBit("%M0.0");
    ASSERT_TRUE(bench.stepUntil([&] { return bench.state() == 2; }, 1s));
    bench.set("%VR0", 600);
    bench.setBit("%M10.0");
    bench.step(500ms);
    bench.setBit("%M0.0", false);
    ASSERT_TRUE(bench.stepUntil([&] { return bench.state() == 0; }, 1s));
    bench.step(5ms);
    EXPECT_TRUE(bench.bit("%M10.1"));
    EXPECT_EQ(bench.number("%MB11"), 2);
    EXPECT_FALSE(bench.bit("%M10.3"));
}

// KS-MC-07
TEST_F(KincoPowerTest, ErrorIdStaysUntilTheCallIsExecutedAgain)
{
    bench.start();
    bench.set("%MW6", 9);
    bench.setBit("%M4.0");
    bench.step(5ms);
    bench.setBit("%M4.0", false);
    bench.set("%MW6", 2);
    bench.step(1s);
    bench.setBit("%M4.0");
    bench.step(1ms);
    EXPECT_EQ(bench.number("%MB5"), 0);
    EXPECT_FALSE(bench.bit("%M4.1"));
    EXPECT_TRUE(bench.stepUntil([&] { return bench.bit("%M4.1"); }, 1s));
    EXPECT_FALSE(bench.bit("%M4.2"));
}

} // namespace
} // namespace camwright
