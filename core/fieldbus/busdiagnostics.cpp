#include "core/fieldbus/canopenmaster.h"

#include <fmt/format.h>

namespace camwright {

namespace {

std::string objectName(ObjectId object) { return fmt::format("0x{:04X}:{:02X}", object.index, object.sub); }

} // namespace

Diagnostic sdoDiagnostic(std::uint8_t node, ObjectId object, SdoStatus status, SdoAbort abort)
{
    const std::string number = fmt::format("{}", node);
    switch (status) {
    case SdoStatus::Aborted:
        return diagnostic(Code::NodeRefusesObject,
            {number, objectName(object), fmt::format("0x{:08X}", static_cast<std::uint32_t>(abort)), std::string(sdoAbortText(abort))});
    case SdoStatus::TimedOut: return diagnostic(Code::NodeDoesNotAnswer, {number, objectName(object)});
    case SdoStatus::Malformed: return diagnostic(Code::NodeAnswersWrongly, {number, objectName(object)});
    case SdoStatus::BufferFull: return diagnostic(Code::SendBufferFull, {number});
    case SdoStatus::Busy:
    case SdoStatus::Pending: return diagnostic(Code::NodeHasRequest, {number});
    case SdoStatus::NoNode: return diagnostic(Code::NoSuchNode, {number});
    case SdoStatus::Cancelled: return diagnostic(Code::NodeRequestCancelled, {number, objectName(object)});
    case SdoStatus::Done: break;
    }
    return diagnostic(Code::NodeStarted, {number});
}

Diagnostic bootDiagnostic(std::uint8_t node, const BootReport& report)
{
    return sdoDiagnostic(node, report.object, report.status, report.abort);
}

Diagnostic emergencyDiagnostic(const Emergency& emergency)
{
    const std::string number = fmt::format("{}", emergency.node);
    if (emergency.errorCode == 0)
        return diagnostic(Code::NodeErrorGone, {number});
    return diagnostic(Code::NodeEmergency,
        {number, fmt::format("16#{:04X}", emergency.errorCode), fmt::format("16#{:02X}", emergency.errorRegister)});
}

} // namespace camwright
