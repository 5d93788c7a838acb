#include "tests/core/language/source/trees.h"

#include <gtest/gtest.h>

using namespace camwright;
using namespace camwright::test;

namespace {

Rung rungOf(const Dialect& dialect, const std::string& text)
{
    const std::string head = dialect.networkHeaders ? "(* Network 0 *)\n" : "";
    const ParsedProgram program = parseIl(dialect, head + text);
    EXPECT_EQ(codesOf(program.diagnostics), "") << text;
    EXPECT_EQ(program.networks.size(), 1u) << text;
    return program.networks.at(0).rungs.at(0).rung;
}

// The example of the TS600 manual, figure 5-3, word by word.
const char* const Manual = "LD X0\nOR X1\nAND X14\nMPS\nOUT Y0\nAND X1\nOUT Y1\nMPP\nAND X2\nMPS\nOUT Y2\nAND X3\nAND X4\nOUT Y3\n"
                           "MRD\nLD X5\nAND X6\nLD X7\nAND X10\nORB\nANB\nOUT Y4\nMPP\nOUT Y5\n";

TEST(RungTest, drawsTheExampleOfTheTs600Manual) // TS-IL-02
{
    EXPECT_EQ(show(rungOf(ts600Il(), Manual)),
        "([X0 | X1] X14 {(OUT:Y0 X1 OUT:Y1) / (X2 {(OUT:Y2 X3 X4 OUT:Y3) / ([(X5 X6) | (X7 X10)] OUT:Y4) / (OUT:Y5)})})");
}

struct Case {
    const char* name;
    DialectId dialect;
    const char* text;
    const char* tree;
};

class RungCases : public testing::TestWithParam<Case> {};

TEST_P(RungCases, drawsAndWritesBack)
{
    const Dialect& dialect = camwright::dialect(GetParam().dialect);
    const Rung rung = rungOf(dialect, GetParam().text);
    EXPECT_EQ(show(rung), GetParam().tree);
    const auto lines = linearize(dialect, rung);
    ASSERT_TRUE(lines);
    const std::string canonical = writeRung(dialect, *lines);
    const Rung again = rungOf(dialect, canonical);
    EXPECT_EQ(show(again), GetParam().tree) << canonical;
    EXPECT_EQ(writeRung(dialect, *linearize(dialect, again)), canonical);
}

using enum DialectId;
const Case Cases[] = {
    {"chain", KincoIl, "LD %M0.0\nANDN %M0.1\nST %M0.2\n", "(%M0.0 /%M0.1 ST:%M0.2)"},
    {"or", KincoIl, "LDN %M0.0\nOR %M0.1\nORN %M0.2\nAND %M0.3\nST %M0.4\n", "([/%M0.0 | %M0.1 | /%M0.2] %M0.3 ST:%M0.4)"},
    {"seriesOr", KincoIl, "LD %M0.0\nAND %M0.1\nOR %M0.2\nST %M0.4\n", "([(%M0.0 %M0.1) | %M0.2] ST:%M0.4)"},
    {"edge", KincoIl, "LD %M0.4\nR_TRIG\nMOVE DI#100, %SMD208\nST %SM201.4\n", "(%M0.4 R_TRIG MOVE:DI#100,%SMD208 ST:%SM201.4)"},
    {"compare", KincoIl, "LD %SM0.0\nGE %VW308, 0\nST %M3.0\n", "(%SM0.0 GE:%VW308,0 ST:%M3.0)"},
    {"severalOutputs", KincoIl, "LD %M0.0\nST %M0.1\nAND %M0.2\nS %M0.3\nR %M0.4\n", "(%M0.0 ST:%M0.1 %M0.2 S:%M0.3 R:%M0.4)"},
    {"andGroup", KincoIl, "LD %M0.0\nAND( %M0.1\nOR %M0.2\n)\nST %M0.3\n", "(%M0.0 [%M0.1 | %M0.2] ST:%M0.3)"},
    {"orGroup", KincoIl, "LD %M0.0\nOR( %M0.1\nANDN %M0.2\n)\nST %M0.3\n", "([%M0.0 | (%M0.1 /%M0.2)] ST:%M0.3)"},
    {"groupWithLoad", KincoIl, "LD %M0.0\nAND(\nLDN %M0.1\nOR %M0.2\n)\nST %M0.3\n", "(%M0.0 [/%M0.1 | %M0.2] ST:%M0.3)"},
    {"nestedGroup", KincoIl, "LD %M0.0\nAND( %M0.1\nOR( %M0.2\nAND( %M0.3\nOR %M0.4\n)\n)\n)\nST %M0.5\n",
        "(%M0.0 [%M0.1 | (%M0.2 [%M0.3 | %M0.4])] ST:%M0.5)"},
    {"compareGroup", KincoIl, "LD %M0.0\nOR(\nEQ %VW0, 1\n)\nST %M0.3\n", "([%M0.0 | EQ:%VW0,1] ST:%M0.3)"},
    {"timer", KincoIl, "LD %M0.0\nTON T0, 3000\nST %M0.1\n", "(%M0.0 TON:T0,3000 ST:%M0.1)"},
    {"blocks", Ts600Il, "LD X0\nAND X1\nLDI X2\nAND X3\nORB\nLD X4\nORI X5\nANB\nOUT Y0\n", "([(X0 X1) | (/X2 X3)] [X4 | /X5] OUT:Y0)"},
    {"edges", Ts600Il, "LDP X0\nORF X1\nANDP X2\nSET M0\n", "([LDP:X0 | ORF:X1] ANDP:X2 SET:M0)"},
    {"comparisons", Ts600Il, "LD>= D0 10\nANDD< D2 D4\nOR<> D1 0\nOUT Y0\n", "([(LD>=:D0,10 ANDD<:D2,D4) | OR<>:D1,0] OUT:Y0)"},
    {"fork", Ts600Il, "LD X0\nMPS\nAND X1\nOUT Y0\nMRD\nANI X2\nOUT Y1\nMPP\nOUT Y2\n", "(X0 {(X1 OUT:Y0) / (/X2 OUT:Y1) / (OUT:Y2)})"},
    {"forkInFork", Ts600Il, "LD X0\nMPS\nAND X1\nMPS\nOUT Y0\nMPP\nAND X2\nOUT Y1\nMPP\nOUT Y2\n",
        "(X0 {(X1 {(OUT:Y0) / (X2 OUT:Y1)}) / (OUT:Y2)})"},
    {"emptyBranch", Ts600Il, "LD X0\nMPS\nMPP\nOUT Y2\n", "(X0 {() / (OUT:Y2)})"},
    {"invert", Ts600Il, "LD X0\nINV\nOUT Y2\n", "(X0 INV OUT:Y2)"},
};
INSTANTIATE_TEST_SUITE_P(Rungs, RungCases, testing::ValuesIn(Cases), [](const auto& info) { return info.param.name; });

TEST(RungTest, writesTheManualsExampleBackWordByWord)
{
    const auto lines = linearize(ts600Il(), rungOf(ts600Il(), Manual));
    std::string out;
    for (const Statement& statement : lines->statements)
        out += statement.mnemonic + (statement.operands.empty() ? "" : " " + statement.operands[0].text) + "\n";
    EXPECT_EQ(out, Manual);
}

TEST(RungTest, keepsCommentsOfStructuralStatements)
{
    const Rung rung = rungOf(ts600Il(), "LD X0 // a\n// b\nLD X1\nOR X2\nANB // joined\n// c\nOUT Y0 // d\n");
    const auto lines = linearize(ts600Il(), rung);
    ASSERT_TRUE(lines);
    EXPECT_EQ(writeRung(ts600Il(), *lines), "LD      X0  // a\n// b\nLD      X1\nOR      X2\nANB\n// joined\n// c\nOUT     Y0  // d\n");
}

TEST(RungTest, keepsAnOutputInsideABranchAsTextRung)
{
    for (const char* text : {"LD %M0.0\nST %M0.1\nOR %M0.2\nST %M0.3\n", "LD %M0.0\nTON T0, 5\nOR %M0.2\nST %M0.3\n",
             "LD %M0.0\nAND(\nLD %M0.1\nST %M0.2\n)\nST %M0.3\n"}) {
        const Rung rung = rungOf(kincoIl(), text);
        EXPECT_EQ(show(rung), "text");
        EXPECT_EQ(writeRung(kincoIl(), *linearize(kincoIl(), rung)).size(), writeRung(kincoIl(), rung).size());
    }
    EXPECT_EQ(show(rungOf(ts600Il(), "LD X0\nMPS\nAND X1\nOR X2\nOUT Y0\nMPP\nOUT Y1\n")), "text");
}

TEST(RungTest, hasNoKincoTextForAFork)
{
    EXPECT_FALSE(linearize(kincoIl(), rungOf(ts600Il(), "LD X0\nMPS\nAND X1\nOUT Y0\nMPP\nOUT Y1\n")));
}

} // namespace
