#include "core/language/source/dialect.h"

#include <array>
#include <span>
#include <string>

namespace camwright {

namespace {

using enum StatementRole;
using Form = ContactForm;

struct Row {
    std::string_view mnemonic;
    StatementRole role;
    ContactForm form;
};

// Kinco: LD, ST, R_TRIG are in the manual; LDN, AND, ANDN, OR, ORN, S, R, EQ, NE are confirmed from outside; AND( OR( ) are
// IEC 61131-3 and ours (CONTRACTS 32).
constexpr Row KincoRows[] = {
    {"LD", Load, Form::NormallyOpen},   {"LDN", Load, Form::NormallyClosed},
    {"AND", And, Form::NormallyOpen},   {"ANDN", And, Form::NormallyClosed},
    {"OR", Or, Form::NormallyOpen},     {"ORN", Or, Form::NormallyClosed},
    {"EQ", And, Form::Equal},           {"NE", And, Form::NotEqual},
    {"GT", And, Form::Greater},         {"GE", And, Form::GreaterEqual},
    {"LT", And, Form::Less},            {"LE", And, Form::LessEqual},
    {"AND(", OpenAnd, Form::NormallyOpen}, {"OR(", OpenOr, Form::NormallyOpen}, {")", CloseGroup, Form::None},
    {"R_TRIG", Flow, Form::Rising},     {"F_TRIG", Flow, Form::Falling},
    {"NOT", Flow, Form::None},
    {"ST", Output, Form::None},         {"STN", Output, Form::None},
    {"S", Output, Form::None},          {"R", Output, Form::None},
};

// TS600: LD OR AND ANB ORB MPS MRD MPP OUT are in the manual; the rest is the common form of this kind of list.
constexpr Row Ts600Rows[] = {
    {"LD", Load, Form::NormallyOpen},   {"LDI", Load, Form::NormallyClosed},
    {"AND", And, Form::NormallyOpen},   {"ANI", And, Form::NormallyClosed},
    {"OR", Or, Form::NormallyOpen},     {"ORI", Or, Form::NormallyClosed},
    {"LDP", Load, Form::Rising},        {"LDF", Load, Form::Falling},
    {"ANDP", And, Form::Rising},        {"ANDF", And, Form::Falling},
    {"ORP", Or, Form::Rising},          {"ORF", Or, Form::Falling},
    {"ANB", AndBlock, Form::None},      {"ORB", OrBlock, Form::None},
    {"MPS", PushFlow, Form::None},      {"MRD", ReadFlow, Form::None}, {"MPP", PopFlow, Form::None},
    {"INV", Flow, Form::None},
    {"OUT", Output, Form::None},        {"SET", Output, Form::None},   {"RST", Output, Form::None},
};

// Koyo: RST is in the D2-MLINK manual; the rest is published for DL205. Several instructions may have one mnemonic
// (koyodialect.h); a comparison written with two operands stands before its name with a sign, which is ours.
constexpr Row KoyoRows[] = {
    {"STR", Load, Form::NormallyOpen},  {"STRN", Load, Form::NormallyClosed},
    {"AND", And, Form::NormallyOpen},   {"ANDN", And, Form::NormallyClosed},
    {"OR", Or, Form::NormallyOpen},     {"ORN", Or, Form::NormallyClosed},
    {"STRPD", Load, Form::Rising},      {"STRND", Load, Form::Falling},
    {"ANDPD", And, Form::Rising},       {"ANDND", And, Form::Falling},
    {"ORPD", Or, Form::Rising},         {"ORND", Or, Form::Falling},
    {"STRE", Load, Form::Equal},        {"STRNE", Load, Form::NotEqual},
    {"ANDE", And, Form::Equal},         {"ANDNE", And, Form::NotEqual},
    {"ORE", Or, Form::Equal},           {"ORNE", Or, Form::NotEqual},
    {"STR", Load, Form::GreaterEqual},  {"STRN", Load, Form::Less},
    {"AND", And, Form::GreaterEqual},   {"ANDN", And, Form::Less},
    {"OR", Or, Form::GreaterEqual},     {"ORN", Or, Form::Less},
    {"STR>=", Load, Form::GreaterEqual}, {"STR<", Load, Form::Less},
    {"AND>=", And, Form::GreaterEqual}, {"AND<", And, Form::Less},
    {"OR>=", Or, Form::GreaterEqual},   {"OR<", Or, Form::Less},
    {"ANDSTR", AndBlock, Form::None},   {"ORSTR", OrBlock, Form::None},
    {"NOT", Flow, Form::None},
    {"OUT", Output, Form::None},        {"SET", Output, Form::None},
    {"RST", Output, Form::None},        {"PD", Output, Form::None},
};

struct Comparison {
    std::string_view sign;
    ContactForm form;
};
constexpr Comparison Comparisons[] = {
    {"=", Form::Equal}, {"<>", Form::NotEqual}, {">=", Form::GreaterEqual},
    {"<=", Form::LessEqual}, {">", Form::Greater}, {"<", Form::Less},
};
struct Position {
    std::string_view word;
    StatementRole role;
};
constexpr Position Positions[] = {{"LD", Load}, {"AND", And}, {"OR", Or}};

constexpr char Widths[] = {' ', 'D', 'R'};

/// All TS600 comparisons: LD= … ORR<=, in a fixed order, as text that outlives every view of it.
constexpr std::size_t ComparisonCount = std::size(Positions) * std::size(Widths) * std::size(Comparisons);

std::size_t comparisonIndex(std::size_t position, std::size_t width, std::size_t sign)
{
    return (position * std::size(Widths) + width) * std::size(Comparisons) + sign;
}

const std::array<std::string, ComparisonCount>& comparisonNames()
{
    static const auto names = [] {
        std::array<std::string, ComparisonCount> out;
        for (std::size_t p = 0; p < std::size(Positions); ++p)
            for (std::size_t w = 0; w < std::size(Widths); ++w)
                for (std::size_t s = 0; s < std::size(Comparisons); ++s) {
                    std::string& name = out[comparisonIndex(p, w, s)];
                    name = Positions[p].word;
                    if (Widths[w] != ' ')
                        name += Widths[w];
                    name += Comparisons[s].sign;
                }
        return out;
    }();
    return names;
}

std::span<const Row> rowsOf(DialectId id)
{
    switch (id) {
    case DialectId::KincoIl: return KincoRows;
    case DialectId::Ts600Il: return Ts600Rows;
    case DialectId::KoyoIl: break;
    }
    return KoyoRows;
}

std::optional<MnemonicShape> comparisonShape(std::string_view name)
{
    const auto& names = comparisonNames();
    for (std::size_t p = 0; p < std::size(Positions); ++p)
        for (std::size_t w = 0; w < std::size(Widths); ++w)
            for (std::size_t s = 0; s < std::size(Comparisons); ++s)
                if (names[comparisonIndex(p, w, s)] == name)
                    return MnemonicShape{Positions[p].role, Comparisons[s].form, DialectId::Ts600Il, Widths[w]};
    return std::nullopt;
}

std::string upper(std::string_view text)
{
    std::string out(text);
    for (char& c : out)
        if (c >= 'a' && c <= 'z')
            c = static_cast<char>(c - 'a' + 'A');
    return out;
}

} // namespace

MnemonicShape Dialect::shapeOf(std::string_view mnemonic) const
{
    constexpr std::size_t LongestStructural = 8;
    MnemonicShape shape;
    shape.dialect = id;
    if (mnemonic.size() > LongestStructural)
        return shape;
    const std::string name = upper(mnemonic);
    for (const Row& row : rowsOf(id))
        if (row.mnemonic == name)
            return {row.role, row.form, id, ' '};
    if (id == DialectId::Ts600Il)
        if (const auto comparison = comparisonShape(name))
            return *comparison;
    return shape;
}

std::string_view Dialect::contactMnemonic(StatementRole position, ContactForm form, char width) const
{
    for (const Row& row : rowsOf(id))
        if (row.role == position && row.form == form)
            return row.mnemonic;
    if (id != DialectId::Ts600Il)
        return {};
    for (std::size_t p = 0; p < std::size(Positions); ++p)
        for (std::size_t w = 0; w < std::size(Widths); ++w)
            for (std::size_t s = 0; s < std::size(Comparisons); ++s)
                if (Positions[p].role == position && Widths[w] == width && Comparisons[s].form == form)
                    return comparisonNames()[comparisonIndex(p, w, s)];
    return {};
}

bool Dialect::standsAlone(std::string_view mnemonic)
{
    const std::string name = mnemonic.size() <= 4 ? upper(mnemonic) : std::string();
    return name == "LBL" || name == "NEXT";
}

std::string_view Dialect::structureMnemonic(StatementRole role) const
{
    for (const Row& row : rowsOf(id))
        if (row.role == role)
            return row.mnemonic;
    return {};
}

const Dialect& kincoIl()
{
    static const Dialect out{DialectId::KincoIl, "Kinco IL", "kinco", true, false, true, 0};
    return out;
}

const Dialect& ts600Il()
{
    static const Dialect out{DialectId::Ts600Il, "TS600 IL", "invt", false, true, false, 1};
    return out;
}

const Dialect& koyoIl()
{
    static const Dialect out{DialectId::KoyoIl, "Koyo IL", "koyo", false, true, false, 1};
    return out;
}

const Dialect& dialect(DialectId id)
{
    switch (id) {
    case DialectId::KincoIl: return kincoIl();
    case DialectId::Ts600Il: return ts600Il();
    case DialectId::KoyoIl: break;
    }
    return koyoIl();
}

const Dialect* dialectOfFamily(std::string_view family)
{
    for (const Dialect* candidate : {&kincoIl(), &ts600Il(), &koyoIl()})
        if (candidate->family == family)
            return candidate;
    return nullptr;
}

} // namespace camwright
