#pragma once

#include "core/runtime/executor/bytecode.h"

#include <cstring>

namespace camwright {

template <class T>
inline T load(const Frame& frame, std::uint32_t offset)
{
    T value;
    std::memcpy(&value, frame.bytes + offset, sizeof value);
    return value;
}

template <class T>
inline void store(Frame& frame, std::uint32_t offset, T value)
{
    std::memcpy(frame.bytes + offset, &value, sizeof value);
}

inline bool loadBit(const Frame& frame, std::uint32_t offset, std::uint8_t mask)
{
    return (frame.bytes[offset] & mask) != 0;
}

/// Mask 0xFF: the whole byte is the BOOL, 0 or 1.
inline void storeBit(Frame& frame, std::uint32_t offset, std::uint8_t mask, bool value)
{
    std::uint8_t& byte = frame.bytes[offset];
    if (mask == 0xFF)
        byte = value ? 1 : 0;
    else
        byte = static_cast<std::uint8_t>((byte & ~mask) | (value ? mask : 0));
}

} // namespace camwright
