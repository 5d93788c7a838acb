#pragma once

#include "core/base/result.h"
#include "core/language/ir/ir.h"

#include <array>
#include <cstdint>

namespace camwright {

/// Sizes of the memory areas in bytes, by id; 0: no such area.
using AreaSizes = std::array<std::uint32_t, 256>;

/// Whether a program is safe to run on areas of these sizes whatever its instructions do: known operations of fitting
/// types, registers written once and before they are read on every path, addresses and jumps inside, calls without cycles
/// and not too deep. The first violation is the error (CW4006). Linear in the program.
Result<void> verifyProgram(const IrProgram& program, const AreaSizes& areas);

/// Whether `bytes` bytes from an address lie inside its area.
bool fits(const AreaSizes& areas, const IrAddress& address, std::uint64_t bytes);

/// Whether a value of the type may lie at the address: inside, and with a bit number only where the type is BOOL.
bool fits(const AreaSizes& areas, const IrAddress& address, DataType type);

bool isKnownType(DataType type);
/// Whether the bits are a value of the type: no bit beyond its width, BOOL 0 or 1.
bool isConstantOf(DataType type, std::uint64_t bits);

/// One violation: where and what, in English words for the person who must mend the compiler.
Diagnostic unsafeProgram(const IrRoutine& routine, std::size_t instruction, std::string what);

/// The part of verifyProgram that looks at one routine.
Result<void> verifyRoutine(const IrProgram& program, const IrRoutine& routine, const AreaSizes& areas);

} // namespace camwright
