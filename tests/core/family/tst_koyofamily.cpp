#include "core/family/family.h"
#include "core/family/koyo/koyoareas.h"

#include <gtest/gtest.h>

#include <ostream>

using namespace camwright;

namespace {

const Family& koyoFamily() { return *findFamily("koyo"); }

Result<Address> parse(std::string_view text)
{
    return koyoFamily().parseAddress(text, koyoFamily().defaultModel());
}

struct Row {
    const char* text;
    Address address;
    const char* written; ///< as the family writes it
    friend std::ostream& operator<<(std::ostream& out, const Row& row) { return out << row.text; }
};

class KoyoAddresses : public testing::TestWithParam<Row> {};

TEST_P(KoyoAddresses, areReadInEveryNotationAndWrittenInOne) // D2-AMB-21
{
    const auto address = parse(GetParam().text);
    ASSERT_TRUE(address.ok()) << englishText(address.error());
    EXPECT_EQ(*address, GetParam().address);
    EXPECT_EQ(koyoFamily().formatAddress(*address), GetParam().written);
    const auto again = parse(GetParam().written);
    ASSERT_TRUE(again.ok());
    EXPECT_EQ(*again, *address);
}

using enum DataType;
INSTANTIATE_TEST_SUITE_P(All, KoyoAddresses, testing::Values(
    Row{"X0", bitAddress(koyo::X, 0, 0), "X0"}, Row{"x17", bitAddress(koyo::X, 1, 7), "X17"}, Row{"I17", bitAddress(koyo::X, 1, 7), "X17"},
    Row{"X1777", bitAddress(koyo::X, 127, 7), "X1777"}, Row{"B40400.15", bitAddress(koyo::X, 1, 7), "X17"},
    Row{"Q10", bitAddress(koyo::Y, 1, 0), "Y10"}, Row{"M1002", bitAddress(koyo::C, 64, 2), "C1002"}, Row{"C3777", bitAddress(koyo::C, 255, 7), "C3777"},
    Row{"S1777", bitAddress(koyo::S, 127, 7), "S1777"}, Row{"SP777", bitAddress(koyo::SP, 63, 7), "SP777"},
    Row{"GI0", bitAddress(koyo::GX, 0, 0), "GX0"}, Row{"GQ3777", bitAddress(koyo::GY, 255, 7), "GY3777"},
    Row{"T377", bitAddress(koyo::TimerBit, 31, 7), "T377"}, Row{"CT7", bitAddress(koyo::CounterBit, 0, 7), "CT7"},
    Row{"TA5", valueAddress(koyo::TimerValue, 10, Word), "V5"}, Row{"V5", valueAddress(koyo::TimerValue, 10, Word), "V5"},
    Row{"CTA2", valueAddress(koyo::CounterValue, 4, Word), "V1002"}, Row{"V1377", valueAddress(koyo::CounterValue, 510, Word), "V1377"},
    Row{"R5000", valueAddress(koyo::V, 05000 * 2, Word), "V5000"}, Row{"V37777", valueAddress(koyo::V, 32766, Word), "V37777"},
    Row{"V40400", valueAddress(koyo::X, 0, Word), "V40400"}, Row{"V40777", valueAddress(koyo::C, 254, Word), "V40777"},
    Row{"V41100", valueAddress(koyo::TimerBit, 0, Word), "V41100"}, Row{"V41237", valueAddress(koyo::SP, 62, Word), "V41237"},
    Row{"B10003.1", bitAddress(koyo::V, 010003 * 2, 1), "B10003.1"}, Row{"V1400.9", bitAddress(koyo::V, 01400 * 2 + 1, 1), "B1400.9"},
    Row{"ACC0", valueAddress(koyo::Accumulator, 0, Dword), "ACC0"}, Row{"ACC10", valueAddress(koyo::Accumulator, 32, Dword), "ACC10"}));

TEST(KoyoFamilyTest, bitsAndWordsOfOnePlaceOverlap) // CONTRACTS 8
{
    EXPECT_TRUE(overlap(*parse("X17"), *parse("V40400")));
    EXPECT_FALSE(overlap(*parse("X20"), *parse("V40400")));
    EXPECT_TRUE(overlap(*parse("C20"), *parse("V40601")));
    EXPECT_TRUE(overlap(*parse("T0"), *parse("B41100.0")));
}

TEST(KoyoFamilyTest, aTimersBitAndValueFindEachOther)
{
    const Family& family = koyoFamily();
    const Address bit = *parse("T15");
    ASSERT_TRUE(family.valueOf(bit).has_value());
    EXPECT_EQ(*family.valueOf(bit), *parse("V15"));
    EXPECT_EQ(*family.bitOf(*parse("V15")), bit);
    EXPECT_EQ(*family.bitOf(*parse("V1010")), *parse("CT10"));
    EXPECT_EQ(family.elementNumber(bit), 015u);
    EXPECT_FALSE(family.withType(*parse("V15"), Bool, family.defaultModel()).ok()) << "V15 is a word, T15 its bit";
    EXPECT_TRUE(family.withType(bit, Word, family.defaultModel()).ok());
}

TEST(KoyoFamilyTest, valuesOfTwoWordsEndWhereTheNextElementsBegin)
{
    const Family& family = koyoFamily();
    const auto takesTwo = [&](const char* text) { return family.withType(*parse(text), Dword, family.defaultModel()).ok(); };
    EXPECT_TRUE(takesTwo("V376"));
    EXPECT_FALSE(takesTwo("V377"));
    EXPECT_TRUE(takesTwo("V776"));
    EXPECT_FALSE(takesTwo("V777"));
    EXPECT_FALSE(takesTwo("V1377"));
    EXPECT_TRUE(takesTwo("V37776"));
    EXPECT_FALSE(takesTwo("V37777"));
    EXPECT_FALSE(takesTwo("V40477"));
    EXPECT_FALSE(family.withType(valueAddress(koyo::V, 0, Word), Word, family.defaultModel()).ok()) << "V0 is a place of the timers";
    EXPECT_FALSE(family.withType(valueAddress(koyo::V, 01377 * 2, Word), Word, family.defaultModel()).ok());
    EXPECT_TRUE(family.withType(valueAddress(koyo::V, 0400 * 2, Word), Word, family.defaultModel()).ok());
}

TEST(KoyoFamilyTest, modelsAndErrorsAreThoseOfTheSheet) // D2-SYS-01, D2-SYS-04, D2-ERR-01 … 03
{
    const Family& family = koyoFamily();
    EXPECT_EQ(&family.defaultModel(), family.findModel("DL-260"));
    EXPECT_NE(family.findModel("DL-265"), nullptr);
    EXPECT_EQ(family.defaultModel().axesMax, 0u) << "axes of MECHATROLINK are not in this version";
    EXPECT_EQ(family.errorText("Rnn6", 0xFFF4, TextLanguage::English), "More stations are configured than the module takes.");
    EXPECT_EQ(family.errorText("Rnn7", 1u << 3, TextLanguage::English), "Not all stations were served within one cycle.");
    EXPECT_EQ(family.errorText("Rnn10", 0xE, TextLanguage::English), "The station is busy or moving; the command was ignored.");
    EXPECT_EQ(family.errorText("I-box", 3, TextLanguage::English), "The data length differs from that of the other side."); // D2-IBC-05
    EXPECT_TRUE(family.isWritable(*parse("C0")));
    EXPECT_FALSE(family.isWritable(*parse("SP1")));
    EXPECT_TRUE(family.area(koyo::X).isInput);
    EXPECT_TRUE(family.area(koyo::Y).isOutput);
}

} // namespace
