#pragma once

#include "core/online/tracebuffer.h"

#include <limits>

namespace camwright {

inline constexpr double Nan = std::numeric_limits<double>::quiet_NaN();

/// A block of the first channel set with a motion cycle of 1 ms; block 0 names the channels.
inline SampleBlock sampleBlock(std::uint64_t sequence, std::uint64_t firstCycle, std::vector<std::vector<double>> columns,
    std::vector<ChannelInfo> channels = {}, std::uint32_t stride = 1)
{
    SampleBlock out;
    out.channelSet = 1;
    out.sequence = sequence;
    out.firstCycle = firstCycle;
    out.stride = stride;
    out.columns = std::move(columns);
    out.channels = std::move(channels);
    return out;
}

} // namespace camwright
