#include "core/language/st/check/checker.h"
#include "core/language/st/syntax/timeliterals.h"

#include <gtest/gtest.h>

using namespace camwright;
using namespace camwright::st;

namespace {

TEST(StLiteralTest, durationsOfEveryForm)
{
    EXPECT_EQ(parseDuration("14ms"), 14'000'000);
    EXPECT_EQ(parseDuration("-14ms"), -14'000'000);
    EXPECT_EQ(parseDuration("5d14h12m18s3.5ms"), 5 * 86'400'000'000'000 + 14 * 3'600'000'000'000 + 12 * 60'000'000'000 + 18 * 1'000'000'000LL + 3'500'000);
    EXPECT_EQ(parseDuration("25h_15m"), 25 * 3'600'000'000'000 + 15 * 60'000'000'000);
    EXPECT_EQ(parseDuration("1us_5NS"), 1005);
    EXPECT_EQ(parseDuration("0.1d"), 8'640'000'000'000);
    for (const char* bad : {"", "5", "ms", "1s1s", "1s1m", "1.5s2ms", "1.s", "--1s", "1s ", "107000d"})
        EXPECT_EQ(parseDuration(bad), std::nullopt) << bad;
}

TEST(StLiteralTest, datesAreDaysOfTheCalendar)
{
    EXPECT_EQ(parseDate(TokenKind::Date, "1970-01-01"), 0);
    EXPECT_EQ(parseDate(TokenKind::Date, "2000-02-29"), 11016LL * 86'400'000'000'000);
    EXPECT_EQ(parseDate(TokenKind::DateTime, "1970-01-02-00:00:01.5"), 86'401'500'000'000);
    EXPECT_EQ(parseDate(TokenKind::TimeOfDay, "15:36:55.36"), (15 * 3600 + 36 * 60 + 55) * 1'000'000'000LL + 360'000'000);
    for (const char* bad : {"1900-02-29", "2100-02-29", "2026-00-10", "2026-04-31", "2026-1", "26-01-01"})
        EXPECT_EQ(parseDate(TokenKind::Date, bad), std::nullopt) << bad;
}

TEST(StLiteralTest, namesAreTheSameInEveryCase)
{
    Names names;
    EXPECT_EQ(names.intern("Speed_1"), names.intern("sPEED_1"));
    EXPECT_NE(names.intern("Speed_1"), names.intern("Speed_2"));
    EXPECT_EQ(Names::wordOf(names.intern("end_if")), Word::END_IF);
    EXPECT_EQ(Names::wordOf(names.intern("null")), Word::NULL_);
    const std::size_t before = names.count();
    for (int i = 0; i < 20'000; ++i)
        names.intern("name" + std::to_string(i));
    for (int i = 0; i < 20'000; ++i)
        EXPECT_EQ(names.intern("NAME" + std::to_string(i)), before + static_cast<std::size_t>(i));
}

TEST(StLiteralTest, everyStandardNameIsFound)
{
    EXPECT_EQ(standardOf(findStandard("limit")), Standard::Limit);
    const std::uint32_t conversion = findStandard("Real_To_Dint");
    EXPECT_EQ(convertsFrom(conversion), Elementary::Real);
    EXPECT_EQ(convertsTo(conversion), Elementary::Dint);
    EXPECT_TRUE(convertTruncates(findStandard("LREAL_TRUNC_DINT")));
    EXPECT_EQ(convertsTo(findStandard("TO_TIME_OF_DAY")), Elementary::Tod);
    EXPECT_EQ(findStandard("SPEED_TO_HIGH"), 0u);
}

} // namespace
