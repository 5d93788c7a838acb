#include "core/runtime/kinco/motioncall.h"

namespace camwright::kinco {

bool MotionCall::take(CallContext& context, bool wrong, AxisState state)
{
    Axis* const target = axisOf(context);
    m_paused = m_ending = false;
    if (!target || !target->isOnline())
        return finish(ErrorId::AxisAbsent), false;
    use(*target);
    if (!axis().isLocked())
        return finish(ErrorId::NotLocked), false;
    if (axis().isPanelArmed() || !axis().claim(self()))
        return finish(ErrorId::Busy), false;
    if (wrong)
        return finish(ErrorId::StateNotSeen), false;
    m_stops = axis().stops();
    axis().beginMotion(state, AxisCause::ProgramMotion);
    output().active = true;
    return true;
}

void MotionCall::proceed(CallContext& context)
{
    if (isLost())
        return;
    if (!context.inputs.enabled && !m_ending)
        stopAndFinish(ErrorId::None);
    if (!m_ending && axis().master().sendBlocked(axis().node()))
        stopAndFinish(ErrorId::SendBufferFull);
    if (!m_ending)
        move(context);
    else if (axis().motion().isStanding())
        finish(m_ends);
}

/// While it comes to rest the axis is "not stationary": the new execution has to wait for another edge.
void MotionCall::beginAgain(CallContext& context)
{
    if (m_ending)
        return finish(ErrorId::Busy);
    output().active = true;
    again(context);
}

bool MotionCall::isLost()
{
    if (!axis().isOnline())
        finish(ErrorId::AxisAbsent);
    else if (axis().hasFault())
        finish(ErrorId::StateNotSeen);
    else if (axis().stops() != m_stops)
        finish(ErrorId::Busy);
    else if (!axis().isLocked())
        finish(ErrorId::NotLocked);
    if (!isRunning())
        dropped();
    return !isRunning();
}

void MotionCall::stopAndFinish(ErrorId error)
{
    m_ending = true;
    m_ends = error;
    dropped();
    axis().motion().stop();
}

void MotionCall::setPaused(bool pause)
{
    if (pause == m_paused)
        return;
    m_paused = pause;
    if (pause)
        axis().motion().halt();
    else
        axis().motion().resume();
}

void MotionCall::saveMore(ByteWriter& writer) const
{
    writer.put(m_paused);
    writer.put(m_ending);
    writer.put(m_ends);
    writer.put(m_stops);
}

void MotionCall::restoreMore(ByteReader& reader)
{
    m_paused = reader.getBool();
    m_ending = reader.getBool();
    m_ends = reader.get<ErrorId>();
    m_stops = reader.get<std::uint32_t>();
}

} // namespace camwright::kinco
