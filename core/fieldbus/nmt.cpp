#include "core/fieldbus/nmt.h"

namespace camwright {

CanFrame nmtFrame(NmtCommand command, std::uint8_t node)
{
    CanFrame frame;
    frame.id = kNmtId;
    frame.length = 2;
    frame.data[0] = static_cast<std::uint8_t>(command);
    frame.data[1] = node;
    return frame;
}

CanFrame guardRequest(std::uint8_t node)
{
    CanFrame frame;
    frame.id = kErrorControlId + node;
    frame.remote = true;
    frame.length = 1;
    return frame;
}

CanFrame syncFrame()
{
    CanFrame frame;
    frame.id = kSyncId;
    return frame;
}

} // namespace camwright
