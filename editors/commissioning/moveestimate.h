#pragma once

namespace camwright {

/// How a move at trapezoidal velocity goes from rest to rest. Units: the axis's own, seconds.
struct MoveEstimate {
    double duration = 0;      ///< 0: nothing to do, or a number that is not positive
    double rampTime = 0;      ///< of either ramp
    double topVelocity = 0;   ///< reached; less than asked for where the way is short
};

MoveEstimate estimateMove(double distance, double velocity, double acceleration);
/// The way from `velocity` to rest, signed as the velocity.
double stoppingDistance(double velocity, double deceleration);

} // namespace camwright
