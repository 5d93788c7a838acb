#include "tests/core/fieldbus/slavefixture.h"

#include <gtest/gtest.h>

using namespace camwright;

namespace {

class CanopenSlaveTest : public testing::Test {
protected:
    TestDevice device;
};

} // namespace

TEST_F(CanopenSlaveTest, announcesItselfAndWaitsPreOperational)
{
    ASSERT_EQ(device.port.frames.size(), 1U);
    EXPECT_EQ(device.port.frames[0], dataFrame(0x705, {0}));
    EXPECT_EQ(device.slave.state(), NmtState::PreOperational);
}

TEST_F(CanopenSlaveTest, followsNmtCommandsToItselfAndToAll)
{
    device.nmt(NmtCommand::Start);
    EXPECT_EQ(device.slave.state(), NmtState::Operational);
    device.slave.receive(nmtFrame(NmtCommand::Stop, 0), Time{0});
    EXPECT_EQ(device.slave.state(), NmtState::Stopped);
    device.slave.receive(nmtFrame(NmtCommand::Start, 6), Time{0});
    EXPECT_EQ(device.slave.state(), NmtState::Stopped);
    device.nmt(NmtCommand::EnterPreOperational);
    EXPECT_EQ(device.slave.state(), NmtState::PreOperational);
}

TEST_F(CanopenSlaveTest, isDeafToSdoWhileStopped)
{
    device.nmt(NmtCommand::Stop);
    EXPECT_EQ(device.sdo({0x40, 0x41, 0x60, 0, 0, 0, 0, 0}), CanFrame{});
}

TEST_F(CanopenSlaveTest, resetCommunicationForgetsItsConfigurationAndAnnouncesItself)
{
    device.mapTransmit(255);
    device.write({0x100C, 0}, 500, 2);
    device.port.take();
    device.nmt(NmtCommand::ResetCommunication);
    EXPECT_EQ(device.port.frames.at(0), dataFrame(0x705, {0}));
    EXPECT_EQ(device.dictionary.number({0x100C, 0}), 0);
    EXPECT_EQ(device.dictionary.number({0x1A00, 0}), 0);
    EXPECT_EQ(device.dictionary.number({0x1800, 1}), 0x80000185);
    EXPECT_EQ(device.resets, 0);
}

TEST_F(CanopenSlaveTest, resetNodeIsTheApplicationsAffair)
{
    device.nmt(NmtCommand::ResetNode);
    EXPECT_EQ(device.resets, 1);
    EXPECT_FALSE(device.slave.isRunning());
    EXPECT_EQ(device.sdo({0x40, 0x41, 0x60, 0, 0, 0, 0, 0}), CanFrame{});
}

TEST_F(CanopenSlaveTest, answersGuardingWithAToggleThatStartsAtZero)
{
    device.nmt(NmtCommand::Start);
    device.port.take();
    for (const std::uint8_t expected : {0x05, 0x85, 0x05}) {
        device.slave.receive(guardRequest(5), Time{0});
        EXPECT_EQ(device.port.take().at(0), dataFrame(0x705, {expected}));
    }
    device.nmt(NmtCommand::ResetCommunication);
    device.port.take();
    device.slave.receive(guardRequest(5), Time{0});
    EXPECT_EQ(device.port.take().at(0), dataFrame(0x705, {0x7F}));
}

TEST_F(CanopenSlaveTest, lifeGuardingBeginsWithTheFirstQuestion)
{
    device.write({0x100C, 0}, 100, 2);
    device.write({0x100D, 0}, 3, 1);
    device.nmt(NmtCommand::Start);
    device.slave.step(10s);
    EXPECT_FALSE(device.lifeLost);
    device.slave.receive(guardRequest(5), 10s);
    device.slave.step(10s + 299ms);
    EXPECT_FALSE(device.lifeLost);
    device.slave.step(10s + 300ms);
    EXPECT_TRUE(device.lifeLost);
    EXPECT_EQ(device.slave.state(), NmtState::PreOperational);
    device.slave.receive(guardRequest(5), 11s);
    EXPECT_FALSE(device.lifeLost);
}

TEST_F(CanopenSlaveTest, producesHeartbeats)
{
    device.write({0x1017, 0}, 50, 2);
    device.port.take();
    for (int i = 1; i <= 200; ++i)
        device.slave.step(i * 1ms);
    const auto frames = device.port.take();
    ASSERT_EQ(frames.size(), 4U);
    EXPECT_EQ(frames[0], dataFrame(0x705, {0x7F}));
}

TEST_F(CanopenSlaveTest, sendsEmergenciesAndRemembersThem)
{
    device.port.take();
    device.slave.sendEmergency(0x8611, 0x21, {1, 2, 3, 4, 5}, Time{0});
    device.slave.sendEmergency(0x4310, 0x09, {}, Time{0});
    device.slave.sendEmergency(0, 0, {}, Time{0});
    const auto frames = device.port.take();
    ASSERT_EQ(frames.size(), 3U);
    EXPECT_EQ(frames[0], dataFrame(0x085, {0x11, 0x86, 0x21, 1, 2, 3, 4, 5}));
    EXPECT_EQ(device.dictionary.number({0x1003, 0}), 2);
    EXPECT_EQ(device.dictionary.number({0x1003, 1}), 0x4310);
    EXPECT_EQ(device.dictionary.number({0x1003, 2}), 0x8611);
    EXPECT_EQ(device.dictionary.number({0x1001, 0}), 0);
    EXPECT_EQ(device.write({0x1003, 0}, 0, 1), SdoAbort::None);
    EXPECT_EQ(device.write({0x1003, 0}, 1, 1), SdoAbort::ValueTooHigh);
}

TEST_F(CanopenSlaveTest, mappingChangesOnlyWhileThePdoIsOffAndItsCountIsZero)
{
    device.mapTransmit(255);
    EXPECT_EQ(device.write({0x1A00, 0}, 0, 1), SdoAbort::UnsupportedAccess);
    EXPECT_EQ(device.write({0x1800, 1}, 0x80000185, 4), SdoAbort::None);
    EXPECT_EQ(device.write({0x1A00, 1}, 0x60640020, 4), SdoAbort::UnsupportedAccess);
    EXPECT_EQ(device.write({0x1A00, 0}, 0, 1), SdoAbort::None);
    EXPECT_EQ(device.write({0x1A00, 1}, 0x60640020, 4), SdoAbort::None);
    EXPECT_EQ(device.write({0x1A00, 0}, 1, 1), SdoAbort::None);
}

TEST_F(CanopenSlaveTest, refusesMappingsThatCannotBe)
{
    EXPECT_EQ(device.write({0x1A00, 1}, 0x70000010, 4), SdoAbort::NoSuchObject);
    EXPECT_EQ(device.write({0x1A00, 1}, 0x20000140, 4), SdoAbort::NotMappable);
    EXPECT_EQ(device.write({0x1A00, 1}, 0x60410020, 4), SdoAbort::NotMappable); // 16 bits, not 32
    EXPECT_EQ(device.write({0x1600, 1}, 0x60410010, 4), SdoAbort::NotMappable); // read-only cannot be received
    for (std::uint8_t sub = 1; sub <= 3; ++sub)
        EXPECT_EQ(device.write({0x1A00, sub}, 0x60640020, 4), SdoAbort::None);
    EXPECT_EQ(device.write({0x1A00, 0}, 3, 1), SdoAbort::PdoTooLong);
    EXPECT_EQ(device.write({0x1A00, 0}, 4, 1), SdoAbort::NoSuchObject);
    EXPECT_EQ(device.write({0x1A00, 0}, 9, 1), SdoAbort::PdoTooLong);
    EXPECT_EQ(device.write({0x1A00, 0}, 2, 1), SdoAbort::None);
}

TEST_F(CanopenSlaveTest, refusesIdentifiersThatBelongToOthers)
{
    EXPECT_EQ(device.write({0x1800, 1}, 0x605, 4), SdoAbort::ValueRange);
    EXPECT_EQ(device.write({0x1800, 1}, 0x000, 4), SdoAbort::ValueRange);
    EXPECT_EQ(device.write({0x1800, 1}, 0x20000185, 4), SdoAbort::ValueRange);
    EXPECT_EQ(device.write({0x1800, 1}, 0x185, 4), SdoAbort::None);
    EXPECT_EQ(device.write({0x1800, 1}, 0x186, 4), SdoAbort::ParameterIncompatible);
    EXPECT_EQ(device.write({0x1800, 3}, 10, 2), SdoAbort::ParameterIncompatible);
    EXPECT_EQ(device.write({0x1800, 2}, 250, 1), SdoAbort::ValueRange);
}

TEST_F(CanopenSlaveTest, sendsOnChangeAfterTheInhibitTime)
{
    device.mapTransmit(255, 100); // 10 ms
    device.nmt(NmtCommand::Start);
    device.sentPdos();
    int sent = 0;
    for (int i = 1; i <= 100; ++i) {
        device.dictionary.setNumber({0x6064, 0}, i);
        device.slave.step(i * 1ms);
        sent += static_cast<int>(device.sentPdos().size());
    }
    EXPECT_EQ(sent, 10); // at 1, 11 … 91 ms
    device.slave.step(101ms);
    const auto last = device.sentPdos();
    ASSERT_EQ(last.size(), 1U);
    EXPECT_EQ(last[0], dataFrame(0x185, {0, 0, 100, 0, 0, 0}));
    for (int i = 102; i <= 300; ++i)
        device.slave.step(i * 1ms);
    EXPECT_TRUE(device.sentPdos().empty());
}

TEST_F(CanopenSlaveTest, repeatsByTheEventTimer)
{
    device.mapTransmit(254, 0, 20);
    device.nmt(NmtCommand::Start);
    device.sentPdos();
    for (int i = 1; i <= 101; ++i)
        device.slave.step(i * 1ms);
    EXPECT_EQ(device.sentPdos().size(), 6U); // at 1, 21 … 101 ms
}

TEST_F(CanopenSlaveTest, aFullPortLosesNoPdo)
{
    device.mapTransmit(255);
    device.nmt(NmtCommand::Start);
    device.port.full = true;
    device.slave.step(1ms);
    EXPECT_EQ(device.slave.unsentFrames(), 1U);
    device.port.full = false;
    device.slave.step(2ms);
    EXPECT_EQ(device.sentPdos().size(), 1U);
}

TEST_F(CanopenSlaveTest, synchronousPdosFollowTheSync)
{
    device.mapTransmit(3);
    device.nmt(NmtCommand::Start);
    device.slave.step(1ms);
    EXPECT_TRUE(device.sentPdos().empty());
    int sent = 0;
    for (int i = 0; i < 9; ++i) {
        device.slave.receive(syncFrame(), 2ms);
        sent += static_cast<int>(device.sentPdos().size());
    }
    EXPECT_EQ(sent, 3);
}

TEST_F(CanopenSlaveTest, anAcyclicSynchronousPdoIsSentOnSyncWhenItChanged)
{
    device.mapTransmit(0);
    device.nmt(NmtCommand::Start);
    device.slave.receive(syncFrame(), 1ms);
    EXPECT_EQ(device.sentPdos().size(), 1U);
    device.slave.receive(syncFrame(), 2ms);
    EXPECT_EQ(device.sentPdos().size(), 0U);
    device.dictionary.setNumber({0x6041, 0}, 7);
    device.slave.receive(syncFrame(), 3ms);
    EXPECT_EQ(device.sentPdos().size(), 1U);
}

TEST_F(CanopenSlaveTest, aReceivedPdoIsStoredWholeBeforeTheControlWordActs)
{
    device.mapReceive(255);
    device.nmt(NmtCommand::Start);
    device.log.clear();
    device.slave.receive(dataFrame(0x205, {0x1F, 0, 0x10, 0x27, 0, 0}), 1ms);
    EXPECT_EQ(device.targetAtControlWord, 10000);
    ASSERT_EQ(device.log.size(), 2U);
    EXPECT_EQ(device.log[0].second, 0x1F);
}

TEST_F(CanopenSlaveTest, aSynchronousReceivedPdoWaitsForTheSync)
{
    device.mapReceive(1);
    device.nmt(NmtCommand::Start);
    device.slave.receive(dataFrame(0x205, {0x1F, 0, 1, 0, 0, 0}), 1ms);
    EXPECT_EQ(device.dictionary.number({0x607A, 0}), 0);
    device.slave.receive(syncFrame(), 2ms);
    EXPECT_EQ(device.dictionary.number({0x607A, 0}), 1);
}

TEST_F(CanopenSlaveTest, aPdoTooShortIsReportedAndIgnored)
{
    device.mapReceive(255);
    device.nmt(NmtCommand::Start);
    device.port.take();
    device.slave.receive(dataFrame(0x205, {0x1F, 0, 1}), 1ms);
    EXPECT_EQ(device.dictionary.number({0x6040, 0}), 0);
    const auto frames = device.port.take();
    ASSERT_EQ(frames.size(), 1U);
    EXPECT_EQ(frames[0].id, 0x085U);
    EXPECT_EQ(frames[0].data[0] | frames[0].data[1] << 8, 0x8210);
}

TEST_F(CanopenSlaveTest, aValueTheDeviceRefusesIsNotTakenFromAPdo)
{
    device.mapReceive(255);
    device.nmt(NmtCommand::Start);
    device.slave.receive(dataFrame(0x205, {0xAD, 0x0B, 5, 0, 0, 0}), 1ms);
    EXPECT_EQ(device.dictionary.number({0x6040, 0}), 0);
    EXPECT_EQ(device.dictionary.number({0x607A, 0}), 5);
}

TEST_F(CanopenSlaveTest, pdosAreExchangedOnlyWhileOperational)
{
    device.mapReceive(255);
    device.mapTransmit(255);
    device.slave.receive(dataFrame(0x205, {1, 0, 1, 0, 0, 0}), 1ms);
    device.slave.step(1ms);
    EXPECT_EQ(device.dictionary.number({0x607A, 0}), 0);
    EXPECT_TRUE(device.sentPdos().empty());
}

TEST_F(CanopenSlaveTest, readsExpeditedAndInSegments)
{
    device.dictionary.setNumber({0x6041, 0}, 0x1234);
    EXPECT_EQ(device.sdo({0x40, 0x41, 0x60, 0, 0, 0, 0, 0}), dataFrame(0x585, {0x4B, 0x41, 0x60, 0, 0x34, 0x12, 0, 0}));
    EXPECT_EQ(device.sdo({0x40, 0x08, 0x10, 0, 0, 0, 0, 0}), dataFrame(0x585, {0x41, 0x08, 0x10, 0, 25, 0, 0, 0}));
    EXPECT_EQ(device.sdo({0x60, 0, 0, 0, 0, 0, 0, 0}), dataFrame(0x585, {0x00, 'C', 'a', 'm', 'w', 'r', 'i', 'g'}));
    EXPECT_EQ(device.sdo({0x70, 0, 0, 0, 0, 0, 0, 0}).data[0], 0x10);
    EXPECT_EQ(device.sdo({0x60, 0, 0, 0, 0, 0, 0, 0}).data[0], 0x00);
    EXPECT_EQ(device.sdo({0x70, 0, 0, 0, 0, 0, 0, 0}), dataFrame(0x585, {0x17, 'r', 'i', 'v', 'e', 0, 0, 0}));
    EXPECT_EQ(TestDevice::abortOf(device.sdo({0x60, 0, 0, 0, 0, 0, 0, 0})), SdoAbort::UnknownCommand);
}

TEST_F(CanopenSlaveTest, abortsAReadWhoseToggleStandsStill)
{
    device.sdo({0x40, 0x08, 0x10, 0, 0, 0, 0, 0});
    device.sdo({0x60, 0, 0, 0, 0, 0, 0, 0});
    EXPECT_EQ(TestDevice::abortOf(device.sdo({0x60, 0, 0, 0, 0, 0, 0, 0})), SdoAbort::ToggleNotAlternated);
}

TEST_F(CanopenSlaveTest, writesInSegmentsAndChecksTheLength)
{
    EXPECT_EQ(device.sdo({0x21, 0x00, 0x20, 1, 8, 0, 0, 0}).data[0], 0x60);
    EXPECT_EQ(device.sdo({0x00, 1, 2, 3, 4, 5, 6, 7}).data[0], 0x20);
    EXPECT_EQ(device.sdo({0x1D, 8, 0, 0, 0, 0, 0, 0}).data[0], 0x30);
    EXPECT_EQ(device.dictionary.number({0x2000, 1}), 0x0807060504030201);
    device.sdo({0x21, 0x00, 0x20, 1, 9, 0, 0, 0});
    device.sdo({0x00, 1, 2, 3, 4, 5, 6, 7});
    EXPECT_EQ(TestDevice::abortOf(device.sdo({0x1D, 8, 0, 0, 0, 0, 0, 0})), SdoAbort::LengthMismatch);
}

TEST_F(CanopenSlaveTest, takesAnExpeditedWriteWithoutASizeAsLongAsTheObject)
{
    EXPECT_EQ(device.sdo({0x22, 0x40, 0x60, 0, 6, 0, 0, 0}).data[0], 0x60);
    EXPECT_EQ(device.dictionary.number({0x6040, 0}), 6);
}

TEST_F(CanopenSlaveTest, givesTheAbortCodeThatFits)
{
    EXPECT_EQ(device.write({0x7000, 0}, 0, 1), SdoAbort::NoSuchObject);
    EXPECT_EQ(device.write({0x2000, 2}, 0, 1), SdoAbort::NoSuchSubindex);
    EXPECT_EQ(device.write({0x6041, 0}, 0, 2), SdoAbort::ReadOnly);
    EXPECT_EQ(device.write({0x6040, 0}, 0, 4), SdoAbort::TooLong);
    EXPECT_EQ(device.write({0x607A, 0}, 0, 2), SdoAbort::TooShort);
    EXPECT_EQ(device.write({0x6040, 0}, 0xBAD, 2), SdoAbort::LocalControl);
    EXPECT_EQ(TestDevice::abortOf(device.sdo({0xC0, 0x41, 0x60, 0, 0, 0, 0, 0})), SdoAbort::UnknownCommand);
    EXPECT_EQ(TestDevice::abortOf(device.sdo({0x21, 0x00, 0x20, 1, 0, 0, 1, 0})), SdoAbort::OutOfMemory);
}

TEST_F(CanopenSlaveTest, survivesAnyFrame)
{
    std::uint64_t state = 1;
    device.nmt(NmtCommand::Start);
    for (int i = 0; i < 50000; ++i) {
        state = state * 6364136223846793005ULL + 1442695040888963407ULL;
        CanFrame frame;
        const std::uint32_t ids[] = {0x605, 0x605, 0x605, 0x205, 0x080, 0x705, 0x305};
        frame.id = ids[(state >> 33) % 7];
        frame.remote = (state >> 40) % 16 == 0;
        frame.length = static_cast<std::uint8_t>((state >> 44) % 4 == 0 ? (state >> 50) % 9 : 8);
        for (unsigned byte = 0; byte < 8; ++byte)
            frame.data[byte] = static_cast<std::uint8_t>((state * (byte + 3)) >> 41);
        if ((state >> 20) % 3 == 0) {
            const std::uint16_t indices[] = {0x1400, 0x1600, 0x1800, 0x1A00, 0x1A03, 0x2000, 0x1008, 0x607A};
            frame.data[1] = static_cast<std::uint8_t>(indices[state >> 61]);
            frame.data[2] = static_cast<std::uint8_t>(indices[state >> 61] >> 8);
            frame.data[3] %= 9;
        }
        device.slave.receive(frame, i * 1ms);
        device.slave.step(i * 1ms);
        device.port.take();
    }
    EXPECT_TRUE(device.slave.isRunning());
}
