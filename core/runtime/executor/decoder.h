#pragma once

#include "core/runtime/executor/bytecode.h"

namespace camwright {

/// Bytecode of a verified image for a memory made from its layout, without steps: timers, counters, the fault flag.
Bytecode decodeTables(const ControllerImage& image, const Memory& memory);
/// Adds the steps, contacts and constants.
void decodeSteps(const ControllerImage& image, const Memory& memory, Bytecode& out);

} // namespace camwright
