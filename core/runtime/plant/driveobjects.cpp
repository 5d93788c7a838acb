#include "core/runtime/plant/driveobjects.h"

#include <algorithm>
#include <array>

namespace camwright {

namespace {

/// A default that scales with the encoder: turns are turns on every axis.
enum class Per : std::uint8_t { Fixed, Turn, ThousandthTurn };

struct Row {
    std::uint16_t index;
    std::uint8_t sub;
    DataType type;
    ObjectAccess access;
    bool mappable;
    std::int64_t minimum;
    std::int64_t maximum;
    std::int64_t initial;
    Per per;
};

constexpr std::int64_t kInt32Min = -2147483648LL;
constexpr std::int64_t kInt32Max = 2147483647LL;
constexpr std::int64_t kUint32Max = 4294967295LL;
constexpr auto rw = ObjectAccess::ReadWrite;
constexpr auto ro = ObjectAccess::ReadOnly;
constexpr auto constant = ObjectAccess::Constant;

// Ranges of the 45 parameters from kinco_drive_parameters.csv (KS-MC-15); the other objects from CiA 402. Defaults are ours.
constexpr Row kRows[] = {
    {0x1010, 0, DataType::Usint, constant, false, 0, 255, 1, Per::Fixed},
    {0x1010, 1, DataType::Udint, rw, false, 0, kUint32Max, 1, Per::Fixed},
    {0x1011, 0, DataType::Usint, constant, false, 0, 255, 1, Per::Fixed},
    {0x1011, 1, DataType::Udint, rw, false, 0, kUint32Max, 1, Per::Fixed},
    {0x2010, 0, DataType::Usint, constant, false, 0, 255, 0x1F, Per::Fixed},
    {0x2010, 0x01, DataType::Uint, rw, false, 0, 255, 255, Per::Fixed},
    {0x2010, 0x0D, DataType::Uint, rw, false, 0, 255, 255, Per::Fixed},
    {0x2340, 0, DataType::Usint, constant, false, 0, 255, 6, Per::Fixed},
    {0x2340, 0x04, DataType::Uint, rw, false, 0, 32767, 100, Per::Fixed},
    {0x2340, 0x05, DataType::Uint, rw, false, 0, 32767, 5, Per::Fixed},
    {0x2340, 0x06, DataType::Uint, rw, false, 0, 32767, 1000, Per::Fixed},
    {0x2508, 0, DataType::Usint, constant, false, 0, 255, 4, Per::Fixed},
    {0x2508, 0x03, DataType::Usint, rw, false, 0, 255, 1, Per::Fixed},
    {0x2508, 0x04, DataType::Dint, rw, false, kInt32Min, kInt32Max, 0, Per::Fixed},
    {0x6007, 0, DataType::Int, rw, false, 0, 3, 1, Per::Fixed},
    {0x603F, 0, DataType::Uint, ro, true, 0, 65535, 0, Per::Fixed},
    {0x6040, 0, DataType::Uint, rw, true, 0, 65535, 0, Per::Fixed},
    {0x6041, 0, DataType::Uint, ro, true, 0, 65535, 0, Per::Fixed},
    {0x605A, 0, DataType::Int, rw, false, 0, 6, 2, Per::Fixed},
    {0x605B, 0, DataType::Int, rw, false, 0, 1, 0, Per::Fixed},
    {0x605C, 0, DataType::Int, rw, false, 0, 1, 1, Per::Fixed},
    {0x605D, 0, DataType::Int, rw, false, 1, 2, 1, Per::Fixed},
    {0x605E, 0, DataType::Int, rw, false, 0, 2, 2, Per::Fixed},
    {0x6060, 0, DataType::Sint, rw, true, 0, 6, 0, Per::Fixed},
    {0x6061, 0, DataType::Sint, ro, true, -128, 127, 0, Per::Fixed},
    {0x6062, 0, DataType::Dint, ro, true, kInt32Min, kInt32Max, 0, Per::Fixed},
    {0x6063, 0, DataType::Dint, ro, true, kInt32Min, kInt32Max, 0, Per::Fixed},
    {0x6064, 0, DataType::Dint, ro, true, kInt32Min, kInt32Max, 0, Per::Fixed},
    {0x6065, 0, DataType::Udint, rw, false, 0, 268435455, 1, Per::Turn},
    {0x6067, 0, DataType::Udint, rw, false, 0, 268435455, 1, Per::ThousandthTurn},
    {0x6068, 0, DataType::Uint, rw, false, 0, 32767, 10, Per::Fixed},
    {0x606B, 0, DataType::Dint, ro, true, kInt32Min, kInt32Max, 0, Per::Fixed},
    {0x606C, 0, DataType::Dint, ro, true, kInt32Min, kInt32Max, 0, Per::Fixed},
    {0x606D, 0, DataType::Uint, rw, false, 0, 65535, 10, Per::ThousandthTurn},
    {0x6073, 0, DataType::Uint, rw, false, 0, 2048, 2048, Per::Fixed},
    {0x6078, 0, DataType::Int, ro, true, -32768, 32767, 0, Per::Fixed},
    {0x607A, 0, DataType::Dint, rw, true, kInt32Min, kInt32Max, 0, Per::Fixed},
    {0x607C, 0, DataType::Dint, rw, false, kInt32Min, kInt32Max, 0, Per::Fixed},
    {0x607D, 0, DataType::Usint, constant, false, 0, 255, 2, Per::Fixed},
    {0x607D, 0x01, DataType::Dint, rw, false, kInt32Min, kInt32Max, 0, Per::Fixed},
    {0x607D, 0x02, DataType::Dint, rw, false, kInt32Min, kInt32Max, 0, Per::Fixed},
    {0x607E, 0, DataType::Usint, rw, false, 0, 1, 0, Per::Fixed},
    {0x607F, 0, DataType::Dint, rw, false, kInt32Min, kInt32Max, 100, Per::Turn},
    {0x6081, 0, DataType::Udint, rw, true, 0, kUint32Max, 1, Per::Turn},
    {0x6083, 0, DataType::Udint, rw, true, 0, 268435455, 20, Per::Turn},
    {0x6084, 0, DataType::Udint, rw, true, 0, 268435455, 20, Per::Turn},
    {0x6085, 0, DataType::Udint, rw, false, 0, 268435455, 100, Per::Turn},
    {0x6098, 0, DataType::Sint, rw, false, -128, 127, 35, Per::Fixed},
    {0x6099, 0, DataType::Usint, constant, false, 0, 255, 5, Per::Fixed},
    {0x6099, 0x01, DataType::Dint, rw, false, kInt32Min, kInt32Max, 5, Per::Turn},
    {0x6099, 0x02, DataType::Dint, rw, false, kInt32Min, kInt32Max, 1, Per::Turn},
    {0x6099, 0x05, DataType::Usint, rw, false, 0, 255, 0, Per::Fixed},
    {0x609A, 0, DataType::Udint, rw, false, 0, 268435455, 20, Per::Turn},
    {0x60F4, 0, DataType::Dint, ro, true, kInt32Min, kInt32Max, 0, Per::Fixed},
    {0x60F9, 0, DataType::Usint, constant, false, 0, 255, 6, Per::Fixed},
    {0x60F9, 0x01, DataType::Uint, rw, false, 0, 32767, 100, Per::Fixed},
    {0x60F9, 0x02, DataType::Uint, rw, false, 0, 32767, 5, Per::Fixed},
    {0x60F9, 0x05, DataType::Usint, rw, false, 0, 45, 7, Per::Fixed},
    {0x60F9, 0x06, DataType::Usint, rw, false, 0, 85, 0, Per::Fixed},
    {0x60FB, 0, DataType::Usint, constant, false, 0, 255, 5, Per::Fixed},
    {0x60FB, 0x01, DataType::Uint, rw, false, 0, 32767, 1000, Per::Fixed},
    {0x60FB, 0x02, DataType::Uint, rw, false, 0, 1024, 230, Per::Fixed},
    {0x60FB, 0x05, DataType::Uint, rw, false, 0, 255, 1, Per::Fixed},
    {0x60FD, 0, DataType::Udint, ro, true, 0, kUint32Max, 0, Per::Fixed},
    {0x60FF, 0, DataType::Dint, rw, true, kInt32Min, kInt32Max, 0, Per::Fixed},
    {0x6410, 0, DataType::Usint, constant, false, 0, 255, 1, Per::Fixed},
    {0x6410, 0x01, DataType::Uint, rw, false, 0, 65535, 0, Per::Fixed},
    {0x6502, 0, DataType::Udint, constant, false, 0, kUint32Max, 0x25, Per::Fixed}, // profile position and velocity, homing
};

/// Functions of the terminals, parameters 25 to 32 and 34 to 40: kept, without effect on the simulation.
constexpr std::uint8_t kTerminalFunctions[] = {0x03, 0x04, 0x05, 0x06, 0x07, 0x08, 0x09, 0x1D, 0x0F, 0x10, 0x11, 0x12, 0x13, 0x1E, 0x1F};

std::int64_t defaultOf(const Row& row, double countsPerTurn)
{
    double value = static_cast<double>(row.initial);
    if (row.per == Per::Turn)
        value *= countsPerTurn;
    else if (row.per == Per::ThousandthTurn)
        value = value * countsPerTurn / 1000 < 1 ? 1 : value * countsPerTurn / 1000;
    const double highest = static_cast<double>(row.maximum);
    return static_cast<std::int64_t>(std::min(value, highest));
}

void addRow(ObjectDictionary& dictionary, const Row& row, double countsPerTurn)
{
    ObjectInfo info;
    info.id = {row.index, row.sub};
    info.type = row.type;
    info.access = row.access;
    info.mappable = row.mappable;
    info.minimum = row.minimum;
    info.maximum = row.maximum;
    info.initial = defaultOf(row, countsPerTurn);
    dictionary.add(std::move(info));
}

bool isCommand(ObjectId id)
{
    return id.index == 0x6040 || id.index == 0x6060 || id.index == 0x607A || id.index == 0x60FF || id.index == 0x6081;
}

} // namespace

void addDriveObjects(ObjectDictionary& dictionary, double countsPerTurn)
{
    for (const Row& row : kRows)
        addRow(dictionary, row, countsPerTurn);
    for (const std::uint8_t sub : kTerminalFunctions)
        addRow(dictionary, {0x2010, sub, DataType::Uint, rw, false, 0, 65535, 0, Per::Fixed}, countsPerTurn);
}

DriveSlots findDriveSlots(const ObjectDictionary& dictionary)
{
    DriveSlots slots;
    slots.abortOption = dictionary.find({0x6007, 0});
    slots.errorCode = dictionary.find({0x603F, 0});
    slots.controlWord = dictionary.find({0x6040, 0});
    slots.statusWord = dictionary.find({0x6041, 0});
    slots.quickStopOption = dictionary.find({0x605A, 0});
    slots.shutdownOption = dictionary.find({0x605B, 0});
    slots.disableOption = dictionary.find({0x605C, 0});
    slots.haltOption = dictionary.find({0x605D, 0});
    slots.faultOption = dictionary.find({0x605E, 0});
    slots.mode = dictionary.find({0x6060, 0});
    slots.modeDisplay = dictionary.find({0x6061, 0});
    slots.demandPosition = dictionary.find({0x6062, 0});
    slots.encoderPosition = dictionary.find({0x6063, 0});
    slots.position = dictionary.find({0x6064, 0});
    slots.followingWindow = dictionary.find({0x6065, 0});
    slots.positionWindow = dictionary.find({0x6067, 0});
    slots.windowTime = dictionary.find({0x6068, 0});
    slots.demandVelocity = dictionary.find({0x606B, 0});
    slots.velocity = dictionary.find({0x606C, 0});
    slots.velocityWindow = dictionary.find({0x606D, 0});
    slots.currentLimit = dictionary.find({0x6073, 0});
    slots.torque = dictionary.find({0x6078, 0});
    slots.targetPosition = dictionary.find({0x607A, 0});
    slots.homeOffset = dictionary.find({0x607C, 0});
    slots.softPositive = dictionary.find({0x607D, 1});
    slots.softNegative = dictionary.find({0x607D, 2});
    slots.polarity = dictionary.find({0x607E, 0});
    slots.maximumSpeed = dictionary.find({0x607F, 0});
    slots.profileVelocity = dictionary.find({0x6081, 0});
    slots.acceleration = dictionary.find({0x6083, 0});
    slots.deceleration = dictionary.find({0x6084, 0});
    slots.quickDeceleration = dictionary.find({0x6085, 0});
    slots.homingMethod = dictionary.find({0x6098, 0});
    slots.homingFast = dictionary.find({0x6099, 1});
    slots.homingSlow = dictionary.find({0x6099, 2});
    slots.homingAfter = dictionary.find({0x6099, 5});
    slots.homingAcceleration = dictionary.find({0x609A, 0});
    slots.followingError = dictionary.find({0x60F4, 0});
    slots.velocityGain = dictionary.find({0x60F9, 1});
    slots.positionGain = dictionary.find({0x60FB, 1});
    slots.feedForward = dictionary.find({0x60FB, 2});
    slots.digitalInputs = dictionary.find({0x60FD, 0});
    slots.targetVelocity = dictionary.find({0x60FF, 0});
    return slots;
}

bool isStoredParameter(const ObjectInfo& info)
{
    return info.id.index >= 0x2000 && info.access == ObjectAccess::ReadWrite && !isCommand(info.id);
}

} // namespace camwright
