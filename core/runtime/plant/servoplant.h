#pragma once

#include "core/base/bytes.h"

#include <cstdint>

namespace camwright {

/// Numbers of the loops and the motor, in counts.
struct ServoGains {
    double positionGain = 62.8;     ///< 1/s
    double feedForward = 0.9;       ///< share of the reference velocity
    double velocityGain = 1;        ///< relative to the default; larger is stiffer
    double torqueLimit = 3;         ///< of rated
};

/// Motor, load and the two control loops of a servo axis, stepped by one millisecond. A position loop (P with velocity
/// feed-forward) commands a velocity loop whose lag grows with the load's inertia; torque and so acceleration are limited;
/// friction brakes a free shaft. Torques are shares of the rated torque.
class ServoPlant {
public:
    ServoPlant(double countsPerTurn, double inertiaRatio, std::uint64_t seed);
    void reset(double position);

    /// Closed loop: follows the reference. Units: counts, counts/s.
    void follow(double referencePosition, double referenceVelocity, const ServoGains& gains);
    /// No power: friction brings the shaft to rest.
    void coast();
    void setBlocked(bool blocked) { m_blocked = blocked; }

    double position() const { return m_position; }
    double velocity() const { return m_velocity; }
    double torque() const { return m_torque; }

    void save(ByteWriter& writer) const;
    void restore(ByteReader& reader);

private:
    double ripple();

    double m_countsPerTurn;
    double m_inertiaRatio;
    double m_ratedAcceleration;  ///< counts/s² at rated torque, load included
    std::uint64_t m_random;
    double m_position = 0;
    double m_velocity = 0;
    double m_torque = 0;
    bool m_blocked = false;
};

} // namespace camwright
