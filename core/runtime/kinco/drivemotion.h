#pragma once

#include "core/base/bytes.h"
#include "core/base/time.h"
#include "core/fieldbus/canopenmaster.h"

#include <cstdint>

namespace camwright::kinco {

/// Enables a CiA 402 drive and moves it: the handshakes of controlword and statusword (IEC 61800-7-201). Feedback in, command
/// out, once each motion cycle; it knows no frames. Feedback may lag by `feedbackDelay` (PDO inhibit time and transport),
/// so a state that is true already is believed only after that time.
class DriveMotion {
public:
    explicit DriveMotion(Time feedbackDelay) : m_delay(feedbackDelay) {}

    void setEnabled(bool enabled) { m_enable = enabled; }
    void startReset(); ///< clears the drive's fault; endReset() takes the bit back
    void endReset() { m_reset = false; }

    /// Profile position: absolute target in counts, speed in counts per second. During a motion: changes it at once.
    void moveTo(std::int32_t target, std::uint32_t velocity);
    void run(std::int32_t velocity); ///< profile velocity, counts per second
    void home();                     ///< by the drive's own method and speeds
    void halt();                     ///< decelerates to rest and keeps what it was doing
    void resume();
    void stop();                     ///< decelerates to rest and forgets what it was doing

    void update(const DriveInputs& feedback, bool online, Time now);
    const DriveOutputs& command() const { return m_command; }

    bool isEnabled() const { return m_power == Power::Enabled; }
    bool hasFault() const { return m_power == Power::Fault; }
    /// At rest for certain: halted, or with nothing to do, and the feedback is newer than the last command.
    bool isStanding() const { return m_standing; }
    bool hasArrived() const { return m_phase == Phase::Done; } ///< target reached, or home found
    bool hasFailed() const { return m_phase == Phase::Failed; } ///< the drive did not answer, or homing found no home
    /// Feedback of positions has settled since the axis came to rest.
    bool isSettled() const { return m_settled; }

    void save(ByteWriter& writer) const;
    void restore(ByteReader& reader);

private:
    enum class Power : std::uint8_t { Off, Rising, Enabled, Fault };
    enum class Activity : std::uint8_t { None, Position, Velocity, Homing };
    enum class Phase : std::uint8_t { Idle, Mode, Low, High, Release, Moving, Done, Failed };

    void begin(Activity activity);
    void forget();
    void enter(Phase phase, Time now);
    void updatePower(const DriveInputs& feedback, bool online);
    void updateMotion(const DriveInputs& feedback, Time now);
    void updatePosition(const DriveInputs& feedback, Time now);
    void updateHoming(const DriveInputs& feedback, Time now);
    void updateRest(const DriveInputs& feedback, Time now);
    void writeControl();

    Time m_delay;
    bool m_enable = false, m_reset = false;
    bool m_halt = false;           ///< the halt bit; it stays set after a stop until the next motion
    bool m_paused = false;         ///< halted with something to go on with
    bool m_changed = false;        ///< a new target or speed waits for its set-point handshake
    bool m_standing = true, m_settled = true;
    bool m_bit4 = false;
    Power m_power = Power::Off;
    std::uint16_t m_status = 0;
    Activity m_activity = Activity::None;
    Phase m_phase = Phase::Idle;
    Time m_phaseSince{};           ///< of the phase
    Time m_now{};
    Time m_trustFrom{};            ///< feedback of rest and arrival counts from here
    Time m_restSince{};
    std::int32_t m_target = 0;
    std::uint32_t m_velocity = 0;
    DriveOutputs m_command;
};

} // namespace camwright::kinco
