#include "core/language/check/literals.h"

#include <gtest/gtest.h>

using namespace camwright;

namespace {

TEST(LiteralsTest, untypedIntegersFitEveryIntegerType) // KS-IL-05
{
    for (const char* text : {"0", "12", "-3", "+7", "16#FF", "16#ff", "2#1010", "8#17", "1_000"}) {
        const auto literal = Literal::read(text);
        ASSERT_TRUE(literal) << text;
        EXPECT_TRUE(literal->types().contains(DataType::Int) && literal->types().contains(DataType::Dword)) << text;
        EXPECT_FALSE(literal->types().contains(DataType::Real)) << text;
    }
}

TEST(LiteralsTest, aDecimalPointMakesAReal)
{
    for (const char* text : {"1200.0", "-0.5", "1.5E-3", "2.0e6"})
        EXPECT_EQ(Literal::read(text)->types(), (TypeSet{DataType::Real, DataType::Lreal})) << text;
}

TEST(LiteralsTest, prefixesDecideTheType)
{
    const std::pair<const char*, DataType> cases[] = {{"B#0", DataType::Byte}, {"B#16#85", DataType::Byte}, {"DI#2000", DataType::Dint},
        {"DI#-5", DataType::Dint}, {"I#1", DataType::Int}, {"W#16#FFFF", DataType::Word}, {"DW#1", DataType::Dword}, {"R#1.5", DataType::Real},
        {"REAL#2", DataType::Real}, {"T#5s", DataType::Time}, {"TRUE", DataType::Bool}, {"false", DataType::Bool}};
    for (const auto& [text, type] : cases) {
        const auto literal = Literal::read(text);
        ASSERT_TRUE(literal) << text;
        EXPECT_EQ(literal->types(), TypeSet{type}) << text;
        EXPECT_TRUE(literal->as(type).ok()) << text;
    }
}

TEST(LiteralsTest, refusesWhatOnlyLooksLikeANumber)
{
    for (const char* text : {"", "-", "1.", ".5", "1e3", "2.5k", "16#", "16#G", "2#2", "8#8", "12a", "B#", "B#X", "XX#1", "T#", "1.5.2", "_1", "--1"})
        EXPECT_FALSE(Literal::read(text)) << text;
}

} // namespace
