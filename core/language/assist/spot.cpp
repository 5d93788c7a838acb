#include "core/language/assist/spot.h"

#include "core/language/source/koyodialect.h"
#include "core/language/source/letters.h"

#include <algorithm>

namespace camwright {

namespace {

/// The line an offset stands in and the state of the lexer before it.
struct LineAt {
    std::string_view text;
    std::size_t begin = 0;
    LineState state = LineState::Code;
};

LineAt lineAt(const Dialect& dialect, std::string_view text, std::size_t offset)
{
    LineAt out;
    std::vector<Token> tokens;
    for (;;) {
        const std::size_t end = std::min(text.find('\n', out.begin), text.size());
        out.text = text.substr(out.begin, end - out.begin);
        if (out.text.ends_with('\r'))
            out.text.remove_suffix(1);
        if (offset <= end || end == text.size())
            return out;
        tokens.clear();
        out.state = tokenizeLine(dialect, out.text, out.state, tokens);
        out.begin = end + 1;
    }
}

const Pin* pinNamed(const Instruction& instruction, std::string_view name)
{
    for (const Pin& pin : instruction.pins)
        if (upperCase(pin.name) == upperCase(name))
            return &pin;
    return nullptr;
}

const Instruction* instructionOf(const LanguageContext& context, std::string_view mnemonic)
{
    const bool hasSynonyms = context.dialect->id == DialectId::KoyoIl;
    return context.family->catalogue().find(hasSynonyms ? koyoCatalogueName(mnemonic) : std::string(mnemonic));
}

/// Which pin an operand at `column` belongs to.
const Pin* pinAt(const Dialect& dialect, const Instruction& instruction, std::string_view line, const std::vector<Token>& tokens, std::size_t column)
{
    std::size_t index = 0;
    const Pin* named = nullptr;
    for (const Token& token : tokens) {
        const std::size_t end = token.column + token.length;
        const std::string_view text = line.substr(token.column, token.length);
        if (token.kind == TokenKind::Mnemonic || token.kind == TokenKind::Group || token.kind == TokenKind::Comment)
            continue;
        if (token.column >= column)
            break;
        if (token.kind == TokenKind::Pin) {
            named = pinNamed(instruction, text);
        } else if (token.kind == TokenKind::Separator && text == ",") {
            index += named ? 0 : 1;
            named = nullptr;
        } else if (token.kind != TokenKind::Separator && !dialect.commaSeparated && column > end) {
            index += named ? 0 : 1;
            named = nullptr;
        }
    }
    if (named)
        return named;
    return index < instruction.pins.size() ? &instruction.pins[index] : nullptr;
}

} // namespace

Spot spotAt(const LanguageContext& context, std::string_view text, std::size_t offset)
{
    offset = std::min(offset, text.size());
    const LineAt line = lineAt(*context.dialect, text, offset);
    const std::size_t column = std::min(offset - line.begin, line.text.size());
    std::vector<Token> tokens;
    tokenizeLine(*context.dialect, line.text, line.state, tokens);

    Spot out;
    out.begin = out.end = line.begin + column;
    const Token* mnemonic = nullptr;
    bool codeBefore = false;
    for (const Token& token : tokens) {
        const std::size_t end = token.column + token.length;
        if (token.kind == TokenKind::Mnemonic)
            mnemonic = &token;
        codeBefore = codeBefore || (token.kind != TokenKind::Comment && end < column);
        if (column < token.column || column > end || token.kind == TokenKind::Separator)
            continue;
        if (token.kind == TokenKind::Comment || token.kind == TokenKind::NetworkHeader) {
            const bool inside = column > token.column && (column < end || !line.text.substr(token.column, token.length).ends_with("*)"));
            out.isComment = out.isComment || inside;
            continue;
        }
        out.begin = line.begin + token.column;
        out.end = line.begin + end;
        out.word = line.text.substr(token.column, token.length);
        out.kind = token.kind;
    }
    if (tokens.empty() && line.state == LineState::Comment)
        out.isComment = true;
    if (mnemonic)
        out.instruction = instructionOf(context, line.text.substr(mnemonic->column, mnemonic->length));
    out.isMnemonic = !out.isComment && (mnemonic ? column >= mnemonic->column && column <= mnemonic->column + mnemonic->length : !codeBefore);
    if (out.instruction && !out.isMnemonic && !out.isComment && column > mnemonic->column)
        out.pin = out.kind == TokenKind::Pin ? pinNamed(*out.instruction, out.word) : pinAt(*context.dialect, *out.instruction, line.text, tokens, column);
    return out;
}

} // namespace camwright
