#include "core/language/compile.h"

#include "core/checks/validproject.h"
#include "core/language/check/checksources.h"
#include "core/language/imagebuilder.h"
#include "core/language/lowering/lowerprograms.h"
#include "core/language/st/lowering/lowerst.h"
#include "core/language/stprograms.h"

#include <algorithm>
#include <utility>

namespace camwright {

namespace {

/// The programs of a project by language.
struct Sources {
    std::vector<ProgramSource> lists; ///< in the family's instruction list
    std::vector<ProgramSource> st;

    void add(const ObjectKey& key, ProgramRole role, ProgramLanguage language, std::string_view text)
    {
        (language == ProgramLanguage::StructuredText ? st : lists).push_back({key, role, text});
    }
};

Sources sourcesOf(const ValidProject& project)
{
    Sources out;
    for (const ValidProgram& program : project.programs())
        out.add(program.key, program.role, program.language, program.source);
    return out;
}

/// All of them with another text for one.
Sources sourcesOf(const Project& project, const ObjectKey& key, std::string_view text)
{
    Sources out;
    for (const ObjectPtr& object : project.objects(ObjectKind::Program)) {
        if (const auto* program = std::get_if<Program>(&object->content))
            out.add(object->key, program->role, program->language, object->key == key ? text : std::string_view(program->source));
    }
    return out;
}

/// `variableBytes`: what the variable tables take of VariablesArea; Structured Text follows, then what the lists need.
LoweredPrograms lower(const ValidProject& project, const std::vector<CheckedProgram>& lists, const st::Compilation* compilation,
                      std::uint32_t variableBytes, const Job& job)
{
    const std::vector<std::string> following = compilation ? st::programRoutines(*compilation) : std::vector<std::string>();
    LoweredPrograms out = lowerPrograms(project.family(), project.model(), lists, job, following,
                                        compilation ? std::max(variableBytes, compilation->variableBytes) : variableBytes);
    const std::uint32_t end = out.variableBytes;
    if (compilation && !job.isCancelled()) {
        const auto routineByName = [&lists](std::string_view name) {
            const auto found = std::ranges::find(lists, name, [](const CheckedProgram& program) { return std::string_view(program.key.name); });
            return static_cast<std::uint32_t>(found - lists.begin());
        };
        st::lowerSt(*compilation, &project.family(), routineByName, out);
    }
    out.variableBytes = std::max(out.variableBytes, end);
    return out;
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
    const Sources sources = sourcesOf(project);
    CheckedSources checked = checkSources(sources.lists, *context);
    result.diagnostics = std::move(checked.diagnostics);
    const auto compilation = sources.st.empty() ? nullptr : checkSt(sources.st, sources.lists, *context);
    if (compilation) {
        const Diagnostics said = diagnosticsOf(*compilation, *context);
        result.diagnostics.insert(result.diagnostics.end(), said.begin(), said.end());
    }
    job.report(0.5);
    if (!checked.programs || hasErrors(result.diagnostics))
        return result;
    if (options.forVirtualController) {
        for (const CheckedProgram& program : *checked.programs)
            reportNotSimulated(program, result.diagnostics);
    }
    LoweredPrograms lowered = lower(project, *checked.programs, compilation.get(), context->variableBytes, job);
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
    if (program && program->language == ProgramLanguage::StructuredText) {
        const Sources sources = sourcesOf(project, key, text);
        Diagnostics said = diagnosticsOf(*checkSt(sources.st, sources.lists, *context), *context);
        std::erase_if(said, [&](const Diagnostic& d) { return d.place.object != key; });
        return said;
    }
    return checkSource({key, program ? program->role : ProgramRole::Main, text}, *context);
}

} // namespace camwright
