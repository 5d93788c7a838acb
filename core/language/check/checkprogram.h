#pragma once

#include "core/language/check/checkedprogram.h"
#include "core/language/check/resolvedprogram.h"

#include <optional>

namespace camwright {

/// Decides types and checks areas, ranges, constant groups and blocks. The program, unless something is an error; what is
/// wrong is added to `diagnostics`, at most MaximumDiagnostics.
std::optional<CheckedProgram> checkProgram(const ResolvedProgram& program, const LanguageContext& context, Diagnostics& diagnostics);

} // namespace camwright
