#include "core/runtime/engineimpl.h"

#include <algorithm>

namespace camwright {

namespace {

constexpr std::uint32_t kMagic = 0x54535743; // "CWST"
constexpr std::uint32_t kVersion = 2;

/// Three hundred years of milliseconds still fit the nanoseconds of Time, and nothing overflows near them.
constexpr std::uint64_t kMostCycles = 9'000'000'000'000;

void putRef(ByteWriter& writer, const ValueRef& ref)
{
    writer.put(ref.source);
    writer.put(ref.type);
    writer.put(ref.image);
    writer.put(ref.area);
    writer.put(ref.isBit);
    writer.put(ref.bit);
    writer.put(ref.byte);
    writer.put(ref.axis);
    writer.put(ref.field);
}

ValueRef getRef(ByteReader& reader)
{
    ValueRef ref;
    ref.source = reader.get<ValueRef::Source>();
    ref.type = reader.get<DataType>();
    ref.image = reader.get<std::uint32_t>();
    ref.area = reader.get<std::uint8_t>();
    ref.isBit = reader.getBool();
    ref.bit = reader.get<std::uint8_t>();
    ref.byte = reader.get<std::uint32_t>();
    ref.axis = reader.get<std::uint16_t>();
    ref.field = reader.get<AxisField>();
    return ref;
}

} // namespace

void ControllerEngine::Impl::save(ByteWriter& writer) const
{
    writer.put(options.seed);
    writer.put(now.count());
    writer.put(cycle);
    writer.put(static_cast<std::uint32_t>(queue.size()));
    for (const EngineInput& input : queue)
        write(writer, input);
    writer.put(state);
    writer.put(runSwitch);
    writer.put(runCommand);
    writer.put(startPending);
    writer.put(imageNumber);
    writer.put(lateCycles);
    writer.put(lateLogged);
    writer.put(lateLoggedAt.count());
    writer.putBlob(program ? ByteSpan(program->bytes) : ByteSpan{});
    writer.putBlob(pending ? ByteSpan(pending->bytes) : ByteSpan{});
    log.save(writer);
    trace.save(writer);
    writer.put(static_cast<std::uint32_t>(traceRefs.size()));
    for (const ValueRef& ref : traceRefs)
        putRef(writer, ref);
    writer.put(triggerRef.has_value());
    if (triggerRef)
        putRef(writer, *triggerRef);
    if (!program)
        return;
    program->scan.save(writer);
    program->motion->save(writer);
    program->blocks.save(writer);
}

bool ControllerEngine::Impl::restore(ByteReader& reader)
{
    options.seed = reader.get<std::uint64_t>();
    now = Time(reader.get<std::int64_t>());
    cycle = reader.get<std::uint64_t>();
    const auto inputs = reader.get<std::uint32_t>();
    for (std::uint32_t i = 0; i < inputs && reader.ok(); ++i)
        queue.push_back(readEngineInput(reader));
    state = reader.get<RunState>();
    runSwitch = reader.getBool();
    runCommand = reader.getBool();
    startPending = reader.getBool();
    imageNumber = reader.get<std::uint32_t>();
    lateCycles = reader.get<std::uint64_t>();
    lateLogged = reader.get<std::uint64_t>();
    lateLoggedAt = Time(reader.get<std::int64_t>());
    const ByteSpan imageBytes = reader.getBlob();
    const ByteSpan pendingBytes = reader.getBlob();
    log.restore(reader);
    trace.restore(reader);
    const auto refs = reader.get<std::uint32_t>();
    for (std::uint32_t i = 0; i < refs && reader.ok(); ++i)
        traceRefs.push_back(getRef(reader));
    if (reader.getBool())
        triggerRef = getRef(reader);
    if (!reader.ok() || state > RunState::Error || cycle > kMostCycles || static_cast<std::uint64_t>(now / kMotionCycle) != cycle)
        return false;
    traceRow.assign(traceRefs.size(), 0.0);
    if (!pendingBytes.empty()) {
        Result<PreparedImage> prepared = PreparedImage::from(pendingBytes, options.executor);
        if (!prepared)
            return false;
        pending = std::move(prepared).value();
    }
    if (imageBytes.empty())
        return reader.atEnd() && traceRefs.empty() && !triggerRef && !trace.isRunning();
    Result<PreparedImage> prepared = PreparedImage::from(imageBytes, options.executor);
    if (!prepared)
        return false;
    program = std::make_unique<LoadedProgram>(std::move(prepared).value(), options.seed, log, now);
    if (!program->scan.restore(reader))
        return false;
    program->motion->restore(reader);
    program->blocks.restore(reader);
    return reader.ok() && reader.atEnd() && hasUsableTrace();
}

bool ControllerEngine::Impl::hasUsableTrace() const
{
    const auto usable = [this](const ValueRef& ref) {
        return ref.source == ValueRef::Source::Memory || ref.axis < program->motion->axisCount();
    };
    return std::all_of(traceRefs.begin(), traceRefs.end(), usable) && (!triggerRef || usable(*triggerRef))
        && (!trace.isRunning() || trace.channelCount() == traceRefs.size());
}

Bytes ControllerEngine::saveState() const
{
    ByteWriter writer;
    writer.put(kMagic);
    writer.put(kVersion);
    m_impl->save(writer);
    return writer.take();
}

Result<void> ControllerEngine::restoreState(ByteSpan state)
{
    ByteReader reader(state);
    const auto magic = reader.get<std::uint32_t>();
    const auto version = reader.get<std::uint32_t>();
    if (!reader.ok() || magic != kMagic)
        return diagnostic(Code::StateDamaged);
    if (version != kVersion)
        return diagnostic(Code::StateVersion, {std::to_string(version), std::to_string(kVersion)});
    auto restored = std::make_unique<Impl>(m_impl->options);
    if (!restored->restore(reader))
        return diagnostic(Code::StateDamaged);
    m_impl = std::move(restored);
    return {};
}

} // namespace camwright
