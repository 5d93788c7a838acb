#include "core/runtime/plant/canwire.h"

#include "core/fieldbus/canbits.h"

#include <gtest/gtest.h>

#include <vector>

using namespace camwright;

namespace {

struct Heard {
    unsigned node;
    CanFrame frame;
    Time at;
};

class CanWireTest : public testing::Test {
protected:
    CanWireTest()
    {
        for (int i = 0; i < 3; ++i)
            wire.addNode(4);
    }
    static CanFrame frame(std::uint32_t id, std::uint8_t value = 0)
    {
        CanFrame out;
        out.id = id;
        out.length = 1;
        out.data[0] = value;
        return out;
    }
    void advance(Time until)
    {
        wire.advance(until, [this](unsigned node, const CanFrame& received, Time at) { heard.push_back({node, received, at}); });
    }
    CanWire wire{500'000};
    std::vector<Heard> heard;
};

} // namespace

TEST_F(CanWireTest, deliversAtTheFramesEndToAllOthers)
{
    const CanFrame sent = frame(0x123, 7);
    EXPECT_TRUE(wire.port(1).send(sent));
    const Time end = bitTime(frameBits(sent), 500'000);
    advance(end - 1ns);
    EXPECT_TRUE(heard.empty());
    advance(1ms);
    ASSERT_EQ(heard.size(), 2U);
    EXPECT_EQ(heard[0].node, 0U);
    EXPECT_EQ(heard[1].node, 2U);
    EXPECT_EQ(heard[1].frame, sent);
    EXPECT_EQ(heard[1].at, end);
    EXPECT_EQ(wire.counters().bits, frameBits(sent));
    EXPECT_EQ(wire.now(), 1ms);
}

TEST_F(CanWireTest, theSmallestIdentifierGoesFirst)
{
    wire.port(0).send(frame(0x300));
    wire.port(1).send(frame(0x200));
    wire.port(2).send(frame(0x100));
    advance(5ms);
    ASSERT_EQ(heard.size(), 6U);
    EXPECT_EQ(heard[0].frame.id, 0x100U);
    EXPECT_EQ(heard[2].frame.id, 0x200U);
    EXPECT_EQ(heard[4].frame.id, 0x300U);
}

TEST_F(CanWireTest, aFrameOnTheWireIsNotInterrupted)
{
    wire.port(0).send(frame(0x700));
    advance(10us);
    wire.port(1).send(frame(0x001));
    advance(5ms);
    EXPECT_EQ(heard[0].frame.id, 0x700U);
}

TEST_F(CanWireTest, aNodesOwnFramesKeepTheirOrder)
{
    wire.port(0).send(frame(0x300));
    wire.port(0).send(frame(0x100));
    advance(5ms);
    EXPECT_EQ(heard[0].frame.id, 0x300U);
}

TEST_F(CanWireTest, refusesWhatTheQueueCannotHold)
{
    for (int i = 0; i < 4; ++i)
        EXPECT_TRUE(wire.port(0).send(frame(0x100)));
    EXPECT_FALSE(wire.port(0).send(frame(0x100)));
    EXPECT_EQ(wire.counters().refused, 1U);
    EXPECT_EQ(wire.queued(0), 4U);
    advance(5ms);
    EXPECT_TRUE(wire.isIdle());
    EXPECT_TRUE(wire.port(0).send(frame(0x100)));
}

TEST_F(CanWireTest, aReceiverMayAnswerAtOnce)
{
    wire.port(0).send(frame(0x600));
    Time answered{0};
    wire.advance(5ms, [&](unsigned node, const CanFrame& received, Time at) {
        if (node == 1 && received.id == 0x600)
            wire.port(1).send(frame(0x580));
        if (node == 0)
            answered = at;
    });
    EXPECT_EQ(answered, bitTime(frameBits(frame(0x600)), 500'000) + bitTime(frameBits(frame(0x580)), 500'000));
}

TEST_F(CanWireTest, aDisconnectedNodeHearsNothingAndItsFramesWait)
{
    wire.setConnected(2, false);
    wire.port(2).send(frame(0x100));
    wire.port(0).send(frame(0x200));
    advance(5ms);
    ASSERT_EQ(heard.size(), 1U);
    EXPECT_EQ(heard[0].node, 1U);
    wire.setConnected(2, true);
    advance(10ms);
    EXPECT_EQ(heard.size(), 3U);
}

TEST_F(CanWireTest, aFrameNobodyAcknowledgesIsRepeatedForEver)
{
    wire.setConnected(1, false);
    wire.setConnected(2, false);
    wire.port(0).send(frame(0x100));
    advance(100ms);
    EXPECT_TRUE(heard.empty());
    EXPECT_EQ(wire.queued(0), 1U);
    EXPECT_GT(wire.counters().repeated, 500U);
    wire.setConnected(1, true);
    advance(101ms);
    EXPECT_EQ(heard.size(), 1U);
}

TEST_F(CanWireTest, losesTheFramesItIsToldToLose)
{
    wire.loseFrames(0, 2);
    for (std::uint8_t i = 0; i < 4; ++i)
        wire.port(0).send(frame(0x100, i));
    advance(5ms);
    ASSERT_EQ(heard.size(), 4U);
    EXPECT_EQ(heard[0].frame.data[0], 2);
    EXPECT_EQ(wire.counters().lost, 2U);
    EXPECT_EQ(wire.counters().frames, 4U);
}

TEST_F(CanWireTest, countsTheLoadOverTheLastSecond)
{
    for (int i = 0; i < 2000; ++i) {
        wire.port(0).send(frame(0x155, 0x55));
        advance((i + 1) * 1ms);
    }
    const double busy = static_cast<double>(bitTime(frameBits(frame(0x155, 0x55)), 500'000).count()) * 1e-6;
    EXPECT_NEAR(wire.load(), busy, 1e-9);
    advance(10s);
    EXPECT_EQ(wire.load(), 0);
}

TEST_F(CanWireTest, goesOnFromSavedBytesInTheMiddleOfAFrame)
{
    wire.port(0).send(frame(0x100, 1));
    wire.port(1).send(frame(0x200, 2));
    wire.loseFrames(1, 1);
    wire.setConnected(2, false);
    advance(30us);
    ByteWriter writer;
    wire.save(writer);
    CanWire other(500'000);
    for (int i = 0; i < 3; ++i)
        other.addNode(4);
    ByteReader reader(writer.bytes());
    other.restore(reader);
    ASSERT_TRUE(reader.ok() && reader.atEnd());
    advance(5ms);
    std::vector<Heard> second;
    other.advance(5ms, [&](unsigned node, const CanFrame& received, Time at) { second.push_back({node, received, at}); });
    ASSERT_EQ(second.size(), heard.size());
    EXPECT_EQ(second[0].at, heard[0].at);
    ByteWriter first;
    ByteWriter again;
    wire.save(first);
    other.save(again);
    EXPECT_EQ(first.bytes(), again.bytes());
}

// C19: a stop waits for nothing but the frame that is on the wire
TEST_F(CanWireTest, anUrgentFrameGoesBeforeEverythingThatWaits)
{
    for (std::uint8_t i = 0; i < 4; ++i)
        ASSERT_TRUE(wire.port(0).send(frame(0x300u + i, i)));
    EXPECT_FALSE(wire.port(0).send(frame(0x301, 9)));
    advance(10us); // the first is on the wire
    ASSERT_TRUE(wire.port(0).sendFirst(frame(0x302, 99)));
    advance(10ms);
    std::vector<unsigned> order;
    for (const Heard& h : heard) {
        if (h.node == 1)
            order.push_back(h.frame.data[0]);
    }
    EXPECT_EQ(order, (std::vector<unsigned>{0, 99, 1, 3})) << "and takes the place of an older one with its identifier";
}
