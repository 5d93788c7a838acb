#pragma once

#include "core/model/objects.h"

#include <QString>

#include <optional>
#include <string>

namespace camwright {

/// What the panel takes from the project's axis: units, first values of its fields, limit switches of the simulated machine.
struct AxisLimits {
    QString unit;                          ///< "mm", "°"
    double perTurn = 1;                    ///< user units per motor turn
    double highestSpeed = 50;              ///< user units per second; more is refused in the field
    double firstMaxSpeed = 10;
    double acceleration = 20;              ///< of the estimate, user units per second squared
    bool drivesOwnAcceleration = true;     ///< Kinco: the drive's, set by parameters, not by a command
    std::optional<double> lower, upper;    ///< limit switches, where they mean something
    bool operator==(const AxisLimits&) const = default;
};

AxisLimits axisLimits(const Axis& axis, const std::string& family, bool simulated);

} // namespace camwright
