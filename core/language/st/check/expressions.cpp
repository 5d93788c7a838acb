#include "core/language/st/check/checker.h"

#include "core/language/source/letters.h"

namespace camwright::st {

// The part of Checker for operands: literals, names, members, elements.

namespace {

Elementary elementaryOf(TokenKind literal)
{
    switch (literal) {
    case TokenKind::Duration: return Elementary::Time;
    case TokenKind::LongDuration: return Elementary::Ltime;
    case TokenKind::Date: return Elementary::Date;
    case TokenKind::LongDate: return Elementary::Ldate;
    case TokenKind::TimeOfDay: return Elementary::Tod;
    case TokenKind::LongTimeOfDay: return Elementary::Ltod;
    case TokenKind::DateTime: return Elementary::Dt;
    default: return Elementary::Ldt;
    }
}

int hexDigit(char c)
{
    return c >= '0' && c <= '9' ? c - '0' : c >= 'a' && c <= 'f' ? c - 'a' + 10 : c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
}

/// The character of $L, $N …; 0 if there is none.
char namedCharacter(char c)
{
    switch (c | 0x20) {
    case 'l':
    case 'n': return '\n';
    case 'p': return '\f';
    case 'r': return '\r';
    case 't': return '\t';
    default: return c == '$' || c == '\'' || c == '"' ? c : '\0';
    }
}

} // namespace

/// ns in one unit of a time or date type.
std::int64_t nsPerUnit(Elementary e)
{
    switch (e) {
    case Elementary::Time:
    case Elementary::Tod: return 1'000'000;
    case Elementary::Date:
    case Elementary::Dt: return 1'000'000'000;
    default: return 1;
    }
}

const Type& Checker::checkExpr(Expr& expr)
{
    if (expr.type)
        return *expr.type;
    expr.type = &m_bad;
    switch (expr.kind) {
    case ExprKind::Literal: checkLiteral(expr); break;
    case ExprKind::Name: checkName(expr); break;
    case ExprKind::Address: checkAddress(expr); break;
    case ExprKind::Member: checkMember(expr); break;
    case ExprKind::Index: checkIndex(expr); break;
    case ExprKind::Dereference: checkDereference(expr); break;
    case ExprKind::Unary: checkUnary(expr); break;
    case ExprKind::Binary: checkBinary(expr); break;
    case ExprKind::Call: checkCall(expr); break;
    case ExprKind::Typed: checkTyped(expr); break;
    case ExprKind::This:
    case ExprKind::Super: checkThis(expr); break;
    case ExprKind::Aggregate: report(Code::StNotHere, expr, {textOf(expr)}); break;
    case ExprKind::Bad:
    case ExprKind::Convert: break;
    }
    return *expr.type;
}

void Checker::checkLiteral(Expr& expr)
{
    switch (expr.literal) {
    case TokenKind::Integer:
        expr.type = &m_anyInteger;
        expr.constant = makeInteger(Wide{expr.value});
        return;
    case TokenKind::Real:
        expr.type = &m_anyReal;
        expr.constant = makeReal(std::bit_cast<double>(expr.value));
        return;
    case TokenKind::Text:
    case TokenKind::WideText: return checkText(expr);
    case TokenKind::Word: {
        const Word word = Names::wordOf(expr.name);
        expr.type = word == Word::NULL_ ? &m_null : &boolType();
        expr.constant = makeInteger(word == Word::TRUE ? 1 : 0);
        return;
    }
    default: break;
    }
    const Elementary e = elementaryOf(expr.literal);
    const Wide value = Wide{static_cast<std::int64_t>(expr.value)} / nsPerUnit(e);
    expr.type = &elementary(e);
    if (value < smallestOf(e) || value > largestOf(e)) {
        report(Code::StOutOfRange, expr, {textOf(expr), std::string(elementaryName(e)), wideText(smallestOf(e)), wideText(largestOf(e))});
        return setBad(expr);
    }
    expr.constant = makeInteger(value);
}

/// Replaces the escapes of a string.
void Checker::checkText(Expr& expr)
{
    const std::string_view written = m_out.lines[m_file].text().substr(expr.offset + 1, expr.end - expr.offset - 2);
    const bool isWide = expr.literal == TokenKind::WideText;
    const std::size_t digits = isWide ? 4 : 2;
    std::string out;
    out.reserve(written.size());
    for (std::size_t at = 0; at < written.size(); ++at) {
        if (written[at] != '$') {
            out += written[at];
            continue;
        }
        const char named = at + 1 < written.size() ? namedCharacter(written[at + 1]) : '\0';
        int code = 0;
        bool isCode = at + digits < written.size();
        for (std::size_t i = 1; isCode && i <= digits; ++i) {
            isCode = hexDigit(written[at + i]) >= 0;
            code = code * 16 + hexDigit(written[at + i]);
        }
        if (named == '\0' && !isCode) {
            const auto place = static_cast<std::uint32_t>(expr.offset + 1 + at);
            report(Code::StBadEscape, place, place + 2, {shortened(written.substr(at, 1 + digits))});
        } else if (named != '\0') {
            out += named;
            ++at;
        } else {
            out += static_cast<char>(code);
            at += digits;
        }
    }
    Constant& constant = m_out.constants.emplace_back();
    constant.isText = true;
    constant.text = m_out.arena.copy(out);
    expr.constant = &constant;
    expr.type = &m_anyText;
}

void Checker::checkName(Expr& expr)
{
    if (expr.name == 0)
        return;
    const bool isResult = m_pou && m_pou->result && m_pou->tree->name == expr.name; // a function's own name: what it gives back
    Symbol* symbol = isResult ? m_pou->result : lookUp(expr.name);
    if (!symbol)
        return unknownName(expr);
    expr.symbol = symbol;
    symbol->isRead = true;
    switch (symbol->kind) {
    case SymbolKind::Variable:
    case SymbolKind::EnumValue:
        expr.type = symbol->type ? symbol->type : &m_bad;
        expr.constant = symbol->constant;
        return;
    default: break;
    }
    report(Code::StVariableNeeded, expr);
    expr.symbol = nullptr;
}

/// A direct address such as %IX0.0 or %VW304.
void Checker::checkAddress(Expr& expr)
{
    const std::string written = textOf(expr);
    DataType type = DataType::Bool;
    const char size = written.size() > 2 ? static_cast<char>(written[2] & ~0x20) : '\0';
    Elementary e = size == 'B' ? Elementary::Byte : size == 'W' ? Elementary::Word : size == 'D' ? Elementary::Dword : size == 'L' ? Elementary::Lword : size == 'R' ? Elementary::Real : Elementary::Bool;
    type = dataTypeOf(e);
    Symbol& symbol = m_out.symbols.emplace_back();
    symbol.type = &elementary(e);
    symbol.section = Section::Global;
    if (m_environment.isLoose || !m_environment.findAddress) {
        symbol.offset = allocate(8, 8);
    } else if (const auto address = m_environment.findAddress(written, type)) {
        symbol.storage = Storage::Located;
        symbol.address = *address;
    } else {
        return report(Code::StNotAnAddressHere, expr, {written, std::string(elementaryName(e))});
    }
    expr.symbol = &symbol;
    expr.type = symbol.type;
}

void Checker::checkMember(Expr& expr)
{
    const Type& object = checkExpr(*expr.left);
    if (object.kind == TypeKind::Bad)
        return;
    if (expr.isBased)
        return checkBit(expr);
    Symbol* member = object.kind == TypeKind::Enum ? nullptr : findMember(object, expr.name);
    const bool isHidden = member && object.kind == TypeKind::Block && member->section != Section::Input && member->section != Section::Output && expr.left->kind != ExprKind::This;
    if (!member || isHidden)
        return report(Code::StNoMember, expr, {typeName(object), text(expr.name)});
    expr.symbol = member;
    expr.type = member->type;
}

/// Bit of an integer or a bit string: WORD.3. Read only as a value; writing it is not part of the core.
void Checker::checkBit(Expr& expr)
{
    const Type& type = *expr.left->type;
    const bool hasBits = type.kind == TypeKind::Elementary && (isBits(type.elementary) || isAnyInteger(type.elementary));
    if (!hasBits)
        return report(Code::StNoMember, expr, {typeName(type), std::to_string(expr.value)});
    if (expr.value >= bitWidth(type.data))
        return report(Code::StOutOfRange, expr, {std::to_string(expr.value), typeName(type), "0", std::to_string(bitWidth(type.data) - 1)});
    expr.type = &boolType();
}

void Checker::checkIndex(Expr& expr)
{
    const Type* array = &checkExpr(*expr.left);
    for (Argument& argument : expr.arguments) {
        if (!argument.value || argument.name != 0) {
            report(Code::StNotHere, argument.offset, argument.end, {text(argument.name)});
            return setBad(expr);
        }
        checkExpr(*argument.value);
        if (array->kind == TypeKind::Bad)
            continue;
        if (array->kind != TypeKind::Array) {
            if (&argument == expr.arguments.first)
                report(Code::StNotA, *expr.left, {textOf(*expr.left), CW_TEXT("Arguments", "an array")});
            else
                report(Code::StSubscriptCount, *argument.value);
            array = &m_bad;
            continue;
        }
        const bool isWide = argument.value->type->kind == TypeKind::Elementary && (bitWidth(argument.value->type->data) > 32 || argument.value->type->data == DataType::Udint);
        coerce(argument.value, elementary(isWide ? argument.value->type->elementary : Elementary::Dint));
        if (const Constant* constant = argument.value->constant; constant && (constant->integer < array->low || constant->integer > array->high)) {
            report(Code::StIndexOutside, *argument.value, {wideText(constant->integer), std::to_string(array->low), std::to_string(array->high)});
            array = &m_bad;
            continue;
        }
        array = array->element;
    }
    expr.type = array;
}

void Checker::checkDereference(Expr& expr)
{
    const Type& type = checkExpr(*expr.left);
    if (type.kind == TypeKind::Reference)
        expr.type = type.element;
    else if (type.kind != TypeKind::Bad)
        report(Code::StNotA, *expr.left, {textOf(*expr.left), CW_TEXT("Arguments", "a reference")});
}

/// INT#5, BOOL#1, COLOUR#RED.
void Checker::checkTyped(Expr& expr)
{
    Symbol* symbol = lookUpType(expr.name);
    const bool isText = Names::wordOf(expr.name) == Word::STRING || Names::wordOf(expr.name) == Word::WSTRING;
    if (isText) {
        checkExpr(*expr.left);
        expr.type = expr.left->type;
        expr.constant = expr.left->constant;
        return;
    }
    if (!symbol || symbol->kind != SymbolKind::Type)
        return report(Code::StNotA, expr, {text(expr.name), CW_TEXT("Arguments", "a type")});
    const Type& type = *symbol->type;
    if (type.kind == TypeKind::Enum && expr.left->kind == ExprKind::Name) {
        Symbol* value = findMember(type, expr.left->name);
        if (!value)
            return report(Code::StNoMember, expr, {typeName(type), text(expr.left->name)});
        expr.type = &type;
        expr.constant = value->constant;
        return;
    }
    if (type.kind == TypeKind::Bad)
        return;
    checkExpr(*expr.left);
    Expr* value = expr.left;
    if (value->type->kind == TypeKind::Bad || !coerce(value, type) || value->type->kind == TypeKind::Bad)
        return;
    if (!value->constant)
        return report(Code::StConstantNeeded, expr);
    expr.left = value;
    expr.type = &type;
    expr.constant = value->constant;
}

void Checker::checkThis(Expr& expr)
{
    PouInfo* owner = m_pou ? (m_pou->owner ? m_pou->owner : m_pou) : nullptr;
    if (owner && expr.kind == ExprKind::Super)
        owner = owner->base;
    if (!owner || owner->tree->kind != PouKind::FunctionBlock)
        return report(Code::StNotHere, expr, {textOf(expr)});
    expr.type = owner->type;
}

bool Checker::isVariable(const Expr& expr) const
{
    switch (expr.kind) {
    case ExprKind::Name: return expr.symbol && expr.symbol->kind == SymbolKind::Variable;
    case ExprKind::Address: return expr.symbol != nullptr;
    case ExprKind::Member: return !expr.isBased && isVariable(*expr.left);
    case ExprKind::Index: return isVariable(*expr.left);
    case ExprKind::Dereference:
    case ExprKind::This: return true;
    default: return false;
    }
}

} // namespace camwright::st
