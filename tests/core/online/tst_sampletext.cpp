#include "core/online/sampletext.h"

#include <gtest/gtest.h>

#include <limits>

namespace camwright {
namespace {

TEST(SampleTextTest, secondsAreExactDecimals)
{
    EXPECT_EQ(secondsText(0), "0");
    EXPECT_EQ(secondsText(1'000'000), "0.001");
    EXPECT_EQ(secondsText(12'000'000'000), "12");
    EXPECT_EQ(secondsText(10'000'000'001), "10.000000001");
    EXPECT_EQ(secondsText(std::numeric_limits<std::int64_t>::max()), "9223372036.854775807");
}

TEST(SampleTextTest, timeBeforeZeroHasOneSign)
{
    EXPECT_EQ(secondsText(-1'500'000'000), "-1.5");
    EXPECT_EQ(secondsText(-1), "-0.000000001");
    EXPECT_EQ(secondsText(std::numeric_limits<std::int64_t>::min()), "-9223372036.854775808");
}

TEST(SampleTextTest, samplesAreWrittenAsTheirType)
{
    EXPECT_EQ(sampleText(DataType::Bool, 1), "1");
    EXPECT_EQ(sampleText(DataType::Dint, -2147483648.0), "-2147483648");
    EXPECT_EQ(sampleText(DataType::Real, static_cast<double>(0.1f)), "0.1");
    EXPECT_EQ(sampleText(DataType::Lreal, static_cast<double>(0.1f)), "0.10000000149011612");
    EXPECT_EQ(sampleText(DataType::Lreal, std::numeric_limits<double>::quiet_NaN()), "nan");
}

TEST(SampleTextTest, cellsAreQuotedOnlyWhereTheyMust)
{
    EXPECT_EQ(csvCell("axis.Feed.position"), "axis.Feed.position");
    EXPECT_EQ(csvCell(""), "");
    EXPECT_EQ(csvCell("a,b"), "\"a,b\"");
    EXPECT_EQ(csvCell("axis.\"Axis 1\".state"), "\"axis.\"\"Axis 1\"\".state\"");
    EXPECT_EQ(csvCell("two\nlines"), "\"two\nlines\"");
}

} // namespace
} // namespace camwright
