#pragma once

#include "core/language/source/ilparser.h"

#include <optional>
#include <string>

namespace camwright {

/// The text of a program: unedited rungs byte for byte, edited ones canonically.
std::string writeIl(const ParsedProgram& program);

/// The canonical text of one rung: one statement a line, mnemonic padded, comments kept, each line ended by \n.
std::string writeRung(const Dialect& dialect, const Rung& rung);

/// The statements of a drawn rung in the dialect's own words: contacts get the mnemonic of their place, ANB, MPS or AND(
/// are put where the tree needs them. Elements are taken from `rung.statements`; comments of structural statements move
/// to the element that follows. A text rung comes back as it is; a tree that the dialect has no words for (a fork on Kinco)
/// gives nothing.
std::optional<Rung> linearize(const Dialect& dialect, const Rung& rung);

} // namespace camwright
