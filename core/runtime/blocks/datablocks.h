#pragma once

#include "core/runtime/executor/blockhost.h"

namespace camwright {

/// Instructions that work on rows of memory or need more than the IR has: block moves, check codes, ASCII, tables, functions.
/// False if the instruction is none of them. Called only with flow. Nothing is written outside the areas of the pins; what
/// an instruction cannot take leaves its result as it was and sets the family's flag for it (TS600: SM24).
bool runDataBlock(InstructionId instruction, PinValues& pins);

namespace datablocks {

// Each looks whether the instruction is its own.
bool runMoving(InstructionId instruction, PinValues& pins);
bool runCheckCode(InstructionId instruction, PinValues& pins);
bool runText(InstructionId instruction, PinValues& pins);
bool runTable(InstructionId instruction, PinValues& pins);
bool runNumber(InstructionId instruction, PinValues& pins);

/// TS-MEM-09: SM24, illegal parameter.
void reportIllegalParameter(PinValues& pins);
/// A system flag of the TS600 that chooses a mode: SM31 … SM34.
bool isModeOn(PinValues& pins, std::uint32_t flag);
void setFlag(PinValues& pins, std::uint32_t flag, bool on);

/// Element `index` of a pin; 0 outside its area.
std::uint64_t elementBits(PinValues& pins, std::size_t pin, std::uint32_t index);
/// Nothing happens outside the area.
void setElement(PinValues& pins, std::size_t pin, std::uint32_t index, std::uint64_t bits);
/// Whether `count` elements from a pin on lie in its area.
bool hasElements(PinValues& pins, std::size_t pin, std::int64_t count);
/// A count of 0 … `most`, or nothing, which has been reported.
std::optional<std::uint32_t> countAt(PinValues& pins, std::size_t pin, std::int64_t most);

} // namespace datablocks

} // namespace camwright
