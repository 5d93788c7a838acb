#pragma once

#include "core/language/lowering/lowerprograms.h"
#include "core/language/st/check/compilation.h"

#include <functional>
#include <string>
#include <string_view>

namespace camwright::st {

/// The names of the PROGRAMs' routines, in the order lowerSt() adds them, before all others.
std::vector<std::string> programRoutines(const Compilation& compilation);

/// Adds the routines of a compilation without errors to a program: what its main text runs, the PROGRAMs of its other texts,
/// and whatever these call. `routineByName` finds programs of other languages. A PROGRAM that is alone in its text gets the
/// routine name of the text; POUs are named "Motor()" and "Motor.Start()".
/// Start values and symbols are added too: of a program's variable "Main.count", of a global one its name.
/// `family` tells how its areas are addressed; null only where no variable has an address.
void lowerSt(const Compilation& compilation, const Family* family, const std::function<std::uint32_t(std::string_view)>& routineByName, LoweredPrograms& out);

} // namespace camwright::st
