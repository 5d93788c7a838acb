#include "core/runtime/nomotion.h"

namespace camwright {

Result<void> NoMotion::panel(const input::Panel& command)
{
    if (command.kind == AxisCommandKind::Stop)
        return {};
    return diagnostic(Code::NoSuchAxis, {std::to_string(command.axis + 1), "0"});
}

Result<void> NoMotion::inject(const input::InjectFault& fault)
{
    return diagnostic(Code::NoSuchAxis, {std::to_string(fault.axis + 1), "0"});
}

} // namespace camwright
