#include "core/language/source/letters.h"
#include "core/language/source/operandtext.h"
#include "core/language/source/token.h"

#include <gtest/gtest.h>

#include <string>

using namespace camwright;

namespace {

const char* kindName(TokenKind kind)
{
    switch (kind) {
    case TokenKind::Mnemonic: return "mnemonic";
    case TokenKind::Address: return "address";
    case TokenKind::Number: return "number";
    case TokenKind::TypedConstant: return "typed";
    case TokenKind::Symbol: return "symbol";
    case TokenKind::Pin: return "pin";
    case TokenKind::Separator: return "separator";
    case TokenKind::Missing: return "missing";
    case TokenKind::Empty: return "empty";
    case TokenKind::Comment: return "comment";
    case TokenKind::NetworkHeader: return "header";
    case TokenKind::Group: return "group";
    case TokenKind::Invalid: return "invalid";
    }
    return "?";
}

std::string show(const Dialect& dialect, const std::string& line, LineState state = LineState::Code)
{
    std::vector<Token> tokens;
    const LineState after = tokenizeLine(dialect, line, state, tokens);
    std::string out;
    for (const Token& token : tokens)
        out += std::string(out.empty() ? "" : " ") + kindName(token.kind) + "<" + line.substr(token.column, token.length) + ">";
    return after == LineState::Comment ? out + " ..." : out;
}

TEST(TokensTest, splitsAKincoCallAtItsCommas) // KS-IL-01
{
    EXPECT_EQ(show(kincoIl(), "MC_RPARAS %M0.1, 1,%VB100 , Feed"),
        "mnemonic<MC_RPARAS> address<%M0.1> separator<,> number<1> separator<,> address<%VB100> separator<,> symbol<Feed>");
}

TEST(TokensTest, splitsTs600OperandsAtBlanks) // TS-IL-03
{
    EXPECT_EQ(show(ts600Il(), "\tADD # IN1 #IN2 D0.3"), "mnemonic<ADD> symbol<# IN1> symbol<#IN2> address<D0.3>");
    EXPECT_EQ(show(ts600Il(), "MOV 16#FF D0 // why"), "mnemonic<MOV> number<16#FF> address<D0> comment<// why>");
}

TEST(TokensTest, knowsNetworkHeadersAndComments) // KS-IL-02
{
    EXPECT_EQ(show(kincoIl(), "(* Network 12 *)"), "header<(* Network 12 *)>");
    EXPECT_EQ(show(kincoIl(), "(*network 3*) (* a *)"), "header<(*network 3*)> comment<(* a *)>");
    EXPECT_EQ(show(kincoIl(), "(* Network of axes *)"), "comment<(* Network of axes *)>");
    EXPECT_EQ(show(kincoIl(), "ST %M0.0 (* open"), "mnemonic<ST> address<%M0.0> comment<(* open> ...");
    EXPECT_EQ(show(kincoIl(), "still *) ST %M0.0", LineState::Comment), "comment<still *)> mnemonic<ST> address<%M0.0>");
    EXPECT_EQ(show(kincoIl(), "(*)"), "comment<(*)> ...");
}

TEST(TokensTest, endsAForgottenCommentBeforeAHeader)
{
    EXPECT_EQ(show(kincoIl(), "  (* Network 2 *)", LineState::Comment), "header<(* Network 2 *)>");
    EXPECT_EQ(show(kincoIl(), "see (* Network 2 *)", LineState::Comment), "comment<see (* Network 2 *)>");
}

TEST(TokensTest, marksMissingAndEmptyOperandsAndPins) // C6
{
    EXPECT_EQ(show(kincoIl(), "TON T0, PT := ?\?\?, _"),
        "mnemonic<TON> address<T0> separator<,> pin<PT> separator<:=> missing<?\?\?> separator<,> empty<_>");
    EXPECT_EQ(show(ts600Il(), "MC_Power Axis:=0 Enable := M0"),
        "mnemonic<MC_Power> pin<Axis> separator<:=> number<0> pin<Enable> separator<:=> address<M0>");
}

TEST(TokensTest, knowsGroupsAndComparisons)
{
    EXPECT_EQ(show(kincoIl(), "AND( %M0.0"), "mnemonic<AND(> address<%M0.0>");
    EXPECT_EQ(show(kincoIl(), ")"), "group<)>");
    EXPECT_EQ(show(ts600Il(), "LD>= D0 10"), "mnemonic<LD>=> address<D0> number<10>");
}

TEST(TokensTest, classifiesConstants) // KS-IL-05
{
    for (const char* text : {"B#0", "B#16#85", "DI#2000", "DI#-5", "W#2#101", "T#1s500ms", "REAL#1.5"})
        EXPECT_EQ(operandForm(kincoIl(), text), TokenKind::TypedConstant) << text;
    for (const char* text : {"1200.0", "0", "-12", "+3", "16#FF", "1e-3"})
        EXPECT_EQ(operandForm(kincoIl(), text), TokenKind::Number) << text;
    for (const char* text : {"%", "a b", "-", "?", "??", "%%M0.0", "M0.0)"})
        EXPECT_EQ(operandForm(kincoIl(), text), TokenKind::Invalid) << text;
    EXPECT_EQ(operandForm(ts600Il(), "X17"), TokenKind::Address);
    EXPECT_EQ(operandForm(ts600Il(), "电机启动"), TokenKind::Symbol); // TS-VAR-03
}

TEST(TokensTest, colouringByLineEqualsColouringTheWhole)
{
    const std::string text = "(* a\r\nb *)\n(* Network 0 *)\nLD %M0.0\n";
    const std::vector<Token> tokens = tokenize(kincoIl(), text);
    ASSERT_EQ(tokens.size(), 5u);
    EXPECT_EQ(tokens[1], (Token{TokenKind::Comment, 1, 0, 4}));
    EXPECT_EQ(tokens[4], (Token{TokenKind::Address, 3, 3, 5}));
}

TEST(LettersTest, decodesOnlyLegalUtf8)
{
    EXPECT_EQ(characterAt("\xD0\x92", 0).code, 0x0412u);
    for (const char* bad : {"\xC0\x80", "\xE0\x80\x80", "\xED\xA0\x80", "\xF4\x90\x80\x80", "\xFF", "\x80", "\xE4\xB8"})
        EXPECT_FALSE(characterAt(bad, 0).legal) << static_cast<int>(static_cast<unsigned char>(bad[0]));
}

TEST(LettersTest, replacesLookalikes)
{
    EXPECT_EQ(withLatinLetters("В#16#85"), "B#16#85");
    EXPECT_EQ(firstLookalike("В#16#85"), "U+0412");
    EXPECT_EQ(withLatinLetters("％Ｍ０．０"), "%M0.0");
}

TEST(LettersTest, cutsTextsForMessagesBetweenCharacters)
{
    EXPECT_EQ(shortened("абв", 4), "аб…");
    EXPECT_EQ(shortened("a\nb", 60), "a b");
}

} // namespace
