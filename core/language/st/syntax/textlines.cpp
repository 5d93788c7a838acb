#include "core/language/st/syntax/textlines.h"

#include <algorithm>
#include <cstring>

namespace camwright::st {

TextRange TextLines::range(std::uint32_t offset, std::uint32_t end) const
{
    const Position from = position(offset);
    const Position to = position(std::max(offset, end));
    return {from.line, from.column, to.line, to.column};
}

TextLines::Position TextLines::position(std::uint32_t offset) const
{
    if (m_starts.empty()) {
        m_starts.push_back(0);
        for (std::size_t at = 0; at < m_text.size();) {
            const void* found = std::memchr(m_text.data() + at, '\n', m_text.size() - at);
            if (!found)
                break;
            at = static_cast<std::size_t>(static_cast<const char*>(found) - m_text.data()) + 1;
            m_starts.push_back(static_cast<std::uint32_t>(at));
        }
    }
    const auto isIn = [&](std::size_t line) { return m_starts[line] <= offset && (line + 1 == m_starts.size() || offset < m_starts[line + 1]); };
    if (m_near + 1 < m_starts.size() && isIn(m_near + 1))
        ++m_near;
    else if (!isIn(m_near))
        m_near = static_cast<std::size_t>(std::ranges::upper_bound(m_starts, offset) - m_starts.begin()) - 1;
    return {static_cast<std::uint32_t>(m_near + 1), offset - m_starts[m_near] + 1};
}

} // namespace camwright::st
