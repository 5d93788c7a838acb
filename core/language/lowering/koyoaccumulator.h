#pragma once

#include "core/language/lowering/irwriter.h"

namespace camwright {

/// Writes the IR of the Koyo accumulator. The accumulator is 32 bits of memory (area ACC, where people can watch it), not a
/// register of the routine: it keeps its value from rung to rung and from scan to scan, and a rung that is off leaves it.
class KoyoAccumulator {
public:
    explicit KoyoAccumulator(IrWriter& ir) : m_ir(ir) {}

    IrRegister value();
    /// LD and its like: the old value goes onto the stack if it was not written out; only where a program reads the stack.
    void load(IrRegister value, bool usesStack);
    void store(IrRegister value);
    /// The value was written out: the next load does not push it.
    void release();
    void push(IrRegister value);
    void pop();

    IrRegister constant(std::uint32_t value);
    IrRegister compute(IrOp op, IrRegister a, IrRegister b);
    /// a op a constant, in this order whatever order a compiler evaluates arguments in.
    IrRegister computeWith(IrOp op, IrRegister a, std::uint32_t b);
    IrRegister isZero(IrRegister a);
    IrRegister isNotZero(IrRegister a);
    IrRegister shifted(IrOp op, IrRegister a, unsigned by);
    IrRegister masked(IrRegister a, std::uint32_t mask);
    IrRegister isBelow(IrRegister a, IrRegister b);

    /// 8 BCD digits as a number. Flags what is no digit at SP75.
    IrRegister fromBcd(IrRegister digits);
    /// A number below 100,000,000 as BCD digits.
    IrRegister toBcd(IrRegister number);

    void flag(std::uint32_t relay, IrRegister on);
    /// SP63 and SP70 after a calculation.
    void flagResult(IrRegister value);

private:
    IrWriter& m_ir;
};

} // namespace camwright
