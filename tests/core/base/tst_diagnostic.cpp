#include "core/base/bytes.h"
#include "core/base/diagnostic.h"

#include <gtest/gtest.h>

#include <set>

using namespace camwright;

namespace {

TEST(DiagnosticTest, fillsArgumentsOnceAndInAnyOrder)
{
    EXPECT_EQ(fillTemplate("%2 before %1, 5 % of %3", {"a %2", "b"}), "b before a %2, 5 % of ");
}

TEST(DiagnosticTest, saysFileLineCodeAndText)
{
    Place place;
    place.file = "programs/Main.il";
    place.range = {3, 7, 3, 9};
    EXPECT_EQ(englishLine(diagnostic(Code::Cancelled, {}, place)),
              "programs/Main.il:3:7: information CW0002: Cancelled. Nothing was changed.");
}

TEST(CodesTest, idsAreUniqueAndEachHasItsText)
{
    std::set<std::string_view> seen;
    for (const CodeInfo& info : allCodes()) {
        EXPECT_TRUE(seen.insert(info.id).second) << info.id << " stands twice";
        EXPECT_FALSE(info.text.empty()) << info.id;
    }
}

TEST(BytesTest, readerStopsAtTheEndAndSaysSo)
{
    ByteWriter writer;
    writer.put<std::uint16_t>(7);
    writer.putText("axis");
    ByteReader reader(writer.bytes());
    EXPECT_EQ(reader.get<std::uint16_t>(), 7);
    EXPECT_EQ(reader.getText(), "axis");
    EXPECT_TRUE(reader.ok() && reader.atEnd());
    EXPECT_EQ(reader.get<std::uint32_t>(), 0u);
    EXPECT_FALSE(reader.ok());
}

TEST(BytesTest, aHugeDeclaredLengthReadsNothing)
{
    ByteWriter writer;
    writer.put<std::uint32_t>(0xFFFFFFFF);
    ByteReader reader(writer.bytes());
    EXPECT_TRUE(reader.getBlob().empty());
    EXPECT_FALSE(reader.ok());
}

} // namespace
