#include "core/language/ir/verifyprogram.h"

#include <algorithm>

namespace camwright {

namespace {

Diagnostic unsafe(std::string what)
{
    return diagnostic(Code::ImageUnsafe, {std::move(what)});
}

/// Depth of calls below each routine; -1 while it is being looked at.
class CallGraph {
public:
    explicit CallGraph(const IrProgram& program) : m_callees(program.routines.size()), m_depth(program.routines.size(), 0)
    {
        for (std::size_t r = 0; r < program.routines.size(); ++r) {
            for (const IrInstruction& i : program.routines[r].code) {
                if (isCall(i.op))
                    m_callees[r].push_back(i.index);
            }
            std::ranges::sort(m_callees[r]);
            m_callees[r].erase(std::unique(m_callees[r].begin(), m_callees[r].end()), m_callees[r].end());
        }
    }

    /// Takes away routine after routine that calls nothing any more; what is left over calls itself. Returns the greatest
    /// depth, or nothing if there is a cycle.
    std::optional<unsigned> depth()
    {
        std::vector<std::vector<std::uint32_t>> callers(m_callees.size());
        std::vector<std::size_t> open(m_callees.size());
        std::vector<std::uint32_t> ready;
        for (std::uint32_t r = 0; r < m_callees.size(); ++r) {
            open[r] = m_callees[r].size();
            if (open[r] == 0)
                ready.push_back(r);
            for (const std::uint32_t callee : m_callees[r])
                callers[callee].push_back(r);
        }
        std::size_t done = 0;
        unsigned greatest = 0;
        while (!ready.empty()) {
            const std::uint32_t r = ready.back();
            ready.pop_back();
            ++done;
            greatest = std::max(greatest, m_depth[r]);
            for (const std::uint32_t caller : callers[r]) {
                m_depth[caller] = std::max(m_depth[caller], m_depth[r] + 1);
                if (--open[caller] == 0)
                    ready.push_back(caller);
            }
        }
        return done == m_callees.size() ? std::optional(greatest) : std::nullopt;
    }

private:
    std::vector<std::vector<std::uint32_t>> m_callees;
    std::vector<unsigned> m_depth;
};

/// Value and bit of a timer or counter inside their areas, its hidden state inside the hidden state.
bool isElementSafe(const IrProgram& program, const AreaSizes& areas, const IrAddress& value, DataType type,
                   const IrAddress& bit, std::uint32_t state, std::uint32_t stateBytes)
{
    return fits(areas, value, type) && fits(areas, bit, DataType::Bool)
        && state <= program.stateBytes && program.stateBytes - state >= stateBytes;
}

bool isTimerSafe(const IrProgram& program, const AreaSizes& areas, const IrTimer& timer)
{
    constexpr std::int64_t LongestBaseNs = 60'000'000'000;
    return timer.kind >= TimerKind::Ton && timer.kind <= TimerKind::KoyoTmraf && timer.baseNs > 0
        && timer.baseNs <= LongestBaseNs
        && isElementSafe(program, areas, timer.value, valueType(timer.kind), timer.bit, timer.state, TimerStateBytes);
}

bool isCounterSafe(const IrProgram& program, const AreaSizes& areas, const IrCounter& counter)
{
    return counter.kind >= CounterKind::Up && counter.kind <= CounterKind::KoyoUdc
        && (counter.type == DataType::Int || counter.type == DataType::Dint)
        && isElementSafe(program, areas, counter.value, counter.type, counter.bit, counter.state, CounterStateBytes);
}

bool isPinSafe(const AreaSizes& areas, const IrPin& pin)
{
    if (!isKnownType(pin.type))
        return false;
    switch (pin.kind) {
    case IrPin::Kind::Open: return true;
    case IrPin::Kind::Constant: return isConstantOf(pin.type, pin.constant);
    case IrPin::Kind::Memory: return fits(areas, pin.address, pin.type);
    }
    return false;
}

Result<void> verifyTables(const IrProgram& program, const AreaSizes& areas)
{
    for (const IrTimer& timer : program.timers) {
        if (!isTimerSafe(program, areas, timer))
            return unsafe("a timer lies outside its area");
    }
    for (const IrCounter& counter : program.counters) {
        if (!isCounterSafe(program, areas, counter))
            return unsafe("a counter lies outside its area");
    }
    for (std::size_t b = 0; b < program.blocks.size(); ++b) {
        const IrBlock& block = program.blocks[b];
        if (block.instance != b)
            return unsafe("the instances of the blocks are not numbered in order");
        if (!std::ranges::all_of(block.pins, [&](const IrPin& pin) { return isPinSafe(areas, pin); }))
            return unsafe("a pin of a block lies outside its area");
    }
    return {};
}

} // namespace

bool isKnownType(DataType type)
{
    return type >= DataType::Bool && type <= DataType::Lword;
}

bool isConstantOf(DataType type, std::uint64_t bits)
{
    const unsigned width = bitWidth(type);
    return width == 64 || bits >> width == 0;
}

bool fits(const AreaSizes& areas, const IrAddress& address, std::uint64_t bytes)
{
    return std::uint64_t{address.byte} + bytes <= areas[address.area];
}

bool fits(const AreaSizes& areas, const IrAddress& address, DataType type)
{
    const bool hasBit = address.bit != IrAddress::WholeByte;
    if (hasBit && (address.bit > 7 || type != DataType::Bool))
        return false;
    return fits(areas, address, std::uint64_t{byteWidth(type)});
}

Diagnostic unsafeProgram(const IrRoutine& routine, std::size_t instruction, std::string what)
{
    return unsafe(routine.name + ", instruction " + std::to_string(instruction) + ": " + std::move(what));
}

Result<void> verifyProgram(const IrProgram& program, const AreaSizes& areas)
{
    const auto isMain = [](const IrRoutine& routine) { return routine.kind == RoutineKind::Main; };
    if (std::ranges::count_if(program.routines, isMain) != 1)
        return unsafe("there is not exactly one main program");
    if (program.stateBytes > MaximumStateBytes)
        return unsafe("the hidden state is too large");
    if (Result<void> tables = verifyTables(program, areas); !tables)
        return tables;
    for (const IrRoutine& routine : program.routines) {
        if (Result<void> checked = verifyRoutine(program, routine, areas); !checked)
            return checked;
    }
    const std::optional<unsigned> depth = CallGraph(program).depth();
    if (!depth || *depth > MaximumCallDepth)
        return unsafe("calls form a cycle or nest too deep");
    return {};
}

} // namespace camwright
