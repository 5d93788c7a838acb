#pragma once

#include "core/family/family.h"
#include "core/runtime/engine.h"

#include <vector>

namespace camwright {

/// Inputs and outputs on the unit of a model itself, digital before analogue, by number; references lack the image number.
std::vector<Terminal> terminalsOf(const Family& family, const ControllerModel& model);

} // namespace camwright
