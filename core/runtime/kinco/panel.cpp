#include "core/runtime/kinco/panel.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace camwright::kinco {

namespace {
constexpr Time kResetSupervision = 2s; // as MC_RESET, KS-MC-17
}

Result<void> Panel::command(const input::Panel& command)
{
    if (command.acceleration != 0)
        return diagnostic(Code::PanelOwnAcceleration);
    switch (command.kind) {
    case AxisCommandKind::Arm:
        return arm();
    case AxisCommandKind::Disarm:
        disarm();
        return {};
    case AxisCommandKind::Enable:
        return enable();
    case AxisCommandKind::Disable:
        return disable();
    case AxisCommandKind::Reset:
        return reset();
    case AxisCommandKind::Home:
        return home();
    case AxisCommandKind::MoveAbsolute:
        return moveTo(command.position, command.velocity);
    case AxisCommandKind::MoveRelative:
        if (m_axis.isLocked() && !m_axis.motion().isSettled())
            return refused(Code::PanelStillMoving); // the demand position on the bus may be that of the last motion
        return moveTo(m_axis.scale().toUnits(m_axis.inputs().demandPosition) + command.position, command.velocity);
    case AxisCommandKind::Velocity: case AxisCommandKind::Jog:
        return run(command.velocity);
    case AxisCommandKind::Stop:
        stop(AxisCause::StoppedByCommand);
        return {};
    }
    return {};
}

void Panel::heartbeat(std::uint64_t seenCycle)
{
    if (seenCycle <= m_cycle && m_cycle - seenCycle <= kHeartbeatCycles)
        m_lastBeat = m_cycle;
}

Result<void> Panel::arm()
{
    if (m_axis.owner() >= 0)
        return refused(Code::PanelRefusedByProgram);
    m_armed = true;
    m_axis.setPanelArmed(true);
    m_lastBeat = m_cycle;
    return {};
}

Result<void> Panel::enable()
{
    if (m_axis.isErrorStop())
        return refused(Code::PanelAxisInError);
    if (!m_axis.isOnline())
        return refused(Code::PanelAxisOffline);
    m_disableAtRest = false;
    m_axis.setPanelPower(true);
    return {};
}

/// Takes the panel's own wish back; what the program wants stays (CONTRACTS 20). A moving axis is stopped first.
Result<void> Panel::disable()
{
    if (m_axis.owner() >= 0 && !m_axis.programPower())
        return refused(Code::PanelRefusedByProgram);
    if (m_motion == Motion::None) {
        m_axis.setPanelPower(false);
        return {};
    }
    stop(AxisCause::StoppedByCommand);
    m_disableAtRest = true;
    return {};
}

Result<void> Panel::reset()
{
    if (m_axis.owner() >= 0)
        return refused(Code::PanelRefusedByProgram);
    if (!m_axis.isOnline())
        return refused(Code::PanelAxisOffline);
    if (!m_axis.isErrorStop() || m_resetting)
        return {};
    m_axis.startReset();
    m_resetting = true;
    m_resetSince = m_now;
    return {};
}

Result<void> Panel::mayMove(Motion motion) const
{
    if (!m_armed)
        return refused(Code::PanelNotArmed);
    if (m_axis.owner() >= 0)
        return refused(Code::PanelRefusedByProgram);
    if (m_axis.isErrorStop())
        return refused(Code::PanelAxisInError);
    if (!m_axis.isLocked())
        return refused(Code::PanelAxisNotEnabled);
    if (m_motion != motion && (m_motion != Motion::None || m_axis.isBusy()))
        return refused(Code::PanelStillMoving);
    return {};
}

Result<void> Panel::home()
{
    if (auto allowed = mayMove(Motion::None); !allowed)
        return allowed;
    begin(Motion::Homing, AxisState::Homing);
    m_axis.setHomed(false);
    m_axis.motion().home();
    return {};
}

Result<void> Panel::moveTo(double units, double velocity)
{
    const double counts = m_axis.scale().toCounts(units);
    if (!(std::abs(counts) <= std::numeric_limits<std::int32_t>::max()))
        return badNumber(units, CW_TEXT("Arguments", "target position"));
    if (!std::isfinite(velocity) || velocity <= 0)
        return badNumber(velocity, CW_TEXT("Arguments", "commanded velocity"));
    if (auto allowed = mayMove(Motion::None); !allowed)
        return allowed;
    begin(Motion::Position, AxisState::DiscreteMotion);
    m_axis.setReached(false);
    const double speed = clamped(m_axis.scale().toCounts(velocity));
    m_axis.motion().moveTo(roundToInt32(counts), std::max(1u, roundToUint32(speed)));
    return {};
}

Result<void> Panel::run(double velocity)
{
    if (!std::isfinite(velocity))
        return badNumber(velocity, CW_TEXT("Arguments", "commanded velocity"));
    if (auto allowed = mayMove(Motion::Velocity); !allowed)
        return allowed;
    if (m_motion == Motion::None)
        begin(Motion::Velocity, AxisState::ContinuousMotion);
    m_axis.motion().run(roundToInt32(clamped(m_axis.scale().toCounts(velocity))));
    return {};
}

Result<void> Panel::refused(Code code) const
{
    return diagnostic(code, {m_axis.configuration().name});
}

Result<void> Panel::badNumber(double number, const char* what) const
{
    return diagnostic(Code::PanelBadNumber, {formatValue(Value::ofLreal(number)), what, m_axis.configuration().name});
}

double Panel::clamped(double countsPerSecond) const
{
    const double most = kPanelTurnsPerMinute / 60 * m_axis.scale().countsPerTurn;
    return std::clamp(countsPerSecond, -most, most);
}

void Panel::begin(Motion motion, AxisState state)
{
    m_axis.claim(Axis::Panel);
    m_axis.beginMotion(state, AxisCause::PanelMotion);
    m_motion = motion;
    m_stops = m_axis.stops();
}

void Panel::stop(AxisCause cause)
{
    m_axis.stopFromOutside(cause);
    m_stops = m_axis.stops();
    if (m_motion != Motion::None)
        m_motion = Motion::Stopping;
}

void Panel::disarm()
{
    if (m_motion != Motion::None && m_motion != Motion::Stopping)
        stop(AxisCause::StoppedByCommand);
    m_armed = false;
    m_axis.setPanelArmed(false);
}

void Panel::letGo()
{
    disarm();
    if (m_motion == Motion::None)
        m_axis.setPanelPower(false);
    else
        m_disableAtRest = true;
}

void Panel::cycle(std::uint64_t cycle, Time now)
{
    m_cycle = cycle;
    m_now = now;
    if (m_armed && cycle - m_lastBeat >= kHeartbeatCycles) {
        const bool moving = m_motion != Motion::None && m_motion != Motion::Stopping;
        if (moving) {
            stop(AxisCause::DeadMan);
            m_reportedBeat = m_lastBeat;
            m_stopToReport = true;
        }
        disarm();
    }
    if (m_resetting)
        superviseReset(now);
    if (m_motion != Motion::None)
        superviseMotion();
}

void Panel::superviseReset(Time now)
{
    const bool clear = m_axis.isOnline() && !m_axis.hasFault();
    if (!clear && now - m_resetSince < kResetSupervision)
        return;
    m_axis.endReset(clear);
    m_resetting = false;
}

void Panel::superviseMotion()
{
    const bool lost = !m_axis.isLocked();
    if (!lost && m_axis.stops() != m_stops) {
        m_motion = Motion::Stopping; // stopped by somebody else
        m_stops = m_axis.stops();
    }
    if (!lost && m_motion != Motion::Stopping && m_axis.motion().hasFailed())
        stop(AxisCause::MotionEnded);
    const bool arrived = (m_motion == Motion::Position || m_motion == Motion::Homing) && m_axis.motion().hasArrived();
    const bool stands = m_motion == Motion::Stopping && m_axis.motion().isStanding();
    if (!lost && !arrived && !stands)
        return;
    if (arrived && m_motion == Motion::Position)
        m_axis.setReached(true);
    if (arrived && m_motion == Motion::Homing)
        m_axis.setHomed(true);
    m_motion = Motion::None;
    m_axis.letGo(Axis::Panel);
    if (m_disableAtRest) {
        m_disableAtRest = false;
        m_axis.setPanelPower(false);
    }
}

void Panel::afterSending()
{
    if (!m_stopToReport || m_axis.master().commandPending(m_axis.node()))
        return;
    m_stopToReport = false;
    m_log.add(Code::DeadManStop, {m_axis.configuration().name, std::to_string(m_reportedBeat), std::to_string(m_cycle)});
}

void Panel::save(ByteWriter& writer) const
{
    for (const bool flag : {m_armed, m_resetting, m_disableAtRest, m_stopToReport})
        writer.put(flag);
    writer.put(m_motion);
    for (const std::uint64_t number : {m_cycle, m_lastBeat, m_reportedBeat})
        writer.put(number);
    writer.put(m_stops);
    writer.put(m_now.count());
    writer.put(m_resetSince.count());
}

void Panel::restore(ByteReader& reader)
{
    for (bool* flag : {&m_armed, &m_resetting, &m_disableAtRest, &m_stopToReport})
        *flag = reader.getBool();
    m_motion = reader.get<Motion>();
    for (std::uint64_t* number : {&m_cycle, &m_lastBeat, &m_reportedBeat})
        *number = reader.get<std::uint64_t>();
    m_stops = reader.get<std::uint32_t>();
    m_now = Time(reader.get<std::int64_t>());
    m_resetSince = Time(reader.get<std::int64_t>());
}

} // namespace camwright::kinco
