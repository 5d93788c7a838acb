#include "core/language/source/headers.h"

#include "core/language/source/letters.h"
#include "core/language/source/operandtext.h"

#include <algorithm>

namespace camwright {

namespace {

/// A small reader of fixed words in a line.
class Cursor {
public:
    Cursor(std::string_view line, std::size_t at) : m_line(line), m_at(at) {}

    std::size_t position() const { return m_at; }
    bool atEnd() const { return m_at >= m_line.size(); }

    void blanks()
    {
        while (!atEnd() && isBlank(m_line[m_at]))
            ++m_at;
    }

    bool take(std::string_view word)
    {
        if (upperCase(m_line.substr(m_at, word.size())) != word)
            return false;
        m_at += word.size();
        return true;
    }

    std::optional<std::uint32_t> number()
    {
        constexpr std::uint64_t Largest = 0xFFFFFFFF;
        const std::size_t begin = m_at;
        std::uint64_t value = 0;
        for (; !atEnd() && isDigit(m_line[m_at]); ++m_at)
            value = std::min(Largest, value * 10 + static_cast<std::uint64_t>(m_line[m_at] - '0'));
        return m_at > begin ? std::optional(static_cast<std::uint32_t>(value)) : std::nullopt;
    }

private:
    std::string_view m_line;
    std::size_t m_at;
};

} // namespace

std::optional<NetworkHeader> networkHeaderAt(std::string_view line, std::size_t at)
{
    Cursor cursor(line, at);
    if (!cursor.take("(*"))
        return std::nullopt;
    cursor.blanks();
    if (!cursor.take("NETWORK"))
        return std::nullopt;
    cursor.blanks();
    const auto number = cursor.number();
    cursor.blanks();
    if (!number || !cursor.take("*)"))
        return std::nullopt;
    return NetworkHeader{*number, cursor.position()};
}

bool isNetworkHeader(std::string_view line)
{
    const std::string_view text = trimmed(line);
    const auto header = networkHeaderAt(text, 0);
    return header && header->end == text.size();
}

std::optional<std::uint32_t> escapedNetworkHeader(std::string_view line)
{
    if (!hasMarkdownEscapes(line))
        return std::nullopt;
    std::string text = withoutMarkdownEscapes(trimmed(line));
    if (!text.starts_with("(*") || !text.ends_with(')'))
        return std::nullopt;
    // Where the star of "*)" strayed before the number, as in "(* Network * 0)", it is a blank.
    std::replace(text.begin() + 2, text.end(), '*', ' ');
    Cursor cursor(text, 2);
    cursor.blanks();
    if (!cursor.take("NETWORK"))
        return std::nullopt;
    cursor.blanks();
    const auto number = cursor.number();
    cursor.blanks();
    return number && cursor.take(")") && cursor.atEnd() ? number : std::nullopt;
}

std::optional<std::uint32_t> ilpCount(std::string_view line)
{
    const std::string_view text = trimmed(line);
    Cursor cursor(text, 0);
    if (!cursor.take("(*"))
        return std::nullopt;
    cursor.blanks();
    const auto number = cursor.number();
    cursor.blanks();
    return number && cursor.take("*)") && cursor.atEnd() ? number : std::nullopt;
}

} // namespace camwright
