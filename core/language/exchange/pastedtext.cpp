#include "core/language/exchange/pastedtext.h"

#include "core/language/source/headers.h"
#include "core/language/source/letters.h"
#include "core/language/source/operandtext.h"
#include "core/language/source/token.h"

#include <algorithm>
#include <optional>

namespace camwright {

namespace {

struct PastedLine {
    std::string text;        ///< as it is now
    std::string before;
    std::string end;         ///< "\n", "\r\n" or nothing
    bool removed = false;
    std::optional<Code> code; ///< of the first repair
};

std::vector<PastedLine> splitLines(std::string_view text)
{
    std::vector<PastedLine> out;
    while (!text.empty()) {
        const std::size_t end = text.find('\n');
        std::string_view line = text.substr(0, end);
        std::string lineEnd = end == std::string_view::npos ? "" : "\n";
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
        if (line.ends_with('\r')) {
            line.remove_suffix(1);
            lineEnd.insert(lineEnd.begin(), '\r');
        }
        out.push_back({std::string(line), std::string(line), lineEnd, false, {}});
    }
    return out;
}

void change(PastedLine& line, Code code, std::string text)
{
    if (line.text == text)
        return;
    line.text = std::move(text);
    if (!line.code)
        line.code = code;
}

void remove(PastedLine& line, Code code)
{
    line.removed = true;
    change(line, code, {});
    line.code = code;
}

std::string withoutOddCharacters(std::string_view text)
{
    std::string out;
    for (std::size_t at = 0; at < text.size();) {
        const Utf8Character character = characterAt(text, at);
        if (character.legal && isOddBlank(character.code))
            out += ' ';
        else if (!character.legal || !isOddCharacter(character.code))
            out += text.substr(at, character.length);
        at += character.length;
    }
    return out;
}

/// Backslashes before punctuation, as Markdown writes them.
std::string withoutEscapes(std::string_view text)
{
    std::string out;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool escapes = text[i] == '\\' && i + 1 < text.size() && std::string_view("*_()[]#.`>+-").find(text[i + 1]) != std::string_view::npos;
        if (!escapes)
            out += text[i];
    }
    return out;
}

void mendDocument(PastedLine& line)
{
    if (trimmed(line.text).starts_with("```")) {
        remove(line, Code::MarkdownFence);
        return;
    }
    change(line, Code::OddCharacter, withoutOddCharacters(line.text));
    if (const auto number = escapedNetworkHeader(line.text))
        change(line, Code::MarkdownEscape, "(* Network " + std::to_string(*number) + " *)");
    change(line, Code::MarkdownEscape, withoutEscapes(line.text));
}

/// Whether a line inside a comment is rather an instruction that the comment swallowed: a known word and an address.
bool looksLikeStatement(const Dialect& dialect, std::string_view line)
{
    std::vector<Token> tokens;
    tokenizeLine(dialect, line, LineState::Code, tokens);
    if (tokens.size() < 2 || tokens[0].kind != TokenKind::Mnemonic || tokens[1].kind != TokenKind::Address)
        return false;
    return dialect.shapeOf(line.substr(tokens[0].column, tokens[0].length)).role != StatementRole::Block;
}

/// Closes comments that run into a network header: before the first instruction they swallowed.
void closeComments(const Dialect& dialect, std::vector<PastedLine>& lines)
{
    LineState state = LineState::Code;
    std::size_t opened = 0;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        std::vector<Token> tokens;
        const bool ranInto = state == LineState::Comment && (isNetworkHeader(lines[i].text) || looksLikeStatement(dialect, lines[i].text));
        if (ranInto) {
            std::size_t last = i - 1;
            while (last > opened && (lines[last].removed || trimmed(lines[last].text).empty()))
                --last;
            change(lines[last], Code::UnterminatedComment, lines[last].text + " *)");
            state = LineState::Code;
        }
        const LineState before = state;
        state = tokenizeLine(dialect, lines[i].text, before, tokens);
        if (state == LineState::Comment && (before == LineState::Code || tokens.size() > 1))
            opened = i;
    }
    if (state == LineState::Comment && !lines.empty())
        change(lines.back(), Code::CommentOpenAtEnd, lines.back().text + " *)");
}

bool isPunctuation(std::string_view text)
{
    return std::all_of(text.begin(), text.end(), [](char c) { return isAscii(c) && !isAsciiLetter(c) && !isDigit(c) && c != '%' && c != '('; });
}

Code codeOf(OperandDamage damage)
{
    switch (damage) {
    case OperandDamage::MarkdownEscape: return Code::MarkdownEscape;
    case OperandDamage::Lookalike: return Code::LookalikeLetters;
    case OperandDamage::ConstantBlanks: return Code::ConstantHasBlanks;
    case OperandDamage::StrayLetters: return Code::StrayLetters;
    case OperandDamage::SeveralOperands: return Code::MissingComma;
    case OperandDamage::None: break;
    }
    return Code::BadOperand;
}

/// A token as it should be, and the code if it is not; tokens of comments stay.
std::optional<std::pair<Code, std::string>> mendedToken(const Dialect& dialect, const Token& token, std::string_view text, bool afterComment)
{
    switch (token.kind) {
    case TokenKind::Mnemonic: {
        const std::string latin = withLatinLetters(text);
        const bool plain = std::all_of(latin.begin(), latin.end(), isAscii);
        return latin != text && plain ? std::optional(std::pair(Code::LookalikeLetters, latin)) : std::nullopt;
    }
    case TokenKind::Invalid:
        if (afterComment && isPunctuation(text))
            return std::pair(Code::StrayText, std::string());
        [[fallthrough]];
    case TokenKind::Symbol: {
        if (const OperandRepair repair = examineOperand(dialect, text); repair.damage != OperandDamage::None)
            return std::pair(codeOf(repair.damage), repair.text);
        const std::string latin = withLatinLetters(text);
        if (dialect.commaSeparated && lacksPercent(latin))
            return std::pair(latin == text ? Code::AddressMissingPercent : Code::LookalikeLetters, "%" + latin);
        if (latin != text && operandForm(dialect, latin) == TokenKind::Address)
            return std::pair(Code::LookalikeLetters, latin);
        return std::nullopt;
    }
    default:
        return std::nullopt;
    }
}

void mendTokens(const Dialect& dialect, std::vector<PastedLine>& lines)
{
    LineState state = LineState::Code;
    for (PastedLine& line : lines) {
        std::vector<Token> tokens;
        const std::string text = line.text;
        state = tokenizeLine(dialect, text, state, tokens);
        std::string out;
        std::size_t done = 0;
        bool afterComment = false;
        std::optional<Code> code;
        for (const Token& token : tokens) {
            const auto mended = mendedToken(dialect, token, std::string_view(text).substr(token.column, token.length), afterComment);
            afterComment = token.kind == TokenKind::Comment || token.kind == TokenKind::NetworkHeader;
            if (!mended)
                continue;
            out += text.substr(done, token.column - done) + mended->second;
            done = token.column + token.length;
            code = code ? code : mended->first;
        }
        if (code)
            change(line, *code, out + text.substr(done));
    }
}

} // namespace

RepairedText repairPastedText(const Dialect& dialect, std::string_view text)
{
    std::vector<PastedLine> lines = splitLines(text);
    for (PastedLine& line : lines)
        mendDocument(line);
    closeComments(dialect, lines);
    mendTokens(dialect, lines);
    RepairedText out;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const PastedLine& line = lines[i];
        if (line.code)
            out.repairs.push_back({*line.code, static_cast<std::uint32_t>(i + 1), line.before, line.text});
        if (!line.removed)
            out.text += line.text + line.end;
    }
    return out;
}

} // namespace camwright
