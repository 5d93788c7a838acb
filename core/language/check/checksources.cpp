#include "core/language/check/checksources.h"

#include "core/language/check/checkprogram.h"
#include "core/language/check/koyorules.h"
#include "core/language/check/projectrules.h"
#include "core/language/source/ilparser.h"

#include <utility>

namespace camwright {

namespace {

ResolvedProgram readSource(const ProgramSource& source, const LanguageContext& context, Diagnostics& diagnostics)
{
    ParsedProgram parsed = parseIl(*context.dialect, source.text, source.key);
    ResolvedProgram out = resolve(parsed, source.role, context, diagnostics);
    diagnostics.insert(diagnostics.begin(), parsed.diagnostics.begin(), parsed.diagnostics.end());
    return out;
}

void sortByPlace(Diagnostics& diagnostics, const ObjectKey& key)
{
    DiagnosticSink(diagnostics, key).sort();
}

} // namespace

CheckedSources checkSources(std::span<const ProgramSource> sources, const LanguageContext& context)
{
    CheckedSources out;
    std::vector<Diagnostics> diagnostics(sources.size());
    std::vector<ResolvedProgram> resolved;
    std::vector<CheckedProgram> checked;
    for (std::size_t i = 0; i < sources.size(); ++i) {
        resolved.push_back(readSource(sources[i], context, diagnostics[i]));
        if (auto program = checkProgram(resolved.back(), context, diagnostics[i]))
            checked.push_back(std::move(*program));
    }
    out.size = checkTogether(resolved, context, diagnostics);
    checkKoyoTogether(resolved, context, diagnostics);
    for (std::size_t i = 0; i < sources.size(); ++i) {
        sortByPlace(diagnostics[i], sources[i].key);
        out.diagnostics.insert(out.diagnostics.end(), diagnostics[i].begin(), diagnostics[i].end());
    }
    if (checked.size() == sources.size() && !hasErrors(out.diagnostics))
        out.programs = std::move(checked);
    return out;
}

Diagnostics checkSource(const ProgramSource& source, const LanguageContext& context)
{
    Diagnostics out;
    const ResolvedProgram resolved = readSource(source, context, out);
    checkProgram(resolved, context, out);
    sortByPlace(out, source.key);
    return out;
}

} // namespace camwright
