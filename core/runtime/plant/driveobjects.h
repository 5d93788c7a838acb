#pragma once

#include "core/fieldbus/objectdictionary.h"

namespace camwright {

/// Slots of the objects the simulated drive works with, looked up once.
/// Slots of the objects the simulated drive works with, looked up once. Each name is one object of docs/canopen.md.
struct DriveSlots {
    using Slot = ObjectDictionary::Slot;
    Slot abortOption = ObjectDictionary::kNone; ///< 0x6007:00
    Slot errorCode = ObjectDictionary::kNone; ///< 0x603F:00
    Slot controlWord = ObjectDictionary::kNone; ///< 0x6040:00
    Slot statusWord = ObjectDictionary::kNone; ///< 0x6041:00
    Slot quickStopOption = ObjectDictionary::kNone; ///< 0x605A:00
    Slot shutdownOption = ObjectDictionary::kNone; ///< 0x605B:00
    Slot disableOption = ObjectDictionary::kNone; ///< 0x605C:00
    Slot haltOption = ObjectDictionary::kNone; ///< 0x605D:00
    Slot faultOption = ObjectDictionary::kNone; ///< 0x605E:00
    Slot mode = ObjectDictionary::kNone; ///< 0x6060:00
    Slot modeDisplay = ObjectDictionary::kNone; ///< 0x6061:00
    Slot demandPosition = ObjectDictionary::kNone; ///< 0x6062:00
    Slot encoderPosition = ObjectDictionary::kNone; ///< 0x6063:00
    Slot position = ObjectDictionary::kNone; ///< 0x6064:00
    Slot followingWindow = ObjectDictionary::kNone; ///< 0x6065:00
    Slot positionWindow = ObjectDictionary::kNone; ///< 0x6067:00
    Slot windowTime = ObjectDictionary::kNone; ///< 0x6068:00
    Slot demandVelocity = ObjectDictionary::kNone; ///< 0x606B:00
    Slot velocity = ObjectDictionary::kNone; ///< 0x606C:00
    Slot velocityWindow = ObjectDictionary::kNone; ///< 0x606D:00
    Slot currentLimit = ObjectDictionary::kNone; ///< 0x6073:00
    Slot torque = ObjectDictionary::kNone; ///< 0x6078:00
    Slot targetPosition = ObjectDictionary::kNone; ///< 0x607A:00
    Slot homeOffset = ObjectDictionary::kNone; ///< 0x607C:00
    Slot softPositive = ObjectDictionary::kNone; ///< 0x607D:01
    Slot softNegative = ObjectDictionary::kNone; ///< 0x607D:02
    Slot polarity = ObjectDictionary::kNone; ///< 0x607E:00
    Slot maximumSpeed = ObjectDictionary::kNone; ///< 0x607F:00
    Slot profileVelocity = ObjectDictionary::kNone; ///< 0x6081:00
    Slot acceleration = ObjectDictionary::kNone; ///< 0x6083:00
    Slot deceleration = ObjectDictionary::kNone; ///< 0x6084:00
    Slot quickDeceleration = ObjectDictionary::kNone; ///< 0x6085:00
    Slot homingMethod = ObjectDictionary::kNone; ///< 0x6098:00
    Slot homingFast = ObjectDictionary::kNone; ///< 0x6099:01
    Slot homingSlow = ObjectDictionary::kNone; ///< 0x6099:02
    Slot homingAfter = ObjectDictionary::kNone; ///< 0x6099:05
    Slot homingAcceleration = ObjectDictionary::kNone; ///< 0x609A:00
    Slot followingError = ObjectDictionary::kNone; ///< 0x60F4:00
    Slot velocityGain = ObjectDictionary::kNone; ///< 0x60F9:01
    Slot positionGain = ObjectDictionary::kNone; ///< 0x60FB:01
    Slot feedForward = ObjectDictionary::kNone; ///< 0x60FB:02
    Slot digitalInputs = ObjectDictionary::kNone; ///< 0x60FD:00
    Slot targetVelocity = ObjectDictionary::kNone; ///< 0x60FF:00
};

/// Adds the drive's objects with their ranges and defaults (docs/canopen.md), among them the 45 of kinco_drive_parameters.csv.
void addDriveObjects(ObjectDictionary& dictionary, double countsPerTurn);
DriveSlots findDriveSlots(const ObjectDictionary& dictionary);

/// The objects 0x1010 stores and 0x1011 restores: every writable one of the drive that is no command.
bool isStoredParameter(const ObjectInfo& info);

inline constexpr std::uint32_t kSaveSignature = 0x65766173; ///< "save" (KS-MC-15, parameter 43)
inline constexpr std::uint32_t kLoadSignature = 0x64616F6C; ///< "load" (parameter 44)

} // namespace camwright
