#include "tests/core/runtime/kinco/kincobench.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace camwright {
namespace {

/// Feed is 10000 counts and 100 mm a turn: one count is 0.01 mm.
constexpr double kWindow = 0.5;

class KincoMovesTest : public testing::Test {
protected:
    KincoMovesTest()
    {
        bench.call("MC_POWER", {"%M0.0", "1", "%M0.1", "%M0.2", "%MB1"});
        bench.call("MC_MABS", {"%M2.0", "1", "%VR0", "%VR4", "0", "%VW8", "%M2.1", "%M2.2", "%MB3", "%M2.3"}, "%M2.7");
        bench.call("MC_MREL", {"%M4.0", "1", "%VR10", "%VR14", "%M4.1", "%M4.2", "%MB5", "%M4.3"}, "%M4.7");
        bench.call("MC_JOG", {"%M6.0", "1", "%VR20", "0", "%M6.1", "%M6.2", "%MB7", "%M6.3"}, "%M6.7");
        bench.call("MC_HOME", {"%M8.0", "1", "%VR30", "%VD34", "%M8.1", "%M8.2", "%MB9"}, "%M8.7");
        bench.addHomingMethod();
        bench.call("MC_STATE", {"1", "%M20.0", "%M20.1", "%M20.2", "%M20.3", "%M20.4", "%M20.5", "%MW22", "%M20.6", "%MW24", "%VR40",
                                   "%VR44", "%MB26"});
    }

    void powered()
    {
        bench.start();
        bench.writeHomingMethod();
        for (const char* enable : {"%M2.7", "%M4.7", "%M6.7", "%M8.7"})
            bench.setBit(enable);
        bench.setBit("%M0.0");
        ASSERT_TRUE(bench.stepUntil([&] { return bench.state() == 2; }, 1s));
    }
    void moveAbsolute(double position, double velocity, int mode = 0)
    {
        bench.set("%VR0", position);
        bench.set("%VR4", velocity);
        bench.set("%VW8", mode);
        bench.setBit("%M2.0");
    }
    double position() const { return bench.number("axis.Feed.position"); }
    double velocity() const { return bench.number("axis.Feed.velocity"); }
    bool done(const char* bit, Time limit = 20s) { return bench.stepUntil([&] { return bench.bit(bit); }, limit); }

    KincoBench bench;
};

// KS-MC-19, KS-MC-09, KS-MC-28
TEST_F(KincoMovesTest, AbsoluteMoveArrivesAndEnds)
{
    powered();
    moveAbsolute(250, 6000); // 100 mm/s
    bench.step(500ms);
    EXPECT_EQ(bench.state(), 3);
    EXPECT_TRUE(bench.bit("%M2.3"));
    EXPECT_FALSE(bench.bit("%M20.0"));
    EXPECT_TRUE(bench.bit("%M20.2")); // CW
    EXPECT_NEAR(velocity(), 100, 5);
    EXPECT_NEAR(bench.number("%VR44"), 6000, 300); // AVEL per minute
    ASSERT_TRUE(done("%M2.1"));
    EXPECT_FALSE(bench.bit("%M2.2"));
    EXPECT_FALSE(bench.bit("%M2.3"));
    EXPECT_NEAR(position(), 250, kWindow);
    EXPECT_NEAR(bench.number("%VR40"), position(), 0.02);
    EXPECT_TRUE(bench.bit("%M20.0")); // POS
    EXPECT_EQ(bench.state(), 2);
}

// KS-MC-04
TEST_F(KincoMovesTest, WithoutPowerEveryMotionGivesErrorTwo)
{
    bench.start();
    for (const char* enable : {"%M2.7", "%M4.7", "%M6.7", "%M8.7"})
        bench.setBit(enable);
    bench.set("%VR4", 600);
    bench.set("%VR14", 600);
    bench.set("%VR20", 600);
    for (const char* exec : {"%M2.0", "%M4.0", "%M6.0", "%M8.0"})
        bench.setBit(exec);
    bench.step(5ms);
    for (const char* error : {"%MB3", "%MB5", "%MB7", "%MB9"})
        EXPECT_EQ(bench.number(error), 2) << error;
    EXPECT_EQ(bench.state(), 0);
}

// KS-MC-02: the running call wins, the newer ends with ERRID 3 and the axis goes on
TEST_F(KincoMovesTest, ASecondMotionEndsWithErrorThree)
{
    powered();
    moveAbsolute(200, 6000);
    bench.step(300ms);
    bench.set("%VR20", -600);
    bench.setBit("%M6.0");
    bench.step(5ms);
    EXPECT_TRUE(bench.bit("%M6.1"));
    EXPECT_TRUE(bench.bit("%M6.2"));
    EXPECT_EQ(bench.number("%MB7"), 3);
    ASSERT_TRUE(done("%M2.1"));
    EXPECT_NEAR(position(), 200, kWindow);
    EXPECT_EQ(bench.number("%MB7"), 3) << "KS-MC-07";
}

// KS-MC-19: POS is rescanned
TEST_F(KincoMovesTest, AbsoluteMoveFollowsANewTargetOnTheWay)
{
    powered();
    moveAbsolute(400, 6000);
    bench.step(1s);
    bench.set("%VR0", 50);
    ASSERT_TRUE(done("%M2.1"));
    EXPECT_NEAR(position(), 50, kWindow);
}

// KS-MC-19: VEL is rescanned, 0 pauses, a new VEL resumes
TEST_F(KincoMovesTest, VelocityZeroPausesAndANewVelocityGoesOn)
{
    powered();
    moveAbsolute(300, 6000);
    bench.step(1s);
    bench.set("%VR4", 0);
    bench.step(1s);
    EXPECT_NEAR(velocity(), 0, 0.5);
    EXPECT_TRUE(bench.bit("%M2.3"));
    EXPECT_FALSE(bench.bit("%M2.1"));
    EXPECT_EQ(bench.state(), 3);
    const double paused = position();
    EXPECT_LT(paused, 250);
    bench.set("%VR4", 1200);
    bench.step(1s);
    EXPECT_NEAR(velocity(), 20, 2);
    ASSERT_TRUE(done("%M2.1", 30s));
    EXPECT_NEAR(position(), 300, kWindow);
}

// EXEC falling pauses, a new edge goes on
TEST_F(KincoMovesTest, ExecFallingPausesAndANewEdgeGoesOn)
{
    powered();
    moveAbsolute(300, 6000);
    bench.step(1s);
    bench.setBit("%M2.0", false);
    bench.step(1s);
    EXPECT_NEAR(velocity(), 0, 0.5);
    EXPECT_FALSE(bench.bit("%M2.1"));
    bench.setBit("%M2.0");
    ASSERT_TRUE(done("%M2.1"));
    EXPECT_NEAR(position(), 300, kWindow);
}

// KS-MC-19: EN to 0 stops, the axis stays locked and stands
TEST_F(KincoMovesTest, EnableGoingAwayStopsTheMove)
{
    powered();
    moveAbsolute(300, 6000);
    bench.step(1s);
    bench.setBit("%M2.7", false);
    bench.step(1s);
    EXPECT_EQ(bench.state(), 2);
    EXPECT_NEAR(velocity(), 0, 0.5);
    EXPECT_LT(position(), 250);
    EXPECT_FALSE(bench.bit("%M2.3"));
    bench.setBit("%M2.7");
    bench.step(1s);
    EXPECT_EQ(bench.state(), 2) << "a held EXEC is no new edge";
}

// KS-MC-19: MODE 1 stays and follows each new POS, ACT stays 1
TEST_F(KincoMovesTest, ModeOneFollowsEveryNewPosition)
{
    powered();
    moveAbsolute(50, 6000, 1);
    ASSERT_TRUE(done("%M2.1"));
    EXPECT_TRUE(bench.bit("%M2.3"));
    EXPECT_NEAR(position(), 50, kWindow);
    bench.set("%VR0", 80);
    bench.step(50ms);
    EXPECT_FALSE(bench.bit("%M2.1"));
    ASSERT_TRUE(done("%M2.1"));
    EXPECT_NEAR(position(), 80, kWindow);
    EXPECT_EQ(bench.state(), 3);
    bench.setBit("%M2.7", false);
    bench.step(200ms);
    EXPECT_FALSE(bench.bit("%M2.3"));
    EXPECT_EQ(bench.state(), 2);
}

// KS-MC-20: distance from the current position; repeated moves do not drift
TEST_F(KincoMovesTest, RelativeMovesAddUp)
{
    powered();
    bench.set("%VR10", -12.5);
    bench.set("%VR14", 6000);
    for (int i = 1; i <= 4; ++i) {
        bench.setBit("%M4.0");
        bench.step(5ms);
        ASSERT_TRUE(done("%M4.1"));
        EXPECT_EQ(bench.number("%MB5"), 0);
        bench.setBit("%M4.0", false);
        bench.step(5ms);
        EXPECT_NEAR(bench.number("axis.Feed.setPosition"), -12.5 * i, 0.011) << i;
    }
}

// KS-MC-20: VEL is rescanned, POS is not
TEST_F(KincoMovesTest, RelativeMoveLooksAtVelocityButNotAtPosition)
{
    powered();
    bench.set("%VR10", 100);
    bench.set("%VR14", 3000);
    bench.setBit("%M4.0");
    bench.step(800ms);
    bench.set("%VR10", 500);
    bench.set("%VR14", 1500);
    bench.step(800ms);
    EXPECT_NEAR(velocity(), 25, 2);
    ASSERT_TRUE(done("%M4.1"));
    EXPECT_NEAR(position(), 100, kWindow);
}

// KS-MC-20: jog with signed VEL until EXEC falls, the axis stays locked
TEST_F(KincoMovesTest, JogTurnsWithSignedVelocityUntilExecFalls)
{
    powered();
    bench.set("%VR20", -3000);
    bench.setBit("%M6.0");
    bench.step(1s);
    EXPECT_EQ(bench.state(), 4);
    EXPECT_NEAR(velocity(), -50, 2);
    EXPECT_TRUE(bench.bit("%M20.3")); // CCW
    EXPECT_TRUE(bench.bit("%M6.3"));
    bench.set("%VR20", 1200);
    bench.step(2s);
    EXPECT_NEAR(velocity(), 20, 1);
    bench.setBit("%M6.0", false);
    ASSERT_TRUE(done("%M6.1"));
    EXPECT_FALSE(bench.bit("%M6.2"));
    EXPECT_FALSE(bench.bit("%M6.3"));
    EXPECT_EQ(bench.state(), 2);
    bench.step(20ms);
    EXPECT_NEAR(velocity(), 0, 0.5);
}

// C28: a non-finite or non-positive VEL ends with DONE = ERR = 1 and ERRID 7, nothing sent
TEST_F(KincoMovesTest, AnIllegalVelocityGivesErrorSevenAndMovesNothing)
{
    powered();
    for (const double speed : {0.0, -600.0, std::numeric_limits<double>::infinity(), std::nan("")}) {
        moveAbsolute(100, speed);
        bench.step(5ms);
        EXPECT_TRUE(bench.bit("%M2.1") && bench.bit("%M2.2")) << speed;
        EXPECT_EQ(bench.number("%MB3"), 7) << speed;
        bench.setBit("%M2.0", false);
        bench.step(100ms);
        EXPECT_EQ(bench.state(), 2);
        EXPECT_NEAR(position(), 0, kWindow);
    }
}

TEST_F(KincoMovesTest, AVelocityThatBecomesIllegalStopsTheMove)
{
    powered();
    moveAbsolute(300, 6000);
    bench.step(1s);
    bench.set("%VR4", -1);
    ASSERT_TRUE(done("%M2.1"));
    EXPECT_EQ(bench.number("%MB3"), 7);
    EXPECT_EQ(bench.state(), 2);
    bench.step(100ms);
    EXPECT_NEAR(velocity(), 0, 0.5);
}

// KS-MC-18, KS-MC-22: POS is the home offset; HOME goes 0 and comes back
TEST_F(KincoMovesTest, HomingFindsTheSwitchAndSetsTheOffset)
{
    powered();
    bench.set("%VR30", 7.5);
    bench.set("%VD34", 60000);
    bench.setBit("%M8.0");
    bench.step(200ms);
    EXPECT_EQ(bench.state(), 5);
    EXPECT_FALSE(bench.bit("%M20.1"));
    ASSERT_TRUE(done("%M8.1", 60s));
    EXPECT_EQ(bench.number("%MB9"), 0);
    EXPECT_TRUE(bench.bit("%M20.1"));
    EXPECT_EQ(bench.state(), 2);
}

// KS-MC-18: TIME elapsed is an error; the axis stays locked
TEST_F(KincoMovesTest, HomingThatTakesTooLongGivesErrorSeven)
{
    powered();
    bench.set("%VD34", 150);
    bench.setBit("%M8.0");
    ASSERT_TRUE(done("%M8.1"));
    EXPECT_TRUE(bench.bit("%M8.2"));
    EXPECT_EQ(bench.number("%MB9"), 7);
    EXPECT_EQ(bench.state(), 2);
}

// KS-MC-18: EXEC falling pauses, a new edge homes
TEST_F(KincoMovesTest, HomingPausesWithExec)
{
    powered();
    bench.set("%VD34", 60000);
    bench.setBit("%M8.0");
    bench.step(300ms);
    bench.setBit("%M8.0", false);
    bench.step(1s);
    EXPECT_NEAR(velocity(), 0, 0.5);
    EXPECT_EQ(bench.state(), 5);
    bench.setBit("%M8.0");
    ASSERT_TRUE(done("%M8.1", 60s));
    EXPECT_EQ(bench.number("%MB9"), 0);
}

// KS-MC-27 note 1: an alarm ends the motion
TEST_F(KincoMovesTest, AnAlarmEndsTheMotionWithAnError)
{
    powered();
    moveAbsolute(300, 6000);
    bench.step(500ms);
    ASSERT_TRUE(bench.engine().apply(input::InjectFault{0, input::InjectedFault::DriveAlarm}));
    ASSERT_TRUE(done("%M2.1"));
    EXPECT_EQ(bench.number("%MB3"), 7);
    EXPECT_EQ(bench.state(), 1);
    EXPECT_EQ(bench.logged(Code::AxisAlarm).size(), 1u);
}

// KS-MC-10 ERRID 1: the node goes away while it moves
TEST_F(KincoMovesTest, ALostNodeEndsTheMotionWithErrorOne)
{
    powered();
    moveAbsolute(3000, 600);
    bench.step(500ms);
    ASSERT_TRUE(bench.engine().apply(input::InjectFault{0, input::InjectedFault::NodeLoss}));
    ASSERT_TRUE(done("%M2.1"));
    EXPECT_EQ(bench.number("%MB3"), 1);
    EXPECT_EQ(bench.state(), 1);
}

// KS-MC-10 ERRID 4: nobody acknowledges, so the send buffer fills
TEST_F(KincoMovesTest, AFullSendBufferEndsTheMotionWithErrorFour)
{
    powered();
    bench.set("%VR20", 600);
    bench.setBit("%M6.0");
    bench.step(200ms);
    for (std::uint16_t axis : {0, 1})
        ASSERT_TRUE(bench.engine().apply(input::InjectFault{axis, input::InjectedFault::NodeLoss}));
    for (int i = 0; i < 400 && bench.number("%MB7") == 0; ++i) {
        bench.set("%VR20", 600 + i);
        bench.step(1ms);
    }
    EXPECT_EQ(bench.number("%MB7"), 4);
}

// KS-MC-08: restarting the controller reconnects
TEST_F(KincoMovesTest, SwitchingOffAndOnBringsALostNodeBack)
{
    powered();
    ASSERT_TRUE(bench.engine().apply(input::InjectFault{0, input::InjectedFault::NodeLoss}));
    ASSERT_TRUE(bench.stepUntil([&] { return bench.state() == 1; }, 10s));
    ASSERT_TRUE(bench.engine().apply(input::InjectFault{0, input::InjectedFault::None}));
    ASSERT_TRUE(bench.engine().apply(input::PowerCycle{}));
    bench.step(2s);
    EXPECT_TRUE(bench.engine().status().axes[0].online);
    EXPECT_EQ(bench.state(), 0);
    EXPECT_EQ(bench.engine().status().state, RunState::Run);
    bench.setBit("%M0.0");
    EXPECT_TRUE(bench.stepUntil([&] { return bench.state() == 2; }, 1s));
}

} // namespace
} // namespace camwright
