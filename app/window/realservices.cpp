#include "app/window/realservices.h"

#include "core/checks/checkproject.h"
#include "core/language/compile.h"
#include "devices/session/connect.h"

namespace camwright {

namespace {

Diagnostics checkEverything(const Project& project)
{
    Diagnostics out = checkProject(project);
    for (const ObjectPtr& object : project.objects(ObjectKind::Program)) {
        if (const auto* program = std::get_if<Program>(&object->content)) {
            const Diagnostics found = checkProgramText(project, object->key, program->source);
            out.insert(out.end(), found.begin(), found.end());
        }
    }
    return out;
}

BuildOutcome buildImage(const Project& project, Job& job)
{
    Validation validation = validate(project);
    BuildOutcome out;
    out.diagnostics = std::move(validation.diagnostics);
    if (!validation.project) {
        out.diagnostics = checkEverything(project); // the programs' errors too, all at once
        return out;
    }
    CompileResult result = compile(*validation.project, {}, job);
    out.diagnostics.insert(out.diagnostics.end(), result.diagnostics.begin(), result.diagnostics.end());
    if (result.image)
        out.package = DownloadPackage{write(*result.image), programHash(*result.image)};
    return out;
}

} // namespace

Services RealServices::services()
{
    Services out;
    out.check = checkEverything;
    out.build = buildImage;
    out.connectTo = [this](const std::string& address, const std::string& projectPath) -> Result<std::unique_ptr<ControllerLink>> {
        auto session = connectTo(address, projectPath, m_executor);
        if (!session)
            return session.error();
        return std::unique_ptr<ControllerLink>(std::move(*session));
    };
    return out;
}

} // namespace camwright
