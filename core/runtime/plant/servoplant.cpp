#include "core/runtime/plant/servoplant.h"

#include <algorithm>
#include <cmath>

namespace camwright {

namespace {

constexpr double kStep = 1e-3;                ///< s
constexpr double kMotorTurnsPerSecond2 = 800; ///< acceleration of the bare motor at rated torque, turn/s²
constexpr double kRatedTurnsPerSecond = 50;   ///< rated speed
constexpr double kDryFriction = 0.02;         ///< of rated torque, while it turns
constexpr double kViscousFriction = 0.05;     ///< of rated torque, at rated speed
constexpr double kRipple = 0.004;             ///< of rated torque, while it turns
constexpr double kVelocityLag = 1e-3;         ///< s, of the velocity loop with inertia ratio 0 and default gain
constexpr double kStandstill = 0.5;           ///< counts/s, below which static friction holds the shaft
constexpr double kHeld = 0.01;                ///< counts from the reference at which it may hold

double signOf(double value) { return value > 0 ? 1.0 : value < 0 ? -1.0 : 0.0; }

} // namespace

ServoPlant::ServoPlant(double countsPerTurn, double inertiaRatio, std::uint64_t seed)
    : m_countsPerTurn(countsPerTurn), m_inertiaRatio(std::max(0.0, inertiaRatio)),
      m_ratedAcceleration(kMotorTurnsPerSecond2 * countsPerTurn / (1 + m_inertiaRatio)), m_random(seed * 2 + 1)
{
}

void ServoPlant::reset(double position)
{
    m_position = position;
    m_velocity = 0;
    m_torque = 0;
}

/// Between -1 and 1 (xorshift, so that every machine draws the same).
double ServoPlant::ripple()
{
    m_random ^= m_random << 13;
    m_random ^= m_random >> 7;
    m_random ^= m_random << 17;
    return static_cast<double>(m_random >> 11) / 4503599627370496.0 - 1.0;
}

void ServoPlant::follow(double referencePosition, double referenceVelocity, const ServoGains& gains)
{
    const double command = referenceVelocity * gains.feedForward + gains.positionGain * (referencePosition - m_position);
    const double lag = std::clamp(kVelocityLag * (1 + m_inertiaRatio) / std::max(gains.velocityGain, 0.01), 0.5e-3, 50e-3);
    const bool turning = std::abs(m_velocity) > kStandstill;
    const double friction
        = turning ? kDryFriction * signOf(m_velocity) + kViscousFriction * m_velocity / (kRatedTurnsPerSecond * m_countsPerTurn) : 0.0;
    // The velocity loop's integral part carries the friction, so torque beyond it accelerates.
    const double wanted = (command - m_velocity) / (lag + kStep) / m_ratedAcceleration;
    const double room = std::max(gains.torqueLimit, 0.0);
    const double torque = std::clamp(wanted + friction, -room, room);
    double acceleration = (torque - friction) * m_ratedAcceleration;
    if (turning && referenceVelocity != 0)
        acceleration += kRipple * ripple() * m_ratedAcceleration * 0.1;
    if (m_blocked) {
        m_velocity = 0;
        m_torque = torque;
        return;
    }
    m_velocity += acceleration * kStep;
    m_position += m_velocity * kStep;
    if (referenceVelocity == 0 && std::abs(m_velocity) < kStandstill && std::abs(referencePosition - m_position) < kHeld) {
        m_velocity = 0;
        m_position = referencePosition;
    }
    m_torque = torque + (turning ? kRipple * ripple() : 0.0);
}

void ServoPlant::coast()
{
    m_torque = 0;
    const double brake
        = (kDryFriction + kViscousFriction * std::abs(m_velocity) / (kRatedTurnsPerSecond * m_countsPerTurn)) * m_ratedAcceleration * kStep;
    if (m_blocked || std::abs(m_velocity) <= brake) {
        m_velocity = 0;
        return;
    }
    m_velocity -= signOf(m_velocity) * brake;
    m_position += m_velocity * kStep;
}

void ServoPlant::save(ByteWriter& writer) const
{
    writer.put(m_random);
    writer.put(m_position);
    writer.put(m_velocity);
    writer.put(m_torque);
    writer.put(m_blocked);
}

void ServoPlant::restore(ByteReader& reader)
{
    m_random = reader.get<std::uint64_t>();
    m_position = reader.get<double>();
    m_velocity = reader.get<double>();
    m_torque = reader.get<double>();
    m_blocked = reader.getBool();
}

} // namespace camwright
