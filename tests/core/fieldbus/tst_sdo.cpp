#include "core/fieldbus/sdo.h"

#include "tests/core/fieldbus/slavefixture.h"

#include <gtest/gtest.h>

using namespace camwright;

namespace {

/// A client against the real server, frame by frame.
class SdoTest : public testing::Test {
protected:
    SdoStatus run(CanFrame request)
    {
        for (int i = 0; i < 1000; ++i) {
            device.port.take();
            device.slave.receive(request, Time{0});
            if (device.port.frames.empty() || !client.receive(device.port.frames.back(), request))
                break;
        }
        return client.status();
    }
    TestDevice device;
    SdoTransfer client;
};

} // namespace

TEST_F(SdoTest, readsAndWritesExpedited)
{
    const Bytes data{0x10, 0x27, 0, 0};
    EXPECT_EQ(run(client.startWrite(5, 0x607A, 0, data)), SdoStatus::Done);
    EXPECT_EQ(run(client.startRead(5, 0x607A, 0)), SdoStatus::Done);
    EXPECT_EQ(client.data(), data);
}
TEST_F(SdoTest, readsAndWritesInSegments)
{
    EXPECT_EQ(run(client.startRead(5, 0x1008, 0)), SdoStatus::Done);
    EXPECT_EQ(std::string(client.data().begin(), client.data().end()), "Camwright simulated drive");
    const Bytes eight{1, 2, 3, 4, 5, 6, 7, 8};
    EXPECT_EQ(run(client.startWrite(5, 0x2000, 1, eight)), SdoStatus::Done);
    EXPECT_EQ(run(client.startRead(5, 0x2000, 1)), SdoStatus::Done);
    EXPECT_EQ(client.data(), eight);
}
TEST_F(SdoTest, bringsTheAbortCode)
{
    EXPECT_EQ(run(client.startRead(5, 0x7000, 0)), SdoStatus::Aborted);
    EXPECT_EQ(client.abort(), SdoAbort::NoSuchObject);
    const Bytes nine(9, 0);
    EXPECT_EQ(run(client.startWrite(5, 0x2000, 1, nine)), SdoStatus::Aborted);
    EXPECT_EQ(client.abort(), SdoAbort::TooLong);
}
TEST_F(SdoTest, abortsAnAnswerThatDoesNotFit)
{
    client.startRead(5, 0x6041, 0);
    CanFrame reply;
    EXPECT_TRUE(client.receive(dataFrame(0x585, {0x60, 0x41, 0x60, 0, 0, 0, 0, 0}), reply));
    EXPECT_EQ(client.status(), SdoStatus::Malformed);
    EXPECT_EQ(reply, dataFrame(0x605, {0x80, 0x41, 0x60, 0, 0x01, 0, 0x04, 0x05}));
}
TEST_F(SdoTest, overlooksTheLateAnswerOfAnotherRequest)
{
    client.startRead(5, 0x6041, 0);
    CanFrame reply;
    EXPECT_FALSE(client.receive(dataFrame(0x585, {0x4B, 0x64, 0x60, 0, 9, 9, 0, 0}), reply));
    EXPECT_FALSE(client.receive(dataFrame(0x585, {0x80, 0x64, 0x60, 0, 9, 9, 0, 0}), reply));
    EXPECT_EQ(client.status(), SdoStatus::Pending);
}
TEST_F(SdoTest, refusesAnAnswerWithoutEnd)
{
    client.startRead(5, 0x1008, 0);
    CanFrame reply;
    ASSERT_TRUE(client.receive(dataFrame(0x585, {0x40, 0x08, 0x10, 0, 0, 0, 0, 0}), reply));
    for (int i = 0; i < 1000 && client.status() == SdoStatus::Pending; ++i)
        client.receive(dataFrame(0x585, {static_cast<std::uint8_t>(i % 2 != 0 ? 0x10 : 0), 1, 2, 3, 4, 5, 6, 7}), reply);
    EXPECT_EQ(client.status(), SdoStatus::Malformed);
    EXPECT_LE(client.data().size(), SdoTransfer::kMaximumBytes);
}
TEST_F(SdoTest, announcesATooLargeAnswerAsTooLarge)
{
    client.startRead(5, 0x1008, 0);
    CanFrame reply;
    EXPECT_TRUE(client.receive(dataFrame(0x585, {0x41, 0x08, 0x10, 0, 0xFF, 0xFF, 0xFF, 0xFF}), reply));
    EXPECT_EQ(client.status(), SdoStatus::Malformed);
}
TEST_F(SdoTest, tellsTheServerOfATimeOut)
{
    client.startRead(5, 0x6041, 0);
    EXPECT_EQ(client.timeOut(), dataFrame(0x605, {0x80, 0x41, 0x60, 0, 0, 0, 0x04, 0x05}));
    EXPECT_EQ(client.status(), SdoStatus::TimedOut);
}
TEST_F(SdoTest, everyNamedAbortHasAText)
{
    EXPECT_EQ(sdoAbortText(SdoAbort::ValueTooHigh), "value too high");
    EXPECT_EQ(sdoAbortText(static_cast<SdoAbort>(0x12345678)), "unknown reason");
}
