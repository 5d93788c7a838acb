#include "core/language/ir/verifyprogram.h"

#include <functional>
#include <queue>

namespace camwright {

namespace {

/// What is known of a register while the instructions are walked in order.
struct RegisterState {
    bool defined = false;
    DataType type = DataType::Bool;
    std::uint32_t validUntil = 0; ///< first instruction that may be reached without the definition
};

/// Walks a routine once. A definition that an open forward jump may skip counts only up to that jump's target: so a
/// register is never read on a path on which it was not written.
class RoutineVerifier {
public:
    RoutineVerifier(const IrProgram& program, const IrRoutine& routine, const AreaSizes& areas)
        : m_program(program), m_routine(routine), m_areas(areas), m_registers(routine.registers)
    {
    }

    Result<void> run()
    {
        for (m_at = 0; m_at < m_routine.code.size(); ++m_at) {
            while (!m_openTargets.empty() && m_openTargets.top() <= m_at)
                m_openTargets.pop();
            if (const char* what = check(m_routine.code[m_at]))
                return unsafeProgram(m_routine, m_at, what);
        }
        return {};
    }

private:
    const char* check(const IrInstruction& i)
    {
        const IrShape& shape = shapeOf(i.op);
        if (!shape.known)
            return "unknown operation";
        if (!isKnownType(i.type) || (shape.from && !isKnownType(i.from)) || !isAllowed(i.op, i.type, i.from))
            return "operation does not exist for this type";
        if (shape.constant && !isConstantOf(i.type, i.constant))
            return "constant is not of its type";
        if (shape.address && !fits(m_areas, i.address, i.type))
            return "address outside its area";
        if (const char* what = checkIndex(shape.index, i))
            return what;
        if (const char* what = checkOperands(shape, i))
            return what;
        return shape.dest ? define(i) : nullptr;
    }

    const char* checkOperands(const IrShape& shape, const IrInstruction& i)
    {
        const bool boolInput = shape.index != IrShape::Index::None;
        const DataType first = boolInput ? DataType::Bool : shape.from ? i.from : i.type;
        if (shape.a && !isReadable(i.a, first))
            return "operand a is not written before, or not of the type";
        const DataType second = i.op == IrOp::CounterArm ? DataType::Bool : secondOperandType(i.op, i.type);
        if (shape.b && !isReadable(i.b, second))
            return "operand b is not written before, or not of the type";
        return nullptr;
    }

    const char* checkIndex(IrShape::Index index, const IrInstruction& i)
    {
        switch (index) {
        case IrShape::Index::None: return nullptr;
        case IrShape::Index::Target:
            if (i.index > m_routine.code.size())
                return "jump out of the routine";
            if (i.index > m_at)
                m_openTargets.push(i.index);
            return nullptr;
        case IrShape::Index::Routine: return i.index < m_program.routines.size() ? nullptr : "no such routine";
        case IrShape::Index::Timer: return i.index < m_program.timers.size() ? nullptr : "no such timer";
        case IrShape::Index::Counter:
            if (i.index >= m_program.counters.size())
                return "no such counter";
            return i.op != IrOp::Counter || m_program.counters[i.index].type == i.type ? nullptr : "counter of another type";
        case IrShape::Index::Block: return i.index < m_program.blocks.size() ? nullptr : "no such block";
        case IrShape::Index::EdgeState: return i.index < m_program.stateBytes ? nullptr : "edge outside the hidden state";
        }
        return "unknown operation";
    }

    bool isReadable(IrRegister number, DataType type) const
    {
        if (number >= m_registers.size())
            return false;
        const RegisterState& state = m_registers[number];
        return state.defined && state.type == type && m_at < state.validUntil;
    }

    const char* define(const IrInstruction& i)
    {
        if (i.dest >= m_registers.size() || m_registers[i.dest].defined)
            return "destination is no register, or written twice";
        const std::uint32_t end = m_openTargets.empty() ? 0xFFFFFFFF : m_openTargets.top();
        m_registers[i.dest] = {true, resultType(i.op, i.type), end};
        return nullptr;
    }

    const IrProgram& m_program;
    const IrRoutine& m_routine;
    const AreaSizes& m_areas;
    std::vector<RegisterState> m_registers;
    std::priority_queue<std::uint32_t, std::vector<std::uint32_t>, std::greater<>> m_openTargets;
    std::uint32_t m_at = 0;
};

} // namespace

Result<void> verifyRoutine(const IrProgram& program, const IrRoutine& routine, const AreaSizes& areas)
{
    // A register is written by one instruction, so there are never more of them; this also bounds the memory taken here.
    if (routine.registers > routine.code.size() || routine.code.size() >= NoRegister)
        return unsafeProgram(routine, 0, "more registers than instructions");
    return RoutineVerifier(program, routine, areas).run();
}

} // namespace camwright
