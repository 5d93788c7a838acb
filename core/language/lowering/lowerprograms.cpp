#include "core/language/lowering/lowerprograms.h"

#include "core/language/lowering/routinelowering.h"

#include <algorithm>

namespace camwright {

namespace {

RoutineKind kindOf(ProgramRole role)
{
    switch (role) {
    case ProgramRole::Main: return RoutineKind::Main;
    case ProgramRole::Subroutine: return RoutineKind::Subroutine;
    case ProgramRole::Interrupt: return RoutineKind::Interrupt;
    }
    return RoutineKind::Subroutine;
}

bool readsStack(const CheckedProgram& program)
{
    for (const CheckedNetwork& network : program.networks)
        for (const CheckedRung& rung : network.rungs)
            for (const CheckedStatement& statement : rung.statements)
                if (statement.instruction->id == InstructionId::KoyoPop)
                    return true;
    return false;
}

InterruptSource sourceOf(const InterruptEvent& event, std::uint32_t routine)
{
    using Kind = InterruptEvent::Kind;
    if (event.kind == Kind::Timed)
        return {routine, InterruptCause::Timed, {}, std::chrono::milliseconds(event.milliseconds)};
    return {routine, event.kind == Kind::Rising ? InterruptCause::Rising : InterruptCause::Falling, event.input, {}};
}

class ProgramLinker {
public:
    ProgramLinker(const Family& family, const ControllerModel& model, std::span<const CheckedProgram> programs, std::span<const std::string> following,
                  std::uint32_t variableBytes)
        : m_family(family), m_model(model), m_programs(programs), m_following(following), m_elements(family, m_out.program, variableBytes)
    {
        m_out.blocksWithLocals = programs.size();
        for (const CheckedProgram& program : programs) {
            m_out.program.routines.push_back({program.key.name, kindOf(program.role), 0, {}});
            m_out.debug.objects.push_back(program.key);
            m_usesStack = m_usesStack || readsStack(program);
        }
    }

    void lower(std::uint32_t index)
    {
        RoutineContext context{m_family, m_model, m_elements, index,
                               [this](std::string_view name) { return routineByName(name); }, m_programs,
                               [this, index](std::uint32_t network, const TextRange& range) { return source(index, network, range); },
                               m_usesStack};
        RoutineLowering(context, m_out.program.routines[index]).lower(m_programs[index]);
        if (m_programs[index].event)
            m_out.interrupts.push_back(sourceOf(*m_programs[index].event, index));
    }

    LoweredPrograms take()
    {
        m_out.variableBytes = m_elements.variableBytes();
        return std::move(m_out);
    }

private:
    std::uint32_t routineByName(std::string_view name) const
    {
        const auto found = std::ranges::find(m_programs, name, [](const CheckedProgram& program) { return std::string_view(program.key.name); });
        const auto number = static_cast<std::uint32_t>(found - m_programs.begin());
        if (found != m_programs.end())
            return number;
        return number + static_cast<std::uint32_t>(std::ranges::find(m_following, name) - m_following.begin());
    }

    std::uint32_t source(std::uint32_t object, std::uint32_t network, const TextRange& range)
    {
        m_out.debug.sources.push_back({object, network, range});
        return static_cast<std::uint32_t>(m_out.debug.sources.size());
    }

    const Family& m_family;
    const ControllerModel& m_model;
    std::span<const CheckedProgram> m_programs;
    std::span<const std::string> m_following;
    LoweredPrograms m_out;
    bool m_usesStack = false;
    ElementTables m_elements;
};

} // namespace

LoweredPrograms lowerPrograms(const Family& family, const ControllerModel& model, std::span<const CheckedProgram> programs,
                              const Job& job, std::span<const std::string> following, std::uint32_t variableBytes)
{
    ProgramLinker linker(family, model, programs, following, variableBytes);
    for (std::uint32_t i = 0; i < programs.size() && !job.isCancelled(); ++i)
        linker.lower(i);
    return linker.take();
}

} // namespace camwright
