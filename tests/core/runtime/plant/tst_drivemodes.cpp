#include "tests/core/runtime/plant/networkfixture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

using namespace camwright;

namespace {

class DriveModeTest : public testing::Test {
protected:
    void start(const SimulatedDriveConfig& config = {})
    {
        MasterNodeConfig node;
        node.inhibitTime = 1ms;
        network = std::make_unique<Network>(1, 1'000'000, config, node);
        ASSERT_TRUE(network->boot());
    }
    void startIn(std::int8_t mode, const SimulatedDriveConfig& config = {})
    {
        start(config);
        ASSERT_TRUE(network->enable(1, mode));
    }
    bool arrive(Time limit = 10s) { return network->until([&] { return network->reached(1); }, limit); }
    double position() { return network->drive(1).plantPosition(); }
    std::unique_ptr<Network> network;
};

} // namespace

// Profile position.

TEST_F(DriveModeTest, acknowledgesASetPointAndTakesItOnlyOnTheRisingBit)
{
    startIn(1);
    ASSERT_TRUE(network->setPoint(1, 1000, 10000));
    ASSERT_TRUE(arrive());
    network->out(1).targetPosition = 5000; // without a new edge
    network->run(1s);
    EXPECT_NEAR(position(), 1000, 1);
}

TEST_F(DriveModeTest, aHeldStartBitKeepsTheAcknowledge)
{
    startIn(1);
    network->out(1).targetPosition = 100;
    network->out(1).profileVelocity = 1000;
    network->out(1).controlWord = 0x1F;
    network->run(1s);
    EXPECT_TRUE(network->status(1, 0x1400, 0x1400));
}

TEST_F(DriveModeTest, aSecondSetPointWaitsForTheFirst)
{
    startIn(1);
    ASSERT_TRUE(network->setPoint(1, 10000, 20000));
    network->out(1).targetPosition = 0;
    network->out(1).controlWord = 0x1F;
    ASSERT_TRUE(network->until([&] { return network->status(1, 0x1000, 0x1000); }, 100ms));
    network->out(1).controlWord = 0x0F;
    network->run(50ms);
    EXPECT_TRUE(network->status(1, 0x1000, 0x1000)); // the buffer is full
    double highest = 0;
    ASSERT_TRUE(network->until([&] {
        highest = std::max(highest, position());
        return network->reached(1);
    }, 5s));
    EXPECT_NEAR(highest, 10000, 5);
    EXPECT_NEAR(position(), 0, 10);
    EXPECT_TRUE(network->status(1, 0x1000, 0));
}

TEST_F(DriveModeTest, changeImmediatelyTurnsOnTheWay)
{
    startIn(1);
    ASSERT_TRUE(network->setPoint(1, 100000, 20000));
    network->run(1s);
    ASSERT_TRUE(network->setPoint(1, -1000, 20000, 1U << 5));
    ASSERT_TRUE(arrive());
    EXPECT_NEAR(position(), -1000, 10);
}

TEST_F(DriveModeTest, relativeSetPointsAddToTheLastTarget)
{
    startIn(1);
    ASSERT_TRUE(network->setPoint(1, 3000, 20000));
    ASSERT_TRUE(arrive());
    ASSERT_TRUE(network->setPoint(1, -1000, 20000, 1U << 6));
    ASSERT_TRUE(arrive());
    EXPECT_NEAR(position(), 2000, 10);
    ASSERT_TRUE(network->setPoint(1, 50000, 20000, 1U << 6));
    network->run(500ms);
    ASSERT_TRUE(network->setPoint(1, 100, 20000, (1U << 6) | (1U << 5)));
    ASSERT_TRUE(arrive());
    EXPECT_NEAR(position(), 52100, 10);
}

TEST_F(DriveModeTest, haltStopsAndGoesOn)
{
    startIn(1);
    ASSERT_TRUE(network->setPoint(1, 50000, 20000));
    network->run(1s);
    network->out(1).controlWord = 0x10F;
    network->run(300ms);
    const double halted = position();
    EXPECT_TRUE(network->reached(1)); // standing, as bit 10 means while halted
    network->run(300ms);
    EXPECT_NEAR(position(), halted, 1);
    EXPECT_LT(halted, 40000);
    network->out(1).controlWord = 0x0F;
    network->run(10ms);
    EXPECT_FALSE(network->reached(1));
    ASSERT_TRUE(arrive());
    EXPECT_NEAR(position(), 50000, 10);
}

TEST_F(DriveModeTest, aProfileVelocityOfZeroPausesAndANewOneResumes)
{
    startIn(1);
    ASSERT_TRUE(network->setPoint(1, 50000, 20000));
    network->run(500ms);
    ASSERT_TRUE(network->setPoint(1, 50000, 0, 1U << 5));
    network->run(500ms);
    EXPECT_EQ(network->in(1).velocity, 0);
    EXPECT_FALSE(network->reached(1));
    ASSERT_TRUE(network->setPoint(1, 50000, 30000, 1U << 5));
    ASSERT_TRUE(arrive());
}

TEST_F(DriveModeTest, accelerationComesFrom6083)
{
    start();
    ASSERT_EQ(network->write(1, {0x6083, 0}, 20000, 4).status, SdoStatus::Done);
    ASSERT_TRUE(network->enable(1, 1));
    ASSERT_TRUE(network->setPoint(1, 100000, 20000));
    network->run(500ms);
    EXPECT_NEAR(network->drive(1).plantVelocity(), 10000, 500);
}

TEST_F(DriveModeTest, theWindowTimeDelaysTargetReached)
{
    start();
    ASSERT_EQ(network->write(1, {0x6068, 0}, 500, 2).status, SdoStatus::Done);
    ASSERT_TRUE(network->enable(1, 1));
    network->run(600ms);
    ASSERT_TRUE(network->setPoint(1, 1000, 20000));
    ASSERT_TRUE(network->until([&] { return std::abs(network->in(1).position - 1000) <= 10; }, 2s));
    const Time inside = network->now;
    ASSERT_TRUE(arrive());
    EXPECT_GE(network->now - inside, 450ms);
}

TEST_F(DriveModeTest, softLimitsHoldTheAxis)
{
    start();
    ASSERT_EQ(network->write(1, {0x607D, 1}, 20000, 4).status, SdoStatus::Done);
    ASSERT_EQ(network->write(1, {0x607D, 2}, -20000, 4).status, SdoStatus::Done);
    ASSERT_TRUE(network->enable(1, 1));
    ASSERT_TRUE(network->setPoint(1, 30000, 40000));
    network->run(3s);
    EXPECT_NEAR(position(), 20000, 1);
    EXPECT_TRUE(network->status(1, 0x0C00, 0x0800)); // limited, and not reached
    ASSERT_TRUE(network->setPoint(1, 0, 40000));
    ASSERT_TRUE(arrive());
    EXPECT_TRUE(network->status(1, 0x0800, 0));
}

TEST_F(DriveModeTest, softLimitsEndAVelocityToo)
{
    start();
    ASSERT_EQ(network->write(1, {0x607D, 1}, 20000, 4).status, SdoStatus::Done);
    ASSERT_EQ(network->write(1, {0x607D, 2}, -20000, 4).status, SdoStatus::Done);
    ASSERT_TRUE(network->enable(1, 3));
    network->out(1).targetVelocity = -30000;
    network->run(3s);
    EXPECT_NEAR(position(), -20000, 1);
    network->out(1).targetVelocity = 30000;
    network->run(300ms);
    EXPECT_GT(position(), -19000);
}

TEST_F(DriveModeTest, aLimitSwitchStopsAndLetsTheAxisOut)
{
    SimulatedDriveConfig config;
    config.upperLimitSwitch = 10000;
    startIn(1, config);
    ASSERT_TRUE(network->setPoint(1, 50000, 40000));
    network->run(3s);
    EXPECT_GT(position(), 9999);
    EXPECT_LT(position(), 11000);
    EXPECT_TRUE(network->status(1, 0x0C00, 0x0800));
    EXPECT_EQ(network->in(1).digitalInputs & 3U, 2U);
    const double there = position();
    ASSERT_TRUE(network->setPoint(1, 60000, 40000)); // further in: refused
    network->run(1s);
    EXPECT_NEAR(position(), there, 50);
    ASSERT_TRUE(network->setPoint(1, 0, 40000));
    ASSERT_TRUE(arrive());
    EXPECT_NEAR(position(), 0, 10);
    EXPECT_EQ(network->in(1).digitalInputs & 3U, 0U);
}

// Profile velocity.

TEST_F(DriveModeTest, velocityModeFollowsItsTargetBothWays)
{
    startIn(3);
    network->out(1).targetVelocity = 30000;
    network->run(1s);
    EXPECT_NEAR(network->in(1).velocity, 30000, 30);
    EXPECT_TRUE(network->status(1, 0x1400, 0x0400));
    network->out(1).targetVelocity = -5000;
    network->run(1s);
    EXPECT_NEAR(network->in(1).velocity, -5000, 30);
    network->out(1).targetVelocity = 0;
    network->run(1s);
    EXPECT_EQ(network->in(1).velocity, 0);
    EXPECT_TRUE(network->status(1, 0x1400, 0x1400)); // at speed, and the speed is zero
}

TEST_F(DriveModeTest, maximumSpeedHoldsBothModes)
{
    start();
    ASSERT_EQ(network->write(1, {0x607F, 0}, 8000, 4).status, SdoStatus::Done);
    ASSERT_TRUE(network->enable(1, 3));
    network->out(1).targetVelocity = 30000;
    network->run(1s);
    EXPECT_NEAR(network->in(1).velocity, 8000, 30);
}

TEST_F(DriveModeTest, haltHoldsAVelocity)
{
    startIn(3);
    network->out(1).targetVelocity = 10000;
    network->run(500ms);
    network->out(1).controlWord = 0x10F;
    network->run(500ms);
    EXPECT_EQ(network->in(1).velocity, 0);
    network->out(1).controlWord = 0x0F;
    network->run(500ms);
    EXPECT_NEAR(network->in(1).velocity, 10000, 30);
}

TEST_F(DriveModeTest, changingTheModeOnTheWayStopsWithoutAJump)
{
    startIn(3);
    network->out(1).targetVelocity = 40000;
    network->run(1s);
    network->out(1).mode = 1;
    double previous = network->drive(1).plantVelocity();
    for (int i = 0; i < 1000; ++i) {
        network->cycle();
        const double velocity = network->drive(1).plantVelocity();
        ASSERT_LE(std::abs(velocity - previous), 600);
        previous = velocity;
    }
    EXPECT_EQ(network->in(1).velocity, 0);
    EXPECT_TRUE(network->reached(1));
}

TEST_F(DriveModeTest, reversedPolarityTurnsTheShaftTheOtherWay)
{
    SimulatedDriveConfig config;
    config.upperLimitSwitch = 10000;
    start(config);
    ASSERT_EQ(network->write(1, {0x607E, 0}, 1, 1).status, SdoStatus::Done);
    ASSERT_TRUE(network->enable(1, 1));
    EXPECT_EQ(network->write(1, {0x607E, 0}, 0, 1).abort, SdoAbort::DeviceState);
    ASSERT_TRUE(network->setPoint(1, 5000, 20000));
    ASSERT_TRUE(arrive());
    EXPECT_NEAR(position(), -5000, 10);
    EXPECT_NEAR(network->in(1).position, 5000, 10);
    ASSERT_TRUE(network->setPoint(1, -50000, 20000));
    network->run(3s);
    EXPECT_EQ(network->in(1).digitalInputs & 3U, 1U); // the plant's upper switch is now the negative one
}

TEST_F(DriveModeTest, refusesModesItHasNot)
{
    start();
    for (const std::int64_t mode : {2, 4, 5, 7, 8, -1})
        EXPECT_NE(network->write(1, {0x6060, 0}, mode, 1).status, SdoStatus::Done) << mode;
    EXPECT_EQ(network->readNumber(1, {0x6502, 0}, DataType::Udint), 0x25);
}

TEST_F(DriveModeTest, demandFollowsTheProfileAndActualLagsBehind)
{
    startIn(1);
    ASSERT_TRUE(network->setPoint(1, 100000, 50000));
    network->run(1s);
    const int lag = network->in(1).demandPosition - network->in(1).position;
    EXPECT_GT(lag, 20);
    EXPECT_LT(lag, 400);
    EXPECT_GT(network->in(1).torque, 10);
}
