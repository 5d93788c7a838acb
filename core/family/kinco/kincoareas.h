#pragma once

#include "core/family/address.h"

#include <bit>

/// Permanent numbers of the Kinco memory areas, and what the sheets leave open (docs/families.md).
namespace camwright::kinco {

enum Area : AreaId {
    I = 0, Q = 1, M = 2, V = 3, L = 4, SM = 5, AI = 6, AQ = 7,
    TimerBit = 8, TimerValue = 9, CounterBit = 10, CounterValue = 11,
};

/// KS-MEM-04: the manuals do not say. Everything that stores more than a byte goes through ByteWriter/memcpy in this order.
inline constexpr std::endian MemoryByteOrder = std::endian::little;
static_assert(MemoryByteOrder == std::endian::native, "memory areas are copied, not swapped");

inline constexpr std::uint32_t AlwaysOnBit = 0;  ///< SM0.0 (KS-MEM-09, inferred)
inline constexpr std::uint32_t FirstScanBit = 1; ///< SM0.1 (KS-MEM-09)

} // namespace camwright::kinco
