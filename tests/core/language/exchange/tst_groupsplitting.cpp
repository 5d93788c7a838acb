#include "core/language/exchange/groupsplitting.h"
#include "tests/core/language/check/checking.h"

#include <gtest/gtest.h>

using namespace camwright;
using namespace camwright::test;

namespace {

std::optional<std::string> split(const std::string& text)
{
    int next = 0;
    const ParsedProgram program = parseIl(kincoIl(), "(* Network 0 *)\n" + text);
    return splitGroups(program.networks.at(0), [&] { return "%M9." + std::to_string(next++); });
}

TEST(GroupSplittingTest, writesEachGroupToAMarker) // C32
{
    EXPECT_EQ(split("LD %M0.0\nAND( %M0.1 (* either *)\nOR %M0.2\n)\nST %M0.3\n"),
        "(* Network 0 *)\nLD      %M0.1\nOR      %M0.2\nST      %M9.0\n"
        "(* Network 1 *)\nLD      %M0.0\nAND     %M9.0  (* either *)\nST      %M0.3\n");
    EXPECT_EQ(split("LD %M0.0\nOR( %M0.1\nAND( %M0.2\nOR %M0.3\n)\n)\nST %M0.4\n"),
        "(* Network 0 *)\nLD      %M0.2\nOR      %M0.3\nST      %M9.0\n"
        "(* Network 1 *)\nLD      %M0.1\nAND     %M9.0\nST      %M9.1\n"
        "(* Network 2 *)\nLD      %M0.0\nOR      %M9.1\nST      %M0.4\n");
    EXPECT_EQ(split("LD %M0.0\nOR(\nEQ %VW0, 1\n)\nST %M0.3\n"),
        "(* Network 0 *)\nLD      %SM0.0\nEQ      %VW0, 1\nST      %M9.0\n"
        "(* Network 1 *)\nLD      %M0.0\nOR      %M9.0\nST      %M0.3\n");
}

TEST(GroupSplittingTest, resultIsStrictKinco)
{
    LanguageContext strict = ks101m();
    strict.strictKinco = true;
    const auto text = split("LD %M0.0\nAND(\nLDN %M0.1\nOR( %M0.2\nANDN %M0.5\n)\n)\nST %M0.3\n");
    ASSERT_TRUE(text);
    EXPECT_EQ(codesOf(check(strict, *text).diagnostics), "") << *text;
}

TEST(GroupSplittingTest, leavesWhatItCannotSplit)
{
    EXPECT_FALSE(split("LD %M0.0\nST %M0.3\n"));
    EXPECT_FALSE(split("LD %M0.0\nAND( %M0.1\nST %M0.3\n"));
    EXPECT_FALSE(split("LD %M0.0\nAND( %M0.1\nR_TRIG\n)\nST %M0.3\n"));
    EXPECT_FALSE(split("LD %M0.0\n)\n"));
}

} // namespace
