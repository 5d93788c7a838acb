#include "core/runtime/blocks/datablocks.h"

#include <array>
#include <vector>

namespace camwright::datablocks {

namespace {

constexpr std::int64_t MostElements = 4096;
constexpr std::uint32_t HexadecimalDigitsFlag = 34; // SMOV (TS-MEM-09)

/// Source, destination and count as the instruction orders them. As if through a copy, so the blocks may overlap.
void copyBlock(PinValues& pins, std::size_t from, std::size_t to, std::size_t count)
{
    const auto n = countAt(pins, count, MostElements);
    if (!n)
        return;
    if (!hasElements(pins, from, *n) || !hasElements(pins, to, *n))
        return reportIllegalParameter(pins);
    std::vector<std::uint64_t> copy(*n);
    for (std::uint32_t i = 0; i < *n; ++i)
        copy[i] = elementBits(pins, from, i);
    for (std::uint32_t i = 0; i < *n; ++i)
        setElement(pins, to, i, copy[i]);
}

void fill(PinValues& pins, std::uint64_t bits, std::size_t to, std::size_t count)
{
    const auto n = countAt(pins, count, MostElements);
    if (!n)
        return;
    if (!hasElements(pins, to, *n))
        return reportIllegalParameter(pins);
    for (std::uint32_t i = 0; i < *n; ++i)
        setElement(pins, to, i, bits);
}

using Digits = std::array<unsigned, 4>; ///< the lowest first

std::optional<Digits> digitsOf(std::uint64_t word, bool hexadecimal)
{
    if (!hexadecimal && word > 9999)
        return std::nullopt;
    const unsigned base = hexadecimal ? 16 : 10;
    Digits out{};
    for (unsigned& digit : out) {
        digit = static_cast<unsigned>(word % base);
        word /= base;
    }
    return out;
}

std::uint64_t wordOf(const Digits& digits, bool hexadecimal)
{
    std::uint64_t out = 0;
    for (std::size_t i = digits.size(); i-- > 0;)
        out = out * (hexadecimal ? 16 : 10) + digits[i];
    return out;
}

/// SMOV S S1 N D S2.
void moveDigits(PinValues& pins)
{
    const bool hexadecimal = isModeOn(pins, HexadecimalDigitsFlag);
    const std::int64_t first = pins.read(1).asInteger();
    const std::int64_t count = pins.read(2).asInteger();
    const std::int64_t target = pins.read(4).asInteger();
    const auto from = digitsOf(pins.read(0).bits, hexadecimal);
    auto to = digitsOf(pins.read(3).bits, hexadecimal);
    const bool legal = first <= 4 && target <= 4 && count >= 1 && count <= first && count <= target;
    if (!from || !to || !legal)
        return reportIllegalParameter(pins);
    for (std::int64_t i = 0; i < count; ++i)
        (*to)[static_cast<std::size_t>(target - 1 - i)] = (*from)[static_cast<std::size_t>(first - 1 - i)];
    pins.write(3, Value{pins.read(3).type, wordOf(*to, hexadecimal)});
}

} // namespace

bool runMoving(InstructionId instruction, PinValues& pins)
{
    switch (instruction) {
    case InstructionId::KincoBlkMove:
    case InstructionId::InvtBmov: copyBlock(pins, 0, 1, 2); return true;
    case InstructionId::KincoFill:
    case InstructionId::InvtFmov:
    case InstructionId::InvtDfmov: fill(pins, pins.read(0).bits, 1, 2); return true;
    case InstructionId::InvtZset: fill(pins, 1, 0, 1); return true;
    case InstructionId::InvtZrst: fill(pins, 0, 0, 1); return true;
    case InstructionId::InvtSmov: moveDigits(pins); return true;
    default: return false;
    }
}

} // namespace camwright::datablocks
