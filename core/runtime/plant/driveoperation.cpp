#include "core/runtime/plant/simulateddrive.h"

#include <algorithm>
#include <cmath>

// What the drive does while enabled: its three modes of operation and the limits that bound them.

namespace camwright {

namespace {

constexpr double kMotorTurnsPerSecond = 100; ///< what the motor can do when 0x607F sets no limit
constexpr std::uint16_t kFollowingError = 0x8611;

} // namespace

void SimulatedDrive::takeMode()
{
    const auto wanted = static_cast<std::int8_t>(m_dictionary.number(m_slots.mode));
    if (wanted == m_mode)
        return;
    cancelHoming();
    m_homingPhase = HomingPhase::None;
    m_mode = wanted;
    m_hasNext = m_acknowledge = m_moving = false;
    m_replan = true;
    if (isEnabled() && m_leaving == Leaving::No && m_mode != 3)
        m_motion.stop(ramp(m_slots.deceleration));
    m_target = m_motion.restPosition();
}

void SimulatedDrive::setHalted(bool halted)
{
    if (halted == m_halted)
        return;
    m_halted = halted;
    if (halted) {
        const bool quick = m_dictionary.number(m_slots.haltOption) == 2;
        m_motion.stop(ramp(quick ? m_slots.quickDeceleration : m_slots.deceleration));
        return;
    }
    m_replan = true;
    if (m_mode == 1 && m_moving)
        resumeMove();
}

MotionLimits SimulatedDrive::profileLimits(double velocity) const
{
    const double limit = number(m_slots.maximumSpeed);
    const double highest = limit > 0 ? limit : kMotorTurnsPerSecond * m_config.countsPerTurn;
    return {std::min(std::abs(velocity), highest), ramp(m_slots.acceleration), ramp(m_slots.deceleration)};
}

/// 0x607D. Sub-index 1 is the positive limit, as the Kinco list has it; off unless it lies above the negative one.
bool SimulatedDrive::clampToSoftLimits(double& target) const
{
    const double upper = number(m_slots.softPositive);
    const double lower = number(m_slots.softNegative);
    if (upper <= lower)
        return false;
    // From outside, the way back is free, the way further out is not (CONTRACTS 30).
    const double here = m_motion.position();
    const double clamped = std::clamp(target, std::min(lower, here), std::max(upper, here));
    const bool limited = clamped != target;
    target = clamped;
    return limited;
}

void SimulatedDrive::acceptSetPoint(bool immediately, bool relative)
{
    if (m_acknowledge)
        return; // the last one has not been taken back, or both buffers are full
    const double raw = number(m_slots.targetPosition);
    const bool busy = m_moving && m_motion.isMoving();
    const double target = relative ? raw + (busy ? m_target : m_motion.restPosition()) : raw;
    m_acknowledge = true;
    if (busy && !immediately) {
        m_nextTarget = target;
        m_hasNext = true;
        return;
    }
    m_hasNext = false;
    startMove(target);
}

void SimulatedDrive::startMove(double target)
{
    m_target = target;
    m_moving = true;
    m_inWindowSince = Time{-1};
    if (!m_halted)
        resumeMove();
}

/// Plans the move to the present set-point from where the reference is.
void SimulatedDrive::resumeMove()
{
    double target = m_target;
    m_internalLimit = clampToSoftLimits(target);
    const MotionLimits limits = profileLimits(number(m_slots.profileVelocity));
    if (limits.velocity > 0)
        m_motion.moveTo(target, limits);
    else
        m_motion.stop(limits.deceleration);
}

void SimulatedDrive::startHoming()
{
    m_homing.start(static_cast<int>(m_dictionary.number(m_slots.homingMethod)), machine(), direction() * m_plant.position());
    m_homed = false;
    m_replan = true;
    m_homingPhase = HomingPhase::Searching;
}

void SimulatedDrive::cancelHoming()
{
    const bool active = m_homingPhase == HomingPhase::Searching || m_homingPhase == HomingPhase::Braking
        || m_homingPhase == HomingPhase::Returning;
    if (!active)
        return;
    m_homing.cancel();
    m_homingPhase = HomingPhase::None;
    m_motion.stop(ramp(m_slots.homingAcceleration));
}

void SimulatedDrive::operate()
{
    if (m_leaving != Leaving::No) {
        if (!m_motion.isMoving())
            finishLeaving();
        return;
    }
    if (m_state != DriveState::OperationEnabled)
        return;
    switch (m_mode) {
    case 1: operatePosition(); break;
    case 3: operateVelocity(); break;
    case 6: return operateHoming();
    default: break;
    }
    holdAtLimits();
}

void SimulatedDrive::operatePosition()
{
    if (!m_hasNext || m_halted || m_motion.isMoving())
        return;
    m_hasNext = false;
    if ((m_controlWord & (1U << 4)) == 0)
        m_acknowledge = false;
    startMove(m_nextTarget);
}

void SimulatedDrive::operateVelocity()
{
    const double wanted = number(m_slots.targetVelocity);
    if (m_halted || (!m_replan && wanted == m_speedCommand))
        return;
    m_replan = false;
    m_speedCommand = wanted;
    const MotionLimits limits = profileLimits(wanted);
    m_internalLimit = false;
    if (wanted == 0)
        return m_motion.stop(limits.deceleration);
    // Towards a soft limit the way ends there.
    double end = std::copysign(9e15, wanted);
    if (clampToSoftLimits(end))
        m_motion.moveTo(end, limits);
    else
        m_motion.moveAt(wanted, limits);
}

/// A limit switch ends every motion into it; back out of it the way is free.
void SimulatedDrive::holdAtLimits()
{
    const double way = m_motion.velocity() != 0 ? m_motion.velocity() : m_motion.acceleration();
    if (!m_motion.isMoving() || !limitAhead(way))
        return;
    m_internalLimit = true;
    m_motion.stop(ramp(m_slots.quickDeceleration));
}

bool SimulatedDrive::limitAhead(double way) const
{
    const HomingMachine switches = machine();
    const double position = direction() * m_plant.position();
    return (way > 0 && position >= switches.upperLimit) || (way < 0 && position <= switches.lowerLimit);
}

void SimulatedDrive::operateHoming()
{
    const double rate = ramp(m_slots.homingAcceleration);
    switch (m_homingPhase) {
    case HomingPhase::Searching: {
        if (m_homing.state() == HomingSequence::State::Found || m_homing.state() == HomingSequence::State::Failed) {
            m_homingPhase = m_homing.state() == HomingSequence::State::Found ? HomingPhase::Braking : HomingPhase::Failed;
            return m_motion.stop(rate);
        }
        const HomingSequence::Demand demand = m_homing.demand();
        const double speed = std::max(1.0, std::abs(number(demand.fast ? m_slots.homingFast : m_slots.homingSlow)));
        const double wanted = demand.direction * speed;
        if (m_halted || (!m_replan && wanted == m_speedCommand))
            return;
        m_replan = false;
        m_speedCommand = wanted;
        return m_motion.moveAt(wanted, {speed, rate, rate});
    }
    case HomingPhase::Braking:
        if (!m_motion.isMoving())
            finishHoming();
        return;
    case HomingPhase::Returning:
        if (m_halted)
            return;
        if (m_replan) {
            m_replan = false;
            m_motion.moveTo(m_target, {std::max(1.0, std::abs(number(m_slots.homingSlow))), rate, rate});
        }
        if (positionReached())
            m_homingPhase = HomingPhase::Attained;
        return;
    default: return;
    }
}

/// The place found gets the home offset as its position; the axis goes back to it, or stays where it stopped (0x6099:05).
void SimulatedDrive::finishHoming()
{
    const double shift = number(m_slots.homeOffset) - (m_homing.reference() + m_offset);
    m_motion.shift(shift);
    m_offset += shift;
    m_homed = true;
    m_target = number(m_slots.homeOffset);
    m_inWindowSince = Time{-1};
    if (m_dictionary.number(m_slots.homingAfter) == 0) {
        m_replan = true;
        m_homingPhase = HomingPhase::Returning;
    } else {
        m_target = m_motion.position();
        m_homingPhase = HomingPhase::Attained;
    }
}

void SimulatedDrive::superviseFollowing()
{
    const double window = number(m_slots.followingWindow);
    if (window == 0 || std::abs(m_motion.position() - drivePosition()) <= window)
        return;
    m_followingError = true;
    fault(kFollowingError);
}

} // namespace camwright
