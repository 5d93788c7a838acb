#include "core/language/lowering/routinelowering.h"

#include <algorithm>

namespace camwright {

namespace {

enum class Form : std::uint8_t { None, Move, Unary, Binary, Conversion, Step, Shift, Division, Swap, Exchange };

struct Rule {
    Form form = Form::None;
    IrOp op = IrOp::Nop;
};

Rule arithmeticRule(InstructionId id)
{
    switch (id) {
    case InstructionId::KincoAdd:
    case InstructionId::InvtAdd:
    case InstructionId::InvtDadd:
    case InstructionId::InvtRadd: return {Form::Binary, IrOp::Add};
    case InstructionId::KincoSub:
    case InstructionId::InvtSub:
    case InstructionId::InvtDsub:
    case InstructionId::InvtRsub: return {Form::Binary, IrOp::Sub};
    case InstructionId::KincoMul:
    case InstructionId::InvtMul:
    case InstructionId::InvtDmul:
    case InstructionId::InvtRmul: return {Form::Binary, IrOp::Mul};
    case InstructionId::KincoDiv:
    case InstructionId::InvtDiv:
    case InstructionId::InvtDdiv:
    case InstructionId::InvtRdiv: return {Form::Division, IrOp::Div};
    case InstructionId::KincoMod:
    case InstructionId::InvtMod:
    case InstructionId::InvtDmod: return {Form::Division, IrOp::Mod};
    case InstructionId::KincoInc:
    case InstructionId::InvtInc:
    case InstructionId::InvtDinc: return {Form::Step, IrOp::Add};
    case InstructionId::KincoDec:
    case InstructionId::InvtDec:
    case InstructionId::InvtDdec: return {Form::Step, IrOp::Sub};
    case InstructionId::KincoAbs:
    case InstructionId::InvtVabs:
    case InstructionId::InvtDvabs:
    case InstructionId::InvtRabs: return {Form::Unary, IrOp::Abs};
    case InstructionId::KincoNeg:
    case InstructionId::InvtNeg:
    case InstructionId::InvtDneg:
    case InstructionId::InvtRneg: return {Form::Unary, IrOp::Neg};
    case InstructionId::KincoSqrt:
    case InstructionId::InvtRsqt: return {Form::Unary, IrOp::Sqrt};
    default: return {};
    }
}

Rule bitsRule(InstructionId id)
{
    switch (id) {
    case InstructionId::KincoAndByte:
    case InstructionId::KincoAndWord:
    case InstructionId::KincoAndDword:
    case InstructionId::InvtWAnd:
    case InstructionId::InvtDwAnd: return {Form::Binary, IrOp::And};
    case InstructionId::KincoOrByte:
    case InstructionId::KincoOrWord:
    case InstructionId::KincoOrDword:
    case InstructionId::InvtWOr:
    case InstructionId::InvtDwOr: return {Form::Binary, IrOp::Or};
    case InstructionId::KincoXorByte:
    case InstructionId::KincoXorWord:
    case InstructionId::KincoXorDword:
    case InstructionId::InvtWXor:
    case InstructionId::InvtDwXor: return {Form::Binary, IrOp::Xor};
    case InstructionId::KincoInvByte:
    case InstructionId::KincoInvWord:
    case InstructionId::KincoInvDword:
    case InstructionId::InvtWInv:
    case InstructionId::InvtDwInv: return {Form::Unary, IrOp::Not};
    case InstructionId::KincoShl:
    case InstructionId::InvtShl:
    case InstructionId::InvtDshl: return {Form::Shift, IrOp::ShiftLeft};
    case InstructionId::KincoShr:
    case InstructionId::InvtShr:
    case InstructionId::InvtDshr: return {Form::Shift, IrOp::ShiftRight};
    case InstructionId::KincoRol:
    case InstructionId::InvtRol:
    case InstructionId::InvtDrol: return {Form::Shift, IrOp::RotateLeft};
    case InstructionId::KincoRor:
    case InstructionId::InvtRor:
    case InstructionId::InvtDror: return {Form::Shift, IrOp::RotateRight};
    default: return {};
    }
}

Rule ruleOf(InstructionId id)
{
    switch (id) {
    case InstructionId::KincoMove:
    case InstructionId::InvtMov:
    case InstructionId::InvtDmov:
    case InstructionId::InvtRmov: return {Form::Move, IrOp::Nop};
    case InstructionId::KincoDiToI:
    case InstructionId::KincoIToDi:
    case InstructionId::KincoDiToR:
    case InstructionId::KincoRToDi:
    case InstructionId::KincoBToI:
    case InstructionId::KincoIToB:
    case InstructionId::InvtItd:
    case InstructionId::InvtDti:
    case InstructionId::InvtFlt:
    case InstructionId::InvtDflt: return {Form::Conversion, IrOp::Convert};
    case InstructionId::KincoTrunc:
    case InstructionId::InvtInt:
    case InstructionId::InvtDint: return {Form::Conversion, IrOp::Truncate};
    case InstructionId::KincoSwap:
    case InstructionId::InvtSwap: return {Form::Swap, IrOp::RotateLeft};
    case InstructionId::InvtXch:
    case InstructionId::InvtDxch: return {Form::Exchange, IrOp::Nop};
    default: break;
    }
    const Rule rule = arithmeticRule(id);
    return rule.form != Form::None ? rule : bitsRule(id);
}

} // namespace

bool RoutineLowering::lowerComputing(const CheckedStatement& statement)
{
    const Rule rule = ruleOf(statement.instruction->id);
    if (rule.form == Form::None)
        return false;
    openGuard();
    switch (rule.form) {
    case Form::Move: lowerMove(statement); break;
    case Form::Unary: lowerUnary(statement, rule.op); break;
    case Form::Binary: lowerBinary(statement, rule.op); break;
    case Form::Conversion: lowerConversion(statement, rule.op); break;
    case Form::Swap: lowerSwap(statement); break;
    case Form::Exchange: lowerExchange(statement); break;
    case Form::Step: lowerStep(statement, rule.op); break;
    case Form::Shift: lowerShift(statement, rule.op); break;
    case Form::Division: lowerDivision(statement, rule.op); break;
    case Form::None: break;
    }
    return true;
}

void RoutineLowering::lowerMove(const CheckedStatement& statement)
{
    const DataType type = commonType(statement);
    write(statement.operands[1], type, read(statement.operands[0], type));
}

void RoutineLowering::lowerUnary(const CheckedStatement& statement, IrOp op)
{
    const DataType type = commonType(statement);
    write(statement.operands[1], type, m_ir.compute(op, type, read(statement.operands[0], type)));
}

void RoutineLowering::lowerBinary(const CheckedStatement& statement, IrOp op)
{
    const DataType type = commonType(statement);
    const IrRegister a = read(statement.operands[0], type);
    const IrRegister b = read(statement.operands[1], type);
    write(statement.operands[2], type, m_ir.compute(op, type, a, b));
}

/// An integer divided by zero leaves the result as it was; the failed instruction is counted and flagged all the same.
void RoutineLowering::lowerDivision(const CheckedStatement& statement, IrOp op)
{
    const DataType type = commonType(statement);
    const IrRegister a = read(statement.operands[0], type);
    const IrRegister b = read(statement.operands[1], type);
    if (isFloat(type))
        return write(statement.operands[2], type, m_ir.compute(op, type, a, b));
    const IrRegister isPossible = m_ir.compute(IrOp::NotEqual, type, b, m_ir.constant(type, 0));
    const IrRegister result = m_ir.compute(op, type, a, b);
    const std::size_t skip = m_ir.jumpIf(false, isPossible);
    write(statement.operands[2], type, result);
    m_ir.land(skip);
}

void RoutineLowering::lowerConversion(const CheckedStatement& statement, IrOp op)
{
    const DataType from = typeOf(statement.operands[0]);
    const DataType to = typeOf(statement.operands[1]);
    write(statement.operands[1], to, m_ir.convert(op, from, to, read(statement.operands[0], from)));
}

/// The two halves of a value change places.
void RoutineLowering::lowerSwap(const CheckedStatement& statement)
{
    const DataType type = typeOf(statement.operands[0]);
    const IrRegister half = m_ir.constant(DataType::Dword, bitWidth(type) / 2);
    write(statement.operands[0], type, m_ir.compute(IrOp::RotateLeft, type, read(statement.operands[0], type), half));
}

void RoutineLowering::lowerExchange(const CheckedStatement& statement)
{
    const DataType type = commonType(statement);
    const IrRegister first = read(statement.operands[0], type);
    const IrRegister second = read(statement.operands[1], type);
    write(statement.operands[0], type, second);
    write(statement.operands[1], type, first);
}

void RoutineLowering::lowerStep(const CheckedStatement& statement, IrOp op)
{
    const DataType type = typeOf(statement.operands[0]);
    const IrRegister value = read(statement.operands[0], type);
    write(statement.operands[0], type, m_ir.compute(op, type, value, m_ir.constant(type, 1)));
}

void RoutineLowering::lowerShift(const CheckedStatement& statement, IrOp op)
{
    const DataType type = commonType(statement);
    const CheckedOperand& count = *operandAt(statement, "N");
    const IrRegister value = read(statement.operands[0], type);
    const IrRegister by = m_ir.convert(IrOp::Convert, typeOf(count), DataType::Dword, read(count, typeOf(count)));
    const CheckedOperand& result = *std::ranges::find_if(statement.operands, [](const CheckedOperand& o) { return o.pin->direction == PinDirection::Out; });
    write(result, type, m_ir.compute(op, type, value, by));
}

} // namespace camwright
