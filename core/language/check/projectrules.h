#pragma once

#include "core/language/check/checksources.h"
#include "core/language/check/resolvedprogram.h"

#include <span>

namespace camwright {

/// What the programs of a project must keep together: the model's limits (KS-CPU-02, KS-MC-01), no recursion, one place for
/// each timer, axes that exist, lists that are prepared. Diagnostics are added per program, as many lists as programs.
ProgramSize checkTogether(std::span<const ResolvedProgram> programs, const LanguageContext& context, std::span<Diagnostics> diagnostics);

} // namespace camwright
