#include "core/motion/units.h"

#include <cmath>
#include <limits>

namespace camwright {

namespace {

template <class Integer>
Integer roundTo(double value)
{
    // The bounds as doubles: the lower one is exact, the upper one may round up to one more than the integer holds.
    constexpr double lowest = static_cast<double>(std::numeric_limits<Integer>::min());
    constexpr double beyond = static_cast<double>(Integer(1) << (std::numeric_limits<Integer>::digits - 1)) * 2.0;
    if (std::isnan(value))
        return 0;
    const double rounded = std::round(value);
    if (rounded <= lowest)
        return std::numeric_limits<Integer>::min();
    if (rounded >= beyond)
        return std::numeric_limits<Integer>::max();
    return static_cast<Integer>(rounded);
}

bool isPositive(double value) { return std::isfinite(value) && value > 0; }

} // namespace

bool AxisScale::isValid() const { return isPositive(countsPerTurn) && isPositive(unitsPerTurn); }

std::int64_t roundToInt64(double value) { return roundTo<std::int64_t>(value); }
std::int32_t roundToInt32(double value) { return roundTo<std::int32_t>(value); }
std::uint32_t roundToUint32(double value) { return roundTo<std::uint32_t>(value); }

DriveQuantity kincoParameterQuantity(unsigned number)
{
    switch (number) {
    case 0:
    case 1: return DriveQuantity::Acceleration;
    case 2:
    case 12: return DriveQuantity::SpeedPerMinute;
    case 6:
    case 10: return DriveQuantity::GainHz;
    case 7: return DriveQuantity::FeedForwardPercent;
    case 16:
    case 17: return DriveQuantity::Position;
    case 22: return DriveQuantity::FilterHz;
    default: return DriveQuantity::Raw;
    }
}

DriveQuantity kincoObjectQuantity(std::uint16_t index, std::uint8_t sub)
{
    switch ((std::uint32_t{index} << 8) | sub) {
    case 0x608300: return kincoParameterQuantity(0);
    case 0x608400: return kincoParameterQuantity(1);
    case 0x609901: return kincoParameterQuantity(2);
    case 0x60FB01: return kincoParameterQuantity(6);
    case 0x60FB02: return kincoParameterQuantity(7);
    case 0x234006: return kincoParameterQuantity(10);
    case 0x607F00: return kincoParameterQuantity(12);
    case 0x607D01: return kincoParameterQuantity(16);
    case 0x607D02: return kincoParameterQuantity(17);
    case 0x60F905: return kincoParameterQuantity(22);
    default: return DriveQuantity::Raw;
    }
}

double driveToProcess(DriveQuantity quantity, double driveValue, const AxisScale& scale)
{
    switch (quantity) {
    case DriveQuantity::Raw: break;
    case DriveQuantity::Position:
    case DriveQuantity::Acceleration: return scale.toUnits(driveValue);
    case DriveQuantity::SpeedPerMinute: return scale.countsPerSecondToPerMinute(driveValue);
    case DriveQuantity::GainHz: return driveValue / 100.0;
    case DriveQuantity::FeedForwardPercent: return driveValue * 100.0 / 256.0;
    case DriveQuantity::FilterHz: return driveValue * 20.0 + 100.0;
    }
    return driveValue;
}

std::int64_t processToDrive(DriveQuantity quantity, double processValue, const AxisScale& scale)
{
    switch (quantity) {
    case DriveQuantity::Raw: break;
    case DriveQuantity::Position:
    case DriveQuantity::Acceleration: return roundToInt64(scale.toCounts(processValue));
    case DriveQuantity::SpeedPerMinute: return roundToInt64(scale.perMinuteToCountsPerSecond(processValue));
    case DriveQuantity::GainHz: return roundToInt64(processValue * 100.0);
    case DriveQuantity::FeedForwardPercent: return roundToInt64(processValue * 256.0 / 100.0);
    case DriveQuantity::FilterHz: return roundToInt64((processValue - 100.0) / 20.0);
    }
    return roundToInt64(processValue);
}

} // namespace camwright
