#include "core/runtime/native/routinetranslator.h"

namespace camwright::native {

void RoutineTranslator::convert(const IrInstruction& i)
{
    if (isFloat(i.from))
        return isFloat(i.type) ? floatToFloat(i) : floatToInteger(i);
    return isFloat(i.type) ? integerToFloat(i) : integerToInteger(i);
}

/// Extended by the source's sign, cut by the destination's width.
void RoutineTranslator::integerToInteger(const IrInstruction& i)
{
    const unsigned from = byteWidth(i.from);
    const unsigned to = byteWidth(i.type);
    if (to <= from && from < 8) { // what lies above the width does not matter
        const x86::Gp value = m_registers.general(i.a);
        return m_registers.define(i.dest, i.type, value.id());
    }
    x86::Gp value = m_registers.ownGeneral(i.a, RegisterAllocator::Width::Extended);
    if (from == 8 && to < 8)
        m_asm.mov(value.r32(), value.r32());
    else if (to == 8 && from < 8 && isSigned(i.from))
        m_asm.movsxd(value.r64(), value.r32());
    const bool isExtended = to < 4 && (!isSigned(i.from) || isSigned(i.type)) && from < to;
    m_registers.define(i.dest, i.type, value.id(), isExtended);
}

void RoutineTranslator::integerToFloat(const IrInstruction& i)
{
    if (i.from == DataType::Ulint || i.from == DataType::Lword)
        return interpreted(i);
    const x86::Gp value = m_registers.general(i.a, RegisterAllocator::Width::Extended);
    const bool isWide = byteWidth(i.from) == 8 || (byteWidth(i.from) == 4 && !isSigned(i.from));
    const x86::Gp source = generalRegister(value.id(), isWide ? 8 : 4);
    const x86::Xmm result = m_registers.takeFloat();
    m_asm.xorps(result, result); // the conversion keeps the upper bytes and would wait for them
    m_asm.emit(i.type == DataType::Real ? x86::Inst::kIdCvtsi2ss : x86::Inst::kIdCvtsi2sd, result, source);
    m_registers.define(i.dest, i.type, result.id() + FirstFloat, false, true);
}

void RoutineTranslator::floatToFloat(const IrInstruction& i)
{
    const x86::Xmm value = m_registers.ownFloating(i.a);
    if (i.from != i.type)
        m_asm.emit(i.type == DataType::Lreal ? x86::Inst::kIdCvtss2sd : x86::Inst::kIdCvtsd2ss, value, value);
    m_registers.define(i.dest, i.type, value.id() + FirstFloat);
}

/// To 64 bits first: a number beyond those gives the smallest integer, as a NaN does; that seldom happens and is sorted out
/// apart. The rest is brought to the nearest end of the type.
void RoutineTranslator::floatToInteger(const IrInstruction& i)
{
    const unsigned width = bitWidth(i.type);
    if (width == 64 && !isSigned(i.type))
        return interpreted(i);
    const bool isReal = i.from == DataType::Real;
    const bool truncates = i.op == IrOp::Truncate;
    const x86::Xmm value = m_registers.floating(i.a);
    const x86::Gp result = generalRegister(m_registers.take(Bank::General), 8);
    const x86::Gp bound = generalRegister(m_registers.take(Bank::General), 8);
    const x86::Inst::Id rounding = isReal ? x86::Inst::kIdCvtss2si : x86::Inst::kIdCvtsd2si;
    const x86::Inst::Id truncating = isReal ? x86::Inst::kIdCvttss2si : x86::Inst::kIdCvttsd2si;
    m_asm.emit(truncates ? truncating : rounding, result, value);
    m_asm.cmp(result, 1);
    Cold& overflow = cold(&RoutineTranslator::coldOverflow, value.id() << 16 | bound.id() << 8 | result.id());
    overflow.back = m_asm.newLabel();
    m_asm.jo(overflow.entry);
    m_asm.bind(overflow.back);
    if (width < 64) {
        const std::int64_t greatest = isSigned(i.type) ? (std::int64_t{1} << (width - 1)) - 1 : (std::int64_t{1} << width) - 1;
        const std::int64_t least = isSigned(i.type) ? -(std::int64_t{1} << (width - 1)) : 0;
        m_asm.mov(bound, greatest);
        m_asm.cmp(result, bound);
        m_asm.cmovg(result, bound);
        m_asm.mov(bound, least);
        m_asm.cmp(result, bound);
        m_asm.cmovl(result, bound);
        m_asm.mov(result.r32(), result.r32());
    }
    m_registers.define(i.dest, i.type, result.id(), width < 32);
}

/// extra: the float, a spare register, the result. A NaN gives 0, a number the end of the 64-bit integers on its side.
void RoutineTranslator::coldOverflow(const Cold& c)
{
    const bool isReal = m_routine.code[c.at].from == DataType::Real;
    const x86::Xmm value = x86::xmm(c.extra >> 16);
    const x86::Gp spare = generalRegister(c.extra >> 8 & 0xFF, 8);
    const x86::Gp result = generalRegister(c.extra & 0xFF, 8);
    const asmjit::Label isNumber = m_asm.newLabel();
    m_asm.emit(isReal ? x86::Inst::kIdUcomiss : x86::Inst::kIdUcomisd, value, value);
    m_asm.jnp(isNumber);
    m_asm.xor_(result.r32(), result.r32());
    m_asm.jmp(c.back);
    m_asm.bind(isNumber);
    // The smallest integer less 1 is the greatest: 1 is taken off where the sign bit is clear.
    m_asm.movq(spare, value);
    if (isReal)
        m_asm.shl(spare, 32);
    m_asm.not_(spare);
    m_asm.shr(spare, 63);
    m_asm.sub(result, spare);
    m_asm.jmp(c.back);
}

} // namespace camwright::native
