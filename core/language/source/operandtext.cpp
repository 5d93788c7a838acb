#include "core/language/source/operandtext.h"

#include "core/language/source/koyodialect.h"
#include "core/language/source/letters.h"

#include <algorithm>

namespace camwright {

namespace {

std::string_view takeLetters(std::string_view& text)
{
    std::size_t n = 0;
    while (n < text.size() && isAsciiLetter(text[n]))
        ++n;
    const std::string_view out = text.substr(0, n);
    text.remove_prefix(n);
    return out;
}

bool takeDigits(std::string_view& text)
{
    std::size_t n = 0;
    while (n < text.size() && isDigit(text[n]))
        ++n;
    text.remove_prefix(n);
    return n > 0;
}

/// digits [ "." digits ] to the end
bool isElementNumber(std::string_view text)
{
    if (!takeDigits(text))
        return false;
    if (text.empty())
        return true;
    if (text.front() != '.')
        return false;
    text.remove_prefix(1);
    return takeDigits(text) && text.empty();
}

bool isOneOf(std::string_view word, std::initializer_list<std::string_view> words)
{
    return std::find(words.begin(), words.end(), word) != words.end();
}

bool isKincoAddress(std::string_view text)
{
    const bool percent = text.starts_with('%');
    if (percent)
        text.remove_prefix(1);
    const std::string area = upperCase(takeLetters(text));
    if (!isElementNumber(text))
        return false;
    if (isOneOf(area, {"T", "C"}))
        return true;
    return percent && !area.empty();
}

bool isTs600Address(std::string_view text)
{
    const std::string area = upperCase(takeLetters(text));
    return isOneOf(area, {"X", "Y", "M", "LM", "S", "T", "C", "D", "R", "V", "Z", "SM"}) && isElementNumber(text);
}

bool isKoyoAddress(std::string_view text)
{
    const std::string area = upperCase(takeLetters(text));
    return isOneOf(area, {"X", "Y", "C", "S", "T", "CT", "SP", "GX", "GY", "V", "B", "I", "Q", "M", "R", "GI", "GQ", "TA", "CTA", "ACC"})
        && isElementNumber(text);
}

bool isAddress(const Dialect& dialect, std::string_view text)
{
    switch (dialect.id) {
    case DialectId::KincoIl: return isKincoAddress(text);
    case DialectId::Ts600Il: return isTs600Address(text);
    case DialectId::KoyoIl: break;
    }
    return isKoyoAddress(text);
}

bool isNumber(std::string_view text)
{
    if (!text.empty() && (text.front() == '-' || text.front() == '+'))
        text.remove_prefix(1);
    if (text.empty() || !isDigit(text.front()))
        return false;
    return std::all_of(text.begin(), text.end(), [](char c) {
        return isDigit(c) || isAsciiLetter(c) || c == '.' || c == '#' || c == '_' || c == '-' || c == '+';
    });
}

bool isTypedConstant(std::string_view text)
{
    const std::string_view prefix = takeLetters(text);
    if (prefix.empty() || prefix.size() > 5 || !text.starts_with('#'))
        return false;
    text.remove_prefix(1);
    return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) {
        return isDigit(c) || isAsciiLetter(c) || c == '.' || c == '#' || c == '_' || c == '-' || c == '+';
    });
}

/// A name: letters of any script, digits, underscores; brackets and dots for parts of variables; a leading # on TS600.
bool isSymbol(const Dialect& dialect, std::string_view text)
{
    if (!dialect.commaSeparated && text.starts_with('#'))
        text = trimmed(text.substr(1));
    if (text.empty() || isDigit(text.front()) || text.front() == '.' || text.front() == '[')
        return false;
    return std::all_of(text.begin(), text.end(), [](char c) {
        return !isAscii(c) || isAsciiLetter(c) || isDigit(c) || c == '_' || c == '.' || c == '[' || c == ']';
    });
}

std::string without(std::string_view text, char dropped)
{
    std::string out(text);
    std::erase(out, dropped);
    return out;
}

/// The text without Cyrillic words: "%адресу VW0" gives "%VW0".
std::string withoutCyrillicWords(std::string_view text)
{
    std::string out;
    for (std::size_t at = 0; at < text.size();) {
        const Utf8Character character = characterAt(text, at);
        if (!(character.legal && isCyrillic(character.code)) && !isBlank(text[at]))
            out += text.substr(at, character.length);
        at += character.length;
    }
    return out;
}

/// An address or a constant; a symbol proves nothing.
bool isPlain(const Dialect& dialect, std::string_view text)
{
    const TokenKind form = operandForm(dialect, text);
    return form == TokenKind::Address || form == TokenKind::Number || form == TokenKind::TypedConstant;
}

bool everyWordIsPlain(const Dialect& dialect, std::string_view text)
{
    while (!(text = trimmed(text)).empty()) {
        const std::size_t end = std::min(text.find_first_of(" \t"), text.size());
        if (!isPlain(dialect, text.substr(0, end)))
            return false;
        text.remove_prefix(end);
    }
    return true;
}

std::string commaForBlanks(std::string_view text)
{
    std::string out;
    for (const char c : text)
        if (!isBlank(c))
            out += c;
        else if (!out.ends_with(", "))
            out += ", ";
    return out;
}

} // namespace

TokenKind operandForm(const Dialect& dialect, std::string_view text)
{
    if (text == "???")
        return TokenKind::Missing;
    if (text == "_")
        return TokenKind::Empty;
    if (isAddress(dialect, text))
        return TokenKind::Address;
    if (isNumber(text) || (dialect.id == DialectId::KoyoIl && koyoConstant(text)))
        return TokenKind::Number;
    if (isTypedConstant(text))
        return TokenKind::TypedConstant;
    return isSymbol(dialect, text) ? TokenKind::Symbol : TokenKind::Invalid;
}

bool lacksPercent(std::string_view text)
{
    std::string_view rest = text;
    const std::string area = upperCase(takeLetters(rest));
    if (!isElementNumber(rest))
        return false;
    for (const std::string_view known : {"SM", "AI", "AQ", "I", "Q", "M", "V", "L"})
        if (area.starts_with(known)) {
            const std::string_view size = std::string_view(area).substr(known.size());
            return size.empty() || isOneOf(size, {"B", "W", "D", "R"});
        }
    return false;
}

bool hasMarkdownEscapes(std::string_view text)
{
    return text.find('\\') != std::string_view::npos;
}

std::string withoutMarkdownEscapes(std::string_view text)
{
    return without(text, '\\');
}

OperandRepair examineOperand(const Dialect& dialect, std::string_view text)
{
    if (hasMarkdownEscapes(text))
        return {OperandDamage::MarkdownEscape, withoutMarkdownEscapes(text)};
    if (operandForm(dialect, text) != TokenKind::Invalid)
        return {};
    const bool hasBlanks = text.find_first_of(" \t") != std::string_view::npos;
    const std::string latin = withLatinLetters(text);
    const std::string joined = without(without(latin, ' '), '\t');
    const bool isConstant = text.find('#') != std::string_view::npos;
    if (hasCyrillic(text) && text.starts_with('%')) {
        if (const std::string bare = withoutCyrillicWords(text); hasBlanks && isPlain(dialect, bare))
            return {OperandDamage::StrayLetters, bare};
    }
    if (latin != text && isPlain(dialect, joined))
        return {OperandDamage::Lookalike, joined};
    if (hasBlanks && isConstant && isPlain(dialect, joined))
        return {OperandDamage::ConstantBlanks, joined};
    if (hasBlanks && everyWordIsPlain(dialect, text))
        return {OperandDamage::SeveralOperands, commaForBlanks(text)};
    if (hasBlanks && isPlain(dialect, joined) && text.starts_with('%'))
        return {OperandDamage::ConstantBlanks, joined};
    return {};
}

} // namespace camwright
