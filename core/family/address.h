#pragma once

#include "core/base/datatype.h"

#include <compare>
#include <cstdint>

namespace camwright {

/// Permanent number of a memory area within its family; images carry it. Named in kinco/kincoareas.h and invt/invtareas.h.
using AreaId = std::uint8_t;

/// Where variables without an address live (TS600 custom variables, locals). No text addresses it; its size is the compiler's.
inline constexpr AreaId VariablesArea = 0xFE;

/// A typed place in a controller's memory. Memory is one little-endian byte array per area (CONTRACTS 8), so `byte` counts
/// from the start of the array whatever the numbering people use: %VW304 is byte 304 of V, D100 byte 200 of D, X17 (octal)
/// byte 15 of X. Timers and counters have two arrays, a bit and a value each; `T5` parses as the bit, `Family::valueOf`
/// gives the value.
struct Address {
    AreaId area = 0;
    std::uint8_t bit = 0;            ///< 0 … 7 within `byte`; 0 where `isBit` is false or the area is one byte per bit
    bool isBit = false;
    DataType type = DataType::Bool;  ///< BOOL exactly when `isBit`; else the type access has by default (see Family::withType)
    std::uint32_t byte = 0;

    auto operator<=>(const Address&) const = default;
};

inline Address bitAddress(AreaId area, std::uint32_t byte, unsigned bit = 0)
{
    return {area, static_cast<std::uint8_t>(bit), true, DataType::Bool, byte};
}

inline Address valueAddress(AreaId area, std::uint32_t byte, DataType type)
{
    return {area, 0, false, type, byte};
}

/// Whether two addresses share a bit of memory.
bool overlap(const Address& a, const Address& b);

} // namespace camwright
