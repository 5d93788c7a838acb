#pragma once

#include "core/language/check/checkedprogram.h"
#include "core/language/check/context.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace camwright {

/// The source of a program and where it belongs.
struct ProgramSource {
    ObjectKey key;
    ProgramRole role = ProgramRole::Main;
    std::string_view text;
};

/// How much of the model's program memory is used (KS-CPU-02: a contact, a coil and a block count one each).
struct ProgramSize {
    std::uint32_t instructions = 0;
    std::uint32_t instructionsMax = 0;       ///< 0: the model has no limit
    std::uint32_t motionInstructions = 0;
    std::uint32_t motionInstructionsMax = 0;
};

struct CheckedSources {
    std::optional<std::vector<CheckedProgram>> programs; ///< in the order given; nothing if a diagnostic is an error
    ProgramSize size;
    Diagnostics diagnostics;                 ///< by program, then by place
};

/// All programs of a project: each for itself, then what concerns them together (size, calls, timers, lists). Pure.
CheckedSources checkSources(std::span<const ProgramSource> sources, const LanguageContext& context);

/// One program while somebody types: what is wrong in it alone.
Diagnostics checkSource(const ProgramSource& source, const LanguageContext& context);

} // namespace camwright
