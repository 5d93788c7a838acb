#pragma once

#include "core/base/bytes.h"
#include "core/base/time.h"
#include "core/fieldbus/canopenslave.h"
#include "core/fieldbus/objectdictionary.h"
#include "core/motion/trapezoid.h"
#include "core/runtime/plant/driveobjects.h"
#include "core/runtime/plant/homing.h"
#include "core/runtime/plant/servoplant.h"

#include <cstdint>

namespace camwright {

/// A drive and the machine behind it. Everything in encoder counts of the plant's own coordinate, whose zero is where the
/// machine's zero is. The encoder is absolute: from power-on to homing the drive shows the plant's position.
struct SimulatedDriveConfig {
    std::uint8_t node = 1;
    double countsPerTurn = 10000;
    double startPosition = 0;
    double inertiaRatio = 1;            ///< load to motor, at least 0
    double lowerLimitSwitch = -1e9;     ///< active at and below
    double upperLimitSwitch = 1e9;      ///< active at and above
    double homeSwitch = 0;              ///< its edge, see homeSwitchActive()
    double homeCamWidth = 0;            ///< of methods 7 … 14 and 23 … 30; 0: a quarter of a turn
    double indexOffset = -1;            ///< of the index pulse in a turn; below 0: a quarter of a turn
    Time bootTime = 100ms;              ///< from power-on to the boot-up message
    std::uint64_t seed = 1;             ///< of the torque ripple
};

/// States of CiA 402.
enum class DriveState : std::uint8_t {
    NotReady, SwitchOnDisabled, ReadyToSwitchOn, SwitchedOn, OperationEnabled, QuickStopActive, FaultReaction, Fault,
};

/// A CiA 402 servo drive with its motor and machine, on the wire as a CANopen slave: profile position, profile velocity and
/// homing, the 45 parameters of the Kinco list (KS-MC-15), limit and home switches, following error, fault reaction, life
/// guarding. docs/canopen.md tells units and what is ours. One thread; time passed in.
class SimulatedDrive final : private SlaveApplication {
public:
    SimulatedDrive(const SimulatedDriveConfig& config, CanPort& port);
    SimulatedDrive(const SimulatedDrive&) = delete;
    SimulatedDrive& operator=(const SimulatedDrive&) = delete;

    /// Boot-up follows after config.bootTime. Parameters are those saved last (0x1010), else the defaults.
    void powerOn(Time now);
    void powerOff();
    void receive(const CanFrame& frame, Time now);
    /// One millisecond of drive and plant ending at `now`; then PDOs and timers. Call each millisecond.
    void step(Time now);

    DriveState state() const { return m_state; }
    const SimulatedDriveConfig& config() const { return m_config; }
    CanopenSlave& slave() { return m_slave; }
    const CanopenSlave& slave() const { return m_slave; }
    const ObjectDictionary& objects() const { return m_dictionary; }
    bool isHomed() const { return m_homed; }

    /// The simulated truth, plant coordinates: counts, counts/s, share of rated torque.
    double plantPosition() const { return m_plant.position(); }
    double plantVelocity() const { return m_plant.velocity(); }
    double plantTorque() const { return m_plant.torque(); }

    /// A fault as the drive itself would find it (CiA 402 error code, e.g. 16#4310 over-temperature).
    void injectFault(std::uint16_t errorCode, Time now);
    /// The shaft cannot move: what a jammed machine looks like.
    void setBlocked(bool blocked) { m_plant.setBlocked(blocked); }

    void save(ByteWriter& writer) const;
    void restore(ByteReader& reader);

private:
    /// Why the axis ramps down although its state still is an enabled one.
    enum class Leaving : std::uint8_t { No, ToSwitchedOn, ToReady, ToDisabled, QuickStop, Fault };
    enum class HomingPhase : std::uint8_t { None, Searching, Braking, Returning, Attained, Failed };

    SdoAbort checkWrite(ObjectId id, std::int64_t value) override;
    void written(ObjectId id, std::int64_t value) override;
    void nmtChanged(NmtState state) override;
    void resetNode() override;
    void lifeGuardChanged(bool lost) override;

    // The state machine of CiA 402 (drivestates.cpp).
    void controlWordWritten(std::uint16_t word);
    void commandInEnabled(std::uint16_t word);
    void quickStop();
    void leave(Leaving leaving, bool ramp, double deceleration);
    void finishLeaving();
    void enterState(DriveState state);
    void connectionLost();
    void fault(std::uint16_t errorCode);
    void resetFault();
    bool isEnabled() const;

    // Modes of operation (driveoperation.cpp).
    void takeMode();
    void setHalted(bool halted);
    void acceptSetPoint(bool immediately, bool relative);
    void startMove(double target);
    void resumeMove();
    void startHoming();
    void cancelHoming();
    void operate();
    void operatePosition();
    void operateVelocity();
    void operateHoming();
    void finishHoming();
    void holdAtLimits();
    void superviseFollowing();
    bool limitAhead(double direction) const;
    bool clampToSoftLimits(double& target) const;
    MotionLimits profileLimits(double velocity) const;

    void initialise();
    void publish();
    std::uint16_t statusWord();
    std::uint16_t modeBits();
    bool positionReached();
    std::uint32_t digitalInputs() const;
    HomingMachine machine() const;
    Bytes storedParameters() const;
    void loadParameters(bool saved);
    double direction() const { return m_dictionary.number(m_slots.polarity) == 0 ? 1.0 : -1.0; }
    double drivePosition() const { return direction() * m_plant.position() + m_offset; }
    double number(ObjectDictionary::Slot slot) const { return static_cast<double>(m_dictionary.number(slot)); }
    double ramp(ObjectDictionary::Slot slot) const { return number(slot) < 1 ? 1.0 : number(slot); }

    SimulatedDriveConfig m_config;
    ObjectDictionary m_dictionary;
    CanopenSlave m_slave;
    DriveSlots m_slots;
    ServoPlant m_plant;
    TrapezoidMotion m_motion;     ///< the reference, drive counts
    HomingSequence m_homing;
    Bytes m_savedParameters;      ///< what 0x1010 stored

    DriveState m_state = DriveState::NotReady;
    Leaving m_leaving = Leaving::No;
    HomingPhase m_homingPhase = HomingPhase::None;
    bool m_powered = false;
    Time m_now{0};
    Time m_bootAt{0};
    std::uint16_t m_controlWord = 0;
    std::int8_t m_mode = 0;
    std::uint16_t m_errorCode = 0;
    double m_offset = 0;          ///< drive position = direction * plant position + offset
    double m_target = 0;          ///< of the present set-point
    double m_nextTarget = 0;
    bool m_hasNext = false;
    bool m_acknowledge = false;
    bool m_moving = false;        ///< the set-point is not reached yet
    bool m_halted = false;
    bool m_internalLimit = false;
    bool m_homed = false;
    bool m_followingError = false;
    bool m_replan = false;        ///< the speed commanded by velocity mode or homing has to be taken anew
    double m_speedCommand = 0;
    Time m_inWindowSince{-1};     ///< below 0: outside
};

} // namespace camwright
