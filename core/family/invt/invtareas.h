#pragma once

#include "core/family/address.h"

/// Permanent numbers of the TS600 memory areas.
namespace camwright::invt {

enum Area : AreaId {
    X = 0, Y = 1, M = 2, LM = 3, S = 4, SM = 5, TimerBit = 6, CounterBit = 7,
    D = 8, R = 9, V = 10, Z = 11, TimerValue = 12, CounterValue = 13,
};

/// First counter whose value is 32 bits wide (TS-MEM-04).
inline constexpr std::uint32_t FirstWideCounter = 200;

} // namespace camwright::invt
