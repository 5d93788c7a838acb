#pragma once

#include "core/language/check/resolvedprogram.h"

#include <span>

namespace camwright {

/// Rules of the Koyo DL205 that need all programs: numbers of subroutines, FOR and NEXT, the work areas of I-boxes
/// (D2-IBC-07), and the registers of D2-MLINK modules as far as the programs write constants there (D2-REG-02 … 04,
/// D2-PRG-06). Does nothing for other families.
void checkKoyoTogether(std::span<const ResolvedProgram> programs, const LanguageContext& context, std::span<Diagnostics> diagnostics);

} // namespace camwright
