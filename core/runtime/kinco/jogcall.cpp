#include "core/runtime/kinco/jogcall.h"

#include <cmath>

namespace camwright::kinco {

void JogCall::begin(CallContext& context)
{
    if (take(context, !std::isfinite(context.inputs.velocity), AxisState::ContinuousMotion))
        move(context);
}

void JogCall::move(CallContext& context)
{
    if (!context.inputs.exec)
        return stopAndFinish(ErrorId::None);
    if (!std::isfinite(context.inputs.velocity) || axis().motion().hasFailed())
        return stopAndFinish(ErrorId::StateNotSeen);
    axis().motion().run(roundToInt32(axis().scale().perMinuteToCountsPerSecond(context.inputs.velocity)));
}

} // namespace camwright::kinco
