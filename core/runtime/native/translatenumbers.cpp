#include "core/runtime/native/routinetranslator.h"

#include <utility>

namespace camwright::native {

// Integers. Sums, products and bit operations do not look at what lies above the type's width; who does look (comparisons,
// divisions, shifts to the right) extends first.

namespace {

bool isCommutative(IrOp op)
{
    return op != IrOp::Sub;
}

x86::Inst::Id operationOf(IrOp op)
{
    switch (op) {
    case IrOp::Add: return x86::Inst::kIdAdd;
    case IrOp::Sub: return x86::Inst::kIdSub;
    case IrOp::And: return x86::Inst::kIdAnd;
    case IrOp::Or: return x86::Inst::kIdOr;
    default: return x86::Inst::kIdXor;
    }
}

x86::CondCode conditionOf(IrOp op, bool isSigned)
{
    switch (op) {
    case IrOp::Equal: return x86::CondCode::kEqual;
    case IrOp::NotEqual: return x86::CondCode::kNotEqual;
    case IrOp::Greater: return isSigned ? x86::CondCode::kSignedGT : x86::CondCode::kUnsignedGT;
    case IrOp::GreaterEqual: return isSigned ? x86::CondCode::kSignedGE : x86::CondCode::kUnsignedGE;
    case IrOp::Less: return isSigned ? x86::CondCode::kSignedLT : x86::CondCode::kUnsignedLT;
    default: return isSigned ? x86::CondCode::kSignedLE : x86::CondCode::kUnsignedLE;
    }
}

/// The same register in the width of another operand.
x86::Gp sized(x86::Gp value, unsigned bytes)
{
    return generalRegister(value.id(), bytes);
}

} // namespace

void RoutineTranslator::arithmetic(const IrInstruction& i)
{
    if (i.type == DataType::Bool)
        return bitLogic(i);
    if (isFloat(i.type))
        return floatArithmetic(i);
    const unsigned bytes = byteWidth(i.type);
    IrRegister into = i.a;
    IrRegister other = i.b;
    if (isCommutative(i.op) && !m_registers.isOwnable(into)
        && (m_registers.isOwnable(other) || m_registers[into].where == Value::Where::Constant))
        std::swap(into, other);
    const x86::Gp result = m_registers.ownGeneral(into);
    asmjit::Operand source = m_registers.source(other);
    if (source.isMem())
        m_asm.emit(operationOf(i.op), sized(result, bytes), source);
    else if (source.isReg())
        m_asm.emit(operationOf(i.op), result, sized(source.as<x86::Gp>(), result.size()));
    else
        m_asm.emit(operationOf(i.op), result, source);
    m_registers.define(i.dest, i.type, result.id());
}

void RoutineTranslator::multiply(const IrInstruction& i)
{
    if (isFloat(i.type))
        return floatArithmetic(i);
    const unsigned bytes = byteWidth(i.type);
    const bool swap = !m_registers.isOwnable(i.a) && (m_registers.isOwnable(i.b) || m_registers[i.a].where == Value::Where::Constant);
    const x86::Gp result = m_registers.ownGeneral(swap ? i.b : i.a);
    const IrRegister other = swap ? i.a : i.b;
    if (bytes == 1) { // no such instruction for bytes
        m_asm.imul(result, m_registers.general(other));
    } else {
        const asmjit::Operand source = m_registers.source(other);
        if (source.isMem())
            m_asm.emit(x86::Inst::kIdImul, sized(result, bytes), source);
        else if (source.isReg())
            m_asm.emit(x86::Inst::kIdImul, result, sized(source.as<x86::Gp>(), result.size()));
        else
            m_asm.emit(x86::Inst::kIdImul, result, result, source);
    }
    m_registers.define(i.dest, i.type, result.id());
}

void RoutineTranslator::negate(const IrInstruction& i)
{
    if (isFloat(i.type)) { // 0 - a, so that the negative of 0 is 0
        const x86::Xmm result = m_registers.takeFloat();
        m_asm.xorps(result, result);
        m_asm.emit(i.type == DataType::Real ? x86::Inst::kIdSubss : x86::Inst::kIdSubsd, result, m_registers.floatSource(i.a));
        return m_registers.define(i.dest, i.type, result.id() + FirstFloat);
    }
    const x86::Gp result = m_registers.ownGeneral(i.a);
    m_asm.neg(result);
    m_registers.define(i.dest, i.type, result.id());
}

void RoutineTranslator::absolute(const IrInstruction& i)
{
    if (isFloat(i.type)) {
        const x86::Xmm result = m_registers.ownFloating(i.a);
        const x86::Xmm mask = m_registers.takeFloat();
        m_asm.pcmpeqd(mask, mask);
        if (i.type == DataType::Real)
            m_asm.psrld(mask, 1);
        else
            m_asm.psrlq(mask, 1);
        m_asm.andps(result, mask);
        return m_registers.define(i.dest, i.type, result.id() + FirstFloat);
    }
    const x86::Gp result = m_registers.ownGeneral(i.a, RegisterAllocator::Width::Extended);
    if (isSigned(i.type)) {
        const x86::Gp negative = sized(m_registers.takeGeneral(), result.size());
        m_asm.mov(negative, result);
        m_asm.neg(negative);
        m_asm.cmovns(result, negative);
    }
    m_registers.define(i.dest, i.type, result.id());
}

/// min, max
void RoutineTranslator::extreme(const IrInstruction& i)
{
    if (isFloat(i.type))
        return floatExtreme(i);
    const x86::Gp result = m_registers.ownGeneral(i.a, RegisterAllocator::Width::Extended);
    const x86::Gp other = m_registers.general(i.b, RegisterAllocator::Width::Extended);
    m_asm.cmp(other, result);
    m_asm.cmov(conditionOf(i.op == IrOp::Min ? IrOp::Less : IrOp::Greater, isSigned(i.type)), result, other);
    m_registers.define(i.dest, i.type, result.id(), true);
}

void RoutineTranslator::compare(const IrInstruction& i)
{
    if (i.type == DataType::Bool)
        return bitLogic(i);
    if (isFloat(i.type))
        return compareFloats(i);
    compareIntegers(i);
}

void RoutineTranslator::compareIntegers(const IrInstruction& i)
{
    const unsigned bytes = byteWidth(i.type);
    const bool isJump = isJumpOn(i.dest);
    if (!isJump && !m_registers.isUsed(i.dest)) {
        m_registers.use(i.a);
        return m_registers.use(i.b);
    }
    const x86::Gp result = isJump ? x86::Gp() : m_registers.takeGeneral();
    x86::Gp a = sized(m_registers.general(i.a), bytes);
    const asmjit::Operand b = m_registers.source(i.b);
    if (b.isImm() && bytes == 2 && b.as<asmjit::Imm>().value() != static_cast<std::int8_t>(b.as<asmjit::Imm>().value())) {
        // A constant of 16 bits makes the decoder stumble. Extending both by their sign keeps the order without signs too.
        const x86::Gp wide = m_registers.takeGeneral();
        m_asm.emit(x86::Inst::kIdMovsx, wide, a);
        a = wide;
    }
    if (isJump)
        m_registers.settle();
    else
        m_asm.xor_(result, result);
    m_asm.emit(x86::Inst::kIdCmp, a, b);
    const x86::CondCode condition = conditionOf(i.op, isSigned(i.type));
    if (isJump) {
        const IrInstruction& next = m_routine.code[++m_at];
        m_registers.use(next.a);
        return jumpWhen(next.op == IrOp::JumpIf ? condition : x86::negateCond(condition), m_at, next.index);
    }
    setCondition(i, condition, result);
}

/// `result` was zero before the comparison.
void RoutineTranslator::setCondition(const IrInstruction& i, x86::CondCode condition, x86::Gp result)
{
    m_asm.set(condition, result.r8());
    m_registers.defineBool(i.dest, result.id(), 0, false, true);
}

} // namespace camwright::native
