#pragma once

#include "core/base/place.h"

#include <cstdint>
#include <string_view>
#include <vector>

namespace camwright::st {

/// Lines and columns of a text by byte offset. The lines are found when they are asked for first.
class TextLines {
public:
    explicit TextLines(std::string_view text = {}) : m_text(text) {}

    std::string_view text() const { return m_text; }
    TextRange range(std::uint32_t offset, std::uint32_t end) const;

private:
    struct Position {
        std::uint32_t line = 0;
        std::uint32_t column = 0;
    };
    Position position(std::uint32_t offset) const;

    std::string_view m_text;
    mutable std::vector<std::uint32_t> m_starts;
    mutable std::size_t m_near = 0; ///< the line asked for last; places come mostly in order
};

} // namespace camwright::st
