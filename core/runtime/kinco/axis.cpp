#include "core/runtime/kinco/axis.h"

#include <array>
#include <cstdlib>

namespace camwright::kinco {

namespace {

/// Feedback may be this much older than the PDO inhibit time: transport, drive and master cycles.
constexpr Time kTransport = 5ms;

/// An axis that does not come to rest is released after this all the same (ours).
constexpr Time kReleaseTimeout = 5s;

/// CiA 301 error code of a lost node: life guard or heartbeat error.
constexpr std::uint32_t kNodeLostCode = 0x8130;

/// Slower than this the motor counts as not turning, for CW and CCW: turns per second (ours).
constexpr double kTurningThreshold = 0.005;

constexpr std::uint16_t kInternalLimit = 1u << 11; // of the statusword
constexpr std::uint32_t kLimitSwitches = 0x3;      // of the digital inputs
constexpr unsigned kDinShift = 16;                 // DIN1 in 0x60FD

Time feedbackDelay(const AxisConfiguration& configuration)
{
    return std::chrono::milliseconds(configuration.inhibitTimeMs) + kTransport;
}

} // namespace

std::string_view causeText(AxisCause cause)
{
    static constexpr std::array<std::string_view, 15> texts{
        "", "powered by the program", "enabled by a panel", "released by the program", "released by a panel", "stopped and released",
        "alarm of the drive", "no longer on the bus", "reset", "node restarted", "motion of the program", "motion of a panel",
        "motion ended", "stopped by command", "stopped: no heartbeat from the panel",
    };
    return texts[static_cast<std::size_t>(cause)];
}

Axis::Axis(const AxisConfiguration& configuration, CanopenMaster& master)
    : m_configuration(configuration)
    , m_scale{static_cast<double>(configuration.encoderResolution), configuration.mechanicalEquivalent}
    , m_master(master)
    , m_motion(feedbackDelay(configuration))
{
}

void Axis::observe(Time now, bool startingUp)
{
    m_now = now;
    m_inputs = m_master.inputs(node());
    m_online = m_master.isOnline(node());
    const NodeState nodeState = m_master.nodeState(node());
    const bool lostNow = nodeState == NodeState::Lost || (nodeState == NodeState::BootFailed && !startingUp);
    m_justLost = lostNow && !m_lost;
    m_lost = lostNow;
    const bool faultNow = m_motion.hasFault();
    m_justFaulted = faultNow && !m_errorStop && !m_lost;
    if (m_justLost || m_justFaulted) {
        m_errorStop = true;
        m_homed = m_homed && !m_justLost;
        m_panelPower = false;
        m_releasing = false;
        m_nextCause = m_justLost ? AxisCause::NodeLost : AxisCause::DriveAlarm;
    }
    if (m_inputs.errorCode)
        m_lastAlarm = m_inputs.errorCode;
}

void Axis::act(Time now)
{
    if (m_releasing && (m_motion.isStanding() || now - m_releasingSince > kReleaseTimeout)) {
        m_releasing = false;
        m_programPower = m_panelPower = false;
        m_nextCause = AxisCause::StoppedAndReleased;
    }
    m_motion.setEnabled((m_programPower || m_panelPower) && !m_errorStop);
    m_motion.update(m_inputs, m_online, now);
    m_master.setOutputs(node(), m_motion.command(), m_urgent);
    m_urgent = false;
    noteState(m_nextCause);
}

void Axis::noteState(AxisCause cause)
{
    const AxisState next = state();
    if (next == m_shownState)
        return;
    m_shownState = next;
    m_cause = cause;
    m_lastChange = m_now;
    m_nextCause = AxisCause::MotionEnded;
}

void Axis::setProgramPower(bool on)
{
    m_programPower = on;
    if (!m_panelPower)
        m_nextCause = on ? AxisCause::PoweredByProgram : AxisCause::ReleasedByProgram;
}

void Axis::setPanelPower(bool on)
{
    m_panelPower = on;
    if (!m_programPower)
        m_nextCause = on ? AxisCause::PoweredByPanel : AxisCause::ReleasedByPanel;
}

void Axis::stopAndRelease()
{
    stopFromOutside(AxisCause::StoppedAndReleased);
    if (m_releasing || isReleased()) {
        m_programPower = m_programPower && m_releasing;
        m_panelPower = m_panelPower && m_releasing;
        return;
    }
    m_releasing = true;
    m_releasingSince = m_now;
}

void Axis::startReset()
{
    m_programPower = m_panelPower = false;
    m_releasing = false;
    m_motion.startReset();
}

void Axis::endReset(bool successful)
{
    m_motion.endReset();
    if (!successful)
        return;
    m_errorStop = false;
    m_lastAlarm = 0;
    m_nextCause = AxisCause::Reset;
}

void Axis::restarted()
{
    m_programPower = m_panelPower = false;
    m_errorStop = m_motion.hasFault();
    m_homed = false;
    m_nextCause = AxisCause::Restarted;
}

bool Axis::claim(Owner owner)
{
    if (isBusy())
        return false;
    m_owner = owner;
    m_motionState = AxisState::Standstill;
    return true;
}

void Axis::letGo(Owner owner)
{
    if (m_owner != owner)
        return;
    m_owner = Nobody;
    m_motionState = AxisState::Standstill;
}

void Axis::beginMotion(AxisState state, AxisCause cause)
{
    m_motionState = state;
    m_nextCause = cause;
}

void Axis::stopFromOutside(AxisCause cause)
{
    ++m_stops;
    m_motion.stop();
    m_urgent = true;
    m_nextCause = cause;
}

AxisState Axis::state() const
{
    if (m_errorStop)
        return AxisState::ErrorStop;
    if (!m_motion.isEnabled())
        return AxisState::PowerOff;
    return m_motionState;
}

std::uint32_t Axis::errorCode() const
{
    if (!m_errorStop)
        return 0;
    if (m_lost)
        return kNodeLostCode;
    return m_lastAlarm;
}

AxisView Axis::view() const
{
    AxisView out;
    const double turns = m_inputs.velocity / m_scale.countsPerTurn;
    out.reached = m_reached;
    out.homed = m_homed;
    out.forward = turns > kTurningThreshold;
    out.backward = turns < -kTurningThreshold;
    out.running = m_motion.isEnabled();
    out.fault = m_motion.hasFault();
    out.limit = (m_inputs.statusWord & kInternalLimit) || (m_inputs.digitalInputs & kLimitSwitches);
    out.online = m_online;
    out.inputs = static_cast<std::uint16_t>(m_inputs.digitalInputs >> kDinShift);
    out.errorCode = m_inputs.errorCode;
    out.position = static_cast<float>(m_scale.toUnits(m_inputs.position));
    out.velocity = static_cast<float>(m_scale.countsPerSecondToPerMinute(m_inputs.velocity));
    return out;
}

void Axis::save(ByteWriter& writer) const
{
    m_motion.save(writer);
    for (const bool flag : {m_online, m_programPower, m_panelPower, m_releasing, m_armed, m_errorStop, m_lost, m_reached, m_homed, m_justFaulted,
             m_justLost, m_urgent})
        writer.put(flag);
    writer.put(m_owner);
    writer.put(m_motionState);
    writer.put(m_shownState);
    writer.put(m_cause);
    writer.put(m_nextCause);
    writer.put(m_stops);
    writer.put(m_lastAlarm);
    for (const Time time : {m_now, m_releasingSince, m_lastChange})
        writer.put(time.count());
}

void Axis::restore(ByteReader& reader)
{
    m_motion.restore(reader);
    for (bool* flag : {&m_online, &m_programPower, &m_panelPower, &m_releasing, &m_armed, &m_errorStop, &m_lost, &m_reached, &m_homed,
             &m_justFaulted, &m_justLost, &m_urgent})
        *flag = reader.getBool();
    m_owner = reader.get<Owner>();
    m_motionState = reader.get<AxisState>();
    m_shownState = reader.get<AxisState>();
    m_cause = reader.get<AxisCause>();
    m_nextCause = reader.get<AxisCause>();
    if (m_cause > AxisCause::DeadMan || m_nextCause > AxisCause::DeadMan)
        reader.fail();
    m_stops = reader.get<std::uint32_t>();
    m_lastAlarm = reader.get<std::uint16_t>();
    for (Time* time : {&m_now, &m_releasingSince, &m_lastChange})
        *time = Time(reader.get<std::int64_t>());
    m_inputs = m_master.inputs(node());
}

} // namespace camwright::kinco
