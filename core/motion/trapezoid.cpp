#include "core/motion/trapezoid.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace camwright {

namespace {

/// A braking distance longer than the way left by no more than this share is rounding, not a reason to overshoot.
constexpr double kRounding = 1e-9;

bool isPositive(double value) { return std::isfinite(value) && value > 0; }
double signOf(double value) { return value < 0 ? -1.0 : 1.0; }

} // namespace

const char* invalidLimit(const MotionLimits& limits)
{
    if (!isPositive(limits.velocity))
        return "velocity";
    if (!isPositive(limits.acceleration))
        return "acceleration";
    return isPositive(limits.deceleration) ? nullptr : "deceleration";
}

void TrapezoidMotion::reset(double position)
{
    *this = {};
    m_position = position;
    m_basePosition = position;
    m_target = position;
    m_hasTarget = true;
}

void TrapezoidMotion::begin()
{
    m_count = 0;
    m_segment = 0;
    m_elapsed = Time{0};
    m_segmentStart = 0;
    m_basePosition = m_position;
    m_baseVelocity = m_velocity;
    m_endVelocity = 0;
    m_hasTarget = true;
}

void TrapezoidMotion::add(double duration, double endVelocity, double acceleration)
{
    if (duration <= 0)
        return;
    m_segments[m_count++] = {duration, acceleration, endVelocity};
}

/// From one velocity to another; through rest if the direction changes. Two segments at most.
void TrapezoidMotion::addRamp(double from, double to, const MotionLimits& limits)
{
    if (from != 0 && to != 0 && signOf(from) != signOf(to)) {
        addRamp(from, 0, limits);
        from = 0;
    }
    const bool faster = std::abs(to) > std::abs(from);
    const double rate = faster ? limits.acceleration : limits.deceleration;
    add(std::abs(to - from) / rate, to, to > from ? rate : -rate);
}

/// From a velocity towards the target (not away from it, and with room to stop) to rest at `distance`. Both are sizes in
/// the direction of `sign`. The peak of an uncut triangle is where the accelerated and the braked way add up to the distance.
void TrapezoidMotion::addMove(double startVelocity, double distance, double sign, const MotionLimits& limits)
{
    const double v0 = startVelocity;
    const double a = limits.acceleration;
    const double d = limits.deceleration;
    if (v0 > limits.velocity) {
        const double peak = limits.velocity;
        add((v0 - peak) / d, sign * peak, -sign * d);
        add((distance - v0 * v0 / (2 * d)) / peak, sign * peak, 0);
        add(peak / d, 0, -sign * d);
        return;
    }
    const double triangle = std::sqrt((2 * distance * a * d + v0 * v0 * d) / (a + d));
    const double peak = std::max(v0, std::min(triangle, limits.velocity));
    if (peak <= 0)
        return;
    const double cruise = distance - (peak * peak - v0 * v0) / (2 * a) - peak * peak / (2 * d);
    add((peak - v0) / a, sign * peak, sign * a);
    add(cruise / peak, sign * peak, 0);
    add(peak / d, 0, -sign * d);
}

void TrapezoidMotion::moveTo(double target, const MotionLimits& limits)
{
    assert(invalidLimit(limits) == nullptr);
    begin();
    m_target = target;
    const double distance = target - m_position;
    const double sign = signOf(distance);
    const double speed = m_velocity * sign;
    const double size = std::abs(distance);
    const double braking = speed * speed / (2 * limits.deceleration);
    if (speed >= 0 && braking <= size) {
        addMove(speed, size, sign, limits);
    } else if (speed > 0 && braking <= size * (1 + kRounding)) {
        add(2 * size / speed, 0, -sign * speed * speed / (2 * size));
    } else {
        const double rest = m_position + m_velocity * std::abs(m_velocity) / (2 * limits.deceleration);
        add(std::abs(m_velocity) / limits.deceleration, 0, -signOf(m_velocity) * limits.deceleration);
        addMove(0, std::abs(target - rest), signOf(target - rest), limits);
    }
    advance(Time{0});
}

void TrapezoidMotion::moveAt(double velocity, const MotionLimits& limits)
{
    assert(invalidLimit(limits) == nullptr);
    begin();
    m_endVelocity = std::clamp(velocity, -limits.velocity, limits.velocity);
    addRamp(m_velocity, m_endVelocity, limits);
    endAtRest();
    advance(Time{0});
}

void TrapezoidMotion::stop(double deceleration)
{
    assert(isPositive(deceleration));
    begin();
    addRamp(m_velocity, 0, {std::max(std::abs(m_velocity), 1.0), deceleration, deceleration});
    endAtRest();
    advance(Time{0});
}

/// Where a move without a target of its own comes to rest.
void TrapezoidMotion::endAtRest()
{
    m_hasTarget = m_endVelocity == 0;
    m_target = m_basePosition;
    double velocity = m_baseVelocity;
    for (std::uint8_t i = 0; i < m_count; ++i) {
        m_target += (velocity + m_segments[i].endVelocity) / 2 * m_segments[i].duration;
        velocity = m_segments[i].endVelocity;
    }
}

void TrapezoidMotion::advance(Time span)
{
    m_elapsed += span;
    const double now = seconds(m_elapsed);
    while (m_segment < m_count && now >= m_segmentStart + m_segments[m_segment].duration) {
        const Segment& past = m_segments[m_segment];
        m_basePosition += (m_baseVelocity + past.endVelocity) / 2 * past.duration;
        m_baseVelocity = past.endVelocity;
        m_segmentStart += past.duration;
        ++m_segment;
    }
    if (m_segment < m_count) {
        const double inside = now - m_segmentStart;
        m_acceleration = m_segments[m_segment].acceleration;
        m_position = m_basePosition + (m_baseVelocity + m_acceleration * inside / 2) * inside;
        m_velocity = m_baseVelocity + m_acceleration * inside;
        return;
    }
    m_acceleration = 0;
    m_velocity = m_endVelocity;
    m_position = m_hasTarget ? m_target : m_basePosition + m_endVelocity * (now - m_segmentStart);
}

double TrapezoidMotion::restPosition() const { return m_hasTarget ? m_target : m_position; }

double TrapezoidMotion::duration() const
{
    double sum = 0;
    for (std::uint8_t i = 0; i < m_count; ++i)
        sum += m_segments[i].duration;
    return sum;
}

void TrapezoidMotion::shift(double delta)
{
    assert(!isMoving());
    const double position = m_position + delta;
    reset(position);
}

void TrapezoidMotion::save(ByteWriter& writer) const
{
    for (const Segment& segment : m_segments) {
        writer.put(segment.duration);
        writer.put(segment.acceleration);
        writer.put(segment.endVelocity);
    }
    writer.put(m_count);
    writer.put(m_segment);
    writer.put(m_elapsed.count());
    for (const double number : {m_segmentStart, m_basePosition, m_baseVelocity, m_position, m_velocity, m_acceleration, m_target, m_endVelocity})
        writer.put(number);
    writer.put(m_hasTarget);
}

void TrapezoidMotion::restore(ByteReader& reader)
{
    for (Segment& segment : m_segments) {
        segment.duration = reader.get<double>();
        segment.acceleration = reader.get<double>();
        segment.endVelocity = reader.get<double>();
    }
    m_count = reader.get<std::uint8_t>();
    m_segment = reader.get<std::uint8_t>();
    m_elapsed = Time(reader.get<std::int64_t>());
    for (double* number :
        {&m_segmentStart, &m_basePosition, &m_baseVelocity, &m_position, &m_velocity, &m_acceleration, &m_target, &m_endVelocity})
        *number = reader.get<double>();
    m_hasTarget = reader.getBool();
    if (m_count > m_segments.size() || m_segment > m_count) {
        reader.fail();
        reset(0);
    }
}

} // namespace camwright
