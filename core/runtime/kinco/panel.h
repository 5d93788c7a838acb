#pragma once

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/online/controllerlink.h"
#include "core/runtime/log/controllerlog.h"
#include "core/runtime/engineinput.h"
#include "core/runtime/kinco/axis.h"

namespace camwright::kinco {

/// A heartbeat that has seen nothing newer than this many cycles is dropped, and without a valid one for this many the axis
/// is stopped: 100 ms (CONTRACTS 19).
inline constexpr std::uint64_t kHeartbeatCycles = 100;

/// A panel's speeds are clamped to this many motor turns a minute (ours).
inline constexpr double kPanelTurnsPerMinute = 3000;

/// The commissioning panel's hold on one axis: arming, its own wish for power, one motion at a time, and the dead-man, which
/// is looked at here, in the motion task (CONTRACTS 19, 20).
class Panel {
public:
    Panel(Axis& axis, ControllerLog& log) : m_axis(axis), m_log(log) {}

    Result<void> command(const input::Panel& command);
    void heartbeat(std::uint64_t seenCycle);
    /// Stops the panel's motion, disarms, and takes its enabling back once the axis stands; at a program start.
    void letGo();

    void cycle(std::uint64_t cycle, Time now);
    /// After the master has sent: says in the log when a dead-man's stop reached the bus.
    void afterSending();

    bool isMoving() const { return m_motion != Motion::None; }

    void save(ByteWriter& writer) const;
    void restore(ByteReader& reader);

private:
    enum class Motion : std::uint8_t { None, Homing, Position, Velocity, Stopping };

    Result<void> arm();
    Result<void> enable();
    Result<void> disable();
    Result<void> reset();
    Result<void> home();
    Result<void> moveTo(double units, double velocity);
    Result<void> run(double velocity);
    Result<void> mayMove(Motion motion) const;
    Result<void> refused(Code code) const;
    Result<void> badNumber(double number, const char* what) const;
    double clamped(double countsPerSecond) const;
    void begin(Motion motion, AxisState state);
    void stop(AxisCause cause);
    void disarm();
    void superviseReset(Time now);
    void superviseMotion();

    Axis& m_axis;
    ControllerLog& m_log;
    bool m_armed = false;
    bool m_resetting = false;
    bool m_disableAtRest = false;
    bool m_stopToReport = false;
    Motion m_motion = Motion::None;
    std::uint64_t m_cycle = 0;
    std::uint64_t m_lastBeat = 0;
    std::uint64_t m_reportedBeat = 0;
    std::uint32_t m_stops = 0;
    Time m_now{}, m_resetSince{};
};

} // namespace camwright::kinco
