#pragma once

#include "core/runtime/executor/bytecode.h"

namespace camwright {

/// Makes the bytecode of a verified image for a memory made from its layout.
Bytecode decode(const ControllerImage& image, const Memory& memory);

} // namespace camwright
