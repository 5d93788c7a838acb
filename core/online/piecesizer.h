#pragma once

#include "core/base/time.h"
#include "core/online/messages.h"

#include <algorithm>
#include <cstddef>

namespace camwright {

/// How large the pieces of a bulk transfer may be so that each takes at most 5 ms of line time (CONTRACTS 16). Pieces leave
/// in pairs; the time between the two acknowledgements of a pair is what the line needed for the second piece.
class PieceSizer {
public:
    static constexpr Time LineTime = 5ms;

    std::size_t size() const { return m_size; }

    /// `gap` between the acknowledgements of two pieces of `bytes` each, sent back to back.
    void onPair(std::size_t bytes, Time gap)
    {
        const auto nanoseconds = std::max<std::int64_t>(gap.count(), 1);
        const double fitting = static_cast<double>(bytes) * static_cast<double>(LineTime.count()) / static_cast<double>(nanoseconds);
        // At most doubled at a time: one lucky gap says little.
        const double wanted = std::min(fitting, 2.0 * static_cast<double>(m_size));
        m_size = static_cast<std::size_t>(std::clamp(wanted, double(message::MinimumPiece), double(message::MaximumPiece)));
    }

private:
    std::size_t m_size = 512;
};

} // namespace camwright
