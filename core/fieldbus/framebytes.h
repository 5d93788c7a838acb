#pragma once

#include "core/base/bytes.h"
#include "core/fieldbus/canframe.h"

#include <cstdint>

namespace camwright {

/// `size` (at most 8) low bytes of a number, little-endian, as CANopen lays numbers into frames.
inline void putLittle(std::uint8_t* out, std::uint64_t value, unsigned size)
{
    for (unsigned i = 0; i < size; ++i)
        out[i] = static_cast<std::uint8_t>(value >> (8 * i));
}

inline std::uint64_t getLittle(const std::uint8_t* in, unsigned size)
{
    std::uint64_t value = 0;
    for (unsigned i = 0; i < size; ++i)
        value |= std::uint64_t{in[i]} << (8 * i);
    return value;
}

void write(ByteWriter& writer, const CanFrame& frame);
/// A length above 8 or an identifier too large fails the reader.
CanFrame readCanFrame(ByteReader& reader);

} // namespace camwright
