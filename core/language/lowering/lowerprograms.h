#pragma once

#include "core/base/job.h"
#include "core/family/family.h"
#include "core/language/check/checkedprogram.h"
#include "core/language/image/controllerimage.h"

#include <span>

namespace camwright {

/// The programs as IR, and where each instruction comes from.
struct LoweredPrograms {
    IrProgram program;
    DebugMap debug;
    std::size_t blocksWithLocals = 0;        ///< routines, from the first on, that have their own L (LM, V)
    std::uint32_t variableBytes = 0;         ///< size of VariablesArea, with what the lowering needs behind the variables
    std::vector<InterruptSource> interrupts{}; ///< by their routines
    std::vector<InitialValue> initialValues; ///< of variables the programs declare
    std::vector<Symbol> symbols;
};

/// Lowers and links checked programs. Routines come in the order of `programs`; calls find theirs by name, there or among
/// `following`, the names of the routines that somebody else adds behind them. `variableBytes`: how much of
/// VariablesArea is taken already.
LoweredPrograms lowerPrograms(const Family& family, const ControllerModel& model, std::span<const CheckedProgram> programs,
                              const Job& job, std::span<const std::string> following = {}, std::uint32_t variableBytes = 0);

} // namespace camwright
