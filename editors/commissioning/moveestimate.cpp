#include "editors/commissioning/moveestimate.h"

#include <cmath>

namespace camwright {

MoveEstimate estimateMove(double distance, double velocity, double acceleration)
{
    const double way = std::abs(distance);
    if (!(way > 0) || !(velocity > 0) || !(acceleration > 0) || !std::isfinite(way))
        return {};
    MoveEstimate out;
    out.topVelocity = std::fmin(velocity, std::sqrt(way * acceleration));
    out.rampTime = out.topVelocity / acceleration;
    out.duration = way / out.topVelocity + out.rampTime;
    return out;
}

double stoppingDistance(double velocity, double deceleration)
{
    if (!(deceleration > 0))
        return 0;
    return velocity * std::abs(velocity) / (2 * deceleration);
}

} // namespace camwright
