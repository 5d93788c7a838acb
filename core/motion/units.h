#pragma once

#include <cstdint>

namespace camwright {

/// Scale of an axis from the motion network window (KS-MCN): encoder pulses and user units (mm or degree) per motor turn.
/// Both positive and finite. Inferred (KS-MCN-12): pulses = value * resolution / equivalent.
struct AxisScale {
    double countsPerTurn = 10000;
    double unitsPerTurn = 1;

    bool isValid() const;
    double countsPerUnit() const { return countsPerTurn / unitsPerTurn; }
    double unitsPerCount() const { return unitsPerTurn / countsPerTurn; }
    double toCounts(double units) const { return units * countsPerTurn / unitsPerTurn; }
    double toUnits(double counts) const { return counts * unitsPerTurn / countsPerTurn; }
    /// The program's mm/min or degree/min to the drive's counts/s and back.
    double perMinuteToCountsPerSecond(double unitsPerMinute) const { return toCounts(unitsPerMinute) / 60.0; }
    double countsPerSecondToPerMinute(double countsPerSecond) const { return toUnits(countsPerSecond) * 60.0; }
    double perMinuteToTurnsPerMinute(double unitsPerMinute) const { return unitsPerMinute / unitsPerTurn; }
    bool operator==(const AxisScale&) const = default;
};

/// Nearest integer, halves away from zero; NaN gives 0, too large values the nearest bound (CONTRACTS 12).
std::int64_t roundToInt64(double value);
std::int32_t roundToInt32(double value);
std::uint32_t roundToUint32(double value);

/// What a drive parameter's number means, for MC_RPARAS and MC_WPARAS (KS-MC-14). The factors are ours: the manual prints none.
enum class DriveQuantity : std::uint8_t {
    Raw,               ///< the integer as it is
    Position,          ///< mm or degree <-> counts
    SpeedPerMinute,    ///< mm/min or degree/min <-> counts/s
    Acceleration,      ///< mm/s² or degree/s² <-> counts/s²
    GainHz,            ///< Hz <-> 0.01 Hz
    FeedForwardPercent,///< % <-> 1/256
    FilterHz,          ///< Hz <-> (f - 100) / 20, the drive's filter steps
};

/// The quantity of a Kinco drive parameter, number 0 … 44; Raw for any other.
DriveQuantity kincoParameterQuantity(unsigned number);
/// The same by object, as 16#60830020 of the parameter list has it in its upper 24 bits.
DriveQuantity kincoObjectQuantity(std::uint16_t index, std::uint8_t sub);

double driveToProcess(DriveQuantity quantity, double driveValue, const AxisScale& scale);
/// Rounded and saturated to 64 bits; the drive checks its own range.
std::int64_t processToDrive(DriveQuantity quantity, double processValue, const AxisScale& scale);

} // namespace camwright
