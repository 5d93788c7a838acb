#include "core/runtime/plant/simulateddrive.h"

#include <algorithm>

// The drive's state machine (CiA 402) and what its communication tells it.

namespace camwright {

namespace {

constexpr std::uint16_t kHalt = 1U << 8;
constexpr std::uint16_t kFaultReset = 1U << 7;
constexpr std::uint16_t kStart = 1U << 4;
constexpr std::uint16_t kLifeGuardError = 0x8130;

enum class Command : std::uint8_t { Shutdown, SwitchOn, EnableOperation, QuickStop, DisableVoltage };

Command commandOf(std::uint16_t word)
{
    if ((word & 0x02) == 0)
        return Command::DisableVoltage;
    if ((word & 0x04) == 0)
        return Command::QuickStop;
    if ((word & 0x01) == 0)
        return Command::Shutdown;
    return (word & 0x08) == 0 ? Command::SwitchOn : Command::EnableOperation;
}

/// 0x1001: which group of errors a code belongs to.
std::uint8_t errorRegisterOf(std::uint16_t code)
{
    if (code == 0)
        return 0;
    switch (code >> 12) {
    case 0x2: return 0x03;
    case 0x3: return 0x05;
    case 0x4: return 0x09;
    case 0x8: return (code & 0x0F00) == 0x0100 ? 0x11 : 0x21;
    default: return 0x01;
    }
}

} // namespace

bool SimulatedDrive::isEnabled() const
{
    return m_state == DriveState::OperationEnabled || m_state == DriveState::QuickStopActive || m_state == DriveState::FaultReaction;
}

SdoAbort SimulatedDrive::checkWrite(ObjectId id, std::int64_t value)
{
    switch (id.index) {
    case 0x1010: return value == kSaveSignature ? SdoAbort::None : SdoAbort::CannotTransfer;
    case 0x1011:
        if (value != kLoadSignature)
            return SdoAbort::CannotTransfer;
        return isEnabled() ? SdoAbort::DeviceState : SdoAbort::None;
    case 0x6060: return value == 0 || value == 1 || value == 3 || value == 6 ? SdoAbort::None : SdoAbort::ValueRange;
    case 0x6098: return isHomingMethodSupported(static_cast<int>(value)) ? SdoAbort::None : SdoAbort::ValueRange;
    case 0x607E: return isEnabled() && value != m_dictionary.number(m_slots.polarity) ? SdoAbort::DeviceState : SdoAbort::None;
    default: return SdoAbort::None;
    }
}

void SimulatedDrive::written(ObjectId id, std::int64_t value)
{
    switch (id.index) {
    case 0x1010:
        m_savedParameters = storedParameters();
        m_dictionary.setNumber(id, 1); // read: "saves on command"
        return;
    case 0x1011:
        loadParameters(false);
        m_dictionary.setNumber(id, 1);
        return;
    case 0x6040: return controlWordWritten(static_cast<std::uint16_t>(value));
    case 0x6060: return takeMode();
    case 0x6083:
    case 0x6084: m_replan = true; return;
    default: return;
    }
}

void SimulatedDrive::nmtChanged(NmtState state)
{
    if (state == NmtState::Stopped)
        connectionLost();
}

void SimulatedDrive::resetNode() { initialise(); }

void SimulatedDrive::lifeGuardChanged(bool lost)
{
    if (lost)
        connectionLost();
}

/// 0x6007: what to do when the master is gone.
void SimulatedDrive::connectionLost()
{
    switch (m_dictionary.number(m_slots.abortOption)) {
    case 1: return fault(kLifeGuardError);
    case 2:
        if (m_state != DriveState::Fault && m_state != DriveState::FaultReaction && m_state != DriveState::NotReady)
            enterState(DriveState::SwitchOnDisabled);
        return;
    case 3:
        if (m_state == DriveState::OperationEnabled)
            quickStop();
        return;
    default: return;
    }
}

void SimulatedDrive::enterState(DriveState state)
{
    const bool wasEnabled = isEnabled();
    m_state = state;
    m_leaving = Leaving::No;
    if (state == DriveState::OperationEnabled && !wasEnabled) {
        m_motion.reset(drivePosition());
        m_target = drivePosition();
        m_hasNext = m_acknowledge = m_moving = m_internalLimit = m_followingError = false;
        m_halted = (m_controlWord & kHalt) != 0;
        m_replan = true;
        m_inWindowSince = Time{-1};
    }
    if (!isEnabled()) {
        cancelHoming();
        m_moving = m_hasNext = m_acknowledge = false;
    }
}

void SimulatedDrive::controlWordWritten(std::uint16_t word)
{
    takeMode();
    const std::uint16_t previous = m_controlWord;
    m_controlWord = word;
    const Command command = commandOf(word);
    switch (m_state) {
    case DriveState::NotReady:
    case DriveState::FaultReaction: return;
    case DriveState::Fault:
        if ((word & kFaultReset) != 0 && (previous & kFaultReset) == 0)
            resetFault();
        return;
    case DriveState::SwitchOnDisabled:
        if (command == Command::Shutdown)
            enterState(DriveState::ReadyToSwitchOn);
        return;
    case DriveState::ReadyToSwitchOn:
    case DriveState::SwitchedOn:
        switch (command) {
        case Command::Shutdown: return enterState(DriveState::ReadyToSwitchOn);
        case Command::SwitchOn: return enterState(DriveState::SwitchedOn);
        case Command::EnableOperation: return enterState(DriveState::OperationEnabled);
        default: return enterState(DriveState::SwitchOnDisabled);
        }
    case DriveState::QuickStopActive:
        if (command == Command::DisableVoltage)
            return enterState(DriveState::SwitchOnDisabled);
        if (command == Command::EnableOperation && m_dictionary.number(m_slots.quickStopOption) >= 5) {
            m_state = DriveState::OperationEnabled;
            m_leaving = Leaving::No;
            m_replan = true;
        }
        return;
    case DriveState::OperationEnabled: break;
    }
    switch (command) {
    case Command::DisableVoltage: return enterState(DriveState::SwitchOnDisabled);
    case Command::QuickStop: return quickStop();
    case Command::Shutdown:
        return leave(Leaving::ToReady, m_dictionary.number(m_slots.shutdownOption) == 1, ramp(m_slots.deceleration));
    case Command::SwitchOn:
        return leave(Leaving::ToSwitchedOn, m_dictionary.number(m_slots.disableOption) == 1, ramp(m_slots.deceleration));
    case Command::EnableOperation: break;
    }
    m_leaving = Leaving::No;
    const bool risen = (word & kStart) != 0 && (previous & kStart) == 0;
    commandInEnabled(static_cast<std::uint16_t>(risen ? word : word & ~kStart));
}

/// The mode's own bits; the start bit stands only when it has just risen.
void SimulatedDrive::commandInEnabled(std::uint16_t word)
{
    const bool start = (word & kStart) != 0;
    const bool startHeld = (m_controlWord & kStart) != 0;
    if (m_mode == 1) {
        if (start)
            acceptSetPoint((word & (1U << 5)) != 0, (word & (1U << 6)) != 0);
        else if (!startHeld && !m_hasNext)
            m_acknowledge = false;
    } else if (m_mode == 6) {
        if (start)
            startHoming();
        else if (!startHeld)
            cancelHoming();
    }
    setHalted((word & kHalt) != 0);
}

/// 0x605A: 0 no ramp; 1, 2 ramp and release; 5, 6 ramp and stay. Odd ones take the normal deceleration.
void SimulatedDrive::quickStop()
{
    const std::int64_t option = m_dictionary.number(m_slots.quickStopOption);
    if (option == 0)
        return enterState(DriveState::SwitchOnDisabled);
    m_state = DriveState::QuickStopActive;
    leave(Leaving::QuickStop, true, ramp(option == 1 || option == 5 ? m_slots.deceleration : m_slots.quickDeceleration));
}

void SimulatedDrive::leave(Leaving leaving, bool withRamp, double deceleration)
{
    cancelHoming();
    m_moving = m_hasNext = m_acknowledge = false;
    m_leaving = leaving;
    if (withRamp)
        m_motion.stop(deceleration);
    else
        finishLeaving();
}

void SimulatedDrive::finishLeaving()
{
    switch (m_leaving) {
    case Leaving::No: return;
    case Leaving::ToSwitchedOn: return enterState(DriveState::SwitchedOn);
    case Leaving::ToReady: return enterState(DriveState::ReadyToSwitchOn);
    case Leaving::ToDisabled: return enterState(DriveState::SwitchOnDisabled);
    case Leaving::QuickStop:
        if (m_dictionary.number(m_slots.quickStopOption) < 5)
            enterState(DriveState::SwitchOnDisabled);
        return;
    case Leaving::Fault: return enterState(DriveState::Fault);
    }
}

void SimulatedDrive::fault(std::uint16_t errorCode)
{
    if (m_state == DriveState::Fault || m_state == DriveState::FaultReaction || m_state == DriveState::NotReady)
        return;
    m_errorCode = errorCode;
    m_slave.sendEmergency(errorCode, errorRegisterOf(errorCode), {}, m_now);
    const std::int64_t option = m_dictionary.number(m_slots.faultOption);
    if (!isEnabled() || option == 0)
        return enterState(DriveState::Fault);
    m_state = DriveState::FaultReaction;
    leave(Leaving::Fault, true, ramp(option == 1 ? m_slots.deceleration : m_slots.quickDeceleration));
}

void SimulatedDrive::resetFault()
{
    if (m_slave.lifeLost())
        return; // the cause is still there
    m_errorCode = 0;
    m_followingError = false;
    m_slave.sendEmergency(0, 0, {}, m_now);
    enterState(DriveState::SwitchOnDisabled);
}

Bytes SimulatedDrive::storedParameters() const
{
    ByteWriter writer;
    for (std::size_t i = 0; i < m_dictionary.size(); ++i) {
        const auto slot = static_cast<ObjectDictionary::Slot>(i);
        if (isStoredParameter(m_dictionary.info(slot)))
            writer.put(m_dictionary.number(slot));
    }
    return writer.take();
}

/// The drive's objects as 0x1010 stored them, or their defaults. Communication objects are the slave's own.
void SimulatedDrive::loadParameters(bool saved)
{
    ByteReader reader(m_savedParameters);
    const bool useSaved = saved && !m_savedParameters.empty();
    for (std::size_t i = 0; i < m_dictionary.size(); ++i) {
        const auto slot = static_cast<ObjectDictionary::Slot>(i);
        const ObjectInfo& info = m_dictionary.info(slot);
        if (isStoredParameter(info))
            m_dictionary.setNumber(slot, useSaved ? reader.get<std::int64_t>() : info.initial);
        else if (info.id.index >= 0x6000 && saved)
            m_dictionary.setNumber(slot, info.initial);
    }
}

} // namespace camwright
