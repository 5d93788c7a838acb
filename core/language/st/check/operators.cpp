#include "core/language/st/check/checker.h"

namespace camwright::st {

// The part of Checker for operators and for what becomes what.

namespace {

std::string_view operatorText(Operator op)
{
    constexpr std::string_view Texts[] = {"", "OR", "XOR", "AND", "=", "<>", "<", ">", "<=", ">=", "+", "-", "*", "/", "MOD", "**", "-", "+", "NOT"};
    return Texts[static_cast<unsigned>(op)];
}

bool isLogic(Operator op) { return op == Operator::And || op == Operator::Or || op == Operator::Xor; }
bool isComparison(Operator op) { return op >= Operator::Equal && op <= Operator::GreaterEqual; }

/// The elementary type a value counts as: subranges as their base. Enumerations only as themselves.
Elementary valueType(const Type& type)
{
    return type.kind == TypeKind::Elementary || type.kind == TypeKind::Subrange ? type.elementary : Elementary::None;
}

bool isUntyped(const Type& type)
{
    return type.kind == TypeKind::AnyInteger || type.kind == TypeKind::AnyReal;
}

} // namespace

void Checker::checkUnary(Expr& expr)
{
    const Type& type = checkExpr(*expr.left);
    if (type.kind == TypeKind::Bad)
        return;
    const Elementary e = valueType(type);
    bool isGood = isUntyped(type) || isSigned(e) || isAnyReal(e) || isDuration(e);
    if (expr.op == Operator::Not)
        isGood = e == Elementary::Bool || isBits(e);
    else if (expr.op == Operator::Plus)
        isGood = isUntyped(type) || isNumber(e);
    if (!isGood)
        return report(Code::StNoUnaryOperator, expr, {std::string(operatorText(expr.op)), typeName(type)});
    expr.type = type.kind == TypeKind::Subrange ? type.element : &type;
    foldUnary(expr);
}

void Checker::checkBinary(Expr& expr)
{
    checkExpr(*expr.left);
    checkExpr(*expr.right);
    if (expr.left->type->kind == TypeKind::Bad || expr.right->type->kind == TypeKind::Bad)
        return;
    if (isLogic(expr.op))
        checkLogic(expr);
    else if (isComparison(expr.op))
        checkComparison(expr);
    else
        checkArithmetic(expr);
    if (expr.type->kind == TypeKind::Bad)
        return;
    foldBinary(expr);
}

/// AND, OR, XOR of BOOL and bit strings.
void Checker::checkLogic(Expr& expr)
{
    const Type* common = unify(expr.left, expr.right);
    const Elementary e = common ? valueType(*common) : Elementary::None;
    if (e != Elementary::Bool && !isBits(e))
        return report(Code::StNoOperator, expr, {std::string(operatorText(expr.op)), typeName(*expr.left->type), typeName(*expr.right->type)});
    expr.type = common;
}

void Checker::checkComparison(Expr& expr)
{
    const Type& left = *expr.left->type;
    const Type& right = *expr.right->type;
    const bool isIdentity = expr.op == Operator::Equal || expr.op == Operator::NotEqual;
    bool isGood = false;
    if (left.kind == TypeKind::Enum || right.kind == TypeKind::Enum)
        isGood = &left == &right;
    else if (left.kind == TypeKind::Reference || right.kind == TypeKind::Reference)
        isGood = isIdentity && (coerce(expr.right, left) && coerce(expr.left, *expr.right->type));
    else if (const Type* common = unify(expr.left, expr.right))
        isGood = common->kind == TypeKind::AnyInteger || common->kind == TypeKind::AnyReal || (valueType(*common) != Elementary::None && (isIdentity || valueType(*common) != Elementary::Bool));
    if (!isGood)
        return report(Code::StNoOperator, expr, {std::string(operatorText(expr.op)), typeName(left), typeName(right)});
    expr.type = &boolType();
}

void Checker::checkArithmetic(Expr& expr)
{
    if (expr.op == Operator::Power)
        return checkReals(expr, expr.left, expr.right);
    if (checkTimeArithmetic(expr))
        return;
    const std::string leftName = typeName(*expr.left->type);
    const std::string rightName = typeName(*expr.right->type);
    const Type* common = unify(expr.left, expr.right);
    const bool isInteger = common && (common->kind == TypeKind::AnyInteger || isAnyInteger(valueType(*common)));
    const bool isReal = common && (common->kind == TypeKind::AnyReal || isAnyReal(valueType(*common)));
    const bool isGood = expr.op == Operator::Modulo ? isInteger : isInteger || isReal;
    if (!isGood)
        return report(Code::StNoOperator, expr, {std::string(operatorText(expr.op)), leftName, rightName});
    expr.type = common;
}

/// TIME + TIME, TIME * number, DT - DT and their like; true if it was one of them.
bool Checker::checkTimeArithmetic(Expr& expr)
{
    const Elementary left = valueType(*expr.left->type);
    const Elementary right = valueType(*expr.right->type);
    const bool hasMoment = isMoment(left) || isMoment(right);
    if (!isDuration(left) && !isDuration(right) && !hasMoment)
        return false;
    const bool adds = expr.op == Operator::Add || expr.op == Operator::Subtract;
    if (adds && isDuration(left) && isDuration(right)) {
        expr.type = unify(expr.left, expr.right);
        return true;
    }
    const bool scales = isDuration(left) && (expr.op == Operator::Multiply || expr.op == Operator::Divide);
    if (scales && expr.right->type->kind != TypeKind::AnyReal && (expr.right->type->kind == TypeKind::AnyInteger || isAnyInteger(right))) {
        const Type& number = elementary(left == Elementary::Time ? Elementary::Dint : Elementary::Lint);
        if (coerce(expr.right, number))
            expr.type = expr.left->type;
        return true;
    }
    const bool difference = expr.op == Operator::Subtract && left == right && (left == Elementary::Tod || left == Elementary::Ltod || left == Elementary::Ldt || left == Elementary::Ldate);
    if (difference) {
        expr.type = &elementary(left == Elementary::Tod ? Elementary::Time : Elementary::Ltime);
        return true;
    }
    const bool shift = adds && (left == Elementary::Tod || left == Elementary::Ltod || left == Elementary::Ldt) && isDuration(right);
    if (shift) {
        if (left != Elementary::Tod)
            coerce(expr.right, elementary(Elementary::Ltime));
        if (left != Elementary::Tod || right == Elementary::Time)
            expr.type = expr.left->type;
    }
    if (expr.type->kind == TypeKind::Bad)
        report(Code::StNoOperator, expr, {std::string(operatorText(expr.op)), typeName(*expr.left->type), typeName(*expr.right->type)});
    return true;
}

/// Brings two operands to one type, converting what widens; null if there is none.
const Type* Checker::unify(Expr*& left, Expr*& right)
{
    const Type& a = *left->type;
    const Type& b = *right->type;
    if (isUntyped(a) && isUntyped(b))
        return a.kind == TypeKind::AnyReal || b.kind == TypeKind::AnyReal ? &m_anyReal : &m_anyInteger;
    const Elementary x = valueType(a);
    const Elementary y = valueType(b);
    if (isUntyped(a) || isUntyped(b)) {
        Expr*& literal = isUntyped(a) ? left : right;
        Expr*& other = isUntyped(a) ? right : left;
        Elementary wanted = isUntyped(a) ? y : x;
        if (literal->type->kind == TypeKind::AnyReal && isAnyInteger(wanted))
            wanted = commonOf(wanted, Elementary::Real);
        if (wanted == Elementary::None || !coerce(other, elementary(wanted)) || !coerce(literal, elementary(wanted)))
            return nullptr;
        return &elementary(wanted);
    }
    const Elementary common = x == Elementary::None || y == Elementary::None ? Elementary::None : commonOf(x, y);
    if (common == Elementary::None)
        return nullptr;
    coerce(left, elementary(common));
    coerce(right, elementary(common));
    return &elementary(common);
}

/// Makes an expression one of the target's type. False, and reported, where that needs a conversion by name.
bool Checker::coerce(Expr*& expr, const Type& target)
{
    const Type& type = *expr->type;
    if (type.kind == TypeKind::Bad || target.kind == TypeKind::Bad)
        return true;
    if (target.kind == TypeKind::Subrange) {
        if (!coerce(expr, *target.element))
            return false;
        if (expr->constant && (expr->constant->integer < target.low || expr->constant->integer > target.high)) {
            report(Code::StOutOfRange, *expr, {wideText(expr->constant->integer), typeName(target), std::to_string(target.low), std::to_string(target.high)});
            return false;
        }
        return true;
    }
    if (isUntyped(type) || type.kind == TypeKind::AnyText || type.kind == TypeKind::Null) {
        if (coerceLiteral(*expr, target))
            return true;
        mismatch(*expr, target);
        return false;
    }
    const Elementary from = valueType(type);
    const Elementary to = valueType(target);
    if (from != Elementary::None && to != Elementary::None) {
        if (widens(from, to)) {
            if (from != to)
                expr = converted(*expr, target);
            return true;
        }
    } else if (isSame(type, target)) {
        return true;
    } else if (type.kind == TypeKind::Text && target.kind == TypeKind::Text && type.isWide == target.isWide) {
        return true;
    } else if (type.kind == TypeKind::Reference && target.kind == TypeKind::Reference && type.element->kind == TypeKind::Block && target.element->kind == TypeKind::Block) {
        for (const PouInfo* at = type.element->pou; at; at = at->base) {
            if (at->type == target.element)
                return true;
        }
    }
    mismatch(*expr, target);
    return false;
}

/// A literal, or an expression of literals, takes the type that is wanted if its value fits.
bool Checker::coerceLiteral(Expr& expr, const Type& target)
{
    const Elementary to = valueType(target);
    switch (expr.type->kind) {
    case TypeKind::AnyInteger: {
        const Wide value = expr.constant ? expr.constant->integer : Wide{0};
        if (isAnyReal(to)) {
            expr.constant = makeReal(static_cast<double>(value));
            expr.type = &elementary(to);
            return true;
        }
        if (to == Elementary::Bool ? value != 0 && value != 1 : !isAnyInteger(to) && !isBits(to))
            return false;
        expr.type = &target;
        if (value >= smallestOf(to) && value <= largestOf(to))
            return true;
        report(Code::StOutOfRange, expr, {wideText(value), std::string(elementaryName(to)), wideText(smallestOf(to)), wideText(largestOf(to))});
        setBad(expr);
        return true;
    }
    case TypeKind::AnyReal:
        if (!isAnyReal(to))
            return false;
        refoldReal(expr, elementary(to));
        return true;
    case TypeKind::AnyText:
        if (target.kind != TypeKind::Text || target.isWide != (expr.kind == ExprKind::Literal && expr.literal == TokenKind::WideText))
            return false;
        expr.type = &target;
        return true;
    default:
        if (target.kind != TypeKind::Reference && target.kind != TypeKind::Interface)
            return false;
        expr.type = &target;
        return true;
    }
}

void Checker::mismatch(const Expr& expr, const Type& target)
{
    const Type& type = *(expr.type ? expr.type : &m_bad);
    const Elementary from = valueType(type);
    const Elementary to = valueType(target);
    if (from != Elementary::None && to != Elementary::None)
        return report(Code::StConversionNeeded, expr, {typeName(target), typeName(type), std::string(elementaryName(from)) + "_TO_" + std::string(elementaryName(to))});
    report(Code::StTypeNeeded, expr, {typeName(target), type.kind == TypeKind::Bad ? textOf(expr) : typeName(type)});
}

/// A literal nothing else decides about: DINT, else LINT or ULINT; LREAL.
void Checker::useDefaultType(Expr& expr)
{
    if (!expr.type || !isUntyped(*expr.type))
        return;
    Elementary e = Elementary::Lreal;
    if (expr.type->kind == TypeKind::AnyInteger) {
        const Wide value = expr.constant ? expr.constant->integer : Wide{0};
        e = value >= INT32_MIN && value <= INT32_MAX ? Elementary::Dint : value <= INT64_MAX ? Elementary::Lint : Elementary::Ulint;
    }
    coerceLiteral(expr, elementary(e));
}

Expr* Checker::converted(Expr& expr, const Type& target)
{
    Expr* out = m_out.arena.make<Expr>();
    out->kind = ExprKind::Convert;
    out->offset = expr.offset;
    out->end = expr.end;
    out->left = &expr;
    out->type = &target;
    foldConversion(*out);
    return out;
}

} // namespace camwright::st
