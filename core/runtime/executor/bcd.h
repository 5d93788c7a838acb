#pragma once

#include <cstdint>

namespace camwright {

/// A number of packed decimal digits, four bits each. A digit above 9 counts as what its bits say, as the arithmetic of the
/// Koyo lowering takes it.
constexpr std::int64_t fromBcd(std::uint32_t digits)
{
    std::int64_t out = 0;
    for (int shift = 28; shift >= 0; shift -= 4)
        out = out * 10 + (digits >> shift & 0xF);
    return out;
}

/// The last 8 decimal digits of a number that is not negative.
constexpr std::uint32_t toBcd(std::int64_t number)
{
    std::uint32_t out = 0;
    for (int shift = 0; shift < 32; shift += 4, number /= 10)
        out |= static_cast<std::uint32_t>(number % 10) << shift;
    return out;
}

} // namespace camwright
