#pragma once

#include "core/language/ir/ir.h"

#include <cstddef>
#include <cstdint>

namespace camwright {

/// Appends instructions to a routine and numbers its registers. Knows no language: only how the IR is written.
class IrWriter {
public:
    explicit IrWriter(IrRoutine& routine) : m_routine(routine) {}

    /// What the instructions that follow come from: 1 + index into DebugMap::sources.
    void setSource(std::uint32_t source) { m_source = source; }

    IrRegister constant(DataType type, std::uint64_t bits);
    IrRegister load(DataType type, const IrAddress& address);
    void store(DataType type, const IrAddress& address, IrRegister value);
    IrRegister compute(IrOp op, DataType type, IrRegister a, IrRegister b = NoRegister);
    /// An index: a (DINT) as it is, 0 … count - 1. Else the routine goes on where `land` puts the jump, which is this instruction.
    IrRegister bound(IrRegister a, std::uint32_t count);
    IrRegister loadElement(DataType type, const IrAddress& address, IrRegister index, std::uint32_t stride);
    void storeElement(DataType type, const IrAddress& address, IrRegister index, std::uint32_t stride, IrRegister value);
    IrRegister convert(IrOp op, DataType from, DataType type, IrRegister a);
    /// An operation on an edge slot, a timer or a counter.
    IrRegister element(IrOp op, DataType type, std::uint32_t index, IrRegister a, IrRegister b = NoRegister);
    /// The same without a result; also calls and returns.
    void control(IrOp op, std::uint32_t index = 0, IrRegister a = NoRegister, IrRegister b = NoRegister);
    /// a if condition, else b.
    IrRegister select(DataType type, IrRegister condition, IrRegister a, IrRegister b);
    /// A jump whose target is still open; `land` puts it here.
    std::size_t jumpIf(bool sense, IrRegister condition);
    std::size_t jump();
    void land(std::size_t jump);
    void land(std::size_t jump, std::size_t target);
    /// Number of the instruction that comes next, for jumps back.
    std::size_t here() const { return m_routine.code.size(); }

    /// An instruction with its operation, type and source filled in, for emit() and define().
    IrInstruction make(IrOp op, DataType type) const;
    /// Appends an instruction without a result; returns its place, for land().
    std::size_t emit(const IrInstruction& instruction);
    /// Appends one with a result.
    IrRegister define(IrInstruction instruction);

private:

    IrRoutine& m_routine;
    std::uint32_t m_source = 0;
};

} // namespace camwright
