#pragma once

#include "core/base/bytes.h"

#include <array>

namespace camwright {

/// CRC-32 of IEEE 802.3 (reflected, polynomial 0x04C11DB7): guards records against torn writes.
inline std::uint32_t crc32(ByteSpan bytes)
{
    static constexpr auto Table = [] {
        std::array<std::uint32_t, 256> out{};
        for (std::uint32_t n = 0; n < 256; ++n) {
            std::uint32_t c = n;
            for (int bit = 0; bit < 8; ++bit)
                c = (c & 1) ? 0xEDB88320u ^ (c >> 1) : c >> 1;
            out[n] = c;
        }
        return out;
    }();
    std::uint32_t crc = 0xFFFFFFFFu;
    for (std::uint8_t byte : bytes)
        crc = Table[(crc ^ byte) & 0xFF] ^ (crc >> 8);
    return ~crc;
}

} // namespace camwright
