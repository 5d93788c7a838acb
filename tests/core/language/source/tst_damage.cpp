#include "tests/core/language/source/trees.h"

#include <gtest/gtest.h>

using namespace camwright;
using namespace camwright::test;

namespace {

/// A source that is wrong in a way the text alone shows, and all the codes it must give with their places.
struct Case {
    const char* name;
    DialectId dialect;
    const char* text;
    const char* codes;
};

class DamageCases : public testing::TestWithParam<Case> {};

TEST_P(DamageCases, areLocated)
{
    const ParsedProgram program = parseIl(dialect(GetParam().dialect), GetParam().text);
    EXPECT_EQ(codesOf(program.diagnostics), GetParam().codes);
    for (const Diagnostic& d : program.diagnostics)
        EXPECT_EQ(englishText(d).find('%' + std::string("1")), std::string::npos) << englishText(d);
    EXPECT_EQ(writeIl(program), GetParam().text);
}

using enum DialectId;
#define NET "(* Network 0 *)\n"
const Case Cases[] = {
    // The table of damage of Appendix A (KS-IL-09).
    {"A406_commentLostItsEnd", KincoIl, NET "(*2000* to parameter 8\nLD %SM0.0\nST %M0.0\n(* Network 1 *)\nLD %SM0.0\nST %M0.0\n", "CW3001@2:1"},
    {"A417_dotAfterComment", KincoIl, NET "(*Invoke Instruction*).\nLD %SM0.0\nST %M0.0\n", "CW3002@2:23"},
    {"B1075_escapedHeader", KincoIl, "(\\* Network \\* 0)\nLD %SM0.0\nST %M0.0\n", "CW3003@1:1"},
    {"B1105_escapedHeader", KincoIl, "(\\* Network 0 \\*)\nLD %SM0.0\nST %M0.0\n", "CW3003@1:1"},
    {"B1077_escapedComment", KincoIl, NET "(\\* Основано на сигнале \\*)\nLD %SM0.0\nST %M0.0\n", "CW3003@2:1"},
    {"B1081_escapedMnemonic", KincoIl, NET "LD %M0.4\nR\\_TRIG\nST %SM201.6\n", "CW3003@3:1"},
    {"B1111_cyrillicWord", KincoIl, NET "LD %SM0.0\nMOVE %адресу VW0, %VW2\n", "CW3006@3:6"},
    {"B1121_blanksInConstant", KincoIl, NET "LD %M0.4\nMOVE DI # 100, %SMD208\n", "CW3007@3:6"},
    {"B930_cyrillicLetterAndBlanks", KincoIl, NET "LD %M0.4\nMOVE В # 16 # 85, %SMB67\n", "CW3005@3:6"},
    {"cyrillicLetter", KincoIl, NET "LD %М0.4\nST %M0.0\n", "CW3005@2:4"},
    {"fullWidthComma", KincoIl, NET "LD %M0.4\nMOVE 1，%VW0\n", "CW3013@3:6"},
    {"fence", KincoIl, "```\n" NET "LD %M0.4\nST %M0.0\n```\n", "CW3004@1:1 CW3015@1:1 CW3016@2:1 CW3004@5:1"},
    // Comments.
    {"openAtEnd", KincoIl, NET "LD %M0.0\nST %M0.1\n(* so", "CW3019@4:1"},
    {"openAfterStatement", KincoIl, NET "LD %M0.0\nST %M0.1 (* so\nLD\n\n", "CW3019@3:10"},
    {"openTwice", KincoIl, "(* a\n(* Network 0 *)\n(* b\n(* Network 1 *)\n", "CW3001@1:1 CW3001@3:1"},
    {"textBehindComment", KincoIl, NET "LD %M0.0\n(* a *) ; (* b *)\nST %M0.1\n", "CW3002@3:9"},
    {"slashes", KincoIl, NET "LD %M0.0 // a\nST %M0.1\n", "CW3013@2:4"},
    {"bidiInComment", KincoIl, NET "(* a\xE2\x80\xAE *)\nLD %M0.0\nST %M0.1\n", "CW3008@2:5"},
    {"zeroWidth", KincoIl, NET "LD %M0.\xE2\x80\x8B""0\nST %M0.1\n", "CW3013@2:4 CW3008@2:8"},
    {"nul", KincoIl, NET "(* \x01 *)\nLD %M0.0\nST %M0.1\n", "CW3008@2:4"},
    {"noBreakSpace", KincoIl, NET "LD\xC2\xA0%M0.0\nST %M0.1\n", "CW3008@2:3"},
    {"noBreakSpaceInCommentIsFine", KincoIl, NET "(* a\xC2\xA0 *)\nLD %M0.0\nST %M0.1\n", ""},
    {"latin1", KincoIl, NET "(* \xE9 \xE9 *)\nLD %M0.0\nST %M0.1\n", "CW3009@2:4"},
    // Operands.
    {"blanksForComma", KincoIl, NET "LD %M0.0\nMOVE %VW0 %VW2\n", "CW3010@3:6"},
    {"doubleComma", KincoIl, NET "LD %M0.0\nMOVE %VW0,,%VW2\n", "CW3012@3:11"},
    {"leadingComma", KincoIl, NET "LD %M0.0\nMOVE ,%VW2\n", "CW3012@3:6"},
    {"trailingComma", KincoIl, NET "LD %M0.0\nMOVE %VW0,\n", "CW3012@3:10"},
    {"pinWithoutValue", KincoIl, NET "LD %M0.0\nTON T0, PT:=\n", "CW3012@3:11"},
    {"percentAlone", KincoIl, NET "LD %\nST %M0.1\n", "CW3013@2:4"},
    {"doublePercent", KincoIl, NET "LD %%M0.0\nST %M0.1\n", "CW3013@2:4"},
    {"semicolon", KincoIl, NET "LD %M0.0;\nST %M0.1\n", "CW3013@2:4"},
    {"equals", KincoIl, NET "LD %M0.0\nST %M0.1=1\n", "CW3013@3:4"},
    {"quote", KincoIl, NET "LD \"a\"\nST %M0.1\n", "CW3013@2:4"},
    {"blankInAddress", KincoIl, NET "LD %M 0.0\nST %M0.1\n", "CW3007@2:4"},
    {"escapedOperand", KincoIl, NET "LD Start\\_button\nST %M0.1\n", "CW3003@2:4"},
    {"commaInTs600", Ts600Il, "LD X0\nMOV 5, D0\n", "CW3011@2:6"},
    {"percentInTs600", Ts600Il, "LD %X0\nOUT Y0\n", "CW3013@1:4"},
    {"cyrillicInTs600", Ts600Il, "LD Х0\nOUT Y0\n", ""}, // a legal name as far as the text goes; the next stage knows better
    // Lines that are no statement.
    {"digits", KincoIl, NET "LD %M0.0\n12\nST %M0.1\n", "CW3002@3:1"},
    {"punctuation", KincoIl, NET "LD %M0.0\n---\nST %M0.1\n", "CW3002@3:1"},
    {"percentFirst", KincoIl, NET "LD %M0.0\n%M0.1\nST %M0.1\n", "CW3002@3:1"},
    {"closingStar", KincoIl, NET "LD %M0.0\n*)\nST %M0.1\n", "CW3002@3:1"},
    {"textAfterEnd", KincoIl, NET "LD %M0.0\nST %M0.1\nEND\n(* fine *)\nLD %M0.0\n", "CW3017@6:1"},
    {"textOnEndLine", KincoIl, NET "LD %M0.0\nST %M0.1\nEND (* fine *)\n", ""},
    // Networks.
    {"noHeader", KincoIl, "LD %M0.0\nST %M0.1\n", "CW3015@1:1"},
    {"startsAtOne", KincoIl, "(* Network 1 *)\nLD %M0.0\nST %M0.1\n", "CW3016@1:1"},
    {"hugeNumber", KincoIl, "(* Network 99999999999999999999 *)\n", "CW3016@1:1"},
    // Flow (KS-IL-03, TS-LAD-02).
    {"noLoad", KincoIl, NET "ST %M0.1\n", "CW3101@2:1"},
    {"noLoadTwice", KincoIl, NET "AND %M0.0\nST %M0.1\nST %M0.2\n", "CW3101@2:1"},
    {"secondLoad", KincoIl, NET "LD %M0.0\nST %M0.1\nLD %M0.2\nST %M0.3\n", "CW3102@4:1"},
    {"loadInGroupTwice", KincoIl, NET "LD %M0.0\nAND( %M0.1\nLD %M0.2\n)\nST %M0.3\n", "CW3102@4:1"},
    {"groupOpen", KincoIl, NET "LD %M0.0\nAND( %M0.1\nST %M0.3\n", "CW3106@3:1"},
    {"groupNotOpen", KincoIl, NET "LD %M0.0\n)\nST %M0.3\n", "CW3107@3:1"},
    {"doesNothing", KincoIl, NET "LD %M0.0\nAND %M0.1\n", "CW3501@2:1"},
    {"groupFirst", KincoIl, NET "OR( %M0.0\n)\nST %M0.1\n", "CW3101@2:1 CW3107@3:1"},
    {"anbAlone", Ts600Il, "LD X0\nANB\nOUT Y0\n", "CW3103@2:1"},
    {"orbAlone", Ts600Il, "LD X0\nORB\nOUT Y0\n", "CW3103@2:1"},
    {"mrdAlone", Ts600Il, "LD X0\nMRD\nOUT Y0\n", "CW3104@2:1"},
    {"mppAlone", Ts600Il, "LD X0\nMPP\nOUT Y0\n", "CW3104@2:1"},
    {"mpsOpen", Ts600Il, "LD X0\nMPS\nOUT Y0\n", "CW3105@2:1"},
    {"mpsOpenTwice", Ts600Il, "LD X0\nMPS\nMPS\nOUT Y0\nMPP\nOUT Y1\n", "CW3105@2:1"},
    {"twoLoads", Ts600Il, "LD X0\nLD X1\nOUT Y0\n", "CW3109@2:1"},
    {"outputFirst", Ts600Il, "OUT Y0\nLD X0\nOUT Y1\n", "CW3101@1:1"},
    {"doesNothingTs600", Ts600Il, "LD X0\n", "CW3501@1:1"},
    {"kincoBlockWord", KincoIl, NET "LD %M0.0\nANB\nST %M0.1\n", ""}, // unknown mnemonic: said by the next stage
};
INSTANTIATE_TEST_SUITE_P(Text, DamageCases, testing::ValuesIn(Cases), [](const auto& info) { return info.param.name; });

TEST(DamageTest, namesTheWayOut)
{
    const auto text = [](const char* source) { return englishText(parseIl(kincoIl(), source).diagnostics.at(0)); };
    EXPECT_EQ(text(NET "LD %M0.4\nMOVE DI # 100, %SMD208\n"), "\"DI # 100\" has blanks inside. Write DI#100.");
    EXPECT_EQ(text(NET "LD %M0.4\nMOVE В # 16 # 85, %SMB67\n"), "\"В # 16 # 85\" has a letter that only looks Latin (U+0412). Write B#16#85.");
    EXPECT_EQ(text(NET "LD %SM0.0\nMOVE %адресу VW0, %VW2\n"), "\"%адресу VW0\" has a foreign word inside an address. Write %VW0.");
    EXPECT_EQ(text("(\\* Network \\* 0)\nLD %SM0.0\nST %M0.0\n"), "\"(\\* Network \\* 0)\" has the backslashes of a Markdown document. Write (* Network 0 *).");
    EXPECT_EQ(text(NET "LD %M0.0\nMOVE %VW0 %VW2\n"), "\"%VW0 %VW2\" looks like several operands. Separate them by commas: %VW0, %VW2.");
    EXPECT_EQ(text(NET "(*2000* to\nLD %SM0.0\n(* Network 1 *)\n"), "The comment that begins here is not closed before network 1. End it with *).");
}

} // namespace
