#include "core/runtime/native/routinetranslator.h"

namespace camwright::native {

// Division, remainder, shifts: what wants certain registers.

namespace {

constexpr Unit Rax = 0;
constexpr Unit Rcx = 1;
constexpr Unit Rdx = 2;

} // namespace

void RoutineTranslator::divide(const IrInstruction& i)
{
    if (isFloat(i.type))
        return floatDivide(i);
    beforeFault();
    m_registers.takeFixed(Rax);
    m_registers.takeFixed(Rdx);
    const Value divisor = m_registers[i.b];
    const bool isConstant = divisor.where == Value::Where::Constant;
    const x86::Gp b = m_registers.general(i.b, RegisterAllocator::Width::Extended);
    const x86::Gp a = m_registers.general(i.a, RegisterAllocator::Width::Extended);
    m_asm.mov(a.size() == 8 ? x86::Gp(x86::rax) : x86::Gp(x86::eax), a);
    const std::uint64_t minusOne = ~std::uint64_t{0} >> (64 - bitWidth(i.type));
    const bool canOverflow = isSigned(i.type) && byteWidth(i.type) >= 4; // narrower ones have room in 32 bits
    divideBy(i, b, !isConstant || divisor.content == 0, canOverflow && (!isConstant || divisor.content == minusOne));
    m_registers.define(i.dest, i.type, i.op == IrOp::Div ? Rax : Rdx);
}

void RoutineTranslator::divideBy(const IrInstruction& i, x86::Gp divisor, bool mayBeZero, bool mayBeMinusOne)
{
    const asmjit::Label done = m_asm.newLabel();
    if (mayBeZero) {
        m_asm.test(divisor, divisor);
        Cold& zero = cold(&RoutineTranslator::coldZeroDivisor);
        zero.back = done;
        m_asm.jz(zero.entry);
    }
    if (mayBeMinusOne) {
        m_asm.cmp(divisor, -1);
        Cold& minus = cold(&RoutineTranslator::coldMinusOneDivisor, i.op == IrOp::Div ? divisor.size() : 0);
        minus.back = done;
        m_asm.je(minus.entry);
    }
    if (!isSigned(i.type)) {
        m_asm.xor_(x86::edx, x86::edx);
        m_asm.emit(x86::Inst::kIdDiv, divisor.size() == 8 ? x86::Gp(x86::rdx) : x86::Gp(x86::edx),
                   divisor.size() == 8 ? x86::Gp(x86::rax) : x86::Gp(x86::eax), divisor);
    } else if (divisor.size() == 8) {
        m_asm.cqo(x86::rdx, x86::rax);
        m_asm.idiv(x86::rdx, x86::rax, divisor);
    } else {
        m_asm.cdq(x86::edx, x86::eax);
        m_asm.idiv(x86::edx, x86::eax, divisor);
    }
    m_asm.bind(done);
}

void RoutineTranslator::coldZeroDivisor(const Cold& c)
{
    callFault(c.at);
    m_asm.xor_(x86::eax, x86::eax);
    m_asm.xor_(x86::edx, x86::edx);
    m_asm.jmp(c.back);
}

/// The smallest integer by -1 would trap. extra: bytes of a quotient, 0 for a remainder.
void RoutineTranslator::coldMinusOneDivisor(const Cold& c)
{
    if (c.extra == 8)
        m_asm.neg(x86::rax);
    else if (c.extra == 4)
        m_asm.neg(x86::eax);
    else
        m_asm.xor_(x86::edx, x86::edx);
    m_asm.jmp(c.back);
}

void RoutineTranslator::shift(const IrInstruction& i)
{
    const Value& count = m_registers[i.b];
    if (count.where != Value::Where::Constant)
        return shiftByRegister(i);
    const std::uint64_t width = bitWidth(i.type);
    const std::uint64_t places = count.content;
    m_registers.use(i.b);
    const bool isRotation = i.op == IrOp::RotateLeft || i.op == IrOp::RotateRight;
    if (!isRotation && places >= width) {
        m_registers.use(i.a);
        return m_registers.defineConstant(i.dest, i.type, 0);
    }
    const x86::Gp value = m_registers.ownGeneral(i.a);
    rotateOrShift(i, value, static_cast<unsigned>(places % width));
    m_registers.define(i.dest, i.type, value.id());
}

void RoutineTranslator::rotateOrShift(const IrInstruction& i, x86::Gp value, unsigned count)
{
    const unsigned bytes = byteWidth(i.type);
    const x86::Gp sized = generalRegister(value.id(), bytes);
    switch (i.op) {
    case IrOp::ShiftLeft: m_asm.shl(value, count); break;
    case IrOp::ShiftRight: // zeros come in, for signed types too
        if (bytes < 4)
            m_asm.emit(x86::Inst::kIdMovzx, value, sized);
        m_asm.shr(value, count);
        break;
    case IrOp::RotateLeft: m_asm.rol(sized, count); break;
    default: m_asm.ror(sized, count); break;
    }
}

void RoutineTranslator::shiftByRegister(const IrInstruction& i)
{
    m_registers.takeFixed(Rcx);
    const x86::Gp value = m_registers.ownGeneral(i.a);
    m_asm.mov(x86::ecx, m_registers.general(i.b));
    const unsigned bytes = byteWidth(i.type);
    const x86::Gp sized = generalRegister(value.id(), bytes);
    if (i.op == IrOp::RotateLeft || i.op == IrOp::RotateRight) {
        // The processor takes the count modulo 32 or 64, which every width divides.
        if (i.op == IrOp::RotateLeft)
            m_asm.rol(sized, x86::cl);
        else
            m_asm.ror(sized, x86::cl);
        return m_registers.define(i.dest, i.type, value.id());
    }
    if (i.op == IrOp::ShiftRight && bytes < 4)
        m_asm.emit(x86::Inst::kIdMovzx, value, sized);
    if (i.op == IrOp::ShiftLeft)
        m_asm.shl(value, x86::cl);
    else
        m_asm.shr(value, x86::cl);
    // All ones where the count is less than the width of the register: of a narrow value nothing is left beyond that either.
    const x86::Gp mask = generalRegister(m_registers.take(Bank::General), value.size());
    m_asm.cmp(x86::ecx, value.size() * 8);
    m_asm.sbb(mask, mask);
    m_asm.and_(value, mask);
    m_registers.define(i.dest, i.type, value.id());
}

} // namespace camwright::native
