#pragma once

#include "core/base/datatype.h"

#include <cstdint>
#include <string>
#include <vector>

namespace camwright {

struct ChannelInfo {
    std::string name; ///< as asked for
    DataType type = DataType::Lreal;
    std::string unit; ///< "mm", "mm/s", "" for memory
    bool operator==(const ChannelInfo&) const = default;
};

/// A run of samples taken in the motion task (CONTRACTS 17): row i belongs to cycle firstCycle + i * stride. A block with a
/// sequence number that does not follow, or a first cycle that does not, is a gap and is shown as one.
struct SampleBlock {
    std::uint32_t channelSet = 0;     ///< counts trace starts
    std::uint64_t sequence = 0;       ///< counts blocks of the set from 0
    std::uint64_t firstCycle = 0;
    std::uint32_t stride = 1;
    std::int64_t cycleNs = 1000000;   ///< length of one motion cycle
    std::uint64_t lostRows = 0;       ///< rows that fell out before this block
    std::int64_t triggerCycle = -1;   ///< once the trigger has fired
    bool last = false;
    std::vector<ChannelInfo> channels; ///< only in block 0
    std::vector<std::vector<double>> columns; ///< one per channel, all of one length; integers up to 2^53 are exact

    bool operator==(const SampleBlock&) const = default;
};

} // namespace camwright
