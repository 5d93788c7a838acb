#pragma once

#include "core/fieldbus/objectdictionary.h"

namespace camwright {

/// Slots of the objects the simulated drive works with, looked up once.
struct DriveSlots {
    using Slot = ObjectDictionary::Slot;
    Slot errorRegister, abortOption, errorCode, controlWord, statusWord, quickStopOption, shutdownOption, disableOption, haltOption,
        faultOption, mode, modeDisplay, demandPosition, encoderPosition, position, followingWindow, positionWindow, windowTime, demandVelocity,
        velocity, velocityWindow, currentLimit, torque, targetPosition, homeOffset, softPositive, softNegative, polarity, maximumSpeed,
        profileVelocity, acceleration, deceleration, quickDeceleration, homingMethod, homingFast, homingSlow, homingAfter,
        homingAcceleration, followingError, digitalInputs, targetVelocity, positionGain, feedForward, velocityGain;
};

/// Adds the drive's objects with their ranges and defaults (docs/canopen.md), among them the 45 of kinco_drive_parameters.csv.
void addDriveObjects(ObjectDictionary& dictionary, double countsPerTurn);
DriveSlots findDriveSlots(const ObjectDictionary& dictionary);

/// The objects 0x1010 stores and 0x1011 restores: every writable one of the drive that is no command.
bool isStoredParameter(const ObjectInfo& info);

inline constexpr std::uint32_t kSaveSignature = 0x65766173; ///< "save" (KS-MC-15, parameter 43)
inline constexpr std::uint32_t kLoadSignature = 0x64616F6C; ///< "load" (parameter 44)

} // namespace camwright
