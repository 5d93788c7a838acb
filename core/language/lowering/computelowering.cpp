#include "core/language/lowering/routinelowering.h"

namespace camwright {

namespace {

enum class Form : std::uint8_t { None, Move, Unary, Binary, Conversion, Step, Shift, Division };

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
    case InstructionId::KincoMod: return {Form::Division, IrOp::Mod};
    case InstructionId::KincoInc:
    case InstructionId::InvtInc:
    case InstructionId::InvtDinc: return {Form::Step, IrOp::Add};
    case InstructionId::KincoDec:
    case InstructionId::InvtDec:
    case InstructionId::InvtDdec: return {Form::Step, IrOp::Sub};
    case InstructionId::KincoAbs: return {Form::Unary, IrOp::Abs};
    default: return {};
    }
}

Rule bitsRule(InstructionId id)
{
    switch (id) {
    case InstructionId::KincoAndByte:
    case InstructionId::KincoAndWord:
    case InstructionId::KincoAndDword: return {Form::Binary, IrOp::And};
    case InstructionId::KincoOrByte:
    case InstructionId::KincoOrWord:
    case InstructionId::KincoOrDword: return {Form::Binary, IrOp::Or};
    case InstructionId::KincoXorByte:
    case InstructionId::KincoXorWord:
    case InstructionId::KincoXorDword: return {Form::Binary, IrOp::Xor};
    case InstructionId::KincoInvByte:
    case InstructionId::KincoInvWord:
    case InstructionId::KincoInvDword: return {Form::Unary, IrOp::Not};
    case InstructionId::KincoShl: return {Form::Shift, IrOp::ShiftLeft};
    case InstructionId::KincoShr: return {Form::Shift, IrOp::ShiftRight};
    case InstructionId::KincoRol: return {Form::Shift, IrOp::RotateLeft};
    case InstructionId::KincoRor: return {Form::Shift, IrOp::RotateRight};
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
    case InstructionId::KincoIToB: return {Form::Conversion, IrOp::Convert};
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
    case Form::Conversion: lowerConversion(statement); break;
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

void RoutineLowering::lowerConversion(const CheckedStatement& statement)
{
    const DataType from = typeOf(statement.operands[0]);
    const DataType to = typeOf(statement.operands[1]);
    write(statement.operands[1], to, m_ir.convert(IrOp::Convert, from, to, read(statement.operands[0], from)));
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
    write(statement.operands.back(), type, m_ir.compute(op, type, value, by));
}

} // namespace camwright
