#include "core/language/st/lowering/bodylowering.h"

namespace camwright::st {

// Values: constants, operators, conversions.

namespace {

IrOp operationOf(Operator op)
{
    switch (op) {
    case Operator::Or: return IrOp::Or;
    case Operator::Xor: return IrOp::Xor;
    case Operator::And: return IrOp::And;
    case Operator::Equal: return IrOp::Equal;
    case Operator::NotEqual: return IrOp::NotEqual;
    case Operator::Less: return IrOp::Less;
    case Operator::Greater: return IrOp::Greater;
    case Operator::LessEqual: return IrOp::LessEqual;
    case Operator::GreaterEqual: return IrOp::GreaterEqual;
    case Operator::Add: return IrOp::Add;
    case Operator::Subtract: return IrOp::Sub;
    case Operator::Multiply: return IrOp::Mul;
    case Operator::Divide: return IrOp::Div;
    case Operator::Modulo: return IrOp::Mod;
    case Operator::Not: return IrOp::Not;
    case Operator::Power: return IrOp::Power;
    default: return IrOp::Neg;
    }
}

/// Units of a time or date type in one of its long form, which counts ns; 1 for all others.
std::int64_t unitNs(Elementary e)
{
    switch (e) {
    case Elementary::Time:
    case Elementary::Tod: return 1'000'000;
    case Elementary::Date:
    case Elementary::Dt: return 1'000'000'000;
    default: return 1;
    }
}

bool isTimeOrDate(Elementary e)
{
    return isDuration(e) || isMoment(e);
}

} // namespace

IrRegister BodyLowering::integer(DataType type, std::int64_t value)
{
    return m_ir.constant(type, static_cast<std::uint64_t>(value));
}

IrRegister BodyLowering::constantOf(const Type& type, const Constant& constant)
{
    if (type.kind == TypeKind::Reference)
        return m_ir.constant(DataType::Dword, 0xFFFFFFFF); // NULL
    if (isFloat(type.data))
        return m_ir.constant(type.data, Value::ofDouble(type.data, constant.isReal ? constant.real : static_cast<double>(constant.integer)).bits);
    return m_ir.constant(type.data, static_cast<std::uint64_t>(constant.integer));
}

IrRegister BodyLowering::value(const Expr& expr)
{
    if (expr.constant && expr.type->isScalar())
        return constantOf(*expr.type, *expr.constant);
    switch (expr.kind) {
    case ExprKind::Unary: return unary(expr);
    case ExprKind::Binary: return binary(expr);
    case ExprKind::Call: return call(expr);
    case ExprKind::Convert: return convert(expr.left->type->elementary, expr.type->elementary, value(*expr.left), false);
    case ExprKind::Typed: return value(*expr.left);
    case ExprKind::Member:
        if (expr.isBased)
            return bit(expr);
        break;
    default: break;
    }
    return load(placeOf(expr), *expr.type);
}

/// Bit of a value: shifted to the end and masked.
IrRegister BodyLowering::bit(const Expr& expr)
{
    const DataType type = expr.left->type->data;
    const IrRegister whole = value(*expr.left);
    const IrRegister mask = integer(type, static_cast<std::int64_t>(std::uint64_t{1} << expr.value));
    const IrRegister masked = m_ir.compute(IrOp::And, type, whole, mask);
    return m_ir.compute(IrOp::NotEqual, type, masked, integer(type, 0));
}

IrRegister BodyLowering::unary(const Expr& expr)
{
    const IrRegister operand = value(*expr.left);
    return expr.op == Operator::Plus ? operand : m_ir.compute(operationOf(expr.op), expr.type->data, operand);
}

IrRegister BodyLowering::binary(const Expr& expr)
{
    const DataType type = expr.left->type->data;
    const IrRegister left = value(*expr.left);
    IrRegister right = value(*expr.right);
    if (expr.right->type->data != type) // TIME * DINT, TOD + TIME
        right = asData(expr.right->type->data, type, right);
    const IrRegister out = m_ir.compute(operationOf(expr.op), type, left, right);
    const bool isComparison = expr.op >= Operator::Equal && expr.op <= Operator::GreaterEqual;
    return isComparison || expr.type->data == type ? out : asData(type, expr.type->data, out);
}

IrRegister BodyLowering::select(DataType type, IrRegister condition, IrRegister yes, IrRegister no)
{
    IrInstruction i = m_ir.make(IrOp::Select, type);
    i.a = condition;
    i.b = yes;
    i.index = no;
    return m_ir.define(i);
}

IrRegister BodyLowering::asData(DataType from, DataType to, IrRegister value)
{
    return from == to ? value : m_ir.convert(IrOp::Convert, from, to, value);
}

IrRegister BodyLowering::scaled(IrOp op, std::int64_t factor, DataType from, DataType to, IrRegister value)
{
    const IrRegister wide = asData(from, DataType::Lint, value);
    const IrRegister out = m_ir.compute(op, DataType::Lint, wide, integer(DataType::Lint, factor));
    return asData(DataType::Lint, to, out);
}

IrRegister BodyLowering::convert(Elementary from, Elementary to, IrRegister value, bool truncates)
{
    const DataType source = dataTypeOf(from);
    const DataType target = dataTypeOf(to);
    if (from == to)
        return value;
    if (target == DataType::Bool)
        return m_ir.compute(IrOp::NotEqual, source, value, m_ir.constant(source, 0));
    if (source == DataType::Bool) {
        const IrRegister one = m_ir.constant(target, isFloat(target) ? Value::ofDouble(target, 1).bits : 1);
        return select(target, value, one, m_ir.constant(target, 0));
    }
    if (from == Elementary::Dt && to == Elementary::Date) {
        const IrRegister rest = m_ir.compute(IrOp::Mod, source, value, integer(source, 86'400));
        return m_ir.compute(IrOp::Sub, source, value, rest);
    }
    if (from == Elementary::Dt && to == Elementary::Tod) {
        const IrRegister rest = m_ir.compute(IrOp::Mod, source, value, integer(source, 86'400));
        return m_ir.compute(IrOp::Mul, source, rest, integer(source, 1000));
    }
    if (isTimeOrDate(from) && isTimeOrDate(to) && unitNs(from) != unitNs(to)) {
        const bool grows = unitNs(from) > unitNs(to);
        return scaled(grows ? IrOp::Mul : IrOp::Div, grows ? unitNs(from) / unitNs(to) : unitNs(to) / unitNs(from), source, target, value);
    }
    if (truncates)
        return m_ir.convert(IrOp::Truncate, source, target, value);
    return asData(source, target, value);
}

} // namespace camwright::st
