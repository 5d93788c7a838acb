#pragma once

#include "core/language/check/checksources.h"
#include "core/language/st/check/compilation.h"

#include <memory>
#include <span>
#include <vector>

namespace camwright {

/// The programs of a project that are written in Structured Text, checked together: they share their types, function blocks
/// and global variables, see the variables of the tables, and may call the subroutines in `others` by name.
std::unique_ptr<st::Compilation> checkSt(std::span<const ProgramSource> sources, std::span<const ProgramSource> others, const LanguageContext& context);

/// What is said about them, by source and then by place; with a warning where the real family has no such language.
Diagnostics diagnosticsOf(const st::Compilation& compilation, const LanguageContext& context);

/// A text outside of any project: its own PROGRAM is the main one if it has any, and any address is good. Places have `file`.
Diagnostics checkLooseSt(std::string_view text, const std::string& file);

} // namespace camwright
