#pragma once

#include "core/language/assist/completion.h"
#include "core/language/assist/hover.h"
#include "core/language/check/checksources.h"
#include "core/language/exchange/ilpfile.h"
#include "core/language/exchange/pastedtext.h"
#include "core/language/source/ilwriter.h"
#include "core/language/source/token.h"

#include <cstdlib>
#include <string>
#include <string_view>

namespace camwright {

/// What must hold for any text: it comes back byte for byte, tokens lie inside their lines, drawn rungs survive being
/// written canonically, and checking it ends.
inline void holdLanguageToItsWord(const LanguageContext& context, std::string_view text)
{
    const Dialect& dialect = *context.dialect;
    const ParsedProgram program = parseIl(dialect, text);
    if (writeIl(program) != text)
        std::abort();
    if (program.diagnostics.size() > MaximumDiagnostics + 1)
        std::abort();
    for (const Token& token : tokenize(dialect, text))
        if (token.length == 0 || token.column + token.length > text.size())
            std::abort();
    for (const ParsedNetwork& network : program.networks)
        for (const ParsedRung& rung : network.rungs) {
            if (!rung.rung.drawable)
                continue;
            const auto lines = linearize(dialect, rung.rung);
            if (!lines || !lines->drawable)
                std::abort(); // what was read from this dialect can be written in it
            const auto again = linearize(dialect, *lines);
            if (!again || writeRung(dialect, *again) != writeRung(dialect, *lines))
                std::abort();
        }
    repairPastedText(dialect, text);
    importIlp(exportIlp(text));
    completeAt(context, text, text.size() / 2, TextLanguage::English);
    hoverAt(context, text, text.size() / 2, TextLanguage::English);
    const ProgramSource source{{ObjectKind::Program, "Main"}, ProgramRole::Main, text};
    const CheckedSources checked = checkSources({&source, 1}, context);
    if (checked.programs.has_value() == hasErrors(checked.diagnostics))
        std::abort();
}

/// A project with a few variables and subroutines.
inline LanguageContext fuzzContext(const char* family, const char* model)
{
    LanguageContext out;
    out.family = findFamily(family);
    out.model = model ? out.family->findModel(model) : &out.family->defaultModel();
    out.dialect = dialectOfFamily(family);
    out.programs = {{"Main", ProgramRole::Main}, {"Init", ProgramRole::Subroutine}};
    out.axes = {{"Feed", 1}};
    KnownVariable variable;
    variable.name = "Start";
    variable.address = bitAddress(2, 0);
    variable.isBound = true;
    out.variables.push_back(variable);
    out.index();
    return out;
}

} // namespace camwright
