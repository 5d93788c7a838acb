#include "core/runtime/plant/simulateddrive.h"

#include "core/motion/units.h"

#include <cmath>

namespace camwright {

namespace {

constexpr Time kStep = 1ms;

/// Positions are shown in 32 bits and wrap there.
std::int32_t shownPosition(double counts)
{
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(static_cast<std::uint64_t>(roundToInt64(counts))));
}

SimulatedDriveConfig completed(SimulatedDriveConfig config)
{
    if (config.homeCamWidth <= 0)
        config.homeCamWidth = config.countsPerTurn / 4;
    if (config.indexOffset < 0)
        config.indexOffset = config.countsPerTurn / 4;
    return config;
}

std::uint16_t stateBits(DriveState state)
{
    switch (state) {
    case DriveState::NotReady: return 0x0000;
    case DriveState::SwitchOnDisabled: return 0x0040;
    case DriveState::ReadyToSwitchOn: return 0x0021;
    case DriveState::SwitchedOn: return 0x0023;
    case DriveState::OperationEnabled: return 0x0027;
    case DriveState::QuickStopActive: return 0x0007;
    case DriveState::FaultReaction: return 0x000F;
    case DriveState::Fault: return 0x0008;
    }
    return 0;
}

} // namespace

SimulatedDrive::SimulatedDrive(const SimulatedDriveConfig& config, CanPort& port)
    : m_config(completed(config)), m_slave(config.node, m_dictionary, *this, port),
      m_plant(config.countsPerTurn, config.inertiaRatio, config.seed)
{
    addDriveObjects(m_dictionary, config.countsPerTurn);
    m_slots = findDriveSlots(m_dictionary);
    m_plant.reset(config.startPosition);
}

void SimulatedDrive::powerOn(Time now)
{
    if (m_powered)
        return;
    m_powered = true;
    m_now = now;
    m_homed = false;
    m_offset = 0;
    initialise();
}

void SimulatedDrive::powerOff()
{
    m_powered = false;
    m_slave.stop();
    m_state = DriveState::NotReady;
}

/// From power-on and from the NMT command to reset the node: everything but the shaft and the position counter.
void SimulatedDrive::initialise()
{
    m_slave.stop();
    m_bootAt = m_now + m_config.bootTime;
    m_state = DriveState::NotReady;
    m_leaving = Leaving::No;
    m_homingPhase = HomingPhase::None;
    m_homing.cancel();
    m_controlWord = 0;
    m_mode = 0;
    m_errorCode = 0;
    m_hasNext = m_acknowledge = m_moving = m_halted = m_internalLimit = m_followingError = false;
    loadParameters(true);
    m_motion.reset(drivePosition());
    m_target = drivePosition();
}

void SimulatedDrive::receive(const CanFrame& frame, Time now)
{
    if (!m_powered)
        return;
    m_now = now;
    m_slave.receive(frame, now);
}

void SimulatedDrive::step(Time now)
{
    m_now = now;
    if (!m_powered) {
        m_plant.coast();
        return;
    }
    if (!m_slave.isRunning() && now >= m_bootAt) {
        m_slave.start(now);
        enterState(DriveState::SwitchOnDisabled);
    }
    const double before = direction() * m_plant.position();
    if (isEnabled()) {
        operate();
        m_motion.advance(kStep);
        ServoGains gains;
        gains.positionGain = number(m_slots.positionGain) * 0.01 * 6.283185307179586;
        gains.feedForward = number(m_slots.feedForward) / 256;
        gains.velocityGain = number(m_slots.velocityGain) / 100;
        gains.torqueLimit = number(m_slots.currentLimit) / 2048 * 3;
        m_plant.follow(direction() * (m_motion.position() - m_offset), direction() * m_motion.velocity(), gains);
        m_homing.observe(machine(), before, direction() * m_plant.position());
        superviseFollowing();
    } else {
        m_plant.coast();
        m_motion.reset(drivePosition());
    }
    publish();
    m_slave.step(now);
}

void SimulatedDrive::injectFault(std::uint16_t errorCode, Time now)
{
    m_now = now;
    if (m_powered)
        fault(errorCode);
}

HomingMachine SimulatedDrive::machine() const
{
    HomingMachine machine;
    const bool forward = direction() > 0;
    machine.lowerLimit = forward ? m_config.lowerLimitSwitch : -m_config.upperLimitSwitch;
    machine.upperLimit = forward ? m_config.upperLimitSwitch : -m_config.lowerLimitSwitch;
    machine.homeSwitch = direction() * m_config.homeSwitch;
    machine.homeCamWidth = m_config.homeCamWidth;
    machine.countsPerTurn = m_config.countsPerTurn;
    machine.indexOffset = direction() * m_config.indexOffset;
    return machine;
}

/// 0x60FD: bit 0 negative limit, 1 positive limit, 2 home switch; wired to DIN3, DIN2 and DIN1, which are bits 18, 17, 16.
std::uint32_t SimulatedDrive::digitalInputs() const
{
    const HomingMachine switches = machine();
    const double position = direction() * m_plant.position();
    std::uint32_t bits = 0;
    if (position <= switches.lowerLimit)
        bits |= 1U | (1U << 18);
    if (position >= switches.upperLimit)
        bits |= 2U | (1U << 17);
    if (homeSwitchActive(switches, static_cast<int>(m_dictionary.number(m_slots.homingMethod)), position))
        bits |= 4U | (1U << 16);
    return bits;
}

bool SimulatedDrive::positionReached()
{
    const bool inside = !m_motion.isMoving() && std::abs(drivePosition() - m_target) <= number(m_slots.positionWindow);
    if (!inside) {
        m_inWindowSince = Time{-1};
        return false;
    }
    if (m_inWindowSince < Time{0})
        m_inWindowSince = m_now;
    return m_now - m_inWindowSince >= std::chrono::milliseconds(m_dictionary.number(m_slots.windowTime));
}

std::uint16_t SimulatedDrive::modeBits()
{
    if (!isEnabled())
        return 0;
    const double velocity = direction() * m_plant.velocity();
    const bool standing = std::abs(velocity) <= number(m_slots.velocityWindow) && !m_motion.isMoving();
    std::uint16_t bits = 0;
    const auto set = [&bits](unsigned bit, bool value) { bits = static_cast<std::uint16_t>(bits | (value ? 1U << bit : 0U)); };
    switch (m_mode) {
    case 1: {
        const bool reached = positionReached();
        if (reached)
            m_moving = false;
        set(10, m_halted ? standing : reached && !m_hasNext);
        set(12, m_acknowledge);
        set(13, m_followingError);
        break;
    }
    case 3: {
        const double wanted = m_halted ? 0 : number(m_slots.targetVelocity);
        set(10, m_motion.profileDone() && std::abs(velocity - wanted) <= number(m_slots.velocityWindow));
        set(12, standing);
        break;
    }
    case 6:
        set(10, standing && m_homingPhase != HomingPhase::Returning);
        set(12, m_homingPhase == HomingPhase::Attained);
        set(13, m_homingPhase == HomingPhase::Failed);
        break;
    default: break;
    }
    return bits;
}

std::uint16_t SimulatedDrive::statusWord()
{
    std::uint16_t word = static_cast<std::uint16_t>(stateBits(m_state) | 0x0010 | modeBits());
    if (m_slave.state() == NmtState::Operational)
        word |= 0x0200;
    if (m_internalLimit)
        word |= 0x0800;
    if (m_homed)
        word |= 0x8000;
    return word;
}

void SimulatedDrive::publish()
{
    const double position = drivePosition();
    m_dictionary.setNumber(m_slots.statusWord, statusWord());
    m_dictionary.setNumber(m_slots.modeDisplay, m_mode);
    m_dictionary.setNumber(m_slots.errorCode, m_errorCode);
    m_dictionary.setNumber(m_slots.position, shownPosition(position));
    m_dictionary.setNumber(m_slots.encoderPosition, shownPosition(direction() * m_plant.position()));
    m_dictionary.setNumber(m_slots.demandPosition, shownPosition(m_motion.position()));
    m_dictionary.setNumber(m_slots.followingError, roundToInt32(m_motion.position() - position));
    m_dictionary.setNumber(m_slots.velocity, roundToInt32(direction() * m_plant.velocity()));
    m_dictionary.setNumber(m_slots.demandVelocity, roundToInt32(m_motion.velocity()));
    m_dictionary.setNumber(m_slots.torque, static_cast<std::int16_t>(roundToInt32(direction() * m_plant.torque() * 1000)));
    m_dictionary.setNumber(m_slots.digitalInputs, digitalInputs());
}

void SimulatedDrive::save(ByteWriter& writer) const
{
    m_dictionary.save(writer);
    m_slave.save(writer);
    m_plant.save(writer);
    m_motion.save(writer);
    m_homing.save(writer);
    writer.putBlob(m_savedParameters);
    writer.put(m_state);
    writer.put(m_leaving);
    writer.put(m_homingPhase);
    writer.put(m_powered);
    writer.put(m_now.count());
    writer.put(m_bootAt.count());
    writer.put(m_controlWord);
    writer.put(m_mode);
    writer.put(m_errorCode);
    for (const double number : {m_offset, m_target, m_nextTarget, m_speedCommand})
        writer.put(number);
    for (const bool flag : {m_hasNext, m_acknowledge, m_moving, m_halted, m_internalLimit, m_homed, m_followingError, m_replan})
        writer.put(flag);
    writer.put(m_inWindowSince.count());
}

void SimulatedDrive::restore(ByteReader& reader)
{
    m_dictionary.restore(reader);
    m_slave.restore(reader);
    m_plant.restore(reader);
    m_motion.restore(reader);
    m_homing.restore(reader);
    const ByteSpan saved = reader.getBlob();
    m_savedParameters.assign(saved.begin(), saved.end());
    m_state = reader.get<DriveState>();
    m_leaving = reader.get<Leaving>();
    m_homingPhase = reader.get<HomingPhase>();
    m_powered = reader.getBool();
    m_now = Time(reader.get<std::int64_t>());
    m_bootAt = Time(reader.get<std::int64_t>());
    m_controlWord = reader.get<std::uint16_t>();
    m_mode = reader.get<std::int8_t>();
    m_errorCode = reader.get<std::uint16_t>();
    for (double* number : {&m_offset, &m_target, &m_nextTarget, &m_speedCommand})
        *number = reader.get<double>();
    for (bool* flag : {&m_hasNext, &m_acknowledge, &m_moving, &m_halted, &m_internalLimit, &m_homed, &m_followingError, &m_replan})
        *flag = reader.getBool();
    m_inWindowSince = Time(reader.get<std::int64_t>());
}

} // namespace camwright
