#include "core/runtime/kinco/resetcall.h"

namespace camwright::kinco {

namespace {
constexpr Time kResetSupervision = 2s; // KS-MC-17
}

void ResetCall::begin(CallContext& context)
{
    Axis* const target = axisOf(context);
    if (!target || !target->isOnline())
        return finish(ErrorId::AxisAbsent);
    use(*target);
    if (!axis().claim(self()))
        return finish(ErrorId::Busy);
    axis().startReset();
}

void ResetCall::proceed(CallContext& context)
{
    if (!axis().isOnline()) {
        axis().endReset(false);
        return finish(ErrorId::AxisAbsent);
    }
    if (!axis().hasFault() && !axis().motion().isEnabled()) {
        axis().endReset(true);
        return finish();
    }
    if (context.now - since() < kResetSupervision)
        return;
    axis().endReset(false);
    finish(ErrorId::StateNotSeen);
}

} // namespace camwright::kinco
