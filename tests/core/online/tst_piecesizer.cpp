#include "core/online/piecesizer.h"

#include <gtest/gtest.h>

using namespace camwright;

namespace {

std::size_t settled(double bytesPerSecond)
{
    PieceSizer sizer;
    for (int i = 0; i < 40; ++i)
        sizer.onPair(sizer.size(), Time(static_cast<std::int64_t>(1e9 * static_cast<double>(sizer.size()) / bytesPerSecond)));
    return sizer.size();
}

TEST(PieceSizerTest, aFastLineGetsTheLargestPieces) { EXPECT_EQ(settled(100e6), message::MaximumPiece); }
TEST(PieceSizerTest, aSlowLineGetsTheSmallestPieces) { EXPECT_EQ(settled(1000), message::MinimumPiece); }
TEST(PieceSizerTest, aMediumLineGetsFiveMillisecondsWorth) { EXPECT_NEAR(double(settled(400'000)), 2000, 20); }

TEST(PieceSizerTest, aGapOfNothingDoublesOnly)
{
    PieceSizer sizer;
    const std::size_t before = sizer.size();
    sizer.onPair(before, Time{});
    EXPECT_EQ(sizer.size(), before * 2);
}

} // namespace
