#include "core/language/lowering/koyoaccumulator.h"

#include "core/family/koyo/koyoareas.h"

namespace camwright {

namespace {

constexpr DataType Number = DataType::Udint;

IrAddress at(std::uint32_t byte)
{
    return {koyo::Accumulator, IrAddress::WholeByte, byte};
}

IrAddress relayAt(std::uint32_t relay)
{
    return {koyo::SP, static_cast<std::uint8_t>(relay % 8), relay / 8};
}

} // namespace

IrRegister KoyoAccumulator::value()
{
    return m_ir.load(Number, at(koyo::AccumulatorByte));
}

void KoyoAccumulator::store(IrRegister value)
{
    m_ir.store(Number, at(koyo::AccumulatorByte), value);
}

void KoyoAccumulator::load(IrRegister value, bool usesStack)
{
    if (usesStack) {
        const IrRegister old = this->value();
        const std::size_t skip = m_ir.jumpIf(false, m_ir.load(DataType::Bool, at(koyo::LoadedByte)));
        push(old);
        m_ir.land(skip);
        m_ir.store(DataType::Bool, at(koyo::LoadedByte), m_ir.constant(DataType::Bool, 1));
    }
    store(value);
    flag(koyo::LoadedZero, isZero(value));
}

void KoyoAccumulator::release()
{
    m_ir.store(DataType::Bool, at(koyo::LoadedByte), m_ir.constant(DataType::Bool, 0));
}

void KoyoAccumulator::push(IrRegister value)
{
    for (unsigned level = koyo::StackLevels - 1; level > 0; --level)
        m_ir.store(Number, at(koyo::StackByte + 4 * level), m_ir.load(Number, at(koyo::StackByte + 4 * (level - 1))));
    m_ir.store(Number, at(koyo::StackByte), value);
}

void KoyoAccumulator::pop()
{
    store(m_ir.load(Number, at(koyo::StackByte)));
    for (unsigned level = 0; level + 1 < koyo::StackLevels; ++level)
        m_ir.store(Number, at(koyo::StackByte + 4 * level), m_ir.load(Number, at(koyo::StackByte + 4 * (level + 1))));
    m_ir.store(Number, at(koyo::StackByte + 4 * (koyo::StackLevels - 1)), constant(0));
}

IrRegister KoyoAccumulator::constant(std::uint32_t value)
{
    return m_ir.constant(Number, value);
}

IrRegister KoyoAccumulator::compute(IrOp op, IrRegister a, IrRegister b)
{
    return m_ir.compute(op, Number, a, b);
}

IrRegister KoyoAccumulator::computeWith(IrOp op, IrRegister a, std::uint32_t b)
{
    const IrRegister right = constant(b);
    return compute(op, a, right);
}

IrRegister KoyoAccumulator::isZero(IrRegister a)
{
    const IrRegister zero = constant(0);
    return m_ir.compute(IrOp::Equal, Number, a, zero);
}

IrRegister KoyoAccumulator::isNotZero(IrRegister a)
{
    const IrRegister zero = constant(0);
    return m_ir.compute(IrOp::NotEqual, Number, a, zero);
}

IrRegister KoyoAccumulator::shifted(IrOp op, IrRegister a, unsigned by)
{
    const IrRegister count = m_ir.constant(DataType::Dword, by);
    return m_ir.compute(op, Number, a, count);
}

IrRegister KoyoAccumulator::masked(IrRegister a, std::uint32_t mask)
{
    const IrRegister bits = constant(mask);
    return compute(IrOp::And, a, bits);
}

IrRegister KoyoAccumulator::isBelow(IrRegister a, IrRegister b)
{
    return m_ir.compute(IrOp::Less, Number, a, b);
}

/// Pairs of digits, then of pairs, then the halves: 16a + b becomes 10a + b, by taking 6a away, and so on.
IrRegister KoyoAccumulator::fromBcd(IrRegister digits)
{
    // A digit is above 9 when its highest bit is set together with one of the middle two.
    const IrRegister high = masked(digits, 0x88888888);
    const IrRegister once = shifted(IrOp::ShiftLeft, digits, 1);
    const IrRegister twice = shifted(IrOp::ShiftLeft, digits, 2);
    const IrRegister odd = compute(IrOp::And, high, compute(IrOp::Or, once, twice));
    flag(koyo::NotBcd, isNotZero(odd));
    struct Step {
        unsigned shift;
        std::uint32_t mask, excess;
    };
    IrRegister out = digits;
    for (const Step& step : {Step{4, 0x0F0F0F0F, 16 - 10}, Step{8, 0x00FF00FF, 256 - 100}, Step{16, 0xFFFF, 65536 - 10000}}) {
        const IrRegister upper = masked(shifted(IrOp::ShiftRight, out, step.shift), step.mask);
        out = compute(IrOp::Sub, out, computeWith(IrOp::Mul, upper, step.excess));
    }
    return out;
}

/// The way back: halves, pairs, digits. Within a lane of 16 bits x * 103 / 1024 is x / 10 for x below 100.
IrRegister KoyoAccumulator::toBcd(IrRegister number)
{
    const IrRegister tenThousands = computeWith(IrOp::Div, number, 10000);
    const IrRegister halves = compute(IrOp::Add, number, computeWith(IrOp::Mul, tenThousands, 65536 - 10000));
    const IrRegister upper = computeWith(IrOp::Div, shifted(IrOp::ShiftRight, halves, 16), 100);
    const IrRegister lower = computeWith(IrOp::Div, masked(halves, 0xFFFF), 100);
    const IrRegister hundreds = compute(IrOp::Or, shifted(IrOp::ShiftLeft, upper, 16), lower);
    const IrRegister pairs = compute(IrOp::Add, halves, computeWith(IrOp::Mul, hundreds, 256 - 100));
    IrRegister out = pairs;
    for (const unsigned lane : {0u, 8u}) {
        const IrRegister two = masked(shifted(IrOp::ShiftRight, pairs, lane), 0x00FF00FF);
        const IrRegister tens = masked(shifted(IrOp::ShiftRight, computeWith(IrOp::Mul, two, 103), 10), 0x000F000F);
        const IrRegister excess = computeWith(IrOp::Mul, tens, 16 - 10);
        out = compute(IrOp::Add, out, shifted(IrOp::ShiftLeft, excess, lane));
    }
    return out;
}

void KoyoAccumulator::flag(std::uint32_t relay, IrRegister on)
{
    m_ir.store(DataType::Bool, relayAt(relay), on);
}

void KoyoAccumulator::flagResult(IrRegister value)
{
    flag(koyo::IsZero, isZero(value));
    flag(koyo::IsNegative, isNotZero(masked(value, 0x80000000)));
}

} // namespace camwright
