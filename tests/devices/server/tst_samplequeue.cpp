#include "devices/server/samplequeue.h"

#include <gtest/gtest.h>

using namespace camwright;

namespace {

SampleBlock block(std::uint64_t firstCycle, std::size_t rows, std::size_t columns = 2)
{
    SampleBlock out;
    out.channelSet = 3;
    out.firstCycle = firstCycle;
    for (std::size_t c = 0; c < columns; ++c) {
        out.columns.emplace_back();
        for (std::size_t r = 0; r < rows; ++r)
            out.columns.back().push_back(static_cast<double>(firstCycle + r));
    }
    return out;
}

TEST(SampleQueueTest, twoPiecesAreInFlightAndNoMore)
{
    SampleQueue queue;
    queue.add(block(0, 10'000));
    const auto first = queue.next();
    ASSERT_TRUE(first && queue.next());
    EXPECT_FALSE(queue.next());
    queue.taken(3, first->sequence, 1ms);
    EXPECT_FALSE(queue.next()) << "the pair is waited for";
    queue.taken(3, first->sequence + 1, 1ms);
    EXPECT_TRUE(queue.next() && queue.next());
    EXPECT_FALSE(queue.next());
}

TEST(SampleQueueTest, acknowledgementsNobodyOwesAreIgnored)
{
    SampleQueue queue;
    queue.add(block(0, 10'000));
    (void)queue.next();
    (void)queue.next();
    queue.taken(3, 77, 1ms);
    queue.taken(9, 0, 1ms);
    EXPECT_FALSE(queue.next());
}

TEST(SampleQueueTest, everyRowArrivesOnceInOrder)
{
    SampleQueue queue;
    SampleBlock first = block(100, 3000);
    first.channels = {{"a", DataType::Lreal, ""}, {"b", DataType::Lreal, ""}};
    queue.add(first);
    SampleBlock last = block(3100, 777);
    last.last = true;
    last.triggerCycle = 3200;
    queue.add(last);
    std::uint64_t cycle = 100, sequence = 0;
    bool ended = false;
    for (Time now{}; auto piece = queue.next(); now += 1ms) {
        EXPECT_EQ(piece->sequence, sequence);
        EXPECT_EQ(piece->firstCycle, cycle);
        EXPECT_EQ(piece->channels.empty(), sequence != 0) << "channels come once";
        for (const double value : piece->columns.at(1))
            ASSERT_EQ(value, static_cast<double>(cycle++));
        EXPECT_LE(piece->columns.size() * piece->columns[0].size() * 8, message::MaximumPiece);
        EXPECT_FALSE(ended);
        ended = piece->last;
        queue.taken(3, sequence++, now);
    }
    EXPECT_EQ(cycle, 3877u);
    EXPECT_TRUE(ended);
}

TEST(SampleQueueTest, piecesGrowOnAFastLineAndShrinkOnASlowOne)
{
    const auto settled = [](double bytesPerSecond) {
        SampleQueue queue;
        queue.add(block(0, 40'000));
        std::size_t bytes = 0;
        Time now{};
        for (int i = 0; i < 20; ++i) {
            const auto first = queue.next(), second = queue.next();
            bytes = second->columns[0].size() * 16;
            queue.taken(3, first->sequence, now);
            now += Time(static_cast<std::int64_t>(1e9 * static_cast<double>(bytes) / bytesPerSecond));
            queue.taken(3, second->sequence, now);
        }
        return bytes;
    };
    EXPECT_EQ(settled(1e9), message::MaximumPiece);
    EXPECT_EQ(settled(1e3), message::MinimumPiece);
}

TEST(SampleQueueTest, aClientTooSlowLosesTheOldestAndIsToldHowMany)
{
    SampleQueue queue;
    const std::size_t blocks = 2000, rows = 1000;
    std::uint64_t received = 0, lost = 0, next = 0;
    for (std::size_t i = 0; i < blocks; ++i)
        queue.add(block(i * rows, rows));
    EXPECT_LE(queue.rowsWaiting() * 2, SampleQueue::MaximumValues + 2 * rows);
    for (Time now{}; auto piece = queue.next(); now += 1ms) {
        lost += piece->lostRows;
        EXPECT_EQ(piece->firstCycle, next + piece->lostRows) << "the hole is exactly as large as told";
        next = piece->firstCycle + piece->columns[0].size();
        received += piece->columns[0].size();
        queue.taken(3, piece->sequence, now);
    }
    EXPECT_GT(lost, 0u);
    EXPECT_EQ(received + lost, blocks * rows);
}

} // namespace
