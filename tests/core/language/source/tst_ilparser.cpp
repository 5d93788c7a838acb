#include "tests/core/language/source/trees.h"

#include <gtest/gtest.h>

using namespace camwright;
using namespace camwright::test;

namespace {

const char* const Example1 = "(*5*)\n"
                             "(* Network 0 *)\n"
                             "(*Set the table\n   to read.*)\n"
                             "LD      %SM0.0\n"
                             "MOVE    B#0,%VB100\n"
                             "\n"
                             "(* Network 1 *)\n"
                             "LD      %M0.0  (* go *)\n"
                             "MC_RPARAS %M0.1, 1, %VB100, 3, %M0.2, %M0.3, %MD8, %VD1200\n"
                             "(* the end *)\n"
                             "END\n";

TEST(IlParserTest, readsNetworksStatementsAndComments) // KS-IL-02
{
    const ParsedProgram program = parseIl(kincoIl(), Example1);
    EXPECT_EQ(codesOf(program.diagnostics), "");
    EXPECT_EQ(program.prologue, "(*5*)\n");
    EXPECT_EQ(program.epilogue, "END\n");
    ASSERT_EQ(program.networks.size(), 2u);
    const Rung& first = program.networks[0].rungs.at(0).rung;
    EXPECT_EQ(first.statements[0].leadingComments, std::vector<std::string>{"(*Set the table\n   to read.*)"});
    EXPECT_EQ(show(first), "(%SM0.0 MOVE:B#0,%VB100)");
    const Statement& call = program.networks[1].rungs.at(0).rung.statements[1];
    ASSERT_EQ(call.operands.size(), 8u);
    EXPECT_EQ(call.operands[7].text, "%VD1200");
    EXPECT_EQ(call.operands[7].range, (TextRange{10, 52, 10, 59}));
    EXPECT_EQ(program.networks[1].rungs[0].rung.statements[0].trailingComment, "(* go *)");
    EXPECT_EQ(program.networks[1].tail, "(* the end *)\n");
}

TEST(IlParserTest, writesEveryByteBack)
{
    const std::string crlf = [] {
        std::string out;
        for (const char c : std::string(Example1))
            out += c == '\n' ? std::string("\r\n") : std::string(1, c);
        return out;
    }();
    for (const std::string& text : {std::string(), std::string("\n"), std::string(Example1), crlf, std::string("\xEF\xBB\xBF") + Example1,
             std::string("LD"), std::string("(* Network 0 *) LD %M0.0 (* a\n b *) ST %M0.1 (* c\n d *)\n(* e *)"),
             std::string("junk\n(* Network 3 *)\n.\n```\nLD ,,,\n(* open\n\n  (* Network 4 *)\nst x"), std::string("a\0b\r\r\n", 6)})
        for (const Dialect* dialect : {&kincoIl(), &ts600Il()})
            EXPECT_EQ(writeIl(parseIl(*dialect, text)), text) << dialect->name;
}

TEST(IlParserTest, derivesTs600NetworksFromTheFlow)
{
    const ParsedProgram program = parseIl(ts600Il(), "// lamps\nLD X0\nOUT Y0\nLD X1\nAND X2\nSET M0\nRST M1\nLD X3\nOUT Y1\n");
    EXPECT_EQ(codesOf(program.diagnostics), "");
    ASSERT_EQ(program.networks.size(), 3u);
    EXPECT_EQ(program.networks[0].number, 1u); // TS-LAD-03
    EXPECT_EQ(program.networks[0].rungs[0].rung.statements[0].leadingComments, std::vector<std::string>{"// lamps"});
    EXPECT_EQ(show(program.networks[1].rungs[0].rung), "(X1 X2 SET:M0 RST:M1)");
    EXPECT_EQ(program.networks[1].rungs[0].source, "LD X1\nAND X2\nSET M0\nRST M1\n");
}

TEST(IlParserTest, keepsABlockAfterAnOutputInItsRung)
{
    const ParsedProgram program = parseIl(ts600Il(), "LD X0\nOUT Y0\nLD X1\nOR X2\nANB\nOUT Y1\nLD X3\nOUT Y2\n");
    EXPECT_EQ(codesOf(program.diagnostics), "");
    ASSERT_EQ(program.networks.size(), 2u);
    EXPECT_EQ(show(program.networks[0].rungs[0].rung), "(X0 OUT:Y0 [X1 | X2] OUT:Y1)");
    EXPECT_EQ(program.networks[1].number, 2u);
}

TEST(IlParserTest, takesNetworkHeadersInTs600Too)
{
    const ParsedProgram program = parseIl(ts600Il(), "(* Network 1 *)\nLD X0\nOUT Y0\nLD X1\nOUT Y1\n(* Network 2 *)\nLD X2\nOUT Y2\n");
    EXPECT_EQ(codesOf(program.diagnostics), "");
    ASSERT_EQ(program.networks.size(), 2u);
    EXPECT_EQ(program.networks[0].rungs.size(), 2u);
}

TEST(IlParserTest, writesAnEditedRungCanonicallyAndTheOthersAsTheyWere)
{
    ParsedProgram program = parseIl(kincoIl(), "(* Network 0 *)\n  LD   %M0.0 (* why *)\nst %M0.1\n(* Network 1 *)\nLD\t%M0.2\nST %M0.3\n");
    ParsedRung& rung = program.networks[0].rungs[0];
    rung.rung.statements[0].operands[0].text = "%M5.0";
    rung.edited = true;
    EXPECT_EQ(writeIl(program), "(* Network 0 *)\nLD      %M5.0  (* why *)\nst      %M0.1\n(* Network 1 *)\nLD\t%M0.2\nST %M0.3\n");
}

TEST(IlParserTest, writesAnEditedRungOfACrlfFileWithCrlf)
{
    ParsedProgram program = parseIl(kincoIl(), "(* Network 0 *)\r\nLD %M0.0\r\nST %M0.1\r\n");
    program.networks[0].rungs[0].edited = true;
    EXPECT_EQ(writeIl(program), "(* Network 0 *)\r\nLD      %M0.0\r\nST      %M0.1\r\n");
}

TEST(IlParserTest, closesACommentThatBelongsToTheLastStatementWithItsRung)
{
    ParsedProgram program = parseIl(kincoIl(), "(* Network 0 *)\nLD %M0.0\nST %M0.1 (* a\nb *)\n\n(* Network 1 *)\n");
    program.networks[0].rungs[0].edited = true;
    EXPECT_EQ(writeIl(program), "(* Network 0 *)\nLD      %M0.0\nST      %M0.1  (* a\nb *)\n\n(* Network 1 *)\n");
}

TEST(IlParserTest, warnsOfNetworkNumbersOutOfOrder)
{
    const ParsedProgram program = parseIl(kincoIl(), "(* Network 0 *)\nLD %M0.0\nST %M0.1\n(* Network 0 *)\nLD %M0.0\nST %M0.1\n");
    ASSERT_EQ(codesOf(program.diagnostics), "CW3016@4:1");
    EXPECT_FALSE(hasErrors(program.diagnostics));
}

TEST(IlParserTest, capsTheNumberOfDiagnostics)
{
    std::string text;
    for (int i = 0; i < 100000; ++i)
        text += "?\n";
    const ParsedProgram program = parseIl(kincoIl(), text);
    ASSERT_EQ(program.diagnostics.size(), MaximumDiagnostics + 1);
    EXPECT_EQ(program.diagnostics.back().code, Code::TooManyDiagnostics);
    EXPECT_EQ(writeIl(program), text);
}

TEST(IlParserTest, survivesHugeAndDeepInput)
{
    std::string deep = "LD %M0.0\n", names = "LD ", commas = "LD ", ladder = "LD X0\n", stairs;
    for (int i = 0; i < 50000; ++i) {
        deep += "AND(\n";
        names += "x";
        commas += ",";
        ladder += i % 2 ? "OR X1\n" : "AND X2\n";
        stairs += "MPS\n";
    }
    EXPECT_EQ(parseIl(kincoIl(), deep).diagnostics.front().code, Code::StatementBeforeNetwork);
    EXPECT_EQ(parseIl(kincoIl(), deep).diagnostics.at(1).code, Code::NestedTooDeep);
    EXPECT_LT(englishText(parseIl(kincoIl(), names + " y").diagnostics.at(1)).size(), 300u);
    EXPECT_EQ(parseIl(kincoIl(), commas).diagnostics.at(0).code, Code::TooManyOperandsToRead);
    const ParsedProgram text = parseIl(ts600Il(), ladder + "OUT Y0\n");
    EXPECT_EQ(codesOf(text.diagnostics), "");
    EXPECT_FALSE(text.networks[0].rungs[0].rung.drawable);
    EXPECT_EQ(parseIl(ts600Il(), "LD X0\n" + stairs).diagnostics.at(0).code, Code::NestedTooDeep);
    EXPECT_EQ(writeIl(parseIl(ts600Il(), ladder)), ladder);
}

} // namespace
