#pragma once

#include "core/checks/validproject.h"
#include "core/language/check/context.h"
#include "core/language/compile.h"
#include "core/language/lowering/lowerprograms.h"

namespace camwright {

/// Puts the image together: lowered programs, memory, configuration, variables, places and source.
ControllerImage buildImage(const ValidProject& project, const LanguageContext& context, LoweredPrograms lowered, const BuildOptions& options);

/// Why verify() refused what was just built, for the user: calls that nest too deep are theirs, anything else is ours.
Diagnostic whyNotSafe(const ControllerImage& image, const Diagnostic& reason);

} // namespace camwright
