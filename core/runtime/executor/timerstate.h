#pragma once

#include "core/language/ir/ir.h"

#include <cstdint>

namespace camwright {

/// What a timer remembers besides its value and bit. Saved state and images may hold any bytes here, so nothing read back
/// is trusted: a fraction outside the base and a time that has not come yet count as zero.
struct HiddenTimer {
    std::int64_t last = 0;     ///< ns, when it was last executed
    std::int64_t fraction = 0; ///< ns since the value last grew, less than the base
    std::uint8_t timing = 0;
    std::uint8_t input = 0;    ///< of the last execution
    std::uint8_t known = 0;    ///< executed before
    std::uint8_t reserved[5] = {};

    /// Whole units of the base since the last execution; the rest is kept for the next.
    std::int64_t unitsUntil(std::int64_t now, std::int64_t baseNs)
    {
        const std::int64_t elapsed = last >= 0 && last <= now ? now - last : 0;
        const std::int64_t rest = fraction >= 0 && fraction < baseNs ? fraction : 0;
        const std::int64_t units = elapsed / baseNs + (elapsed % baseNs + rest) / baseNs;
        fraction = (elapsed % baseNs + rest) % baseNs;
        return units;
    }
};
static_assert(sizeof(HiddenTimer) == TimerStateBytes);

} // namespace camwright
