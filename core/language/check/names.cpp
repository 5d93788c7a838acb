#include "core/language/check/resolvedprogram.h"

#include "core/language/source/letters.h"

#include <algorithm>

namespace camwright {

namespace {

/// Levenshtein distance, given up above `limit`.
std::size_t distance(std::string_view a, std::string_view b, std::size_t limit)
{
    if (a.size() > b.size() + limit || b.size() > a.size() + limit)
        return limit + 1;
    std::vector<std::size_t> row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j)
        row[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
            diagonal = row[j];
            row[j] = std::min({replaced, row[j] + 1, row[j - 1] + 1});
        }
    }
    return row.back();
}

} // namespace

std::string nearestName(std::string_view wanted, const std::vector<std::string_view>& names)
{
    constexpr std::size_t LongestCompared = 64;
    if (wanted.size() > LongestCompared)
        return {};
    const std::string upper = upperCase(wanted);
    const std::size_t limit = wanted.size() < 4 ? 1 : 2;
    std::size_t best = limit + 1;
    std::string out;
    for (const std::string_view name : names) {
        if (name.size() > LongestCompared)
            continue;
        const std::size_t d = distance(upper, upperCase(name), limit);
        if (d < best && d < wanted.size()) {
            best = d;
            out = name;
        }
    }
    return out;
}

std::string signature(const Dialect& dialect, const Instruction& instruction)
{
    std::string out = instruction.mnemonic;
    const char* separator = " ";
    for (const Pin& pin : instruction.pins) {
        out += separator + (pin.optional ? "[" + pin.name + "]" : pin.name);
        separator = dialect.commaSeparated ? ", " : " ";
    }
    return out;
}

} // namespace camwright
