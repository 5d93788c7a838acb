#include "core/online/tracebuffer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>

using namespace camwright;

namespace {

__extension__ using Wide = unsigned __int128;

SampleBlock block(std::uint64_t sequence, std::uint64_t firstCycle, std::vector<double> values, std::uint32_t stride = 1)
{
    SampleBlock out;
    out.channelSet = 1;
    out.sequence = sequence;
    out.firstCycle = firstCycle;
    out.stride = stride;
    out.columns = {std::move(values)};
    return out;
}

TEST(TraceBufferTest, blocksThatFollowMakeOneSegment)
{
    TraceBuffer buffer;
    EXPECT_TRUE(buffer.append(block(0, 10, {1, 2}, 2)));
    EXPECT_TRUE(buffer.append(block(1, 14, {3, 4}, 2)));
    ASSERT_EQ(buffer.segments().size(), 1u);
    EXPECT_EQ(buffer.rows(), 4u);
    EXPECT_EQ(buffer.firstCycle(), 10u);
    EXPECT_EQ(buffer.lastCycle(), 16u);
}

TEST(TraceBufferTest, aMissingSequenceNumberIsAGapEvenIfCyclesFollow)
{
    TraceBuffer buffer;
    buffer.append(block(0, 0, {1, 2}));
    buffer.append(block(2, 2, {3}));
    EXPECT_EQ(buffer.segments().size(), 2u);
}

TEST(TraceBufferTest, lostRowsAreAGapAndAreCounted)
{
    TraceBuffer buffer;
    buffer.append(block(0, 0, {1, 2}));
    SampleBlock later = block(1, 5, {3, 4});
    later.lostRows = 3;
    buffer.append(later);
    EXPECT_EQ(buffer.lostRows(), 3u);
    const auto columns = buffer.columns(0, 0, 7, 7);
    EXPECT_FALSE(columns[1].empty || columns[1].gap);
    EXPECT_TRUE(columns[2].empty && columns[3].empty && columns[4].empty);
    EXPECT_TRUE(columns[5].gap);
    EXPECT_FALSE(columns[6].gap);
    EXPECT_EQ(buffer.valueAt(0, 1), 2.0);
    EXPECT_EQ(buffer.valueAt(0, 3), std::nullopt);
    EXPECT_EQ(buffer.valueAt(0, 6), 4.0);
}

TEST(TraceBufferTest, blocksThatDoNotFitAreRefused)
{
    TraceBuffer buffer;
    buffer.append(block(0, 10, {1, 2}));
    EXPECT_FALSE(buffer.append(block(1, 11, {3}))) << "goes back";
    SampleBlock wide = block(1, 12, {3});
    wide.columns.push_back({4});
    EXPECT_FALSE(buffer.append(wide)) << "another number of columns";
    EXPECT_FALSE(buffer.append(block(1, 12, {3}, 0))) << "stride 0";
    EXPECT_EQ(buffer.rows(), 2u);
}

TEST(TraceBufferTest, anotherChannelSetStartsAnew)
{
    TraceBuffer buffer;
    buffer.append(block(0, 10, {1, 2}));
    SampleBlock other = block(0, 3, {7});
    other.channelSet = 2;
    EXPECT_TRUE(buffer.append(other));
    EXPECT_EQ(buffer.rows(), 1u);
    EXPECT_EQ(buffer.firstCycle(), 3u);
}

TEST(TraceBufferTest, notANumberIsLeftOut)
{
    TraceBuffer buffer;
    const double nan = std::nan("");
    buffer.append(block(0, 0, {nan, 2, nan, nan}));
    const auto columns = buffer.columns(0, 0, 4, 2);
    EXPECT_EQ(columns[0], (TraceColumn{false, false, 2, 2, 2, 2}));
    EXPECT_TRUE(columns[1].empty);
}

/// Cycle to sample, and the cycles where a stretch begins after a hole.
struct BruteForce {
    std::map<std::uint64_t, double> samples;
    std::map<std::uint64_t, int> segmentOf;

    std::vector<TraceColumn> columns(std::uint64_t from, std::uint64_t to, std::size_t count) const
    {
        std::vector<TraceColumn> out(count);
        std::vector<int> segment(count, -1);
        for (auto it = samples.lower_bound(from); it != samples.end() && it->first < to; ++it) {
            const auto i = static_cast<std::size_t>(static_cast<Wide>(it->first - from) * count / (to - from));
            const int here = segmentOf.at(it->first);
            const auto before = it == samples.begin() ? samples.end() : std::prev(it);
            const bool torn = before != samples.end() && segmentOf.at(before->first) != here;
            TraceColumn& column = out[i];
            column.gap = column.gap || torn;
            if (column.empty) {
                column.first = column.minimum = column.maximum = it->second;
                column.empty = false;
            }
            column.minimum = std::min(column.minimum, it->second);
            column.maximum = std::max(column.maximum, it->second);
            column.last = it->second;
        }
        return out;
    }
};

TEST(TraceBufferTest, pyramidEqualsBruteForce)
{
    std::mt19937 random(20261122);
    TraceBuffer buffer;
    BruteForce truth;
    std::uint64_t cycle = 1000, sequence = 0;
    int segment = 0;
    while (buffer.rows() < 150'000) {
        const std::size_t rows = 1 + random() % 700;
        const bool gap = random() % 40 == 0;
        if (gap) {
            cycle += 1 + random() % 5000;
            ++segment;
        }
        std::vector<double> values(rows);
        for (double& value : values)
            value = static_cast<double>(random() % 100'000) - 50'000;
        for (std::size_t i = 0; i < rows; ++i) {
            truth.samples[cycle + i] = values[i];
            truth.segmentOf[cycle + i] = segment;
        }
        SampleBlock next = block(sequence++, cycle, std::move(values));
        next.lostRows = gap ? 1 : 0;
        ASSERT_TRUE(buffer.append(next));
        cycle += rows;
    }
    for (int i = 0; i < 60; ++i) {
        const std::uint64_t from = random() % (cycle + 500);
        const std::uint64_t to = from + 1 + random() % (random() % 3 == 0 ? 300 : cycle);
        const std::size_t count = 1 + random() % 1200;
        ASSERT_EQ(buffer.columns(0, from, to, count), truth.columns(from, to, count)) << from << " … " << to << " in " << count;
    }
}

TEST(TraceBufferTest, oldRowsFallOutAndTheRestStaysTrue)
{
    TraceBuffer limited(70'000);
    TraceBuffer all;
    for (std::uint64_t i = 0; i < 600; ++i) {
        std::vector<double> values(1000);
        for (std::size_t k = 0; k < values.size(); ++k)
            values[k] = static_cast<double>((i * 1000 + k) * 7919 % 10'007);
        limited.append(block(i, i * 1000, values));
        all.append(block(i, i * 1000, values));
    }
    EXPECT_GE(limited.rows(), 70'000u);
    EXPECT_LE(limited.rows(), 70'000u + 65'536u);
    EXPECT_EQ(limited.lastCycle(), 599'999u);
    const std::uint64_t from = limited.firstCycle();
    EXPECT_EQ(limited.columns(0, from, 600'000, 333), all.columns(0, from, 600'000, 333));
    EXPECT_EQ(limited.valueAt(0, from - 1), std::nullopt);
}

} // namespace
