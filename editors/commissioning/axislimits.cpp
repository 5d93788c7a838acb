#include "editors/commissioning/axislimits.h"

#include <QCoreApplication>

namespace camwright {

namespace {

// Motor turns: the virtual controller clamps a panel's speed at 3000/min, its drives start with 20 turn/s² (0x6083).
constexpr double HighestTurnsPerSecond = 50, FirstTurnsPerSecond = 10, DriveTurnsPerSecond2 = 20;

} // namespace

AxisLimits axisLimits(const Axis& axis, const std::string& family, bool simulated)
{
    AxisLimits out;
    const bool rotary = axis.type.valueOr(AxisType::Linear) == AxisType::Rotary;
    out.unit = rotary ? QCoreApplication::translate("Commissioning", "°") : QCoreApplication::translate("Commissioning", "mm");
    const double travel = axis.mechanicalEquivalent.valueOr(1);
    out.perTurn = travel > 0 ? travel : 1;
    out.highestSpeed = HighestTurnsPerSecond * out.perTurn;
    out.firstMaxSpeed = FirstTurnsPerSecond * out.perTurn;
    out.acceleration = DriveTurnsPerSecond2 * out.perTurn;
    out.drivesOwnAcceleration = family == "kinco";
    const AxisSimulation none;
    const AxisSimulation& machine = axis.simulation;
    if (simulated && machine.lowerLimitSwitch.isValid() && machine.lowerLimitSwitch != none.lowerLimitSwitch)
        out.lower = machine.lowerLimitSwitch.value();
    if (simulated && machine.upperLimitSwitch.isValid() && machine.upperLimitSwitch != none.upperLimitSwitch)
        out.upper = machine.upperLimitSwitch.value();
    return out;
}

} // namespace camwright
