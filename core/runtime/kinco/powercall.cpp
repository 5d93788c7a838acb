#include "core/runtime/kinco/powercall.h"

namespace camwright::kinco {

namespace {
constexpr Time kPowerSupervision = 5s; // KS-MC-16
}

void PowerCall::begin(CallContext& context)
{
    Axis* const target = axisOf(context);
    if (!target)
        return finish(ErrorId::AxisAbsent);
    m_lock = context.inputs.exec;
    use(*target);
    if (!m_lock) {
        axis().setProgramPower(false);
        return;
    }
    if (!axis().isOnline())
        return finish(ErrorId::AxisAbsent);
    if (!axis().claim(self()))
        return finish(ErrorId::Busy);
    axis().setProgramPower(true);
}

void PowerCall::proceed(CallContext& context)
{
    if (!axis().isOnline())
        return finish(m_lock ? ErrorId::AxisAbsent : ErrorId::None);
    const bool reached = m_lock ? axis().isLocked() : !axis().motion().isEnabled() || axis().panelPower();
    if (reached)
        return finish();
    if (context.now - since() < kPowerSupervision)
        return;
    if (m_lock)
        axis().setProgramPower(false);
    finish(ErrorId::StateNotSeen);
}

} // namespace camwright::kinco
