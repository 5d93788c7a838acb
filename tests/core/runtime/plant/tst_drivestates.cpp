#include "tests/core/runtime/plant/networkfixture.h"

#include <gtest/gtest.h>

#include <cstdlib>

using namespace camwright;

namespace {

class DriveStateTest : public testing::Test {
protected:
    void SetUp() override
    {
        MasterNodeConfig node;
        node.inhibitTime = 1ms;
        network = std::make_unique<Network>(1, 1'000'000, SimulatedDriveConfig{}, node);
        ASSERT_TRUE(network->boot());
        ASSERT_TRUE(network->until([&] { return network->status(1, 0x4F, 0x40); }, 100ms));
    }
    DriveState command(std::uint16_t word)
    {
        network->out(1).controlWord = word;
        network->run(5ms);
        return network->drive(1).state();
    }
    void enableVelocity(std::int32_t velocity)
    {
        ASSERT_TRUE(network->enable(1, 3));
        network->out(1).targetVelocity = velocity;
        network->run(2s);
        ASSERT_NEAR(network->drive(1).plantVelocity(), velocity, 50);
    }
    std::unique_ptr<Network> network;
};

} // namespace

TEST_F(DriveStateTest, climbsToOperationEnabledAndBack)
{
    EXPECT_EQ(command(0x0F), DriveState::SwitchOnDisabled); // shutdown has to come first
    EXPECT_EQ(command(0x06), DriveState::ReadyToSwitchOn);
    EXPECT_EQ(command(0x07), DriveState::SwitchedOn);
    EXPECT_EQ(command(0x0F), DriveState::OperationEnabled);
    EXPECT_EQ(command(0x07), DriveState::SwitchedOn);
    EXPECT_EQ(command(0x06), DriveState::ReadyToSwitchOn);
    EXPECT_EQ(command(0x00), DriveState::SwitchOnDisabled);
}

TEST_F(DriveStateTest, goesFromReadyToEnabledInOneStep)
{
    command(0x06);
    EXPECT_EQ(command(0x0F), DriveState::OperationEnabled);
    EXPECT_EQ(command(0x06), DriveState::ReadyToSwitchOn);
}

TEST_F(DriveStateTest, showsEveryStateInTheStatusWord)
{
    EXPECT_TRUE(network->status(1, 0x4F, 0x40));
    command(0x06);
    EXPECT_TRUE(network->status(1, 0x6F, 0x21));
    command(0x07);
    EXPECT_TRUE(network->status(1, 0x6F, 0x23));
    command(0x0F);
    EXPECT_TRUE(network->status(1, 0x6F, 0x27));
    EXPECT_TRUE(network->status(1, 0x210, 0x210)); // voltage on, remote
}

TEST_F(DriveStateTest, disablingOperationRampsDownFirst)
{
    enableVelocity(50000);
    network->out(1).controlWord = 0x07;
    network->run(20ms);
    EXPECT_EQ(network->drive(1).state(), DriveState::OperationEnabled);
    ASSERT_TRUE(network->until([&] { return network->drive(1).state() == DriveState::SwitchedOn; }, 1s));
    EXPECT_NEAR(network->drive(1).plantVelocity(), 0, 3000);
}

TEST_F(DriveStateTest, disablingVoltageLetsTheShaftRunOut)
{
    enableVelocity(50000);
    EXPECT_EQ(command(0x00), DriveState::SwitchOnDisabled);
    EXPECT_GT(network->drive(1).plantVelocity(), 40000);
    EXPECT_EQ(network->in(1).torque, 0);
    network->run(3s);
    EXPECT_EQ(network->drive(1).plantVelocity(), 0);
}

TEST_F(DriveStateTest, quickStopFollowsItsOption)
{
    for (const std::int64_t option : {0, 1, 2, 5, 6}) {
        SCOPED_TRACE(option);
        command(0x00);
        network->run(3s);
        ASSERT_EQ(network->write(1, {0x605A, 0}, option, 2).status, SdoStatus::Done);
        enableVelocity(50000);
        const Time start = network->now;
        network->out(1).controlWord = 0x02;
        if (option == 0) {
            network->run(5ms);
            EXPECT_EQ(network->drive(1).state(), DriveState::SwitchOnDisabled);
            continue;
        }
        network->run(4ms);
        EXPECT_EQ(network->drive(1).state(), DriveState::QuickStopActive);
        EXPECT_TRUE(network->until([&] { return std::abs(network->drive(1).plantVelocity()) < 500; }, 1s));
        const Time took = network->now - start;
        // 50000 counts/s by 200000 counts/s² or, quick, by 1000000.
        const bool slow = option == 1 || option == 5;
        EXPECT_GT(took, slow ? 240ms : 40ms);
        EXPECT_LT(took, slow ? 340ms : 140ms);
        network->run(300ms);
        EXPECT_EQ(network->drive(1).state(), option >= 5 ? DriveState::QuickStopActive : DriveState::SwitchOnDisabled);
        if (option >= 5) {
            network->out(1).targetVelocity = 0;
            EXPECT_EQ(command(0x0F), DriveState::OperationEnabled);
        }
    }
}

TEST_F(DriveStateTest, aFaultStopsReportsAndNeedsARisingResetBit)
{
    enableVelocity(30000);
    network->drive(1).injectFault(0x4310, network->now);
    network->run(3ms);
    EXPECT_EQ(network->drive(1).state(), DriveState::FaultReaction);
    ASSERT_TRUE(network->until([&] { return network->drive(1).state() == DriveState::Fault; }, 1s));
    network->run(10ms);
    EXPECT_TRUE(network->status(1, 0x4F, 0x08));
    EXPECT_EQ(network->in(1).errorCode, 0x4310);
    ASSERT_EQ(network->master->emergencies().size(), 1U);
    EXPECT_EQ(network->master->emergencies()[0].errorCode, 0x4310);
    EXPECT_EQ(network->master->emergencies()[0].errorRegister, 0x09);
    EXPECT_EQ(command(0x0F), DriveState::Fault);
    EXPECT_EQ(command(0x80), DriveState::SwitchOnDisabled);
    EXPECT_EQ(network->in(1).errorCode, 0);
    EXPECT_EQ(network->master->emergencies().back().errorCode, 0);
    network->drive(1).injectFault(0x4310, network->now);
    EXPECT_EQ(command(0x80), DriveState::Fault); // held, not risen
    EXPECT_EQ(command(0x00), DriveState::Fault);
    EXPECT_EQ(command(0x80), DriveState::SwitchOnDisabled);
}

TEST_F(DriveStateTest, aJammedShaftGivesAFollowingError)
{
    ASSERT_TRUE(network->enable(1, 1));
    network->drive(1).setBlocked(true);
    ASSERT_TRUE(network->setPoint(1, 100000, 50000));
    ASSERT_TRUE(network->until([&] { return network->drive(1).state() == DriveState::Fault; }, 2s));
    network->run(5ms);
    EXPECT_EQ(network->in(1).errorCode, 0x8611);
    EXPECT_EQ(network->in(1).position, 0);
}

TEST_F(DriveStateTest, aSilentMasterIsTakenAs6007Says)
{
    for (const std::int64_t option : {0, 1, 2, 3}) {
        SCOPED_TRACE(option);
        MasterNodeConfig node;
        node.guardTime = 50ms;
        Network guarded(1, 1'000'000, SimulatedDriveConfig{}, node);
        ASSERT_TRUE(guarded.boot());
        ASSERT_EQ(guarded.write(1, {0x6007, 0}, option, 2).status, SdoStatus::Done);
        ASSERT_TRUE(guarded.enable(1, 3));
        guarded.out(1).targetVelocity = 20000;
        guarded.run(500ms);
        guarded.bus.setConnected(0, false);
        const Time lost = guarded.now;
        ASSERT_TRUE(guarded.until([&] { return guarded.drive(1).slave().lifeLost(); }, 1s));
        EXPECT_LE(guarded.now - lost, 151ms);
        guarded.run(500ms);
        const DriveState expected[] = {DriveState::OperationEnabled, DriveState::Fault, DriveState::SwitchOnDisabled, DriveState::SwitchOnDisabled};
        EXPECT_EQ(guarded.drive(1).state(), expected[option]);
        if (option != 2) { // 2 lets the shaft run out
            EXPECT_NEAR(guarded.drive(1).plantVelocity(), option == 0 ? 20000 : 0, 100);
        }
    }
}

TEST_F(DriveStateTest, resetNodeStartsAnew)
{
    enableVelocity(10000);
    network->master->sendNmt(NmtCommand::ResetNode, 1);
    network->run(10ms);
    EXPECT_EQ(network->drive(1).state(), DriveState::NotReady);
    network->run(200ms);
    EXPECT_EQ(network->drive(1).state(), DriveState::SwitchOnDisabled);
    EXPECT_EQ(network->master->nodeState(1), NodeState::Lost);
}
