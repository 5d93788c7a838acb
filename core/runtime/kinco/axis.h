#pragma once

#include "core/base/bytes.h"
#include "core/base/time.h"
#include "core/fieldbus/canopenmaster.h"
#include "core/language/image/controllerimage.h"
#include "core/motion/units.h"
#include "core/runtime/kinco/drivemotion.h"
#include "core/runtime/kinco/exchange.h"

#include <cstdint>
#include <string_view>

namespace camwright::kinco {

/// States of an axis (KS-MC-26).
enum class AxisState : std::uint8_t { PowerOff = 0, ErrorStop = 1, Standstill = 2, DiscreteMotion = 3, ContinuousMotion = 4, Homing = 5 };

/// Why an axis changed its state, for the panel.
enum class AxisCause : std::uint8_t {
    None, PoweredByProgram, PoweredByPanel, ReleasedByProgram, ReleasedByPanel, StoppedAndReleased, DriveAlarm, NodeLost, Reset,
    Restarted, ProgramMotion, PanelMotion, MotionEnded, StoppedByCommand, DeadMan,
};

/// English, for AxisStatus::lastCause.
std::string_view causeText(AxisCause cause);

/// One axis of the Kinco motion network on the motion task's side: who moves it, its power, its state, its drive. Everything
/// that moves it goes through claim(), so that one axis runs one instruction at a time (KS-MC-02).
class Axis {
public:
    using Owner = std::int32_t;             ///< index of the running call, or one of these
    static constexpr Owner Nobody = -1;
    static constexpr Owner Panel = -2;

    Axis(const AxisConfiguration& configuration, CanopenMaster& master);

    const AxisConfiguration& configuration() const { return m_configuration; }
    const AxisScale& scale() const { return m_scale; }
    std::uint8_t node() const { return m_configuration.number; }

    // Once each motion cycle: observe() after the bus, act() after everybody has commanded.
    /// `startingUp`: nodes that have not come up yet are not missed yet.
    void observe(Time now, bool startingUp);
    void act(Time now);

    // Power: enabled while the program or the panel wants it (CONTRACTS 20).
    void setProgramPower(bool on);
    void setPanelPower(bool on);
    bool programPower() const { return m_programPower; }
    bool panelPower() const { return m_panelPower; }
    /// Stops first, then releases; for RUN to STOP, watchdog, fault and image switch.
    void stopAndRelease();
    void startReset();
    void endReset(bool successful);
    /// After MC_RESTART brought the node back.
    void restarted();

    // Motion. claim() fails while somebody else has the axis or it is not at rest (ERRID 3).
    bool claim(Owner owner);
    void letGo(Owner owner);
    Owner owner() const { return m_owner; }
    bool isBusy() const { return m_owner != Nobody || m_releasing || !m_motion.isStanding(); }
    void beginMotion(AxisState state, AxisCause cause);
    DriveMotion& motion() { return m_motion; }
    const DriveMotion& motion() const { return m_motion; }
    /// Stops whoever moves it; the running call sees it by stops() and ends.
    void stopFromOutside(AxisCause cause);
    std::uint32_t stops() const { return m_stops; }
    /// While a panel has the axis armed, motion of the program ends with ERRID 3 (CONTRACTS 20).
    void setPanelArmed(bool armed) { m_armed = armed; }
    bool isPanelArmed() const { return m_armed; }
    void setReached(bool reached) { m_reached = reached; }
    void setHomed(bool homed) { m_homed = homed; }

    bool isOnline() const { return m_online; }
    bool hasFault() const { return m_motion.hasFault(); }
    bool isLocked() const { return m_motion.isEnabled() && !m_releasing && !m_errorStop; }
    bool isReleased() const { return !m_motion.isEnabled() && !m_releasing; }
    bool isErrorStop() const { return m_errorStop; }
    bool isHomed() const { return m_homed; }
    AxisState state() const;
    std::uint32_t errorCode() const;         ///< alarm of the drive, 0x8130 for a lost node, 0 none
    AxisCause cause() const { return m_cause; }
    Time lastChange() const { return m_lastChange; }
    const DriveInputs& inputs() const { return m_inputs; }
    bool isMoving() const { return (m_owner != Nobody && m_motionState != AxisState::Standstill) || !m_motion.isStanding(); }
    AxisView view() const;

    /// Events of this cycle for the log, cleared by the next observe().
    bool justFaulted() const { return m_justFaulted; }
    bool justLost() const { return m_justLost; }

    CanopenMaster& master() { return m_master; }

    void save(ByteWriter& writer) const;
    void restore(ByteReader& reader);

private:
    void noteState(AxisCause cause);

    AxisConfiguration m_configuration;
    AxisScale m_scale;
    CanopenMaster& m_master;
    DriveMotion m_motion;
    DriveInputs m_inputs;
    bool m_online = false;
    bool m_programPower = false, m_panelPower = false;
    bool m_releasing = false;
    bool m_armed = false;
    bool m_errorStop = false, m_lost = false;
    bool m_reached = false, m_homed = false;
    bool m_justFaulted = false, m_justLost = false;
    bool m_urgent = false;
    Owner m_owner = Nobody;
    AxisState m_motionState = AxisState::Standstill; ///< what the owner does
    AxisState m_shownState = AxisState::PowerOff;
    AxisCause m_cause = AxisCause::None, m_nextCause = AxisCause::None;
    std::uint32_t m_stops = 0;
    std::uint16_t m_lastAlarm = 0;
    Time m_now{}, m_releasingSince{}, m_lastChange{};
};

} // namespace camwright::kinco
