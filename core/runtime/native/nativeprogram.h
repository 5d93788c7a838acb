#pragma once

#include "core/runtime/executor/translation.h"

namespace camwright {

/// Machine code of a program, for x86-64: about as fast as a C compiler's with optimisation, made in microseconds a
/// hundred rungs. Null where this processor, build or system cannot.
std::unique_ptr<const TranslatedProgram> translateToNative(const ControllerImage& image, const Memory& memory, const Bytecode& tables);

/// Whether this build makes machine code for the processor it was built for.
bool hasNativeTranslation();

} // namespace camwright
