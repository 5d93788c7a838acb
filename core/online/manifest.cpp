#include "core/online/manifest.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

namespace camwright {

namespace {

struct PartCodes {
    const char* noun; ///< for PlanLine::what
    Code added, changed, removed;
};

PartCodes codesOf(PartKind kind)
{
    switch (kind) {
    case PartKind::Program: return {"program ", Code::PlanProgramAdded, Code::PlanProgramChanged, Code::PlanProgramRemoved};
    case PartKind::Axis: return {"axis ", Code::PlanAxisAdded, Code::PlanAxisChanged, Code::PlanAxisRemoved};
    case PartKind::Network: return {"network ", Code::PlanNetworkChanged, Code::PlanNetworkChanged, Code::PlanNetworkChanged};
    case PartKind::Variables:
        return {"variables ", Code::PlanVariablesChanged, Code::PlanVariablesChanged, Code::PlanVariablesChanged};
    case PartKind::Controller:
        return {"controller ", Code::PlanControllerChanged, Code::PlanControllerChanged, Code::PlanControllerChanged};
    case PartKind::Retained:
        break;
    }
    return {"retained ", Code::PlanRetainedAdded, Code::PlanRetainedLost, Code::PlanRetainedLost};
}

PlanLine line(std::string what, Code code, std::vector<std::string> arguments)
{
    PlanLine out;
    out.what = std::move(what);
    out.message = diagnostic(code, std::move(arguments));
    out.effect = englishText(out.message);
    return out;
}

using Parts = std::map<std::pair<PartKind, std::string>, Hash>;

Parts partsOf(const Manifest& manifest)
{
    Parts out;
    for (const ManifestPart& part : manifest.parts)
        out[{part.kind, part.name}] = part.hash;
    return out;
}

void compareParts(const Manifest& current, const Manifest& next, DownloadPlan& plan)
{
    const Parts before = partsOf(current);
    const Parts after = partsOf(next);
    const auto tell = [&plan](const std::pair<PartKind, std::string>& part, Code code) {
        plan.lines.push_back(line(codesOf(part.first).noun + part.second, code, {part.second}));
    };
    for (const auto& [part, hash] : after) {
        const auto old = before.find(part);
        // A retained value that is new has nothing to lose; it starts as the program says.
        if (old == before.end() && part.first != PartKind::Retained)
            tell(part, codesOf(part.first).added);
        else if (old != before.end() && old->second != hash)
            tell(part, codesOf(part.first).changed);
    }
    for (const auto& [part, hash] : before)
        if (!after.contains(part))
            tell(part, codesOf(part.first).removed);
}

} // namespace

DownloadPlan planDownload(const Manifest& current, const Manifest& next, const ControllerStatus& status)
{
    DownloadPlan plan;
    plan.sameProgram = !current.program.isNull() && current.program == next.program;
    if (status.state == RunState::Run) {
        plan.mustStop = true;
        plan.lines.push_back(line("controller", Code::PlanStops, {}));
    }
    for (const AxisStatus& axis : status.axes)
        if (axis.enabled)
            plan.lines.push_back(line("axis " + axis.name, Code::PlanAxisReleased, {axis.name}));
    compareParts(current, next, plan);
    for (const AxisStatus& axis : status.axes)
        if (axis.homed)
            plan.lines.push_back(line("axis " + axis.name, Code::PlanHomeLost, {axis.name}));
    if (status.forces > 0)
        plan.lines.push_back(line("forces", Code::PlanForcesDropped, {std::to_string(status.forces)}));
    return plan;
}

} // namespace camwright
