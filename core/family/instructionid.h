#pragma once

#include <cstdint>

namespace camwright {

/// Permanent number of every instruction of every family: images carry it, a number is never given to another instruction.
/// The list stands in instructionids.h; the catalogue's data carry the same numbers, a test compares them.
enum class InstructionId : std::uint16_t {
#define CAMWRIGHT_INSTRUCTION(name, number, family, mnemonic) name = number,
#include "core/family/instructionids.h"
#undef CAMWRIGHT_INSTRUCTION
};

} // namespace camwright
