#include "core/language/exchange/pastedtext.h"
#include "tests/core/language/check/checking.h"

#include <gtest/gtest.h>

using namespace camwright;
using namespace camwright::test;

namespace {

std::string raw(const char* name)
{
    return readFile(std::string(CAMWRIGHT_SOURCE_DIR "/tests/data/language/raw/") + name);
}

TEST(PastedTextTest, mendsTheRawPagesOfTheManuals) // Appendix A, table of damage
{
    for (const char* page : {"001_L1075-1091.txt", "001_L1105-1123.txt"}) {
        const RepairedText repaired = repairPastedText(kincoIl(), raw(page));
        EXPECT_FALSE(repaired.repairs.empty());
        EXPECT_EQ(codesOf(check(ks105(), repaired.text).diagnostics), "") << repaired.text;
    }
    const RepairedText ex2 = repairPastedText(kincoIl(), raw("000_L393-422.txt"));
    const CheckedSources checked = check(ks101m(), ex2.text);
    EXPECT_TRUE(checked.programs) << ex2.text << codesOf(checked.diagnostics);
    EXPECT_EQ(checked.programs->front().networks.at(1).rungs.at(0).statements.size(), 4u); // the swallowed ones are back
    const RepairedText ex1 = repairPastedText(kincoIl(), raw("000_L302-351.txt"));
    EXPECT_EQ(codesOf(check(ks101m(), ex1.text).diagnostics).substr(0, 6), "CW3202") << ex1.text; // BN stays, and is named
}

struct Case {
    const char* name;
    const char* before;
    const char* after;
    Code code;
};

class PastedLines : public testing::TestWithParam<Case> {};

TEST_P(PastedLines, areMended)
{
    const RepairedText repaired = repairPastedText(kincoIl(), GetParam().before);
    EXPECT_EQ(repaired.text, GetParam().after);
    ASSERT_EQ(repaired.repairs.size(), 1u);
    EXPECT_EQ(repaired.repairs[0].code, GetParam().code);
    EXPECT_TRUE(repairPastedText(kincoIl(), repaired.text).repairs.empty()) << "mended twice";
}

const Case Cases[] = {
    {"header", "(\\* Network \\* 0)\n", "(* Network 0 *)\n", Code::MarkdownEscape},
    {"comment", "(\\* Пауза \\*)\r\n", "(* Пауза *)\r\n", Code::MarkdownEscape},
    {"mnemonic", "R\\_TRIG\n", "R_TRIG\n", Code::MarkdownEscape},
    {"fence", "```\nLD %M0.0\n", "LD %M0.0\n", Code::MarkdownFence},
    {"dot", "(*Invoke*).\n", "(*Invoke*)\n", Code::StrayText},
    {"percent", "ST M0.1\n", "ST %M0.1\n", Code::AddressMissingPercent},
    {"word", "MOVE %адресу VW0, %VW2\n", "MOVE %VW0, %VW2\n", Code::StrayLetters},
    {"blanks", "MOVE DI # 100, %SMD208\n", "MOVE DI#100, %SMD208\n", Code::ConstantHasBlanks},
    {"letter", "MOVE В # 16 # 85, %SMB67\n", "MOVE B#16#85, %SMB67\n", Code::LookalikeLetters},
    {"cyrillicAddress", "LD М0.4", "LD %M0.4", Code::LookalikeLetters},
    {"cyrillicMnemonic", "МOVE 1, %VW0", "MOVE 1, %VW0", Code::LookalikeLetters},
    {"zeroWidth", "LD %M0.\xE2\x80\x8B""0", "LD %M0.0", Code::OddCharacter},
    {"noBreak", "LD\xC2\xA0%M0.0", "LD %M0.0", Code::OddCharacter},
    {"comma", "MOVE %VW0 %VW2", "MOVE %VW0, %VW2", Code::MissingComma},
    {"openComment", "(* a 2000* b\nLD %M0.0\n(* Network 1 *)\n", "(* a 2000* b *)\nLD %M0.0\n(* Network 1 *)\n", Code::UnterminatedComment},
    {"openAtEnd", "LD %M0.0\n(* a", "LD %M0.0\n(* a *)", Code::CommentOpenAtEnd},
};
INSTANTIATE_TEST_SUITE_P(Lines, PastedLines, testing::ValuesIn(Cases), [](const auto& info) { return info.param.name; });

TEST(PastedTextTest, leavesLegalTextAlone)
{
    for (const char* text : {"", "(* Network 0 *)\nLD Пуск\nST Start_1 (* 100 % \\ *)\nMOVE B#16#85, %SMB67\n", "(* LD\nnot an instruction *)\nLD %M0.0\n"}) {
        const RepairedText repaired = repairPastedText(kincoIl(), text);
        EXPECT_EQ(repaired.text, text);
        EXPECT_TRUE(repaired.repairs.empty());
    }
    EXPECT_TRUE(repairPastedText(ts600Il(), "LD X0 // a\nMOV 5 D0\nOUT 灯\n").repairs.empty());
}

TEST(PastedTextTest, namesLineAndTextOfEachRepair)
{
    const RepairedText repaired = repairPastedText(kincoIl(), "(* Network 0 *)\nLD M0.4\nR\\_TRIG\n");
    ASSERT_EQ(repaired.repairs.size(), 2u);
    EXPECT_EQ(repaired.repairs[1], (PasteRepair{Code::MarkdownEscape, 3, "R\\_TRIG", "R_TRIG"}));
}

} // namespace
