#include "core/runtime/engine.h"

#include "core/runtime/engineimpl.h"
#include "core/runtime/retaineddata.h"
#include "core/runtime/terminallist.h"

#include <algorithm>

namespace camwright {

namespace {

/// Late cycles are logged at most this often, in controller time.
constexpr Time kLateLogInterval = 10s;

} // namespace

ControllerEngine::ControllerEngine(EngineOptions options) : m_impl(std::make_unique<Impl>(options)) {}
ControllerEngine::~ControllerEngine() = default;
ControllerEngine::ControllerEngine(ControllerEngine&&) noexcept = default;
ControllerEngine& ControllerEngine::operator=(ControllerEngine&&) noexcept = default;

Result<void> ControllerEngine::load(ByteSpan image)
{
    return m_impl->apply(input::LoadImage{{image.begin(), image.end()}});
}

bool ControllerEngine::hasImage() const
{
    return m_impl->program != nullptr;
}

std::uint32_t ControllerEngine::imageNumber() const
{
    return m_impl->imageNumber;
}

bool ControllerEngine::switchPending() const
{
    return m_impl->pending.has_value();
}

ByteSpan ControllerEngine::imageBytes() const
{
    return m_impl->program ? ByteSpan(m_impl->program->bytes) : ByteSpan{};
}

Result<void> ControllerEngine::apply(const EngineInputContent& content)
{
    return std::visit([this](const auto& in) { return m_impl->apply(in); }, content);
}

std::uint64_t ControllerEngine::post(EngineInput input)
{
    input.cycle = std::max(input.cycle, m_impl->cycle + 1);
    const std::uint64_t stamp = input.cycle;
    auto& queue = m_impl->queue;
    const auto at = std::upper_bound(queue.begin(), queue.end(), stamp, [](std::uint64_t c, const EngineInput& i) { return c < i.cycle; });
    queue.insert(at, std::move(input));
    return stamp;
}

void ControllerEngine::step(Time span)
{
    const Time target = m_impl->now + span;
    while (kMotionCycle * static_cast<std::int64_t>(m_impl->cycle + 1) <= target)
        m_impl->doCycle();
    m_impl->now = target;
}

Time ControllerEngine::now() const
{
    return m_impl->now;
}

std::uint64_t ControllerEngine::cycle() const
{
    return m_impl->cycle;
}

ControllerStatus ControllerEngine::status() const
{
    ControllerStatus out;
    out.cycle = m_impl->cycle;
    out.time = m_impl->now;
    out.state = m_impl->state;
    out.lateCycles = m_impl->lateCycles;
    if (!m_impl->program)
        return out;
    const LoadedProgram& program = *m_impl->program;
    out.family = program.image->target.family;
    out.model = program.image->target.model;
    out.projectName = program.image->debug.projectName;
    out.program = program.hash;
    out.scanMs = out.scanMaxMs = m_impl->state == RunState::Run ? seconds(program.scan.modelledTime()) * 1e3 : 0;
    out.busLoadPercent = program.motion->busLoadPercent();
    out.forces = static_cast<std::uint32_t>(program.scan.forces().size());
    for (std::size_t i = 0; i < program.motion->axisCount(); ++i)
        out.axes.push_back(program.motion->axisStatus(i));
    return out;
}

bool ControllerEngine::isQuiet() const
{
    return m_impl->isQuiet();
}

void ControllerEngine::countLateCycles(std::uint64_t count)
{
    m_impl->lateCycles += count;
    const bool first = m_impl->lateLogged == 0;
    if (m_impl->lateCycles == m_impl->lateLogged || (!first && m_impl->now - m_impl->lateLoggedAt < kLateLogInterval))
        return;
    m_impl->log.add(Code::LateCycles, {std::to_string(m_impl->lateCycles - m_impl->lateLogged)});
    m_impl->lateLogged = m_impl->lateCycles;
    m_impl->lateLoggedAt = m_impl->now;
}

Result<ValueRef> ControllerEngine::resolve(std::string_view name) const
{
    if (!m_impl->program)
        return diagnostic(Code::NoProgram);
    Result<ValueRef> ref = m_impl->program->names.resolve(name);
    if (ref)
        ref->image = m_impl->imageNumber;
    return ref;
}

Result<Value> ControllerEngine::read(const ValueRef& ref) const
{
    if (!m_impl->program)
        return diagnostic(Code::NoProgram);
    if (ref.image != m_impl->imageNumber)
        return diagnostic(Code::StaleReference);
    if (ref.source == ValueRef::Source::Memory)
        return m_impl->program->scan.memory().read(addressOf(ref));
    if (ref.axis >= m_impl->program->motion->axisCount())
        return diagnostic(Code::StaleReference);
    const double number = m_impl->number(ref);
    if (isFloat(ref.type))
        return Value::ofDouble(ref.type, number);
    return Value::ofInteger(ref.type, static_cast<std::int64_t>(number));
}

bool ControllerEngine::isForced(const ValueRef& ref) const
{
    return m_impl->program && ref.image == m_impl->imageNumber && ref.source == ValueRef::Source::Memory
        && m_impl->program->scan.isForced(addressOf(ref));
}

std::string ControllerEngine::unitOf(const ValueRef& ref) const
{
    return m_impl->program ? m_impl->program->names.unitOf(ref) : std::string{};
}

std::vector<std::string> ControllerEngine::names() const
{
    return m_impl->program ? m_impl->program->names.all() : std::vector<std::string>{};
}

std::vector<Terminal> ControllerEngine::terminals() const
{
    if (!m_impl->program)
        return {};
    std::vector<Terminal> out = terminalsOf(m_impl->program->family, m_impl->program->model);
    for (Terminal& terminal : out)
        terminal.ref.image = m_impl->imageNumber;
    return out;
}

std::vector<std::string> ControllerEngine::forced() const
{
    std::vector<std::string> out;
    if (!m_impl->program)
        return out;
    for (const Force& force : m_impl->program->scan.forces())
        out.push_back(m_impl->program->names.nameOf(force.address));
    return out;
}

Result<void> ControllerEngine::startTrace(const TraceSetup& setup)
{
    if (auto checked = TraceRecorder::check(setup); !checked)
        return checked;
    std::vector<ValueRef> refs;
    std::vector<ChannelInfo> channels;
    for (const std::string& name : setup.channels) {
        const Result<ValueRef> ref = resolve(name);
        if (!ref)
            return ref.error();
        refs.push_back(*ref);
        channels.push_back({name, ref->type, unitOf(*ref)});
    }
    std::optional<ValueRef> trigger;
    if (setup.trigger != TriggerKind::Immediate) {
        const Result<ValueRef> ref = resolve(setup.triggerChannel);
        if (!ref)
            return ref.error();
        trigger = *ref;
    }
    m_impl->trace.start(setup, std::move(channels), m_impl->cycle);
    m_impl->traceRow.assign(refs.size(), 0.0);
    m_impl->traceRefs = std::move(refs);
    m_impl->triggerRef = trigger;
    return {};
}

void ControllerEngine::stopTrace()
{
    m_impl->trace.stop();
}

std::optional<SampleBlock> ControllerEngine::takeSamples()
{
    return m_impl->trace.take();
}

std::vector<LogEntry> ControllerEngine::logSince(std::uint64_t from) const
{
    return m_impl->log.since(from);
}

std::uint64_t ControllerEngine::nextLogSequence() const
{
    return m_impl->log.nextSequence();
}

Bytes ControllerEngine::retained() const
{
    return m_impl->program ? collectRetained(*m_impl->program->image, m_impl->program->scan.memory()) : Bytes{};
}

Result<void> ControllerEngine::restoreRetained(ByteSpan retained)
{
    if (!m_impl->program)
        return diagnostic(Code::NoProgram);
    return applyRetained(retained, *m_impl->program->image, m_impl->program->scan.memory());
}

} // namespace camwright
