#pragma once

#include "core/language/check/resolvedprogram.h"

namespace camwright {

/// Labels and loops of one program: a jump has its label, a label stands once, every FOR has its NEXT. False if something
/// was reported. What jumps where is otherwise free: a jump backwards is a loop that the watchdog ends.
bool checkControl(const ResolvedProgram& program, DiagnosticSink& sink);

} // namespace camwright
