#pragma once

#include "editors/shell/fixes.h"

namespace camwright {

struct QuickFix;

/// What a quick fix does, in the current language.
QString sentenceOf(const QuickFix& fix);

/// The ways out of problems in programs and variable tables, each one step of undo.
FixProvider programFixProvider();

} // namespace camwright
