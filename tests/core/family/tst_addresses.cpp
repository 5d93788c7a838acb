#include "core/family/family.h"
#include "core/family/invt/invtareas.h"
#include "core/family/kinco/kincoareas.h"

#include <gtest/gtest.h>

#include <ostream>

using namespace camwright;

namespace {

const Family& kincoFamily() { return *findFamily("kinco"); }
const Family& invtFamily() { return *findFamily("invt"); }

struct GoodRow {
    const char* text;
    Address address;
    friend std::ostream& operator<<(std::ostream& out, const GoodRow& row) { return out << row.text; }
};

struct BadRow {
    const char* model;
    const char* text;
    Code code;
    std::uint32_t column, endColumn; ///< what the error points at
    friend std::ostream& operator<<(std::ostream& out, const BadRow& row) { return out << row.model << ' ' << row.text; }
};

using enum DataType;

class KincoGood : public testing::TestWithParam<GoodRow> {};

TEST_P(KincoGood, readsAndWritesTheSameText)
{
    const Family& family = kincoFamily();
    const auto address = family.parseAddress(GetParam().text, family.defaultModel());
    ASSERT_TRUE(address.ok()) << englishText(address.error());
    EXPECT_EQ(*address, GetParam().address);
    EXPECT_EQ(family.formatAddress(*address), GetParam().text);
}

INSTANTIATE_TEST_SUITE_P(Addresses, KincoGood, testing::Values(
    GoodRow{"%I0.0", bitAddress(kinco::I, 0, 0)},
    GoodRow{"%Q1.5", bitAddress(kinco::Q, 1, 5)},
    GoodRow{"%M0.1", bitAddress(kinco::M, 0, 1)},
    GoodRow{"%M4095.7", bitAddress(kinco::M, 4095, 7)},
    GoodRow{"%MB1", valueAddress(kinco::M, 1, Byte)},
    GoodRow{"%MD8", valueAddress(kinco::M, 8, Dint)},
    GoodRow{"%MD14", valueAddress(kinco::M, 14, Dint)},
    GoodRow{"%VB100", valueAddress(kinco::V, 100, Byte)},
    GoodRow{"%VB16383", valueAddress(kinco::V, 16383, Byte)},
    GoodRow{"%VW304", valueAddress(kinco::V, 304, Int)},
    GoodRow{"%VW16382", valueAddress(kinco::V, 16382, Int)},
    GoodRow{"%VD6", valueAddress(kinco::V, 6, Dint)},
    GoodRow{"%VD16380", valueAddress(kinco::V, 16380, Dint)},
    GoodRow{"%VR1200", valueAddress(kinco::V, 1200, Real)},
    GoodRow{"%V302.0", bitAddress(kinco::V, 302, 0)},
    GoodRow{"%LW2", valueAddress(kinco::L, 2, Int)},
    GoodRow{"%SM0.0", bitAddress(kinco::SM, 0, kinco::AlwaysOnBit)},
    GoodRow{"%SM0.1", bitAddress(kinco::SM, 0, kinco::FirstScanBit)},
    GoodRow{"%SM201.6", bitAddress(kinco::SM, 201, 6)},
    GoodRow{"%SMB67", valueAddress(kinco::SM, 67, Byte)},
    GoodRow{"%SMW68", valueAddress(kinco::SM, 68, Int)},
    GoodRow{"%SMD208", valueAddress(kinco::SM, 208, Dint)},
    GoodRow{"%AIW18", valueAddress(kinco::AI, 18, Int)},
    GoodRow{"%AQW18", valueAddress(kinco::AQ, 18, Int)},
    GoodRow{"T0", bitAddress(kinco::TimerBit, 0)},
    GoodRow{"T255", bitAddress(kinco::TimerBit, 255)},
    GoodRow{"C17", bitAddress(kinco::CounterBit, 17)}));

class KincoBad : public testing::TestWithParam<BadRow> {};

TEST_P(KincoBad, saysWhatIsWrongAndWhere)
{
    const Family& family = kincoFamily();
    const auto address = family.parseAddress(GetParam().text, *family.findModel(GetParam().model));
    ASSERT_FALSE(address.ok());
    EXPECT_EQ(codeInfo(address.error().code).id, codeInfo(GetParam().code).id) << englishText(address.error());
    EXPECT_EQ(address.error().place.range, (TextRange{1, GetParam().column, 1, GetParam().endColumn}));
}

INSTANTIATE_TEST_SUITE_P(Addresses, KincoBad, testing::Values(
    BadRow{"KS101M-04DX", "M0.1", Code::AddressMissingPercent, 1, 5},
    BadRow{"KS101M-04DX", "VW0", Code::AddressMissingPercent, 1, 4},
    BadRow{"KS101M-04DX", "%ВW0", Code::AddressForeignCharacter, 2, 4}, // Cyrillic В
    BadRow{"KS101M-04DX", "%M 0.1", Code::AddressForeignCharacter, 3, 4},
    BadRow{"KS101M-04DX", "%R\\_1", Code::AddressForeignCharacter, 3, 4},
    BadRow{"KS101M-04DX", "%Z0.0", Code::AddressUnknownArea, 2, 3},
    BadRow{"KS101M-04DX", "%HC0", Code::AddressUnknownArea, 2, 4},
    BadRow{"KS101M-04DX", "Cmd", Code::AddressUnknownArea, 1, 4},
    BadRow{"KS101M-04DX", "%", Code::AddressMalformed, 1, 2},
    BadRow{"KS101M-04DX", "", Code::AddressMalformed, 1, 1},
    BadRow{"KS101M-04DX", "%M0", Code::AddressMalformed, 1, 4},
    BadRow{"KS101M-04DX", "%M0.", Code::AddressMalformed, 1, 5},
    BadRow{"KS101M-04DX", "%VW", Code::AddressMalformed, 1, 4},
    BadRow{"KS101M-04DX", "%VB1.2", Code::AddressMalformed, 1, 7},
    BadRow{"KS101M-04DX", "%M0.8", Code::AddressBitOutOfRange, 5, 6},
    BadRow{"KS101M-04DX", "%VW305", Code::AddressOddByte, 1, 7},
    BadRow{"KS101M-04DX", "%AIW1", Code::AddressOddByte, 1, 6},
    BadRow{"KS101M-04DX", "%AIB0", Code::AddressFormNotAllowed, 1, 6},
    BadRow{"KS101M-04DX", "%MR8", Code::AddressFormNotAllowed, 1, 5},
    BadRow{"KS101M-04DX", "%M4096.0", Code::AddressOutOfRange, 1, 9},
    BadRow{"KS105-16DT", "%M1024.0", Code::AddressOutOfRange, 1, 9},
    BadRow{"KS105-16DT", "%VB4096", Code::AddressOutOfRange, 1, 8},
    BadRow{"KS101M-04DX", "%VD16382", Code::AddressOutOfRange, 1, 9},
    BadRow{"KS101M-04DX", "%VB99999999999999999999", Code::AddressOutOfRange, 1, 24},
    BadRow{"KS101M-04DX", "T256", Code::AddressOutOfRange, 1, 5},
    BadRow{"KS101M-04DX", "C", Code::AddressMalformed, 1, 2}));

TEST(KincoAddressTest, namesTheLegalRangeOfTheModel)
{
    const Family& family = kincoFamily();
    const auto address = family.parseAddress("%VD4094", *family.findModel("KS105-16DT"));
    ASSERT_FALSE(address.ok());
    EXPECT_EQ(englishText(address.error()),
        "\"%VD4094\" lies outside its memory area. On KS105-16DT the legal range is %VD0 to %VD4092.");
}

TEST(KincoAddressTest, aTableForgivesTheMissingPercentAndTheCase)
{
    const Family& family = kincoFamily();
    const auto address = family.parseAddress("vw304", family.defaultModel(), AddressMode::Typed);
    ASSERT_TRUE(address.ok());
    EXPECT_EQ(family.formatAddress(*address), "%VW304");
}

TEST(KincoAddressTest, wordsBytesAndBitsShareTheirMemory)
{
    const Family& family = kincoFamily();
    const auto at = [&](const char* text) { return *family.parseAddress(text, family.defaultModel()); };
    EXPECT_TRUE(overlap(at("%VD0"), at("%VW2")));
    EXPECT_TRUE(overlap(at("%VD0"), at("%VR0")));
    EXPECT_TRUE(overlap(at("%VB3"), at("%V3.7")));
    EXPECT_FALSE(overlap(at("%VD0"), at("%VW4")));
    EXPECT_FALSE(overlap(at("%V3.6"), at("%V3.7")));
    EXPECT_FALSE(overlap(at("%VB0"), at("%MB0")));
}

TEST(KincoAddressTest, inputsAndTheControllersOwnBitsAreNotWritable)
{
    const Family& family = kincoFamily();
    const auto writable = [&](const char* text) { return family.isWritable(*family.parseAddress(text, family.defaultModel())); };
    EXPECT_TRUE(writable("%Q0.0"));
    EXPECT_TRUE(writable("%SM201.6"));
    EXPECT_TRUE(writable("%SMD208"));
    EXPECT_FALSE(writable("%SM0.0"));
    EXPECT_FALSE(writable("%SMW0"));
    EXPECT_FALSE(writable("%I0.0"));
    EXPECT_FALSE(writable("%AIW0"));
    EXPECT_FALSE(writable("T0"));
}

TEST(KincoAddressTest, theSizeLetterDecidesWhichTypesFit)
{
    const Family& family = kincoFamily();
    const ControllerModel& model = family.defaultModel();
    const auto at = [&](const char* text) { return *family.parseAddress(text, model); };
    EXPECT_EQ(family.withType(at("%VW304"), Word, model)->type, Word);
    EXPECT_EQ(family.withType(at("%VD6"), Dword, model)->type, Dword);
    EXPECT_EQ(family.withType(at("T5"), Int, model).value(), valueAddress(kinco::TimerValue, 10, Int));
    EXPECT_FALSE(family.withType(at("%VD6"), Real, model).ok());
    EXPECT_FALSE(family.withType(at("%M0.0"), Byte, model).ok());
    EXPECT_EQ(family.bitOf(*family.valueOf(at("C3"))), at("C3"));
}

class InvtGood : public testing::TestWithParam<GoodRow> {};

TEST_P(InvtGood, readsAndWritesTheSameText)
{
    const Family& family = invtFamily();
    const auto address = family.parseAddress(GetParam().text, family.defaultModel());
    ASSERT_TRUE(address.ok()) << englishText(address.error());
    EXPECT_EQ(*address, GetParam().address);
    EXPECT_EQ(family.formatAddress(*address), GetParam().text);
}

INSTANTIATE_TEST_SUITE_P(Addresses, InvtGood, testing::Values(
    GoodRow{"X0", bitAddress(invt::X, 0)},
    GoodRow{"X17", bitAddress(invt::X, 15)},
    GoodRow{"X1777", bitAddress(invt::X, 1023)},
    GoodRow{"Y10", bitAddress(invt::Y, 8)},
    GoodRow{"M0", bitAddress(invt::M, 0)},
    GoodRow{"M32767", bitAddress(invt::M, 32767)},
    GoodRow{"LM63", bitAddress(invt::LM, 63)},
    GoodRow{"S4095", bitAddress(invt::S, 4095)},
    GoodRow{"SM1", bitAddress(invt::SM, 1)},
    GoodRow{"T399", bitAddress(invt::TimerBit, 399)},
    GoodRow{"C255", bitAddress(invt::CounterBit, 255)},
    GoodRow{"D100", valueAddress(invt::D, 200, Int)},
    GoodRow{"D32767", valueAddress(invt::D, 65534, Int)},
    GoodRow{"D100.0", bitAddress(invt::D, 200, 0)},
    GoodRow{"D100.15", bitAddress(invt::D, 201, 7)},
    GoodRow{"R5.8", bitAddress(invt::R, 11, 0)},
    GoodRow{"V63", valueAddress(invt::V, 126, Int)},
    GoodRow{"Z15", valueAddress(invt::Z, 30, Int)}));

class InvtBad : public testing::TestWithParam<BadRow> {};

TEST_P(InvtBad, saysWhatIsWrongAndWhere)
{
    const Family& family = invtFamily();
    const auto address = family.parseAddress(GetParam().text, *family.findModel(GetParam().model));
    ASSERT_FALSE(address.ok());
    EXPECT_EQ(codeInfo(address.error().code).id, codeInfo(GetParam().code).id) << englishText(address.error());
    EXPECT_EQ(address.error().place.range, (TextRange{1, GetParam().column, 1, GetParam().endColumn}));
}

INSTANTIATE_TEST_SUITE_P(Addresses, InvtBad, testing::Values(
    BadRow{"TS635", "X8", Code::AddressNotOctal, 2, 3},
    BadRow{"TS635", "Y179", Code::AddressNotOctal, 4, 5},
    BadRow{"TS635", "X2000", Code::AddressOutOfRange, 1, 6},
    BadRow{"TS635", "D32768", Code::AddressOutOfRange, 1, 7},
    BadRow{"TS635", "T400", Code::AddressOutOfRange, 1, 5},
    BadRow{"TS635", "C256", Code::AddressOutOfRange, 1, 5},
    BadRow{"TS635", "SM36", Code::AddressOutOfRange, 1, 5},
    BadRow{"TS635", "D100.16", Code::AddressBitOutOfRange, 6, 8},
    BadRow{"TS635", "M0.1", Code::AddressMalformed, 1, 5},
    BadRow{"TS635", "Z0.1", Code::AddressMalformed, 1, 5},
    BadRow{"TS635", "D100.", Code::AddressMalformed, 1, 6},
    BadRow{"TS635", "D", Code::AddressMalformed, 1, 2},
    BadRow{"TS635", "%D100", Code::AddressMalformed, 1, 6},
    BadRow{"TS635", "K10", Code::AddressUnknownArea, 1, 2},
    BadRow{"TS635", "D 100", Code::AddressForeignCharacter, 2, 3}));

TEST(InvtAddressTest, doubleWordsTakeTwoElementsAndMustFit)
{
    const Family& family = invtFamily();
    const ControllerModel& model = family.defaultModel();
    const auto at = [&](const char* text) { return *family.parseAddress(text, model); };
    const auto real = family.withType(at("D100"), Real, model);
    ASSERT_TRUE(real.ok());
    EXPECT_TRUE(overlap(*real, at("D101")));
    EXPECT_TRUE(overlap(*real, at("D101.15")));
    EXPECT_FALSE(overlap(*real, at("D102")));
    EXPECT_FALSE(family.withType(at("D32767"), Dint, model).ok());
    EXPECT_FALSE(family.withType(at("Z0"), Dint, model).ok());
}

TEST(InvtAddressTest, onlyFourSystemFlagsAreWritable) // TS-MEM-09
{
    const Family& family = invtFamily();
    const auto writable = [&](const char* text) { return family.isWritable(*family.parseAddress(text, family.defaultModel())); };
    EXPECT_FALSE(writable("SM0"));
    EXPECT_FALSE(writable("SM30"));
    EXPECT_TRUE(writable("SM31"));
    EXPECT_TRUE(writable("SM34"));
    EXPECT_FALSE(writable("SM35"));
    EXPECT_FALSE(writable("X0"));
    EXPECT_TRUE(writable("D100.5"));
}

TEST(InvtAddressTest, countersFromC200AreDoubleWords)
{
    const Family& family = invtFamily();
    const ControllerModel& model = family.defaultModel();
    const auto at = [&](const char* text) { return *family.parseAddress(text, model); };
    EXPECT_EQ(family.valueOf(at("C199"))->type, Int);
    EXPECT_EQ(family.valueOf(at("C200"))->type, Dint);
    EXPECT_TRUE(family.withType(at("C200"), Dint, model).ok());
    EXPECT_FALSE(family.withType(at("C199"), Dint, model).ok());
}

} // namespace
