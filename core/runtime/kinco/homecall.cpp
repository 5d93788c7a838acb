#include "core/runtime/kinco/homecall.h"

#include <cmath>

namespace camwright::kinco {

namespace {
constexpr ObjectId kHomeOffset{0x607C, 0};
}

void HomeCall::begin(CallContext& context)
{
    m_transfer = 0;
    m_timeMs = context.inputs.timeMs;
    if (!take(context, !std::isfinite(context.inputs.position), AxisState::Homing))
        return;
    axis().setHomed(false);
    const std::int32_t offset = roundToInt32(axis().scale().toCounts(context.inputs.position));
    m_transfer = axis().master().writeSdo(axis().node(), kHomeOffset, offset, 4, context.now);
}

void HomeCall::move(CallContext& context)
{
    if (m_transfer) {
        const SdoResult result = axis().master().takeSdo(m_transfer);
        if (result.status == SdoStatus::Pending)
            return;
        m_transfer = 0;
        if (result.status != SdoStatus::Done)
            return finish(errorOf(result.status));
        axis().motion().home();
    }
    if (!context.inputs.exec) {
        setPaused(true);
        restartClock(context.now);
        return;
    }
    setPaused(false);
    if (axis().motion().hasArrived()) {
        axis().setHomed(true);
        return finish();
    }
    const bool late = m_timeMs && context.now - since() > std::chrono::milliseconds(m_timeMs);
    if (late || axis().motion().hasFailed())
        stopAndFinish(ErrorId::StateNotSeen);
}

void HomeCall::dropped()
{
    if (m_transfer)
        axis().master().cancelSdo(m_transfer);
    m_transfer = 0;
}

void HomeCall::saveMore(ByteWriter& writer) const
{
    MotionCall::saveMore(writer);
    writer.put(m_transfer);
    writer.put(m_timeMs);
}

void HomeCall::restoreMore(ByteReader& reader)
{
    MotionCall::restoreMore(reader);
    m_transfer = reader.get<CanopenMaster::SdoHandle>();
    m_timeMs = reader.get<std::uint32_t>();
}

} // namespace camwright::kinco
