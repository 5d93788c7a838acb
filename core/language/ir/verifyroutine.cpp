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
    std::uint32_t reach = 0;      ///< a pointer: bytes from it that may be touched; 0: no pointer
    std::uint32_t bound = 0;      ///< an index: it is less than this; 0: no index
};

/// Walks a routine once. A definition that an open forward jump may skip counts only up to that jump's target: so a
/// register is never read on a path on which it was not written.
class RoutineVerifier {
public:
    RoutineVerifier(const IrProgram& program, const IrRoutine& routine, const AreaSizes& areas)
        : m_program(program), m_routine(routine), m_areas(areas), m_registers(routine.registers)
    {
        m_areas[InstanceArea] = routine.kind == RoutineKind::Block ? routine.instanceBytes : 0;
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
        if (i.op == IrOp::Const && !isConstantOf(i.type, i.constant))
            return "constant is not of its type";
        if (const char* what = checkIndex(shape.index, i))
            return what;
        if (const char* what = checkOperands(shape, i))
            return what;
        if (const char* what = checkPlace(shape, i))
            return what;
        return shape.dest ? define(i) : nullptr;
    }

    const char* checkOperands(const IrShape& shape, const IrInstruction& i)
    {
        if (shape.a && !isReadable(i.a, firstOperandType(i.op, i.type, i.from)))
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
        case IrShape::Index::Routine: return checkRoutine(i);
        case IrShape::Index::Timer:
            if (i.index >= m_program.timers.size())
                return "no such timer";
            return i.op != IrOp::Timer || valueType(m_program.timers[i.index].kind) == i.type ? nullptr : "timer of another type";
        case IrShape::Index::Counter:
            if (i.index >= m_program.counters.size())
                return "no such counter";
            return i.op != IrOp::Counter || m_program.counters[i.index].type == i.type ? nullptr : "counter of another type";
        case IrShape::Index::Block: return i.index < m_program.blocks.size() ? nullptr : "no such block";
        case IrShape::Index::EdgeState: return i.index < m_program.stateBytes ? nullptr : "edge outside the hidden state";
        case IrShape::Index::Register: return isReadable(i.index, i.type) ? nullptr : "third operand is not written before";
        }
        return "unknown operation";
    }

    const char* checkRoutine(const IrInstruction& i) const
    {
        if (i.index >= m_program.routines.size())
            return "no such routine";
        const bool wantsInstance = m_program.routines[i.index].kind == RoutineKind::Block;
        return wantsInstance == (i.op != IrOp::Call) ? nullptr : "call with an instance of what has none, or without one";
    }

    /// Memory operands: fixed ones, those with an index, and those through a pointer.
    const char* checkPlace(const IrShape& shape, const IrInstruction& i) const
    {
        switch (i.op) {
        case IrOp::CallOn: return isComputable(i, m_program.routines[i.index].instanceBytes) ? nullptr : "instance outside its area";
        case IrOp::CallAt: return reaches(i.a, m_program.routines[i.index].instanceBytes) ? nullptr : "pointer does not reach the instance";
        case IrOp::Place: return isComputable(i, i.constant) ? nullptr : "address outside its area";
        case IrOp::Reach: return i.constant <= m_areas[VariablesArea] && i.index > m_at ? nullptr : "reach beyond the area, or jump back";
        case IrOp::Bound: return irSecond(i.constant) > 0 && irSecond(i.constant) <= MaximumBound && i.index > m_at ? nullptr : "no such bound, or jump back";
        case IrOp::Element: return reaches(i.a, lastByte(i.b, irFirst(i.constant), irSecond(i.constant))) ? nullptr : "element outside its array";
        case IrOp::LoadAt: return isThroughPointer(i, i.a) ? nullptr : "pointer does not reach the value";
        case IrOp::StoreAt: return isThroughPointer(i, i.b) ? nullptr : "pointer does not reach the value";
        case IrOp::LoadElement:
        case IrOp::StoreElement:
            return isWhole(i) && hasElements(i, lastByte(i.b, i.constant, byteWidth(i.type))) ? nullptr : "element outside its area";
        case IrOp::Move: return reaches(i.a, i.constant) && reaches(i.b, i.constant) ? nullptr : "move beyond what its pointers reach";
        default:
            if (shape.address && i.address.area == InstanceArea && !isWhole(i))
                return "bit of an instance";
            return !shape.address || fits(m_areas, i.address, i.type) ? nullptr : "address outside its area";
        }
    }

    /// Bytes from the first element to the end of the last one that an index may choose; too many if it is no index.
    std::uint64_t lastByte(IrRegister index, std::uint64_t stride, std::uint64_t bytes) const
    {
        const std::uint32_t bound = m_registers[index].bound;
        return bound == 0 || stride > MaximumStride ? UINT64_MAX : (bound - 1) * stride + bytes;
    }

    bool reaches(IrRegister pointer, std::uint64_t bytes) const { return m_registers[pointer].reach > 0 && bytes <= m_registers[pointer].reach; }
    bool isWhole(const IrInstruction& i) const { return i.address.bit == IrAddress::WholeByte; }

    /// An address whose offset may be computed with: in VariablesArea, or inside the instance.
    bool isComputable(const IrInstruction& i, std::uint64_t bytes) const
    {
        const bool area = i.address.area == VariablesArea || i.address.area == InstanceArea;
        return area && isWhole(i) && bytes <= UINT32_MAX && fits(m_areas, i.address, bytes);
    }

    /// Elements may lie in any area: an array of the TS600 is bound to words or bits.
    bool hasElements(const IrInstruction& i, std::uint64_t bytes) const { return bytes <= UINT32_MAX && fits(m_areas, i.address, bytes); }

    bool isThroughPointer(const IrInstruction& i, IrRegister pointer) const
    {
        return i.address.area == VariablesArea && isWhole(i) && reaches(pointer, std::uint64_t{i.address.byte} + byteWidth(i.type));
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
        RegisterState state{true, resultType(i.op, i.type), end, 0, 0};
        if (i.op == IrOp::Place || i.op == IrOp::Reach)
            state.reach = static_cast<std::uint32_t>(i.constant);
        else if (i.op == IrOp::Element)
            state.reach = irSecond(i.constant);
        else if (i.op == IrOp::Bound)
            state.bound = irSecond(i.constant);
        m_registers[i.dest] = state;
        return nullptr;
    }

    static constexpr std::uint32_t MaximumBound = 1u << 28;
    static constexpr std::uint64_t MaximumStride = 1u << 28;

    const IrProgram& m_program;
    const IrRoutine& m_routine;
    AreaSizes m_areas;
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
