#include "core/storage/filenames.h"
#include "core/storage/objecttext.h"
#include "core/base/utf8.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

using namespace camwright;

namespace {

std::vector<std::string> hostileNames()
{
    std::vector<std::string> out{"", ".", "..", "../x", "a/b", "a\\b", "C:x", "CON", "con", "nul.txt", "COM1", "lpt9.a", "x.", " x", "x ",
                                 "a*b", "50%", "%46", "%-", "%~", std::string("a\0b", 3), "\n", "tab\t", "\xE2\x80\xAE" "drawkcab",
                                 "zero\xE2\x80\x8B" "width", "\xFF\xFE", "\xC3", "\xED\xA0\x80", "Feed", "feed", "FEED", "进给轴", "Подача",
                                 std::string(300, 'x'), std::string(4096, '/'), std::string(241, 'a') + "b", "-", "~", "aux", ".hidden"};
    std::mt19937 random(3);
    for (int n = 0; n < 1000; ++n) {
        std::string name;
        for (unsigned length = random() % (n % 50 == 0 ? 500 : 12); length-- > 0;)
            name += static_cast<char>(random() % 3 ? random() % 256 : "./\\:%CON "[random() % 9]);
        out.push_back(name);
    }
    return out;
}

TEST(FileNamesTest, everyNameGivesASafeStemThatReadsBack)
{
    for (const std::string& name : hostileNames()) {
        for (const std::string& stem : {stemOf(name), distinctStemOf(name)}) {
            EXPECT_FALSE(stem.empty());
            EXPECT_LE(stem.size(), 240u);
            EXPECT_EQ(stem.find_first_of(std::string_view("/\\:*?\"<>|\0\n", 11)), std::string::npos) << stem;
            EXPECT_EQ(firstInvalidUtf8(stem), std::string::npos);
            EXPECT_NE(stem.front(), '.');
            EXPECT_NE(stem.back(), '.');
            EXPECT_NE(stem.back(), ' ');
            if (!isShortened(stem)) {
                EXPECT_EQ(nameOfStem(stem), name) << stem;
            }
        }
        EXPECT_EQ(nameOfStem(encodedName(name)), name);
    }
}

TEST(FileNamesTest, plainNamesStayReadable)
{
    for (const char* name : {"Feed", "Axis 1 name", "进给轴", "Подача-2", "a.b", "x_(1)"})
        EXPECT_EQ(stemOf(name), name);
    EXPECT_EQ(fileOf({ObjectKind::Axis, "a/b"}), "axes/a%2Fb.toml");
    EXPECT_EQ(fileOf({ObjectKind::Program, "CON"}), "programs/%43ON.il");
    EXPECT_EQ(fileOf(projectKey()), "project.toml");
}

TEST(FileNamesTest, longNamesKeepABeginningAndDiffer)
{
    const std::string one = stemOf(std::string(300, 'x') + "1"), two = stemOf(std::string(300, 'x') + "2");
    EXPECT_TRUE(one.starts_with("xxxx"));
    EXPECT_NE(one, two);
    EXPECT_TRUE(isShortened(one));
}

TEST(FileNamesTest, namesThatDifferInCaseOnlyGetFilesThatDoNot)
{
    Project project;
    for (const char* name : {"Feed", "feed", "FEED", "Turn"})
        project = project.withContent({ObjectKind::Axis, name}, Axis{});
    std::set<std::string> seen;
    for (const auto& [key, object] : project.all())
        EXPECT_TRUE(seen.insert(foldedCase(fileOf(key, project))).second) << key.name;
    EXPECT_EQ(fileOf({ObjectKind::Axis, "Turn"}, project), "axes/Turn.toml");
}

TEST(FileNamesTest, misusedPercentIsNoName)
{
    for (const char* stem : {"50%", "%4", "%zz", "a%"})
        EXPECT_FALSE(nameOfStem(stem).has_value()) << stem;
}

} // namespace
