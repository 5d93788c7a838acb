#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace camwright {

struct CodePoint {
    char32_t value = 0;
    std::size_t length = 0; ///< bytes, 1 … 4
};

/// The code point that begins at `at`; nothing when the bytes there are no well-formed UTF-8.
std::optional<CodePoint> codePointAt(std::string_view text, std::size_t at);

/// Offset of the first byte that is not UTF-8; npos when all is.
std::size_t firstInvalidUtf8(std::string_view text);

/// Every ill-formed byte replaced by U+FFFD.
std::string validUtf8(std::string_view text);

/// Code points that do not show, or turn the direction of what stands beside them.
bool isInvisible(char32_t codePoint);

} // namespace camwright
