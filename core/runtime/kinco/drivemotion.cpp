#include "core/runtime/kinco/drivemotion.h"

namespace camwright::kinco {

namespace {

constexpr std::int8_t kModePosition = 1, kModeVelocity = 3, kModeHoming = 6;

constexpr std::uint16_t kStart = 1u << 4;      // new set-point, or start of homing
constexpr std::uint16_t kAtOnce = 1u << 5;     // change set immediately
constexpr std::uint16_t kFaultReset = 1u << 7;
constexpr std::uint16_t kHalt = 1u << 8;

constexpr std::uint16_t kReached = 1u << 10;   // target reached; with halt: at rest
constexpr std::uint16_t kTaken = 1u << 12;     // set-point acknowledged, or homing attained
constexpr std::uint16_t kModeError = 1u << 13; // homing error

/// A drive answers a mode or a set-point within milliseconds; after this it will not (ours).
constexpr Time kAnswerTimeout = 2s;

} // namespace

void DriveMotion::startReset()
{
    m_reset = true;
    m_enable = false;
}

void DriveMotion::begin(Activity activity)
{
    m_activity = activity;
    m_bit4 = false;
    m_paused = false;
    enter(Phase::Mode, m_now);
    m_standing = m_settled = false;
    m_trustFrom = m_now + m_delay;
}

void DriveMotion::enter(Phase phase, Time now)
{
    m_phase = phase;
    m_phaseSince = now;
}

void DriveMotion::moveTo(std::int32_t target, std::uint32_t velocity)
{
    m_target = target;
    m_velocity = velocity;
    m_changed = true;
    if (m_activity != Activity::Position || m_phase == Phase::Failed) {
        begin(Activity::Position);
    } else if (m_phase == Phase::Done) {
        m_standing = m_settled = false;
        enter(Phase::Moving, m_now);
    }
}

void DriveMotion::run(std::int32_t velocity)
{
    m_command.targetVelocity = velocity;
    if (m_activity != Activity::Velocity)
        begin(Activity::Velocity);
}

void DriveMotion::home()
{
    begin(Activity::Homing);
}

void DriveMotion::halt()
{
    m_paused = true;
    if (m_halt)
        return;
    m_halt = true;
    m_standing = m_settled = false;
    m_trustFrom = m_now + m_delay;
}

void DriveMotion::resume()
{
    if (!m_paused)
        return;
    m_paused = false;
    m_standing = m_settled = false;
    m_trustFrom = m_now + m_delay;
    if (m_activity == Activity::Homing)
        home(); // a halted homing starts over
    else if (m_activity == Activity::Position)
        m_changed = true; // the set-point goes out again together with the end of the halt
    else if (m_phase == Phase::Moving)
        m_halt = false;
}

void DriveMotion::stop()
{
    if (m_activity != Activity::None)
        halt();
    m_activity = Activity::None;
    m_paused = false;
    m_changed = false;
    m_bit4 = false;
    m_command.targetVelocity = 0;
    enter(Phase::Idle, m_now);
}

void DriveMotion::update(const DriveInputs& feedback, bool online, Time now)
{
    m_now = now;
    m_status = feedback.statusWord;
    updatePower(feedback, online);
    if (m_power == Power::Enabled)
        updateMotion(feedback, now);
    else
        forget();
    updateRest(feedback, now);
    writeControl();
}

/// A drive without power moves nothing and starts from nothing when it comes back.
void DriveMotion::forget()
{
    stop();
    m_halt = false;
}

void DriveMotion::updatePower(const DriveInputs& feedback, bool online)
{
    const unsigned low = feedback.statusWord & 0x4F;
    const unsigned state = feedback.statusWord & 0x6F;
    if (!online)
        m_power = Power::Off;
    else if (low == 0x08 || low == 0x0F)
        m_power = Power::Fault;
    else if (state == 0x27)
        m_power = Power::Enabled;
    else
        m_power = m_enable ? Power::Rising : Power::Off;
}

void DriveMotion::updateMotion(const DriveInputs& feedback, Time now)
{
    switch (m_activity) {
    case Activity::None:
        return;
    case Activity::Position:
        updatePosition(feedback, now);
        break;
    case Activity::Homing:
        updateHoming(feedback, now);
        break;
    case Activity::Velocity:
        m_command.mode = kModeVelocity;
        if (m_phase == Phase::Mode && feedback.mode == kModeVelocity) {
            m_halt = m_paused;
            enter(Phase::Moving, now);
        }
        break;
    }
    if (m_paused)
        m_phaseSince = now;
    const bool waits = m_phase != Phase::Moving && m_phase != Phase::Done && m_phase != Phase::Idle;
    if (waits && m_phase != Phase::Failed && now - m_phaseSince > kAnswerTimeout)
        enter(Phase::Failed, now);
}

/// Set-point handshake: bit 4 low, seen; new target with bit 4 high, acknowledged; bit 4 low again, seen; then under way.
void DriveMotion::updatePosition(const DriveInputs& feedback, Time now)
{
    const bool taken = feedback.statusWord & kTaken;
    m_command.mode = kModePosition;
    switch (m_phase) {
    case Phase::Mode:
        m_bit4 = false;
        if (feedback.mode == kModePosition)
            enter(Phase::Low, now);
        break;
    case Phase::Low:
        if (taken || m_paused)
            break;
        m_command.targetPosition = m_target;
        m_command.profileVelocity = m_velocity;
        m_changed = false;
        m_halt = false;
        m_bit4 = true;
        enter(Phase::High, now);
        break;
    case Phase::High:
        if (!taken)
            break;
        m_bit4 = false;
        enter(Phase::Release, now);
        break;
    case Phase::Release:
        if (!taken)
            enter(Phase::Moving, now);
        break;
    case Phase::Moving:
        if (m_changed)
            enter(Phase::Low, now);
        else if (!m_halt && now >= m_trustFrom && (feedback.statusWord & kReached))
            enter(Phase::Done, now);
        break;
    case Phase::Idle: case Phase::Done: case Phase::Failed:
        break;
    }
}

void DriveMotion::updateHoming(const DriveInputs& feedback, Time now)
{
    m_command.mode = kModeHoming;
    switch (m_phase) {
    case Phase::Mode:
        m_bit4 = false;
        if (feedback.mode == kModeHoming)
            enter(Phase::Low, now);
        break;
    case Phase::Low: // bit 4 has been low for one cycle at least
        m_bit4 = true;
        m_halt = false;
        m_trustFrom = now + m_delay;
        enter(Phase::Moving, now);
        break;
    case Phase::Moving:
        if (m_halt || now < m_trustFrom)
            break;
        if (feedback.statusWord & kModeError)
            enter(Phase::Failed, now);
        else if ((feedback.statusWord & kTaken) && (feedback.statusWord & kReached)) {
            m_bit4 = false;
            enter(Phase::Done, now);
        }
        break;
    default:
        break;
    }
}

void DriveMotion::updateRest(const DriveInputs& feedback, Time now)
{
    const bool nothingToDo = m_activity == Activity::None || m_phase == Phase::Done || m_halt;
    const bool atRest = m_power == Power::Enabled ? (feedback.statusWord & kReached) || (m_activity == Activity::None && !m_halt)
                                                  : feedback.velocity == 0;
    const bool standing = nothingToDo && atRest && now >= m_trustFrom;
    if (standing && !m_standing)
        m_restSince = now;
    m_standing = standing;
    m_settled = standing && now >= m_restSince + m_delay;
}

void DriveMotion::writeControl()
{
    std::uint16_t control = 0x06;
    if (m_reset && m_power == Power::Fault) {
        m_command.controlWord = kFaultReset;
        return;
    }
    const unsigned state = m_status & 0x6F;
    if (m_enable && state == 0x21)
        control = 0x07;
    else if (m_enable && (state == 0x23 || state == 0x27))
        control = 0x0F;
    else if (m_power == Power::Fault)
        control = 0;
    if (control == 0x0F) {
        if (m_halt)
            control |= kHalt;
        if (m_bit4)
            control |= kStart;
        if (m_activity == Activity::Position)
            control |= kAtOnce;
    }
    m_command.controlWord = control;
}

void DriveMotion::save(ByteWriter& writer) const
{
    for (const bool flag : {m_enable, m_reset, m_halt, m_paused, m_changed, m_standing, m_settled, m_bit4})
        writer.put(flag);
    writer.put(m_power);
    writer.put(m_status);
    writer.put(m_activity);
    writer.put(m_phase);
    for (const Time time : {m_phaseSince, m_now, m_trustFrom, m_restSince})
        writer.put(time.count());
    writer.put(m_target);
    writer.put(m_velocity);
    writer.put(m_command.controlWord);
    writer.put(m_command.mode);
    writer.put(m_command.targetPosition);
    writer.put(m_command.profileVelocity);
    writer.put(m_command.targetVelocity);
}

void DriveMotion::restore(ByteReader& reader)
{
    for (bool* flag : {&m_enable, &m_reset, &m_halt, &m_paused, &m_changed, &m_standing, &m_settled, &m_bit4})
        *flag = reader.getBool();
    m_power = reader.get<Power>();
    m_status = reader.get<std::uint16_t>();
    m_activity = reader.get<Activity>();
    m_phase = reader.get<Phase>();
    for (Time* time : {&m_phaseSince, &m_now, &m_trustFrom, &m_restSince})
        *time = Time(reader.get<std::int64_t>());
    m_target = reader.get<std::int32_t>();
    m_velocity = reader.get<std::uint32_t>();
    m_command.controlWord = reader.get<std::uint16_t>();
    m_command.mode = reader.get<std::int8_t>();
    m_command.targetPosition = reader.get<std::int32_t>();
    m_command.profileVelocity = reader.get<std::uint32_t>();
    m_command.targetVelocity = reader.get<std::int32_t>();
}

} // namespace camwright::kinco
