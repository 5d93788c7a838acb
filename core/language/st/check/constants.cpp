#include "core/language/st/check/checker.h"

#include "core/base/realmath.h"

#include <cmath>

namespace camwright::st {

// The part of Checker for what is known before the program runs. Whole numbers are folded exactly in 128 bits and must fit
// their type; reals are folded in the precision of their type.

std::int64_t nsPerUnit(Elementary e);

namespace {

Elementary elementaryOf(const Type& type)
{
    return type.kind == TypeKind::Elementary || type.kind == TypeKind::Subrange ? type.elementary : Elementary::None;
}

double realOf(const Constant& constant)
{
    return constant.isReal ? constant.real : static_cast<double>(constant.integer);
}

/// One operation in the precision of its type: a REAL is rounded after each.
double computed(Operator op, double a, double b, bool isShort)
{
    const auto rounded = [isShort](double value) { return isShort ? static_cast<double>(static_cast<float>(value)) : value; };
    a = rounded(a);
    b = rounded(b);
    switch (op) {
    case Operator::Add: return rounded(a + b);
    case Operator::Subtract: return rounded(a - b);
    case Operator::Multiply: return rounded(a * b);
    case Operator::Power: return rounded(power(a, b));
    default: return rounded(a / b);
    }
}

} // namespace

const Constant* Checker::makeInteger(Wide value)
{
    Constant& constant = m_out.constants.emplace_back();
    constant.integer = value;
    return &constant;
}

const Constant* Checker::makeReal(double value)
{
    Constant& constant = m_out.constants.emplace_back();
    constant.real = value;
    constant.isReal = true;
    return &constant;
}

void Checker::foldUnary(Expr& expr)
{
    const Constant* a = expr.left->constant;
    if (!a || a->isText)
        return;
    if (expr.op == Operator::Plus) {
        expr.constant = a;
    } else if (expr.op == Operator::Negate) {
        expr.constant = a->isReal ? makeReal(-a->real) : makeInteger(-a->integer);
        keepInRange(expr);
    } else {
        const Elementary e = elementaryOf(*expr.type);
        expr.constant = makeInteger(e == Elementary::Bool ? (a->integer == 0 ? 1 : 0) : largestOf(e) - a->integer);
    }
}

void Checker::foldBinary(Expr& expr)
{
    const Constant* a = expr.left->constant;
    const Constant* b = expr.right->constant;
    const bool divides = expr.op == Operator::Divide || expr.op == Operator::Modulo;
    if (b && !b->isReal && !b->isText && b->integer == 0 && divides) {
        report(Code::StDivisionByZero, *expr.right);
        return setBad(expr);
    }
    if (!a || !b || a->isText || b->isText)
        return;
    if (expr.op >= Operator::Equal && expr.op <= Operator::GreaterEqual)
        return foldComparison(expr);
    if (a->isReal || b->isReal || expr.op == Operator::Power)
        return foldReals(expr, realOf(*a), realOf(*b));
    if (foldIntegers(expr, a->integer, b->integer))
        keepInRange(expr);
}

bool Checker::foldIntegers(Expr& expr, Wide a, Wide b)
{
    constexpr Wide Most = Wide{1} << 100;
    Wide out = 0;
    switch (expr.op) {
    case Operator::Or: out = a | b; break;
    case Operator::Xor: out = a ^ b; break;
    case Operator::And: out = a & b; break;
    case Operator::Add: out = a + b; break;
    case Operator::Subtract: out = a - b; break;
    case Operator::Multiply: {
        const bool fits = a == 0 || b == 0 || ((a < 0 ? -a : a) < (Wide{1} << 62)) || ((b < 0 ? -b : b) < (Wide{1} << 62));
        out = fits ? a * b : Most;
        break;
    }
    case Operator::Divide: out = a / b; break;
    case Operator::Modulo: out = a % b; break;
    default: return false;
    }
    expr.constant = makeInteger(out);
    return true;
}

void Checker::foldReals(Expr& expr, double a, double b)
{
    expr.constant = makeReal(computed(expr.op, a, b, elementaryOf(*expr.type) == Elementary::Real));
}

void Checker::foldComparison(Expr& expr)
{
    const Constant& a = *expr.left->constant;
    const Constant& b = *expr.right->constant;
    const bool isReal = a.isReal || b.isReal;
    const bool less = isReal ? realOf(a) < realOf(b) : a.integer < b.integer;
    const bool equal = isReal ? realOf(a) == realOf(b) : a.integer == b.integer;
    bool out = false;
    switch (expr.op) {
    case Operator::Equal: out = equal; break;
    case Operator::NotEqual: out = !equal; break;
    case Operator::Less: out = less; break;
    case Operator::Greater: out = !less && !equal; break;
    case Operator::LessEqual: out = less || equal; break;
    default: out = !less; break;
    }
    expr.constant = makeInteger(out ? 1 : 0);
}

/// A widening of a constant is one.
void Checker::foldConversion(Expr& expr)
{
    const Constant* from = expr.left->constant;
    if (!from || from->isText)
        return;
    const Elementary source = elementaryOf(*expr.left->type);
    const Elementary target = elementaryOf(*expr.type);
    if (isAnyReal(target))
        expr.constant = makeReal(target == Elementary::Real ? static_cast<double>(static_cast<float>(realOf(*from))) : realOf(*from));
    else if (isDuration(target) || isMoment(target))
        expr.constant = makeInteger(from->integer * nsPerUnit(source) / nsPerUnit(target));
    else
        expr.constant = from;
}

/// Gives an expression of untyped literals its type; its parts are computed anew in that precision.
void Checker::refoldReal(Expr& expr, const Type& type)
{
    if (!expr.constant || (expr.type->kind != TypeKind::AnyReal && expr.type->kind != TypeKind::AnyInteger))
        return;
    const bool isShort = elementaryOf(type) == Elementary::Real;
    const double whole = realOf(*expr.constant);
    const bool wasReal = expr.type->kind == TypeKind::AnyReal;
    expr.type = &type;
    if (wasReal && expr.kind == ExprKind::Binary) {
        refoldReal(*expr.left, type);
        refoldReal(*expr.right, type);
        expr.constant = makeReal(computed(expr.op, expr.left->constant->real, expr.right->constant->real, isShort));
    } else if (wasReal && expr.kind == ExprKind::Unary) {
        refoldReal(*expr.left, type);
        expr.constant = makeReal(expr.op == Operator::Negate ? -expr.left->constant->real : expr.left->constant->real);
    } else {
        expr.constant = makeReal(isShort ? static_cast<double>(static_cast<float>(whole)) : whole);
        if (isShort && std::isinf(expr.constant->real) && !std::isinf(whole))
            report(Code::StOutOfRange, expr, {textOf(expr), "REAL", "-3.4E38", "3.4E38"});
    }
}

void Checker::keepInRange(Expr& expr)
{
    const Elementary e = elementaryOf(*expr.type);
    if (!expr.constant || expr.constant->isReal || e == Elementary::Bool || isAnyReal(e))
        return;
    const bool isUntyped = expr.type->kind == TypeKind::AnyInteger;
    const Wide least = isUntyped ? -(Wide{1} << 63) : smallestOf(e);
    const Wide most = isUntyped ? (Wide{1} << 64) - 1 : largestOf(e);
    if (expr.constant->integer >= least && expr.constant->integer <= most)
        return;
    report(Code::StOutOfRange, expr, {wideText(expr.constant->integer), typeName(*expr.type), wideText(least), wideText(most)});
    setBad(expr);
    expr.constant = nullptr;
}

/// The value of a constant whole number; nothing, and reported, if it is none.
std::optional<Wide> Checker::constantInteger(Expr*& expr, const Type* type)
{
    if (!expr)
        return std::nullopt;
    checkExpr(*expr);
    if (expr->type->kind == TypeKind::Bad)
        return std::nullopt;
    const bool isWhole = expr->type->kind == TypeKind::AnyInteger || expr->type->kind == TypeKind::Enum || isAnyInteger(elementaryOf(*expr->type)) || isBits(elementaryOf(*expr->type));
    if (!isWhole) {
        report(Code::StTypeNeeded, *expr, {CW_TEXT("Arguments", "a whole number"), typeName(*expr->type)});
        return std::nullopt;
    }
    if (type && !coerce(expr, *type))
        return std::nullopt;
    if (!expr->constant) {
        if (expr->type->kind != TypeKind::Bad)
            report(Code::StConstantNeeded, *expr);
        return std::nullopt;
    }
    return expr->constant->integer;
}

} // namespace camwright::st
