#include "core/runtime/executor/executor.h"

#include "core/runtime/executor/access.h"
#include "core/runtime/executor/decoder.h"

#include <algorithm>
#include <cstring>

namespace camwright {

namespace {

void placeConstants(Memory& memory, const Bytecode& code)
{
    if (!code.constants.empty())
        std::memcpy(memory.data() + code.constantsOffset, code.constants.data(), code.constants.size() * sizeof(std::uint64_t));
}

} // namespace

Result<ScanExecutor> ScanExecutor::load(std::shared_ptr<const ControllerImage> image, Translate translate)
{
    if (const Result<void> safe = verify(*image); !safe)
        return safe.error();
    Memory memory(image->layout, image->program.stateBytes);
    auto code = std::make_unique<Bytecode>(decodeTables(*image, memory));
    std::unique_ptr<const TranslatedProgram> translated = translate ? translate(*image, memory, *code) : nullptr;
    if (translated) {
        memory.reserveScratch(translated->scratchBytes());
        translated->placeConstants(memory);
    } else {
        decodeSteps(*image, memory, *code);
        memory.reserveScratch(code->scratchBytes);
        placeConstants(memory, *code);
    }
    memory.powerOn(image->layout);
    return ScanExecutor(std::move(image), std::move(code), std::move(translated), std::move(memory));
}

ScanExecutor::ScanExecutor(std::shared_ptr<const ControllerImage> image, std::unique_ptr<const Bytecode> code,
                           std::unique_ptr<const TranslatedProgram> translated, Memory memory)
    : m_image(std::move(image)), m_code(std::move(code)), m_translated(std::move(translated)), m_memory(std::move(memory))
{
    const auto& routines = m_image->program.routines;
    const auto main = std::ranges::find(routines, RoutineKind::Main, &IrRoutine::kind);
    m_main = static_cast<std::uint32_t>(main - routines.begin());
}

ScanExecutor::ScanExecutor(ScanExecutor&&) noexcept = default;
ScanExecutor& ScanExecutor::operator=(ScanExecutor&&) noexcept = default;
ScanExecutor::~ScanExecutor() = default;

ScanReport ScanExecutor::scan(const ScanInput& input)
{
    applyForces(m_memory, input.forces);
    const ScanReport report = run(m_main, input);
    applyForces(m_memory, input.forces);
    return report;
}

ScanReport ScanExecutor::run(std::uint32_t routine, const ScanInput& input)
{
    Frame frame;
    frame.bytes = m_memory.data();
    frame.code = m_code.get();
    frame.contacts = m_code->contacts.data();
    frame.program = &m_image->program;
    frame.memory = &m_memory;
    frame.host = input.host;
    frame.now = input.now;
    frame.budget = input.operations;
    frame.routine = routine;
    if (m_code->hasErrorFlag)
        storeBit(frame, m_code->errorFlag, m_code->errorFlagMask, false);
    if (m_translated) {
        m_translated->run(routine, frame);
    } else {
        const Step* step = m_code->steps.data() + m_code->entries[routine];
        while (step)
            step = step->run(frame, step);
    }
    return {frame.outOfOperations ? ScanEnd::OutOfOperations : ScanEnd::Completed, frame.operations, frame.faults,
            frame.stopRoutine, frame.stopInstruction};
}

} // namespace camwright
