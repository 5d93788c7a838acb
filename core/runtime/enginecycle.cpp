#include "core/runtime/engineimpl.h"

namespace camwright {

void ControllerEngine::Impl::doCycle()
{
    applyDueInputs();
    ++cycle;
    now = kMotionCycle * static_cast<std::int64_t>(cycle);
    log.setMoment(cycle, now);
    watchTransitions();
    if (program) {
        if (program->scan.endsAt(now))
            program->motion->endScan();
        program->motion->cycle(cycle, now);
        if (program->scan.isRunning())
            runInterrupts();
        if (program->scan.beginsAt(now))
            runScan();
    }
    if (trace.isRunning())
        sampleTrace();
}

void ControllerEngine::Impl::applyDueInputs()
{
    std::size_t due = 0;
    while (due < queue.size() && queue[due].cycle <= cycle + 1)
        ++due;
    for (std::size_t i = 0; i < due; ++i) {
        const EngineInput input = std::move(queue[i]);
        const Result<void> done = std::visit([this](const auto& content) { return apply(content); }, input.content);
        if (!done)
            log.add(done.error());
    }
    queue.erase(queue.begin(), queue.begin() + static_cast<std::ptrdiff_t>(due));
}

/// What waits for the axes: the switch of an image, and a start.
void ControllerEngine::Impl::watchTransitions()
{
    if (pending && isQuiet())
        switchImage();
    if (startPending && isQuiet() && program->motion->isReady())
        startProgram();
}

/// Interrupt routines run between scans: a scan's code takes no time (CONTRACTS 10), so nothing is there to interrupt.
void ControllerEngine::Impl::runInterrupts()
{
    InterruptTable& interrupts = program->blocks.interrupts();
    interrupts.watch(now, [this](const Address& input) { return program->scan.inputLevel(input); });
    while (const std::optional<std::uint32_t> routine = interrupts.take()) {
        const ScanReport report = program->scan.runInterrupt(*routine, now, program->blocks);
        if (report.end == ScanEnd::OutOfOperations)
            return watchdogFired(report);
    }
}

void ControllerEngine::Impl::runScan()
{
    program->motion->beginScan();
    const ScanReport report = program->scan.run(now, program->blocks);
    if (report.end == ScanEnd::OutOfOperations)
        watchdogFired(report);
}

void ControllerEngine::Impl::watchdogFired(const ScanReport& report)
{
    const Place place = sourceOf(*program->image, report.routine, report.instruction);
    std::string where = place.object.name;
    if (place.range.isValid())
        where += ", line " + std::to_string(place.range.line);
    const auto milliseconds = std::chrono::duration_cast<std::chrono::milliseconds>(program->scan.watchdog()).count();
    Diagnostic message = diagnostic(Code::WatchdogFired, {std::to_string(milliseconds), where}, place);
    program->scan.stop();
    program->motion->stopProgram();
    state = RunState::Error;
    runCommand = false;
    log.add(std::move(message));
}

double ControllerEngine::Impl::number(const ValueRef& ref) const
{
    switch (ref.source) {
    case ValueRef::Source::Memory: return program->scan.memory().read(addressOf(ref)).asDouble();
    case ValueRef::Source::Axis: return program->motion->read(ref.axis, ref.field);
    case ValueRef::Source::Plant: return program->motion->readPlant(ref.axis, ref.field);
    }
    return 0;
}

void ControllerEngine::Impl::sampleTrace()
{
    if (triggerRef && trace.needsTrigger())
        trace.lookAtTrigger(cycle, number(*triggerRef));
    if (!trace.wantsRow(cycle))
        return;
    for (std::size_t i = 0; i < traceRefs.size(); ++i)
        traceRow[i] = number(traceRefs[i]);
    trace.record(cycle, traceRow);
}

} // namespace camwright
