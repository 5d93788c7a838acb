#pragma once

#include "core/family/family.h"
#include "core/language/image/controllerimage.h"

#include <cstdint>

namespace camwright {

/// The memory of a model as an image describes it. Areas that belong to a program block are as often there as there are
/// routines; `variableBytes` is the size of VariablesArea.
MemoryLayout memoryLayout(const Family& family, const ControllerModel& model, std::uint32_t variableBytes, std::size_t routines);

} // namespace camwright
