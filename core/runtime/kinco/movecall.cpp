#include "core/runtime/kinco/movecall.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace camwright::kinco {

namespace {

bool isSpeed(float velocity)
{
    return std::isfinite(velocity) && velocity >= 0;
}

/// Nothing where the drive's 32 bits do not reach.
std::optional<std::int32_t> toDrive(double counts)
{
    if (!(std::abs(counts) <= std::numeric_limits<std::int32_t>::max()))
        return std::nullopt;
    return roundToInt32(counts);
}

} // namespace

void MoveCall::command(std::int32_t target, float velocity)
{
    const std::uint32_t speed = std::max(1u, roundToUint32(axis().scale().perMinuteToCountsPerSecond(velocity)));
    if (m_sent && target == m_target && speed == m_speed)
        return;
    if (!m_sent || target != m_target)
        axis().setReached(false);
    m_sent = true;
    m_target = target;
    m_speed = speed;
    axis().motion().moveTo(target, speed);
}

bool MoveCall::rests(CallContext& context)
{
    if (!isSpeed(context.inputs.velocity)) {
        stopAndFinish(ErrorId::StateNotSeen);
        return true;
    }
    setPaused(!context.inputs.exec || context.inputs.velocity == 0);
    return isPaused();
}

void MoveCall::saveMore(ByteWriter& writer) const
{
    MotionCall::saveMore(writer);
    writer.put(m_sent);
    writer.put(m_target);
    writer.put(m_speed);
}

void MoveCall::restoreMore(ByteReader& reader)
{
    MotionCall::restoreMore(reader);
    m_sent = reader.getBool();
    m_target = reader.get<std::int32_t>();
    m_speed = reader.get<std::uint32_t>();
}

void AbsoluteCall::begin(CallContext& context)
{
    m_mode = context.inputs.mode;
    forgetCommand();
    const CallInputs& in = context.inputs;
    if (take(context, !isSpeed(in.velocity) || in.velocity == 0 || !std::isfinite(in.position), AxisState::DiscreteMotion))
        move(context);
}

void AbsoluteCall::move(CallContext& context)
{
    if (rests(context)) {
        output().done = false;
        return;
    }
    const auto target = toDrive(axis().scale().toCounts(context.inputs.position));
    if (!target)
        return stopAndFinish(ErrorId::StateNotSeen);
    command(*target, context.inputs.velocity);
    if (axis().motion().hasFailed())
        return stopAndFinish(ErrorId::StateNotSeen);
    const bool arrived = axis().motion().hasArrived();
    if (arrived)
        axis().setReached(true);
    if (m_mode == 1)
        output().done = arrived;
    else if (arrived)
        finish();
}

void AbsoluteCall::saveMore(ByteWriter& writer) const
{
    MoveCall::saveMore(writer);
    writer.put(m_mode);
}

void AbsoluteCall::restoreMore(ByteReader& reader)
{
    MoveCall::restoreMore(reader);
    m_mode = reader.get<std::int16_t>();
}

void RelativeCall::begin(CallContext& context)
{
    const CallInputs& in = context.inputs;
    m_distance = in.position;
    m_known = false;
    forgetCommand();
    if (!take(context, !isSpeed(in.velocity) || in.velocity == 0 || !std::isfinite(in.position), AxisState::DiscreteMotion))
        return;
    axis().setReached(false);
    move(context);
}

void RelativeCall::move(CallContext& context)
{
    if (rests(context))
        return;
    if (!m_known) {
        if (!axis().motion().isSettled())
            return; // the demand position on the bus may still be that of the last motion
        const auto target = toDrive(axis().inputs().demandPosition + axis().scale().toCounts(m_distance));
        if (!target)
            return stopAndFinish(ErrorId::StateNotSeen);
        m_target = *target;
        m_known = true;
    }
    command(m_target, context.inputs.velocity);
    if (axis().motion().hasFailed())
        return stopAndFinish(ErrorId::StateNotSeen);
    if (axis().motion().hasArrived()) {
        axis().setReached(true);
        finish();
    }
}

void RelativeCall::saveMore(ByteWriter& writer) const
{
    MoveCall::saveMore(writer);
    writer.put(m_distance);
    writer.put(m_known);
    writer.put(m_target);
}

void RelativeCall::restoreMore(ByteReader& reader)
{
    MoveCall::restoreMore(reader);
    m_distance = reader.get<float>();
    m_known = reader.getBool();
    m_target = reader.get<std::int32_t>();
}

} // namespace camwright::kinco
