#include "core/runtime/native/routinetranslator.h"

#include <utility>

namespace camwright::native {

// BOOLs: contacts, coils, edges. A BOOL is one bit anywhere in a register, perhaps inverted; a chain of contacts costs a
// load, a shift and one operation for each.

void RoutineTranslator::invert(const IrInstruction& i)
{
    if (!m_registers.isUsed(i.dest) && i.type == DataType::Bool)
        return m_registers.use(i.a);
    if (i.type == DataType::Bool) {
        m_registers.defineAlias(i.dest, i.a, true);
        return m_registers.use(i.a);
    }
    const x86::Gp value = m_registers.ownGeneral(i.a);
    m_asm.not_(value);
    m_registers.define(i.dest, i.type, value.id());
}

/// and, or, xor, equal, not_equal of two BOOLs.
void RoutineTranslator::bitLogic(const IrInstruction& i)
{
    if (!m_registers.isUsed(i.dest)) {
        m_registers.use(i.a);
        return m_registers.use(i.b);
    }
    if (m_registers[i.a].where == Value::Where::Constant)
        return logicOfConstant(i, i.a, i.b);
    if (m_registers[i.b].where == Value::Where::Constant)
        return logicOfConstant(i, i.b, i.a);
    Unit into = m_registers.bringBool(i.a);
    Unit other = m_registers.bringBool(i.b);
    Value a = m_registers[i.a];
    Value b = m_registers[i.b];
    m_registers.use(i.a);
    m_registers.use(i.b);
    if (into == other || (!m_registers.mayTakeOver(into) && m_registers.mayTakeOver(other))) {
        std::swap(into, other);
        std::swap(a, b);
    }
    const bool mayShiftOther = other != into && m_registers.mayTakeOver(other);
    if (into == other) {
        into = m_registers.take(Bank::General);
        m_asm.mov(x86::gpd(into), x86::gpd(other));
    } else {
        into = m_registers.takeOver(into);
    }
    unsigned bit = a.bit;
    if (a.bit != b.bit && mayShiftOther && b.bit != 0) {
        other = m_registers.takeOver(other);
        shiftBits(other, b.bit, a.bit);
    } else {
        shiftBits(into, a.bit, b.bit);
        bit = b.bit;
    }
    const bool isInverted = joinBits(i.op, x86::gpd(into), a.inverted, x86::gpd(other), b.inverted);
    const bool isPlain = !a.inverted && !b.inverted;
    const bool isClean = isPlain && (i.op == IrOp::And ? a.clean || b.clean : a.clean && b.clean);
    m_registers.defineBool(i.dest, into, bit, isInverted, isClean);
}

void RoutineTranslator::logicOfConstant(const IrInstruction& i, IrRegister constant, IrRegister other)
{
    const bool isTrue = m_registers[constant].content != 0;
    const bool isFixed = (i.op == IrOp::And && !isTrue) || (i.op == IrOp::Or && isTrue);
    const bool isInverse = (i.op == IrOp::Xor && isTrue) || (i.op == IrOp::NotEqual && isTrue) || (i.op == IrOp::Equal && !isTrue);
    if (isFixed)
        m_registers.defineConstant(i.dest, DataType::Bool, isTrue);
    else
        m_registers.defineAlias(i.dest, other, isInverse);
    m_registers.use(constant);
    m_registers.use(other);
}

/// into := into op other; returns whether the result is inverted. De Morgan spares the inversions.
bool RoutineTranslator::joinBits(IrOp op, x86::Gp into, bool intoInverted, x86::Gp other, bool otherInverted)
{
    if (op != IrOp::And && op != IrOp::Or) {
        m_asm.xor_(into, other);
        return (intoInverted != otherInverted) != (op == IrOp::Equal);
    }
    const bool isAnd = op == IrOp::And;
    if (intoInverted == otherInverted) {
        if (isAnd != intoInverted)
            m_asm.and_(into, other);
        else
            m_asm.or_(into, other);
        return intoInverted;
    }
    // and: the straight one without the inverted one. or: the inverse of the inverted one's bits without the straight one.
    const bool takeInto = isAnd ? intoInverted : !intoInverted;
    if (takeInto)
        andNot(into, into, other);
    else
        andNot(into, other, into);
    return !isAnd;
}

/// into := straight and not inverted; `into` is one of them.
void RoutineTranslator::andNot(x86::Gp into, x86::Gp inverted, x86::Gp straight)
{
    if (m_program.hasAndn) {
        m_asm.andn(into, inverted, straight);
    } else if (into == inverted) {
        m_asm.not_(into);
        m_asm.and_(into, straight);
    } else {
        m_asm.or_(into, inverted);
        m_asm.xor_(into, inverted);
    }
}

void RoutineTranslator::shiftBits(Unit unit, unsigned from, unsigned to)
{
    if (from < to)
        m_asm.shl(x86::gpd(unit), to - from);
    else if (from > to)
        m_asm.shr(x86::gpd(unit), from - to);
}

void RoutineTranslator::storeBit(const IrInstruction& i)
{
    const std::uint32_t offset = offsetOf(i.address);
    const unsigned mask = 1u << i.address.bit;
    if (m_registers[i.a].where == Value::Where::Constant) {
        const bool isTrue = m_registers[i.a].content != 0;
        m_registers.use(i.a);
        const Unit byte = m_registers.byteForBits(offset, m_outline.isLookedAtAgain(m_at));
        const x86::Inst::Id operation = isTrue ? x86::Inst::kIdOr : x86::Inst::kIdAnd;
        const asmjit::Imm operand = asmjit::imm(static_cast<std::int8_t>(isTrue ? mask : ~mask));
        if (byte == RegisterAllocator::NoUnit)
            m_asm.emit(operation, m_registers.at(offset, 1), operand);
        else
            m_asm.emit(operation, x86::gpb(byte), operand);
        return;
    }
    Unit source = m_registers.bringBool(i.a);
    const Value value = m_registers[i.a];
    m_registers.use(i.a);
    source = m_registers.takeOver(source);
    const Unit byte = m_registers.byteForBits(offset, true);
    shiftBits(source, value.bit, i.address.bit);
    const x86::Gp target = x86::gpb(byte);
    if (value.inverted) { // on, and off again where the bit is set
        m_asm.or_(target, static_cast<std::int8_t>(mask));
        if (!value.clean)
            m_asm.and_(x86::gpd(source), mask);
        m_asm.xor_(x86::gpd(byte), x86::gpd(source));
        return;
    }
    m_asm.and_(target, static_cast<std::int8_t>(~mask));
    if (!value.clean)
        m_asm.and_(x86::gpd(source), mask);
    m_asm.or_(x86::gpd(byte), x86::gpd(source));
}

x86::Gp RoutineTranslator::ownZeroOrOne(IrRegister number)
{
    Unit unit = m_registers.bringBool(number);
    const Value value = m_registers[number];
    m_registers.use(number);
    unit = m_registers.takeOver(unit);
    if (value.where == Value::Where::Constant)
        return x86::gpd(unit);
    shiftBits(unit, value.bit, 0);
    if (!value.clean)
        m_asm.and_(x86::gpd(unit), 1);
    if (value.inverted)
        m_asm.xor_(x86::gpd(unit), 1);
    return x86::gpd(unit);
}

void RoutineTranslator::storeWholeByte(const IrInstruction& i)
{
    const Range range{offsetOf(i.address), 1};
    if (m_registers[i.a].where == Value::Where::Constant) {
        const std::uint64_t bits = m_registers[i.a].content;
        m_registers.use(i.a);
        m_registers.beforeStore(range);
        m_asm.mov(m_registers.at(range.offset, 1), bits != 0 ? 1 : 0);
        return;
    }
    const x86::Gp value = ownZeroOrOne(i.a);
    m_registers.beforeStore(range);
    m_asm.mov(m_registers.at(range.offset, 1), value.r8());
}

void RoutineTranslator::edge(const IrInstruction& i)
{
    const x86::Mem before = m_registers.at(m_program.memory.stateOffset() + i.index, 1);
    const x86::Gp now = ownZeroOrOne(i.a);
    if (!m_registers.isUsed(i.dest)) {
        m_asm.mov(before, now.r8());
        return;
    }
    const x86::Gp result = m_registers.takeGeneral();
    const bool isRising = i.op == IrOp::RisingEdge;
    m_asm.xor_(result, result);
    m_asm.cmp(before, 0);
    m_asm.set(isRising ? x86::CondCode::kEqual : x86::CondCode::kNotEqual, result.r8());
    m_asm.mov(before, now.r8());
    if (!isRising)
        m_asm.xor_(now, 1);
    m_asm.and_(result, now);
    m_registers.defineBool(i.dest, result.id(), 0, false, true);
}

x86::CondCode RoutineTranslator::testBool(IrRegister number, bool settles)
{
    const Value value = m_registers[number];
    const x86::CondCode whenTrue = value.inverted ? x86::CondCode::kZero : x86::CondCode::kNotZero;
    const bool isWaiting = value.where == Value::Where::Memory && !value.keep;
    if (isWaiting || value.where == Value::Where::Slot) {
        m_registers.use(number);
        if (settles)
            m_registers.settle();
        if (!isWaiting)
            m_asm.test(m_registers.at(value.slot, 4), static_cast<std::int32_t>(1u << value.bit));
        else if (value.bit == Value::WholeByte)
            m_asm.cmp(m_registers.at(static_cast<std::uint32_t>(value.content), 1), 0);
        else
            m_asm.test(m_registers.at(static_cast<std::uint32_t>(value.content), 1), static_cast<std::int8_t>(1u << value.bit));
        return whenTrue;
    }
    const Unit unit = m_registers.bringBool(number);
    const unsigned bit = m_registers[number].bit; // loading may have moved it
    m_registers.use(number);
    if (settles)
        m_registers.settle();
    if (bit < 8)
        m_asm.test(x86::gpb(unit), static_cast<std::int8_t>(1u << bit));
    else
        m_asm.test(x86::gpd(unit), static_cast<std::int32_t>(1u << bit));
    return whenTrue;
}

} // namespace camwright::native
