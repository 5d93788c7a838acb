#include "core/family/cataloguereader.h"
#include "core/family/csv.h"
#include "core/family/embedded.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>

using namespace camwright;

namespace {

constexpr std::string_view Columns[] = {"a", "b"};

Code firstCode(std::string_view text)
{
    const auto table = CsvTable::read("t.csv", text, Columns);
    return table.ok() ? Code::Cancelled : table.error().front().code;
}

TEST(CsvTest, readsQuotesCommasAndLineBreaks)
{
    const auto table = CsvTable::read("t.csv", "a,b\n\"x, y\",\"say \"\"no\"\"\"\r\n\"two\nlines\",\nlast,row", Columns);
    ASSERT_TRUE(table.ok());
    ASSERT_EQ(table->rowCount(), 3u);
    EXPECT_EQ(table->cell(0, "a"), "x, y");
    EXPECT_EQ(table->cell(0, "b"), "say \"no\"");
    EXPECT_EQ(table->cell(1, "a"), "two\nlines");
    EXPECT_EQ(table->cell(1, "b"), "");
    EXPECT_EQ(table->cell(2, "b"), "row");
    EXPECT_EQ(table->line(2), 5u);
    EXPECT_EQ(table->cell(0, "c"), "");
}

TEST(CsvTest, saysWhichRowIsWrong)
{
    const auto table = CsvTable::read("t.csv", "a,b\n1,2\n1,2,3\n1\n", Columns);
    ASSERT_FALSE(table.ok());
    ASSERT_EQ(table.error().size(), 2u);
    EXPECT_EQ(englishLine(table.error()[0]), "t.csv:3:1: error CW2102: This row has 3 cells, but the header has 2.");
    EXPECT_EQ(table.error()[1].place.range.line, 4u);
}

TEST(CsvTest, refusesDamagedTables)
{
    EXPECT_EQ(firstCode(""), Code::TableColumnMissing);
    EXPECT_EQ(firstCode("a\n"), Code::TableColumnMissing);
    EXPECT_EQ(firstCode("a,b\n\"1,2\n"), Code::TableQuoteOpen);
    EXPECT_EQ(firstCode("a,b\n\"1\"x,2\n"), Code::TableQuoteOpen);
    EXPECT_EQ(firstCode("a,b\n"), Code::Cancelled);
}

TEST(CsvTest, typedCellsNameTheirColumn)
{
    constexpr std::string_view One[] = {"n"};
    const auto table = CsvTable::read("t.csv", "n\n300\n0xFF\n-1\nx\n", One);
    ASSERT_TRUE(table.ok());
    Diagnostics diagnostics;
    EXPECT_EQ(CsvRow(*table, 1, diagnostics).integer("n", 0, 255), 255);
    EXPECT_TRUE(diagnostics.empty());
    for (std::size_t row : {0u, 2u, 3u})
        EXPECT_EQ(CsvRow(*table, row, diagnostics).integer("n", 0, 255), 0);
    ASSERT_EQ(diagnostics.size(), 3u);
    EXPECT_EQ(diagnostics[0].place.field, "n");
    EXPECT_EQ(diagnostics[0].place.range.line, 2u);
}

/// Tables of a catalogue in memory, taken from the Kinco data and then damaged by a test.
struct Tables {
    std::string instructions{embeddedFamilyFile("kinco/instructions.csv")};
    std::string pins{embeddedFamilyFile("kinco/pins.csv")};
    std::string texts{embeddedFamilyFile("kinco/texts.csv")};
    std::string groups{embeddedFamilyFile("kinco/groups.csv")};

    Result<Catalogue, Diagnostics> read() const { return readCatalogue({instructions, pins, texts, groups}, findFamily("kinco")->areas()); }
};

void replace(std::string& text, std::string_view from, std::string_view to)
{
    const std::size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    text.replace(at, from.size(), to);
}

bool says(const Result<Catalogue, Diagnostics>& result, Code code, std::string_view column)
{
    return !result.ok() && std::ranges::any_of(result.error(), [&](const Diagnostic& d) { return d.code == code && d.place.field == column; });
}

TEST(CatalogueReaderTest, readsTheUndamagedTables)
{
    EXPECT_TRUE(Tables().read().ok());
}

TEST(CatalogueReaderTest, refusesANumberGivenTwice)
{
    Tables tables;
    replace(tables.instructions, "1002,LDN", "1001,LDN");
    EXPECT_TRUE(says(tables.read(), Code::TableDuplicate, "id"));
}

TEST(CatalogueReaderTest, refusesAPinOfNoInstruction)
{
    Tables tables;
    replace(tables.pins, "MC_WPARAS,EXEC", "MC_XPARAS,EXEC");
    EXPECT_TRUE(says(tables.read(), Code::TableCellIllegal, "mnemonic"));
}

TEST(CatalogueReaderTest, refusesUnknownAreasTypesAndTexts)
{
    Tables tables;
    replace(tables.pins, "LD,BIT,in,value,BOOL,,I Q", "LD,BIT,in,value,BOOLE,,I Y");
    replace(tables.instructions, "i.MC_MABS", "i.MC_NABS");
    const auto result = tables.read();
    EXPECT_TRUE(says(result, Code::TableCellIllegal, "types"));
    EXPECT_TRUE(says(result, Code::TableCellIllegal, "areas"));
    EXPECT_TRUE(says(result, Code::TableCellIllegal, "help"));
}

TEST(CatalogueReaderTest, theHashIsOfWhatACompilerUses)
{
    const Hash before = Tables().read()->hash();
    EXPECT_EQ(before, findFamily("kinco")->catalogue().hash()) << "two readings of the same bytes";
    Tables words;
    replace(words.texts, "Bit that is examined.", "The bit that is examined.");
    EXPECT_EQ(words.read()->hash(), before);
    Tables pins;
    replace(pins.pins, "LD,BIT,in,value,BOOL,,I Q M", "LD,BIT,in,value,BOOL,,I M");
    EXPECT_NE(pins.read()->hash(), before);
}

std::string koyoFile(const std::string& name)
{
    std::ifstream in(CAMWRIGHT_SOURCE_DIR "/tests/core/family/data/koyo/" + name, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

std::vector<MemoryArea> koyoAreas()
{
    std::vector<MemoryArea> out;
    for (const char* name : {"R", "I", "Q", "M", "GI", "GQ", "B"}) {
        MemoryArea area;
        area.id = static_cast<AreaId>(out.size());
        area.name = name;
        area.kind = area.id == 0 ? AreaKind::Words : AreaKind::Bits;
        area.elementBytes = area.id == 0 ? 2 : 1;
        area.octal = true;
        out.push_back(area);
    }
    return out;
}

// C9, third hard case.
TEST(CatalogueReaderTest, describesAnInterfaceBoxWithItsWorkArea)
{
    const std::string instructions = koyoFile("instructions.csv"), pins = koyoFile("pins.csv"), texts = koyoFile("texts.csv"),
                      groups = koyoFile("groups.csv");
    const auto catalogue = readCatalogue({instructions, pins, texts, groups}, koyoAreas());
    ASSERT_TRUE(catalogue.ok()) << englishLine(catalogue.error().front());
    const Instruction& box = *catalogue->find("ML_PRRD");
    EXPECT_EQ(box.pins.size(), 7u);
    EXPECT_TRUE(box.findPin("AxisNumber")->bcd);
    EXPECT_EQ(box.findPin("AxisNumber")->maximum, 15.0);
    EXPECT_EQ(box.findPin("Error")->areas.size(), 6u);
    const Pin& work = *box.findPin("WorkingMemory");
    EXPECT_EQ(work.fixedCount * work.elementBytes, 40u);

    const auto at = [](std::uint32_t word) { return valueAddress(0, 2 * word, DataType::Word); };
    const OperandSpan header{box.findPin("HeaderAddress"), at(05000), 10};
    EXPECT_FALSE(collide(header, {&work, at(05040), 20})) << "the manual's own example";
    EXPECT_TRUE(collide(header, {&work, at(05011), 20}));
    EXPECT_FALSE(collide(header, {&work, at(05012), 20}));
    EXPECT_TRUE(collide({&work, at(05040), 20}, {box.findPin("DataSize"), at(05063)})) << "R5063 is the last word of the work area";
    EXPECT_FALSE(collide({&work, at(05040), 20}, {box.findPin("DataSize"), at(05064)}));
    EXPECT_FALSE(collide({box.findPin("DataSize"), at(05003)}, {box.findPin("ParameterNumber"), at(05003)})) << "neither is private";
}

} // namespace
