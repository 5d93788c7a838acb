#include "core/base/value.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace camwright;

namespace {

struct Row {
    DataType type;
    const char* typed;
    const char* shown;
};

class TypedText : public testing::TestWithParam<Row> {};

TEST_P(TypedText, isReadAsThePersonMeantIt)
{
    const auto value = parseValue(GetParam().type, GetParam().typed);
    ASSERT_TRUE(value.ok()) << englishText(value.error());
    EXPECT_EQ(formatValue(*value), GetParam().shown);
}

INSTANTIATE_TEST_SUITE_P(ValueTest, TypedText, testing::Values(
    Row{DataType::Bool, "true", "TRUE"}, Row{DataType::Bool, "0", "FALSE"}, Row{DataType::Bool, "ON", "TRUE"},
    Row{DataType::Byte, "16#FF", "255"}, Row{DataType::Byte, "B#16#85", "133"}, Row{DataType::Int, "-32768", "-32768"},
    Row{DataType::Int, "2#101", "5"}, Row{DataType::Dint, "DI#2000", "2000"}, Row{DataType::Dint, "2.5k", "2500"},
    Row{DataType::Udint, "4294967295", "4294967295"}, Row{DataType::Real, "1,5", "1.5"}, Row{DataType::Real, "-0.1", "-0.1"},
    Row{DataType::Real, "3", "3.0"}, Row{DataType::Time, "T#1m5s250ms", "T#1m5s250ms"}, Row{DataType::Time, "t#-5s", "T#-5s"},
    Row{DataType::Time, "1500", "T#1s500ms"}, Row{DataType::Ulint, "18446744073709551615", "18446744073709551615"},
    Row{DataType::Lint, "-9223372036854775808", "-9223372036854775808"}));

class WrongText : public testing::TestWithParam<Row> {};

TEST_P(WrongText, isRefusedWithTheCode)
{
    const auto value = parseValue(GetParam().type, GetParam().typed);
    ASSERT_FALSE(value.ok());
    EXPECT_EQ(codeInfo(value.error().code).id, GetParam().shown);
}

INSTANTIATE_TEST_SUITE_P(ValueTest, WrongText, testing::Values(
    Row{DataType::Bool, "2", "CW0003"}, Row{DataType::Bool, "", "CW0003"}, Row{DataType::Byte, "256", "CW0004"},
    Row{DataType::Byte, "-1", "CW0004"}, Row{DataType::Int, "32768", "CW0004"}, Row{DataType::Int, "1.5", "CW0003"},
    Row{DataType::Int, "16#", "CW0003"}, Row{DataType::Int, "--3", "CW0003"}, Row{DataType::Dint, "QQ#5", "CW0003"},
    Row{DataType::Real, "1e999", "CW0003"}, Row{DataType::Real, "nan", "CW0003"}, Row{DataType::Time, "T#", "CW0003"},
    Row{DataType::Time, "T#5x", "CW0003"}, Row{DataType::Time, "T#99999d", "CW0004"},
    Row{DataType::Ulint, "18446744073709551616", "CW0004"}));

TEST(ValueTest, floatsSaturateAndNanGivesZero)
{
    EXPECT_EQ(Value::ofDouble(DataType::Int, 1e9).asInteger(), 32767);
    EXPECT_EQ(Value::ofDouble(DataType::Int, -1e9).asInteger(), -32768);
    EXPECT_EQ(Value::ofDouble(DataType::Byte, -3).asInteger(), 0);
    EXPECT_EQ(Value::ofDouble(DataType::Dint, std::nan("")).asInteger(), 0);
    EXPECT_EQ(Value::ofDouble(DataType::Int, 2.5).asInteger(), 2);
    EXPECT_EQ(Value::ofReal(std::numeric_limits<float>::quiet_NaN()).bits, 0x7FC00000u);
}

TEST(ValueTest, writesTheBasesOfTheWatchTable)
{
    const Value value = Value::ofInteger(DataType::Int, -2);
    EXPECT_EQ(formatValue(value, NumberBase::Hexadecimal), "16#FFFE");
    EXPECT_EQ(formatValue(Value::ofInteger(DataType::Byte, 5), NumberBase::Binary), "2#101");
    EXPECT_EQ(formatValue(Value::ofInteger(DataType::Byte, 8), NumberBase::Octal), "8#10");
}

TEST(ValueTest, readsBackEveryRealItWrites)
{
    std::uint32_t bits = 12345;
    for (int i = 0; i < 20000; ++i) {
        bits = bits * 1664525u + 1013904223u;
        const Value value{DataType::Real, bits};
        if (!std::isfinite(value.asDouble()))
            continue;
        const auto back = parseValue(DataType::Real, formatValue(value));
        ASSERT_TRUE(back.ok()) << formatValue(value);
        EXPECT_EQ(back->bits, bits);
    }
}

} // namespace
