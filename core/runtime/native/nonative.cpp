#include "core/runtime/native/nativeprogram.h"

namespace camwright {

// Built where there is no generator for the processor: the interpreter runs.

std::unique_ptr<const TranslatedProgram> translateToNative(const ControllerImage&, const Memory&, const Bytecode&)
{
    return nullptr;
}

bool hasNativeTranslation()
{
    return false;
}

} // namespace camwright
