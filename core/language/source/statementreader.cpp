#include "core/language/source/statementreader.h"

#include "core/language/source/koyodialect.h"
#include "core/language/source/letters.h"
#include "core/language/source/operandtext.h"

#include <fmt/format.h>

#include <algorithm>

namespace camwright {

namespace {

TextRange rangeIn(std::uint32_t line, std::size_t begin, std::size_t end)
{
    return {line, static_cast<std::uint32_t>(begin + 1), line, static_cast<std::uint32_t>(end + 1)};
}

TextRange rangeOf(std::uint32_t line, const Token& token)
{
    return rangeIn(line, token.column, token.column + token.length);
}

bool isInComment(std::span<const Token> tokens, std::size_t column)
{
    return std::any_of(tokens.begin(), tokens.end(), [&](const Token& token) {
        return token.kind == TokenKind::Comment && column >= token.column && column < token.column + token.length;
    });
}

std::string exampleAddress(const Dialect& dialect)
{
    switch (dialect.id) {
    case DialectId::KincoIl: return "%VW100";
    case DialectId::Ts600Il: return "D100";
    case DialectId::KoyoIl: break;
    }
    return "V1400";
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

} // namespace

Statement StatementReader::read(std::string_view line, std::uint32_t number, std::span<const Token> tokens)
{
    Statement out;
    const Token& first = tokens.front();
    out.mnemonic = line.substr(first.column, first.length);
    out.range = rangeIn(number, first.column, tokens.back().column + tokens.back().length);
    if (hasMarkdownEscapes(out.mnemonic)) {
        const std::string bare = withoutMarkdownEscapes(out.mnemonic);
        m_sink.add(Code::MarkdownEscape, rangeOf(number, first), {shortened(out.mnemonic), shortened(bare)});
        out.mnemonic = bare;
    }
    const MnemonicShape shape = m_dialect.shapeOf(out.mnemonic);
    out.role = shape.role;
    out.form = shape.form;
    if (tokens.size() > 2 * MaximumOperands) {
        m_sink.add(Code::TooManyOperandsToRead, out.range, {std::to_string(MaximumOperands)});
        out.role = StatementRole::Invalid;
        out.mnemonic = line.substr(first.column, tokens.back().column + tokens.back().length - first.column);
        return out;
    }
    readOperands(line, number, tokens.subspan(1), out);
    if (m_dialect.id == DialectId::KoyoIl)
        settleKoyoStatement(out);
    return out;
}

void StatementReader::readOperands(std::string_view line, std::uint32_t number, std::span<const Token> tokens, Statement& statement)
{
    std::string pin;
    bool expected = false; // an operand must come: after a comma
    bool any = false;      // an operand since the last comma
    const Token* last = nullptr;
    for (const Token& token : tokens) {
        const std::string_view text = line.substr(token.column, token.length);
        last = &token;
        if (token.kind == TokenKind::Pin) {
            pin = text;
        } else if (token.kind == TokenKind::Separator && text == ",") {
            if (!any)
                m_sink.add(Code::OperandLeftOut, rangeOf(number, token));
            expected = true;
            any = false;
        } else if (token.kind == TokenKind::Separator) {
            expected = true;
        } else if (text == "," && !m_dialect.commaSeparated) {
            m_sink.add(Code::UnexpectedComma, rangeOf(number, token), {std::string(m_dialect.name)});
        } else {
            Operand operand = readOperand(text, rangeOf(number, token));
            operand.pin = std::move(pin);
            pin.clear();
            statement.operands.push_back(std::move(operand));
            expected = false;
            any = true;
        }
    }
    if (expected && last)
        m_sink.add(Code::OperandLeftOut, rangeOf(number, *last));
}

Operand StatementReader::readOperand(std::string_view text, const TextRange& range)
{
    Operand out;
    out.text = text;
    out.range = range;
    const TokenKind form = operandForm(m_dialect, text);
    if (form == TokenKind::Missing)
        out.kind = OperandKind::Missing;
    else if (form == TokenKind::Empty)
        out.kind = OperandKind::Empty;
    const OperandRepair repair = examineOperand(m_dialect, text);
    if (repair.damage == OperandDamage::None && form != TokenKind::Invalid)
        return out;
    out.kind = OperandKind::Damaged;
    const Code code = codeOf(repair.damage);
    if (code == Code::BadOperand)
        m_sink.add(code, range, {shortened(text), exampleAddress(m_dialect)});
    else if (code == Code::LookalikeLetters)
        m_sink.add(code, range, {shortened(text), firstLookalike(text), shortened(repair.text)});
    else
        m_sink.add(code, range, {shortened(text), shortened(repair.text)});
    return out;
}

void StatementReader::checkCharacters(std::string_view line, std::uint32_t number, std::span<const Token> tokens)
{
    for (std::size_t at = 0; at < line.size() && !m_sink.isFull();) {
        const Utf8Character character = characterAt(line, at);
        const TextRange range = rangeIn(number, at, at + character.length);
        if (!character.legal) {
            m_sink.add(Code::SourceNotUtf8, range, {fmt::format("{:02X}", character.code)});
            return; // a file in another encoding has thousands; one a line tells enough
        }
        if (isOddCharacter(character.code) || (isOddBlank(character.code) && !isInComment(tokens, at)))
            m_sink.add(Code::OddCharacter, range, {codePointName(character.code)});
        at += character.length;
    }
}

} // namespace camwright
