#pragma once

#include "core/base/bytes.h"
#include "core/base/time.h"

#include <array>
#include <cstdint>

namespace camwright {

/// Bounds of a move, all in the user of the profile's unit per second (squared), all positive and finite.
struct MotionLimits {
    double velocity = 1;
    double acceleration = 1;
    double deceleration = 1;
    bool operator==(const MotionLimits&) const = default;
};

/// Names the first number that is not positive and finite: "velocity", "acceleration", "deceleration"; nullptr if all are good.
const char* invalidLimit(const MotionLimits& limits);

/// Set-point generator of a single axis with trapezoidal velocity: moves to positions and at velocities, takes a new
/// command at any moment without a step in velocity, and ends at its target bit for bit. Position and velocity are closed
/// formulas of the time since the last command, so nothing adds up over long moves.
///
/// A move faster than its (new) velocity limit brakes to the limit; one that cannot stop before its target runs past it at
/// `deceleration` and comes back. Nothing but additions, multiplications, divisions and square roots is used, so that the
/// numbers are equal on every machine.
class TrapezoidMotion {
public:
    void reset(double position);                                 ///< at rest there
    void moveTo(double target, const MotionLimits& limits);
    /// Signed velocity, at most limits.velocity in size; goes on until the next command.
    void moveAt(double velocity, const MotionLimits& limits);
    void stop(double deceleration);

    void advance(Time span);

    double position() const { return m_position; }
    double velocity() const { return m_velocity; }
    double acceleration() const { return m_acceleration; }
    bool isMoving() const { return m_segment < m_count || m_endVelocity != 0; }
    /// True when the commanded velocity of moveAt, or standstill, is reached.
    bool profileDone() const { return m_segment >= m_count; }
    /// Where the present command ends at rest; the current position while it does not end.
    double restPosition() const;
    /// Seconds from the last command to its end at constant velocity or rest.
    double duration() const;

    /// The zero point moves: every position, past and to come, is `delta` larger. At rest only.
    void shift(double delta);

    void save(ByteWriter& writer) const;
    void restore(ByteReader& reader);

private:
    struct Segment {
        double duration = 0;     ///< s
        double acceleration = 0; ///< unit/s²
        double endVelocity = 0;
    };
    void begin();
    void add(double duration, double endVelocity, double acceleration);
    void addRamp(double from, double to, const MotionLimits& limits);
    void addMove(double startVelocity, double distance, double sign, const MotionLimits& limits);
    void endAtRest();

    std::array<Segment, 4> m_segments{};
    std::uint8_t m_count = 0;
    std::uint8_t m_segment = 0;
    Time m_elapsed{0};           ///< since the command
    double m_segmentStart = 0;   ///< s since the command
    double m_basePosition = 0;   ///< at the start of the segment
    double m_baseVelocity = 0;
    double m_position = 0;
    double m_velocity = 0;
    double m_acceleration = 0;
    double m_target = 0;
    double m_endVelocity = 0;
    bool m_hasTarget = false;
};

} // namespace camwright
