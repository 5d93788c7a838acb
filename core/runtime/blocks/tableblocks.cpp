#include "core/runtime/blocks/datablocks.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace camwright::datablocks {

namespace {

constexpr std::uint32_t DownwardsFlag = 33; // SORTR, SORTC
constexpr std::uint32_t AllEqualFlag = 35;  // BKCOMP
constexpr std::int64_t MostRows = 32;
constexpr std::int64_t MostWords = 4096;

/// `lines` records of `width` words each, one behind the other: ordered by word `key` of each, equal ones as they were.
void sortRecords(PinValues& pins, std::uint32_t lines, std::uint32_t width, std::int64_t key)
{
    if (lines == 0 || width == 0 || key < 1 || key > width || !hasElements(pins, 0, lines * width) || !hasElements(pins, 3, lines * width))
        return reportIllegalParameter(pins);
    std::vector<std::int16_t> words(std::size_t{lines} * width);
    for (std::uint32_t i = 0; i < words.size(); ++i)
        words[i] = static_cast<std::int16_t>(elementBits(pins, 0, i));
    std::vector<std::uint32_t> order(lines);
    std::iota(order.begin(), order.end(), 0u);
    const bool downwards = isModeOn(pins, DownwardsFlag);
    const auto keyOf = [&](std::uint32_t line) { return words[std::size_t{line} * width + static_cast<std::size_t>(key - 1)]; };
    std::ranges::sort(order, [&](std::uint32_t a, std::uint32_t b) {
        const std::int16_t first = keyOf(a), second = keyOf(b);
        if (first == second)
            return a < b;
        return downwards ? first > second : first < second;
    });
    for (std::uint32_t i = 0; i < words.size(); ++i)
        setElement(pins, 3, i, static_cast<std::uint16_t>(words[std::size_t{order[i / width]} * width + i % width]));
}

/// SORTR and SORTC S M1 M2 D N.
void sort(PinValues& pins, bool byRow)
{
    const auto rows = countAt(pins, 1, MostRows);
    const auto columns = countAt(pins, 2, MostRows);
    if (rows && columns)
        sortRecords(pins, byRow ? *rows : *columns, byRow ? *columns : *rows, pins.read(4).asInteger());
}

/// BKCOMP S1 S2 D N.
void compare(PinValues& pins)
{
    const auto count = countAt(pins, 3, MostWords);
    if (!count)
        return;
    if (!hasElements(pins, 0, *count) || !hasElements(pins, 1, *count) || !hasElements(pins, 2, *count))
        return reportIllegalParameter(pins);
    bool all = true;
    for (std::uint32_t i = 0; i < *count; ++i) {
        const bool equal = elementBits(pins, 0, i) == elementBits(pins, 1, i);
        setElement(pins, 2, i, equal ? 1 : 0);
        all = all && equal;
    }
    setFlag(pins, AllEqualFlag, all);
}

} // namespace

bool runTable(InstructionId instruction, PinValues& pins)
{
    switch (instruction) {
    case InstructionId::InvtSortr: sort(pins, true); return true;
    case InstructionId::InvtSortc: sort(pins, false); return true;
    case InstructionId::InvtBkcomp: compare(pins); return true;
    default: return false;
    }
}

} // namespace camwright::datablocks
