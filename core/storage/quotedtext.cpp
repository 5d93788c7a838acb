#include "core/storage/quotedtext.h"

#include "core/base/utf8.h"

#include <charconv>
#include <cstdint>

namespace camwright {

namespace {

void appendCode(std::string& out, char c)
{
    static constexpr char Digits[] = "0123456789ABCDEF";
    const auto byte = static_cast<std::uint8_t>(c);
    out += "\\u00";
    out += Digits[byte >> 4];
    out += Digits[byte & 15];
}

std::string escaped(std::string_view text, bool inQuotes)
{
    std::string out;
    for (char c : validUtf8(text)) {
        const auto byte = static_cast<std::uint8_t>(c);
        if (c == '\\')
            out += "\\\\";
        else if (c == '\n')
            out += "\\n";
        else if (c == '\r')
            out += "\\r";
        else if (c == '\t')
            out += "\\t";
        else if (byte < 0x20 || byte == 0x7F || (inQuotes && c == '*'))
            appendCode(out, c);
        else if (inQuotes && c == '"')
            out += "\\\"";
        else
            out += c;
    }
    return out;
}

void appendUtf8(std::string& out, unsigned value)
{
    if (value < 0x80) {
        out += static_cast<char>(value);
    } else if (value < 0x800) {
        out += static_cast<char>(0xC0 | value >> 6);
        out += static_cast<char>(0x80 | (value & 0x3F));
    } else {
        out += static_cast<char>(0xE0 | value >> 12);
        out += static_cast<char>(0x80 | (value >> 6 & 0x3F));
        out += static_cast<char>(0x80 | (value & 0x3F));
    }
}

/// The code of \uXXXX at the beginning of `text`; surrogates are no characters.
std::optional<unsigned> codeEscape(std::string_view text)
{
    if (text.size() < 6 || text[1] != 'u')
        return std::nullopt;
    unsigned value = 0;
    const char* end = text.data() + 6;
    const auto result = std::from_chars(text.data() + 2, end, value, 16);
    if (result.ptr != end || result.ec != std::errc{} || (value >= 0xD800 && value <= 0xDFFF))
        return std::nullopt;
    return value;
}

} // namespace

std::string quoted(std::string_view text)
{
    return '"' + escaped(text, true) + '"';
}

std::string escapedLine(std::string_view text)
{
    return escaped(text, false);
}

std::string unescaped(std::string_view text)
{
    std::string out;
    for (std::size_t at = 0; at < text.size(); ++at) {
        const char next = text[at] == '\\' && at + 1 < text.size() ? text[at + 1] : '\0';
        if (next == 'n' || next == 'r' || next == 't') {
            out += next == 'n' ? '\n' : next == 'r' ? '\r' : '\t';
            ++at;
        } else if (next == '\\' || next == '"') {
            out += next;
            ++at;
        } else if (const auto code = next == 'u' ? codeEscape(text.substr(at)) : std::nullopt) {
            appendUtf8(out, *code);
            at += 5;
        } else {
            out += text[at];
        }
    }
    return out;
}

std::optional<std::size_t> quotedLength(std::string_view text)
{
    for (std::size_t at = 1; at < text.size() && text[at] != '\n'; ++at) {
        if (text[at] == '\\')
            ++at;
        else if (text[at] == '"')
            return at + 1;
    }
    return std::nullopt;
}

} // namespace camwright
