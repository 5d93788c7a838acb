#include "core/runtime/kinco/restartcall.h"

namespace camwright::kinco {

namespace {

RestartError errorOfBoot(SdoStatus status)
{
    switch (status) {
    case SdoStatus::BufferFull: return RestartError::SendError;
    case SdoStatus::TimedOut: return RestartError::SdoTimeout;
    default: return RestartError::SdoAnswer;
    }
}

} // namespace

void RestartCall::begin(CallContext& context)
{
    Axis* const target = axisOf(context);
    if (!target)
        return end(RestartError::WrongAxis);
    use(*target);
    const Time timeout = std::chrono::milliseconds(context.inputs.count > 0 ? context.inputs.count : 0);
    if (!axis().master().restart(axis().node(), timeout, context.now))
        return end(RestartError::AlreadyRestarting);
    axis().stopFromOutside(AxisCause::Restarted);
}

void RestartCall::proceed(CallContext& context)
{
    const BootReport report = axis().master().bootReport(axis().node());
    if (report.running) {
        if (context.inputs.exec)
            return;
        dropped();
        return end(RestartError::Stopped);
    }
    if (!axis().isOnline() && report.status == SdoStatus::Done)
        return; // started; the axis sees it with its next cycle
    if (report.status != SdoStatus::Done)
        return end(errorOfBoot(report.status));
    axis().restarted();
    end(RestartError::None);
}

void RestartCall::dropped()
{
    axis().master().cancelRestart(axis().node());
}

} // namespace camwright::kinco
