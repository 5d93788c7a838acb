#pragma once

#include "core/base/bytes.h"

#include <array>
#include <compare>
#include <string>

namespace camwright {

/// A BLAKE2b-256 digest (libsodium). Names a program, an image, a part of one.
struct Hash {
    std::array<std::uint8_t, 32> bytes{};

    bool isNull() const { return *this == Hash{}; }
    auto operator<=>(const Hash&) const = default;
};

Hash hashOf(ByteSpan bytes);
std::string toHex(const Hash& hash);
inline std::string shortHex(const Hash& hash) { return toHex(hash).substr(0, 8); }

} // namespace camwright
