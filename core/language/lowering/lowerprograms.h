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
};

/// Lowers and links checked programs. Routines come in the order of `programs`; calls find theirs by name.
LoweredPrograms lowerPrograms(const Family& family, const ControllerModel& model, std::span<const CheckedProgram> programs,
                              const Job& job);

} // namespace camwright
