#include "core/runtime/engineimpl.h"
#include "core/runtime/retaineddata.h"

namespace camwright {

namespace {

/// The value in the type of its target.
Value convert(DataType type, const Value& value)
{
    if (value.type == type)
        return value;
    if (isFloat(type) || isFloat(value.type))
        return type == DataType::Bool ? Value::ofBool(value.asDouble() != 0) : Value::ofDouble(type, value.asDouble());
    return type == DataType::Bool ? Value::ofBool(value.bits != 0) : Value::ofInteger(type, value.asInteger());
}

} // namespace

bool ControllerEngine::Impl::isQuiet() const
{
    return state != RunState::Run && (!program || program->motion->isReleased());
}

Result<void> ControllerEngine::Impl::checkMemory(const ValueRef& ref) const
{
    if (!program)
        return diagnostic(Code::NoProgram);
    if (ref.image != imageNumber)
        return diagnostic(Code::StaleReference);
    if (ref.source != ValueRef::Source::Memory)
        return diagnostic(Code::NotWritable);
    if (!program->scan.memory().contains(addressOf(ref)))
        return diagnostic(Code::StaleReference);
    return {};
}

Result<void> ControllerEngine::Impl::apply(const input::Run&)
{
    if (!program)
        return diagnostic(Code::NoProgram);
    runCommand = true;
    if (!runSwitch)
        return diagnostic(Code::SwitchAtStop);
    requestStart();
    return {};
}

/// The program starts once every axis is released and the bus has tried every node; often that is at once.
void ControllerEngine::Impl::requestStart()
{
    if (state == RunState::Run)
        return;
    if (!pending && !isQuiet())
        program->motion->stopProgram();
    startPending = true;
    watchTransitions();
}

void ControllerEngine::Impl::startProgram()
{
    startPending = false;
    state = RunState::Run;
    program->motion->startProgram();
    program->scan.start(now);
    program->blocks.interrupts().start(now, [this](const Address& input) { return program->scan.inputLevel(input); });
    log.add(Code::ProgramStarted);
}

void ControllerEngine::Impl::stopProgram(Code why)
{
    startPending = false;
    if (state == RunState::Run)
        log.add(why);
    state = RunState::Stop;
    if (!program)
        return;
    program->scan.stop();
    program->motion->stopProgram();
}

Result<void> ControllerEngine::Impl::apply(const input::Stop&)
{
    runCommand = false;
    stopProgram(Code::ProgramStopped);
    return {};
}

Result<void> ControllerEngine::Impl::apply(const input::RunSwitch& in)
{
    if (in.run == runSwitch)
        return {};
    runSwitch = in.run;
    if (!runSwitch)
        stopProgram(Code::SwitchedToStop);
    else if (runCommand && program)
        requestStart();
    return {};
}

Result<void> ControllerEngine::Impl::apply(const input::Write& in)
{
    if (auto checked = checkMemory(in.target); !checked)
        return checked;
    program->scan.write(addressOf(in.target), convert(in.target.type, in.value));
    return {};
}

Result<void> ControllerEngine::Impl::apply(const input::Force& in)
{
    if (auto checked = checkMemory(in.target); !checked)
        return checked;
    program->scan.force(addressOf(in.target), convert(in.target.type, in.value));
    return {};
}

Result<void> ControllerEngine::Impl::apply(const input::Release& in)
{
    if (auto checked = checkMemory(in.target); !checked)
        return checked;
    program->scan.release(addressOf(in.target));
    return {};
}

Result<void> ControllerEngine::Impl::apply(const input::ReleaseAll&)
{
    if (program)
        program->scan.releaseAll();
    return {};
}

Result<void> ControllerEngine::Impl::apply(const input::Panel& in)
{
    if (!program)
        return diagnostic(Code::NoProgram);
    return program->motion->panel(in);
}

Result<void> ControllerEngine::Impl::apply(const input::Heartbeat& in)
{
    if (program)
        program->motion->heartbeat(in);
    return {};
}

Result<void> ControllerEngine::Impl::apply(const input::StopAllAxes&)
{
    if (program)
        program->motion->stopAllAxes();
    return {};
}

Result<void> ControllerEngine::Impl::apply(const input::LoadImage& in)
{
    if (state == RunState::Run || startPending)
        return diagnostic(Code::LoadOnlyInStop);
    Result<PreparedImage> prepared = PreparedImage::from(in.image, options.executor);
    if (!prepared)
        return std::move(prepared).error();
    pending = std::move(prepared).value();
    if (isQuiet())
        switchImage();
    else
        program->motion->stopProgram();
    return {};
}

void ControllerEngine::Impl::switchImage()
{
    const Bytes kept = program ? collectRetained(*program->image, program->scan.memory()) : Bytes{};
    auto next = std::make_unique<LoadedProgram>(std::move(*pending), options.seed, log, now);
    pending.reset();
    if (program)
        next->scan.takeTerminals(program->scan);
    next->scan.powerOn();
    if (!kept.empty())
        (void)applyRetained(kept, *next->image, next->scan.memory());
    program = std::move(next);
    ++imageNumber;
    state = RunState::Stop;
    runCommand = startPending; // a RUN that came while the switch was waiting is meant for the new program
    trace.stop();
    traceRefs.clear();
    triggerRef.reset();
    log.add(Code::ImageLoaded, {program->image->debug.projectName, shortHex(program->hash)});
}

Result<void> ControllerEngine::Impl::apply(const input::PowerCycle&)
{
    log.add(Code::PowerCycled);
    state = RunState::Stop;
    startPending = false;
    if (!program)
        return {};
    const Bytes kept = collectRetained(*program->image, program->scan.memory());
    program->scan.releaseAll();
    program->scan.powerOn();
    (void)applyRetained(kept, *program->image, program->scan.memory());
    program->motion->powerCycle(now);
    if (pending)
        switchImage();
    else if (runCommand && runSwitch)
        requestStart();
    return {};
}

Result<void> ControllerEngine::Impl::apply(const input::InjectFault& in)
{
    if (!program)
        return diagnostic(Code::NoProgram);
    return program->motion->inject(in);
}

} // namespace camwright
