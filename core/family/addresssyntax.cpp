#include "core/family/addresssyntax.h"

#include <algorithm>
#include <charconv>

namespace camwright {

namespace {

bool isLetter(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); }
bool isDigit(char c) { return c >= '0' && c <= '9'; }

/// Bytes of the UTF-8 character that begins with `first`.
std::size_t characterLength(char first)
{
    const auto byte = static_cast<unsigned char>(first);
    return byte < 0xC0 ? 1 : byte < 0xE0 ? 2 : byte < 0xF0 ? 3 : 4;
}

} // namespace

std::uint32_t AddressSyntax::endOf(const Address&, std::uint32_t areaBytes) const
{
    return areaBytes;
}

std::optional<Diagnostic> AddressScanner::foreignCharacter() const
{
    for (std::size_t i = 0; i < m_text.size(); ++i) {
        const char c = m_text[i];
        if (isLetter(c) || isDigit(c) || c == '.' || (c == '%' && i == 0))
            continue;
        const std::string_view character = m_text.substr(i, characterLength(c));
        return error(Code::AddressForeignCharacter, {std::string(m_text), std::string(character)}, i, i + character.size());
    }
    return std::nullopt;
}

bool AddressScanner::take(char c)
{
    if (atEnd() || m_text[m_at] != c)
        return false;
    ++m_at;
    return true;
}

std::string AddressScanner::letters()
{
    std::string out;
    for (; !atEnd() && isLetter(m_text[m_at]); ++m_at)
        out += static_cast<char>(m_text[m_at] & ~0x20);
    return out;
}

std::string_view AddressScanner::digits()
{
    const std::size_t begin = m_at;
    while (!atEnd() && isDigit(m_text[m_at]))
        ++m_at;
    return m_text.substr(begin, m_at - begin);
}

Diagnostic AddressScanner::error(Code code, std::vector<std::string> arguments, std::size_t begin, std::size_t end) const
{
    Place place;
    place.range = {1, static_cast<std::uint32_t>(begin + 1), 1, static_cast<std::uint32_t>(end + 1)};
    return diagnostic(code, std::move(arguments), std::move(place));
}

std::uint32_t numberOf(std::string_view digits, unsigned base)
{
    std::uint32_t out = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), out, static_cast<int>(base));
    return error == std::errc{} ? out : 0xFFFFFFFF;
}

std::string areaNames(std::span<const MemoryArea> areas, std::string_view prefix)
{
    std::vector<std::string_view> seen;
    std::string out;
    for (const MemoryArea& area : areas) {
        if (std::ranges::find(seen, area.name) != seen.end())
            continue;
        seen.push_back(area.name);
        out += out.empty() ? "" : ", ";
        if (area.kind == AreaKind::Bytes)
            out += prefix;
        out += area.name;
    }
    return out;
}

} // namespace camwright
