#pragma once

#include "core/online/tracebuffer.h"

#include <optional>

namespace camwright {

/// What the two cursors say of one channel. Times in seconds, values in the channel's unit.
struct TraceStatistics {
    double deltaTime = 0;
    std::optional<double> atA, atB;   ///< nothing in a gap
    double minimum = 0, maximum = 0, mean = 0, rms = 0;
    double slope = 0;                 ///< (value at B − value at A) / Δt; 0 where it does not exist
    std::uint64_t samples = 0;        ///< none: the numbers above mean nothing

    std::optional<double> deltaValue() const { return atA && atB ? std::optional(*atB - *atA) : std::nullopt; }
};

/// Over the samples from the earlier to the later of two cycles, both included; NaN samples and gaps are left out.
TraceStatistics statisticsBetween(const TraceBuffer& buffer, std::size_t channel, std::uint64_t cycleA, std::uint64_t cycleB);

} // namespace camwright
