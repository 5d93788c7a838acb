#include "core/language/assist/completion.h"
#include "core/language/assist/hover.h"
#include "tests/core/language/check/checking.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace camwright;
using namespace camwright::test;

namespace {

/// The text with its cursor at '|'.
struct Cursor {
    std::string text;
    std::size_t offset;
};

Cursor at(std::string marked)
{
    const std::size_t offset = marked.find('|');
    marked.erase(offset, 1);
    return {marked, offset};
}

std::string completions(const LanguageContext& context, const std::string& marked)
{
    const Cursor cursor = at(marked);
    std::string out;
    for (const CompletionItem& item : completeAt(context, cursor.text, cursor.offset, TextLanguage::English).items)
        out += (out.empty() ? "" : " ") + item.text;
    return out;
}

std::optional<Hover> hover(const LanguageContext& context, const std::string& marked, TextLanguage language = TextLanguage::English)
{
    const Cursor cursor = at(marked);
    return hoverAt(context, cursor.text, cursor.offset, language);
}

TEST(CompletionTest, proposesInstructionsByPrefix)
{
    EXPECT_EQ(completions(ks101m(), "LD %M0.0\nmc_re|"), "MC_RESET MC_RESTART");
    EXPECT_EQ(completions(ts635(), "LD X0\nTON|"), "TON TONR");
    EXPECT_EQ(completions(ks101m(), "MC_PO|WER %M0.0"), "MC_POWER");
    const Cursor cursor = at("  mov|");
    const Completion completion = completeAt(ks101m(), cursor.text, cursor.offset, TextLanguage::English);
    EXPECT_EQ(completion.begin, 2u);
    EXPECT_EQ(completion.end, 5u);
    ASSERT_EQ(completion.items.size(), 1u);
    EXPECT_EQ(completion.items[0].detail, "MOVE IN, OUT");
    EXPECT_FALSE(completion.items[0].help.empty());
}

TEST(CompletionTest, knowsTheKoyoCatalogue)
{
    const LanguageContext koyo = contextFor("koyo", "DL-260");
    EXPECT_EQ(completions(koyo, "STR X0\nTMR|"), "TMR TMRA TMRAF TMRF");
    EXPECT_EQ(completions(koyo, "GTS |"), "Init ???");
    const std::string areas = completions(koyo, "OUTW |");
    EXPECT_NE(areas.find('V'), std::string::npos) << areas;
    EXPECT_EQ(areas.find('%'), std::string::npos) << areas;
    const auto box = hover(koyo, "STR M0\nIB-20|01 R5000 R5001");
    ASSERT_TRUE(box.has_value());
    EXPECT_TRUE(box->signature.starts_with("ML_PRRD Header Axis Work Error Sending Number Size")) << box->signature;
    EXPECT_EQ(box->whyNotSimulated, "I-box motion is not simulated yet.");
    const auto pin = hover(koyo, "STR M0\nIB-2001 R5000 R50|01", TextLanguage::Chinese);
    ASSERT_TRUE(pin.has_value() && pin->pin);
    EXPECT_EQ(pin->pin->name, "Axis");
    EXPECT_EQ(pin->help, "存放轴编号的寄存器，BCD 码 1～15。");
    const auto constant = hover(koyo, "STR X0\nLD K1|00");
    ASSERT_TRUE(constant.has_value() && constant->constant.has_value());
    EXPECT_EQ(constant->constant->asInteger(), 0x100);
}

TEST(CompletionTest, proposesWhatThePinTakes)
{
    EXPECT_TRUE(completions(ks101m(), "MC_POWER Start, |").starts_with("1 2 "));
    EXPECT_EQ(completions(ks101m(), "CAL |"), "Init ???");
    EXPECT_EQ(completions(ks101m(), "ST St|"), "Start");
    EXPECT_EQ(completions(ks101m(), "MOVE %VR0, Sp|"), "Speed");
    EXPECT_EQ(completions(ks101m(), "ST Sp|"), "") << "a REAL is no bit";
    EXPECT_EQ(completions(ks101m(), "ST %S|"), "%SM");
    EXPECT_EQ(completions(ks101m(), "MC_RPARAS %M0.1, 1, %V|"), "%VB");
    EXPECT_EQ(completions(ks101m(), "MOVE O|"), "OUT:=");
    EXPECT_EQ(completions(ts635(), "OUT L|"), "Lamp LM");
}

TEST(CompletionTest, proposesPlaceholdersAndNothingInComments) // C6
{
    EXPECT_TRUE(completions(ks101m(), "CTUD C0, %M0.0, %M0.1, %M0.2, 5, |").ends_with("??? _"));
    EXPECT_EQ(completions(ks101m(), "(* MO| *)"), "");
    EXPECT_EQ(completions(ks101m(), "(* a\nMO|"), "");
    EXPECT_EQ(completions(ts635(), "OUT Y0 // LD|"), "");
}

TEST(CompletionTest, followsNamedPins)
{
    EXPECT_EQ(completions(ks101m(), "MOVE OUT:=Sp|"), "Speed");
    EXPECT_EQ(completions(ks101m(), "CTU C0, PV:=5, St|"), "Start");
}

TEST(HoverTest, explainsInstructionsInThreeLanguages)
{
    const auto english = hover(ks101m(), "MC_|RPARAS %M0.1, 1, %VB100, 3, %M0.2, %M0.3, %MD8, %VD1200");
    ASSERT_TRUE(english);
    EXPECT_EQ(english->signature, "MC_RPARAS EXEC, AXIS, ID, NUM, DONE, ERR, ERRID, PARAS");
    EXPECT_EQ(english->begin, 0u);
    EXPECT_EQ(english->end, 9u);
    const auto chinese = hover(ks101m(), "MC_|RPARAS", TextLanguage::Chinese);
    const auto russian = hover(ks101m(), "MC_|RPARAS", TextLanguage::Russian);
    EXPECT_NE(english->help, chinese->help);
    EXPECT_NE(chinese->help, russian->help);
    EXPECT_FALSE(hover(ks105(), "PHO|ME")->whyNotSimulated.empty());
}

TEST(HoverTest, explainsOperands)
{
    const auto address = hover(ks101m(), "LD %M0.0\nMC_RPARAS %M0.1, 1, %VB|100");
    ASSERT_TRUE(address);
    EXPECT_EQ(address->pin->name, "ID");
    EXPECT_EQ(address->types, "BYTE");
    EXPECT_EQ(address->areas, "M, V, L");
    EXPECT_EQ(ks101m().family->formatAddress(*address->address), "%VB100");
    const auto variable = hover(ks101m(), "MOVE 1.5, Spe|ed");
    EXPECT_EQ(variable->variable->name, "Speed");
    EXPECT_EQ(variable->pin->name, "OUT");
    const auto bound = hover(ks101m(), "MOVE 1.5, %VR1|00");
    EXPECT_EQ(bound->variable->name, "Speed");
    const auto constant = hover(ks101m(), "MOVE B#16|#85, %VB0");
    EXPECT_EQ(formatValue(*constant->constant), "133");
    EXPECT_EQ(hover(ts635(), "CTUD C0 M0 Tot|al")->pin->name, "S");
}

TEST(HoverTest, saysNothingWhereNothingIsKnown)
{
    EXPECT_FALSE(hover(ks101m(), "(* MO|VE *)"));
    EXPECT_FALSE(hover(ks101m(), "FROB|NICATE"));
    EXPECT_FALSE(hover(ks101m(), "  |  "));
    EXPECT_FALSE(hover(ks101m(), "(* Netw|ork 0 *)"));
    EXPECT_FALSE(hover(ks101m(), "|"));
}

TEST(AssistTest, survivesEveryPlaceOfTheRawPages)
{
    for (const char* page : {"000_L302-351.txt", "001_L1105-1123.txt"}) {
        const std::string text = readFile(std::string(CAMWRIGHT_SOURCE_DIR "/tests/data/language/raw/") + page);
        for (std::size_t offset = 0; offset <= text.size(); offset += 7) {
            const Completion completion = completeAt(ks105(), text, offset, TextLanguage::English);
            EXPECT_LE(completion.begin, offset);
            EXPECT_GE(completion.end, offset);
            hoverAt(ks105(), text, offset, TextLanguage::English);
        }
    }
}

} // namespace
