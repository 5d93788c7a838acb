#include "core/base/utf8.h"

namespace camwright {

std::optional<CodePoint> codePointAt(std::string_view text, std::size_t at)
{
    const auto byte = [&](std::size_t n) { return static_cast<std::uint8_t>(text[at + n]); };
    const std::uint8_t lead = byte(0);
    if (lead < 0x80)
        return CodePoint{lead, 1};
    const std::size_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
    if (lead < 0xC2 || lead > 0xF4 || at + length > text.size())
        return std::nullopt;
    char32_t value = lead & (0x7Fu >> length);
    for (std::size_t n = 1; n < length; ++n) {
        if ((byte(n) & 0xC0) != 0x80)
            return std::nullopt;
        value = value << 6 | (byte(n) & 0x3Fu);
    }
    static constexpr char32_t Lowest[] = {0, 0, 0x80, 0x800, 0x10000};
    if (value < Lowest[length] || value > 0x10FFFF || (value >= 0xD800 && value <= 0xDFFF))
        return std::nullopt;
    return CodePoint{value, length};
}

std::size_t firstInvalidUtf8(std::string_view text)
{
    for (std::size_t at = 0; at < text.size();) {
        const auto point = codePointAt(text, at);
        if (!point)
            return at;
        at += point->length;
    }
    return std::string_view::npos;
}

std::string validUtf8(std::string_view text)
{
    if (firstInvalidUtf8(text) == std::string_view::npos)
        return std::string(text);
    std::string out;
    for (std::size_t at = 0; at < text.size();) {
        if (const auto point = codePointAt(text, at)) {
            out.append(text.substr(at, point->length));
            at += point->length;
        } else {
            out += "\xEF\xBF\xBD";
            ++at;
        }
    }
    return out;
}

bool isInvisible(char32_t c)
{
    return c < 0x20 || (c >= 0x7F && c <= 0x9F) || c == 0xAD || c == 0x61C || c == 0x180E || (c >= 0x200B && c <= 0x200F)
        || (c >= 0x2028 && c <= 0x202E) || (c >= 0x2060 && c <= 0x206F) || c == 0xFEFF || (c >= 0xFFF0 && c <= 0xFFFB)
        || (c & 0xFFFE) == 0xFFFE || (c >= 0xE0000 && c <= 0xE0FFF);
}

} // namespace camwright
