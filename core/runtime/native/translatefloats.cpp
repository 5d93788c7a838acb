#include "core/runtime/native/routinetranslator.h"

#include <utility>

namespace camwright::native {

// REAL and LREAL. Which NaN lies in a register nobody can tell, so a result becomes the one NaN of the controller only
// when it is stored.

namespace {

constexpr Unit unitOf(x86::Xmm value)
{
    return value.id() + FirstFloat;
}

struct FloatOperations {
    x86::Inst::Id add, sub, mul, div, min, max, sqrt, compare, load;
};

const FloatOperations& operationsOf(DataType type)
{
    static const FloatOperations real{x86::Inst::kIdAddss, x86::Inst::kIdSubss, x86::Inst::kIdMulss, x86::Inst::kIdDivss, x86::Inst::kIdMinss, x86::Inst::kIdMaxss, x86::Inst::kIdSqrtss,
                                      x86::Inst::kIdUcomiss, x86::Inst::kIdMovss};
    static const FloatOperations lreal{x86::Inst::kIdAddsd, x86::Inst::kIdSubsd, x86::Inst::kIdMulsd, x86::Inst::kIdDivsd, x86::Inst::kIdMinsd, x86::Inst::kIdMaxsd, x86::Inst::kIdSqrtsd,
                                       x86::Inst::kIdUcomisd, x86::Inst::kIdMovsd};
    return type == DataType::Real ? real : lreal;
}

} // namespace

void RoutineTranslator::storeFloat(const IrInstruction& i)
{
    const unsigned bytes = byteWidth(i.type);
    const Range range{offsetOf(i.address), bytes};
    const x86::Mem place = m_registers.at(range.offset, bytes);
    const bool neverNaN = m_registers[i.a].clean;
    const x86::Xmm value = m_registers.floating(i.a);
    m_registers.beforeStore(range);
    m_asm.emit(operationsOf(i.type).load, place, value);
    if (!neverNaN) {
        m_asm.emit(operationsOf(i.type).compare, value, value);
        Cold& nan = cold(i.type == DataType::Real ? &RoutineTranslator::coldRealNaN : &RoutineTranslator::coldLrealNaN, range.offset);
        nan.back = m_asm.newLabel();
        m_asm.jp(nan.entry);
        m_asm.bind(nan.back);
    }
    if (m_outline.isLookedAtAgain(m_at))
        m_registers.remember(unitOf(value), range);
}

void RoutineTranslator::coldRealNaN(const Cold& c)
{
    m_asm.mov(m_registers.at(c.extra, 4), 0x7FC00000);
    m_asm.jmp(c.back);
}

void RoutineTranslator::coldLrealNaN(const Cold& c)
{
    m_asm.mov(m_registers.at(c.extra, 4), 0);
    m_asm.mov(m_registers.at(c.extra + 4, 4), 0x7FF80000);
    m_asm.jmp(c.back);
}

void RoutineTranslator::floatArithmetic(const IrInstruction& i)
{
    const FloatOperations& operations = operationsOf(i.type);
    IrRegister into = i.a;
    IrRegister other = i.b;
    if (i.op != IrOp::Sub && !m_registers.isOwnable(into)
        && (m_registers.isOwnable(other) || m_registers[into].where == Value::Where::Constant))
        std::swap(into, other);
    const x86::Inst::Id operation = i.op == IrOp::Add ? operations.add : i.op == IrOp::Sub ? operations.sub : operations.mul;
    const x86::Xmm result = m_registers.ownFloating(into);
    const asmjit::Operand source = m_registers.floatSource(other);
    m_asm.emit(operation, result, source);
    m_registers.define(i.dest, i.type, unitOf(result));
}

void RoutineTranslator::floatDivide(const IrInstruction& i)
{
    const FloatOperations& operations = operationsOf(i.type);
    beforeFault();
    const Value divisor = m_registers[i.b];
    const bool isZeroOrUnknown = divisor.where != Value::Where::Constant || divisor.content << (64 - bitWidth(i.type)) << 1 == 0;
    const x86::Xmm result = m_registers.ownFloating(i.a);
    const x86::Xmm b = m_registers.floating(i.b);
    if (isZeroOrUnknown) {
        const x86::Xmm zero = m_registers.takeFloat();
        m_asm.xorps(zero, zero);
        m_asm.emit(operations.compare, b, zero);
        Cold& fault = cold(&RoutineTranslator::coldZeroFloatDivisor);
        fault.back = m_asm.newLabel();
        m_asm.je(fault.entry);
        m_asm.bind(fault.back);
    }
    m_asm.emit(operations.div, result, b);
    m_registers.define(i.dest, i.type, unitOf(result));
}

/// Equal, or not comparable: a NaN is no fault.
void RoutineTranslator::coldZeroFloatDivisor(const Cold& c)
{
    m_asm.jp(c.back);
    callFault(c.at);
    m_asm.jmp(c.back);
}

void RoutineTranslator::coldFault(const Cold& c)
{
    callFault(c.at);
    m_asm.jmp(c.back);
}

void RoutineTranslator::squareRoot(const IrInstruction& i)
{
    const FloatOperations& operations = operationsOf(i.type);
    beforeFault();
    const x86::Xmm result = m_registers.ownFloating(i.a);
    const x86::Xmm zero = m_registers.takeFloat();
    m_asm.xorps(zero, zero);
    m_asm.emit(operations.compare, zero, result);
    Cold& fault = cold(&RoutineTranslator::coldFault);
    fault.back = m_asm.newLabel();
    m_asm.ja(fault.entry);
    m_asm.bind(fault.back);
    m_asm.emit(operations.sqrt, result, result);
    m_registers.define(i.dest, i.type, unitOf(result));
}

/// The processor's minimum gives its second operand unless the first one is less, which is b < a ? b : a.
void RoutineTranslator::floatExtreme(const IrInstruction& i)
{
    const FloatOperations& operations = operationsOf(i.type);
    const x86::Xmm b = m_registers.ownFloating(i.b);
    const x86::Xmm a = m_registers.floating(i.a);
    Cold& nan = cold(&RoutineTranslator::coldExtremeNaN, b.id() << 8 | a.id());
    nan.back = m_asm.newLabel();
    m_asm.emit(operations.compare, a, b);
    m_asm.jp(nan.entry);
    m_asm.emit(i.op == IrOp::Min ? operations.min : operations.max, b, a);
    m_asm.bind(nan.back);
    m_registers.define(i.dest, i.type, unitOf(b));
}

/// extra: the register of the result and the other one. Their sum is a NaN.
void RoutineTranslator::coldExtremeNaN(const Cold& c)
{
    const bool isReal = m_routine.code[c.at].type == DataType::Real;
    m_asm.emit(isReal ? x86::Inst::kIdAddss : x86::Inst::kIdAddsd, x86::xmm(c.extra >> 8), x86::xmm(c.extra & 0xFF));
    m_asm.jmp(c.back);
}

void RoutineTranslator::compareFloats(const IrInstruction& i)
{
    const bool isEquality = i.op == IrOp::Equal || i.op == IrOp::NotEqual;
    const bool isJump = !isEquality && isJumpOn(i.dest);
    if (!isJump && !m_registers.isUsed(i.dest)) {
        m_registers.use(i.a);
        return m_registers.use(i.b);
    }
    // "Above" is false with a NaN, so the greater one goes first.
    const bool isLess = i.op == IrOp::Less || i.op == IrOp::LessEqual;
    const x86::Xmm first = m_registers.floating(isLess ? i.b : i.a);
    const asmjit::Operand second = m_registers.floatSource(isLess ? i.a : i.b);
    const x86::Gp result = isJump ? x86::Gp() : m_registers.takeGeneral();
    if (isJump)
        m_registers.settle();
    else
        m_asm.xor_(result, result);
    const bool isStrict = i.op == IrOp::Less || i.op == IrOp::Greater;
    const x86::CondCode condition = isStrict ? x86::CondCode::kUnsignedGT : x86::CondCode::kUnsignedGE;
    if (isEquality) {
        const x86::Gp ordered = m_registers.takeGeneral();
        m_asm.emit(operationsOf(i.type).compare, first, second);
        m_asm.set(x86::CondCode::kParityOdd, ordered.r8());
        m_asm.set(x86::CondCode::kEqual, result.r8());
        m_asm.and_(result, ordered);
        return m_registers.defineBool(i.dest, result.id(), 0, i.op == IrOp::NotEqual, true);
    }
    m_asm.emit(operationsOf(i.type).compare, first, second);
    if (!isJump)
        return setCondition(i, condition, result);
    const IrInstruction& next = m_routine.code[++m_at];
    m_registers.use(next.a);
    jumpWhen(next.op == IrOp::JumpIf ? condition : x86::negateCond(condition), m_at, next.index);
}

} // namespace camwright::native
