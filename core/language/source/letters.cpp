#include "core/language/source/letters.h"

#include <fmt/format.h>

namespace camwright {

namespace {

struct Lookalike {
    std::uint32_t code;
    char latin;
};

// Capital and small letters that are drawn like a Latin one: Cyrillic, then Greek.
constexpr Lookalike Lookalikes[] = {
    {0x0405, 'S'}, {0x0406, 'I'}, {0x0408, 'J'}, {0x0410, 'A'}, {0x0412, 'B'}, {0x0415, 'E'}, {0x0417, '3'}, {0x041A, 'K'},
    {0x041C, 'M'}, {0x041D, 'H'}, {0x041E, 'O'}, {0x0420, 'P'}, {0x0421, 'C'}, {0x0422, 'T'}, {0x0423, 'Y'}, {0x0425, 'X'},
    {0x0430, 'a'}, {0x0435, 'e'}, {0x043E, 'o'}, {0x0440, 'p'}, {0x0441, 'c'}, {0x0443, 'y'}, {0x0445, 'x'}, {0x0455, 's'},
    {0x0456, 'i'}, {0x0458, 'j'}, {0x0391, 'A'}, {0x0392, 'B'}, {0x0395, 'E'}, {0x0396, 'Z'}, {0x0397, 'H'}, {0x0399, 'I'},
    {0x039A, 'K'}, {0x039C, 'M'}, {0x039D, 'N'}, {0x039F, 'O'}, {0x03A1, 'P'}, {0x03A4, 'T'}, {0x03A5, 'Y'}, {0x03A7, 'X'},
};

bool isContinuation(std::string_view text, std::size_t offset)
{
    return offset < text.size() && (static_cast<unsigned char>(text[offset]) & 0xC0u) == 0x80u;
}

template <class Visitor>
void forEachCharacter(std::string_view text, Visitor visit)
{
    for (std::size_t at = 0; at < text.size();) {
        const Utf8Character character = characterAt(text, at);
        if (!visit(at, character))
            return;
        at += character.length;
    }
}

} // namespace

Utf8Character characterAt(std::string_view text, std::size_t offset)
{
    const auto first = static_cast<unsigned char>(text[offset]);
    if (first < 0x80)
        return {first, 1, true};
    const std::uint32_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
    if (first < 0xC2 || first > 0xF4)
        return {first, 1, false};
    std::uint32_t code = first & (0x7Fu >> length);
    for (std::uint32_t i = 1; i < length; ++i) {
        if (!isContinuation(text, offset + i))
            return {first, 1, false};
        code = (code << 6) | (static_cast<unsigned char>(text[offset + i]) & 0x3Fu);
    }
    const bool overlong = (length == 3 && code < 0x800) || (length == 4 && code < 0x10000);
    const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
    if (overlong || surrogate || code > 0x10FFFF)
        return {first, 1, false};
    return {code, length, true};
}

bool isOddCharacter(std::uint32_t code)
{
    const bool control = (code < 0x20 && code != '\t' && code != '\n' && code != '\r') || (code >= 0x7F && code < 0xA0);
    const bool direction = (code >= 0x202A && code <= 0x202E) || (code >= 0x2066 && code <= 0x2069) || code == 0x200E || code == 0x200F || code == 0x061C;
    const bool zeroWidth = (code >= 0x200B && code <= 0x200D) || code == 0x2060 || code == 0xFEFF || code == 0x00AD || code == 0x180E;
    const bool lineEnd = code == 0x2028 || code == 0x2029;
    return control || direction || zeroWidth || lineEnd;
}

bool isOddBlank(std::uint32_t code)
{
    return code == 0x00A0 || code == 0x1680 || (code >= 0x2000 && code <= 0x200A) || code == 0x202F || code == 0x205F || code == 0x3000;
}

std::string withPlainBlanks(std::string_view text)
{
    std::string out(text);
    forEachCharacter(text, [&](std::size_t at, Utf8Character character) {
        if (character.legal && isOddBlank(character.code))
            out.replace(at, character.length, character.length, ' ');
        return true;
    });
    return out;
}

bool isCyrillic(std::uint32_t code)
{
    return code >= 0x0400 && code <= 0x052F;
}

bool hasCyrillic(std::string_view text)
{
    bool found = false;
    forEachCharacter(text, [&](std::size_t, Utf8Character character) {
        found = character.legal && isCyrillic(character.code);
        return !found;
    });
    return found;
}

std::optional<char> latinLookalike(std::uint32_t code)
{
    if (code >= 0xFF01 && code <= 0xFF5E) // full-width forms of ASCII
        return static_cast<char>(code - 0xFF01 + '!');
    for (const Lookalike& entry : Lookalikes)
        if (entry.code == code)
            return entry.latin;
    return std::nullopt;
}

std::string withLatinLetters(std::string_view text)
{
    std::string out;
    forEachCharacter(text, [&](std::size_t at, Utf8Character character) {
        if (const auto latin = character.legal ? latinLookalike(character.code) : std::nullopt)
            out += *latin;
        else
            out += text.substr(at, character.length);
        return true;
    });
    return out;
}

std::string firstLookalike(std::string_view text)
{
    std::string out;
    forEachCharacter(text, [&](std::size_t, Utf8Character character) {
        if (character.legal && latinLookalike(character.code))
            out = codePointName(character.code);
        return out.empty();
    });
    return out;
}

std::string codePointName(std::uint32_t code)
{
    return fmt::format("U+{:04X}", code);
}

std::string shortened(std::string_view text, std::size_t limit)
{
    std::string out;
    bool cut = false;
    forEachCharacter(text, [&](std::size_t at, Utf8Character character) {
        if (out.size() + character.length > limit) {
            cut = true;
            return false;
        }
        if (!character.legal)
            out += "\xEF\xBF\xBD";
        else if (character.code < 0x20 || isOddCharacter(character.code))
            out += ' ';
        else
            out += text.substr(at, character.length);
        return true;
    });
    return cut ? out + "…" : out;
}

std::string upperCase(std::string_view text)
{
    std::string out(text);
    for (char& c : out)
        if (c >= 'a' && c <= 'z')
            c = static_cast<char>(c - 'a' + 'A');
    return out;
}

std::string_view trimmed(std::string_view text)
{
    while (!text.empty() && isBlank(text.front()))
        text.remove_prefix(1);
    while (!text.empty() && isBlank(text.back()))
        text.remove_suffix(1);
    return text;
}

} // namespace camwright
