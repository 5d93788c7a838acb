#include "core/language/compile.h"

#include "core/checks/validproject.h"
#include "core/language/check/checksources.h"
#include "core/language/imagebuilder.h"
#include "core/language/lowering/lowerprograms.h"

namespace camwright {

namespace {

std::vector<ProgramSource> sourcesOf(const ValidProject& project)
{
    std::vector<ProgramSource> sources;
    for (const ValidProgram& program : project.programs())
        sources.push_back({program.key, program.role, program.source});
    return sources;
}

void reportNotSimulated(const CheckedProgram& program, Diagnostics& diagnostics)
{
    for (const CheckedNetwork& network : program.networks) {
        for (const CheckedRung& rung : network.rungs) {
            for (const CheckedStatement& statement : rung.statements) {
                if (!statement.instruction || statement.instruction->simulated)
                    continue;
                const bool isPulse = statement.instruction->needs == Capability::PulseOutputs;
                diagnostics.push_back(diagnostic(isPulse ? Code::PulseNotSimulated : Code::BlockNotSimulated,
                                                 {statement.instruction->mnemonic}, {program.key, "source", statement.range, {}}));
            }
        }
    }
}

CompileResult cancelled(CompileResult result)
{
    result.diagnostics.push_back(diagnostic(Code::Cancelled));
    return result;
}

} // namespace

CompileResult compile(const ValidProject& project, const BuildOptions& options, Job& job)
{
    CompileResult result;
    const std::optional<LanguageContext> context = contextOf(project.project());
    if (!context) {
        result.diagnostics.push_back(diagnostic(Code::InternalError, {"a valid project without a family"}));
        return result;
    }
    if (job.isCancelled())
        return cancelled(std::move(result));
    CheckedSources checked = checkSources(sourcesOf(project), *context);
    result.diagnostics = std::move(checked.diagnostics);
    job.report(0.5);
    if (!checked.programs)
        return result;
    if (options.forVirtualController) {
        for (const CheckedProgram& program : *checked.programs)
            reportNotSimulated(program, result.diagnostics);
    }
    LoweredPrograms lowered = lowerPrograms(project.family(), project.model(), *checked.programs, job);
    job.report(0.8);
    if (job.isCancelled())
        return cancelled(std::move(result));
    ControllerImage image = buildImage(project, *context, std::move(lowered), options);
    if (const Result<void> safe = verify(image); !safe)
        result.diagnostics.push_back(whyNotSafe(image, safe.error()));
    else
        result.image = std::move(image);
    job.report(1);
    return result;
}

Diagnostics checkProgramText(const Project& project, const ObjectKey& key, std::string_view text)
{
    const std::optional<LanguageContext> context = contextOf(project);
    if (!context)
        return {};
    const auto* program = project.content<Program>(key);
    return checkSource({key, program ? program->role : ProgramRole::Main, text}, *context);
}

} // namespace camwright
