#include "core/runtime/kinco/call.h"

#include "core/runtime/kinco/homecall.h"
#include "core/runtime/kinco/jogcall.h"
#include "core/runtime/kinco/movecall.h"
#include "core/runtime/kinco/parametercall.h"
#include "core/runtime/kinco/powercall.h"
#include "core/runtime/kinco/resetcall.h"
#include "core/runtime/kinco/restartcall.h"

namespace camwright::kinco {

void Call::cycle(CallContext& context)
{
    if (context.inputs.execution != m_result.execution) {
        const bool again = m_running;
        m_result = {.execution = context.inputs.execution};
        m_since = context.now;
        if (again) {
            beginAgain(context);
        } else {
            m_running = true;
            begin(context);
        }
    } else if (m_running) {
        proceed(context);
    }
}

void Call::beginAgain(CallContext& context)
{
    dropped();
    if (m_axis)
        m_axis->letGo(m_self);
    begin(context);
}

void Call::abandon(std::uint32_t execution)
{
    if (m_running && m_axis) {
        dropped();
        m_axis->letGo(m_self);
    }
    m_running = false;
    m_result.execution = execution;
    m_result.active = false;
    m_result.done = true;
}

Axis* Call::axisOf(CallContext& context) const
{
    const std::int16_t number = context.inputs.axis;
    if (number < 1 || static_cast<std::size_t>(number) > context.axes.size())
        return nullptr;
    return &context.axes[static_cast<std::size_t>(number - 1)];
}

void Call::finish(std::uint32_t errorId)
{
    m_running = false;
    m_result.done = true;
    m_result.error = errorId != 0;
    m_result.errorId = errorId;
    m_result.active = false;
    if (m_axis)
        m_axis->letGo(m_self);
}

void Call::save(ByteWriter& writer) const
{
    writer.put(static_cast<std::uint8_t>(m_axis ? m_axis->node() : 0));
    writer.put(m_running);
    writer.put(m_since.count());
    writer.put(m_result.execution);
    writer.put(m_result.done);
    writer.put(m_result.error);
    writer.put(m_result.active);
    writer.put(m_result.errorId);
    writer.put(m_result.valid);
    saveMore(writer);
}

void Call::restore(ByteReader& reader, Axes& axes)
{
    const auto node = reader.get<std::uint8_t>();
    if (node > axes.size())
        reader.fail();
    m_axis = node && reader.ok() ? &axes[node - 1u] : nullptr;
    m_running = reader.getBool();
    m_since = Time(reader.get<std::int64_t>());
    m_result.execution = reader.get<std::uint32_t>();
    m_result.done = reader.getBool();
    m_result.error = reader.getBool();
    m_result.active = reader.getBool();
    m_result.errorId = reader.get<std::uint32_t>();
    m_result.valid = reader.get<std::uint32_t>();
    restoreMore(reader);
    m_running = m_running && m_axis;
}

std::unique_ptr<Call> makeCall(const CallSite& site, Axis::Owner self)
{
    switch (site.instruction) {
    case InstructionId::KincoMcPower: return std::make_unique<PowerCall>(self);
    case InstructionId::KincoMcReset: return std::make_unique<ResetCall>(self);
    case InstructionId::KincoMcHome: return std::make_unique<HomeCall>(self);
    case InstructionId::KincoMcMabs: return std::make_unique<AbsoluteCall>(self);
    case InstructionId::KincoMcMrel: return std::make_unique<RelativeCall>(self);
    case InstructionId::KincoMcJog: return std::make_unique<JogCall>(self);
    case InstructionId::KincoMcRparas: return std::make_unique<ReadParametersCall>(self);
    case InstructionId::KincoMcWparas: return std::make_unique<WriteParametersCall>(self);
    case InstructionId::KincoMcRestart: return std::make_unique<RestartCall>(self);
    default: return nullptr;
    }
}

ErrorId errorOf(SdoStatus status)
{
    switch (status) {
    case SdoStatus::Done: return ErrorId::None;
    case SdoStatus::TimedOut: return ErrorId::SdoTimeout;
    case SdoStatus::BufferFull: return ErrorId::SendBufferFull;
    case SdoStatus::NoNode: case SdoStatus::Cancelled: return ErrorId::AxisAbsent;
    default: return ErrorId::SdoAnswer;
    }
}

} // namespace camwright::kinco
