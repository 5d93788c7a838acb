#include "core/storage/filenames.h"

#include "core/base/hash.h"
#include "core/base/utf8.h"

#include <algorithm>
#include <array>

namespace camwright {

namespace {

constexpr std::size_t LongestStem = 240; // 255 bytes less an ending and a prefix a tool may add
constexpr std::string_view EmptyName = "%-";
constexpr std::string_view ShortenedMark = "%~";

void appendEscaped(std::string& out, char byte)
{
    static constexpr char Digits[] = "0123456789ABCDEF";
    const auto value = static_cast<std::uint8_t>(byte);
    out += '%';
    out += Digits[value >> 4];
    out += Digits[value & 15];
}

bool isReservedWord(std::string_view name)
{
    static constexpr std::string_view Words[] = {"con", "prn", "aux", "nul", "conin$", "conout$"};
    const std::string folded = foldedCase(name.substr(0, name.find('.')));
    if (std::find(std::begin(Words), std::end(Words), folded) != std::end(Words))
        return true;
    return folded.size() == 4 && (folded.starts_with("com") || folded.starts_with("lpt")) && folded[3] >= '0' && folded[3] <= '9';
}

bool mayStand(char32_t c)
{
    return !isInvisible(c) && (c >= 0x80 || std::string_view("<>:\"/\\|?*%").find(static_cast<char>(c)) == std::string_view::npos);
}

bool isLetter(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

std::optional<int> hexDigit(char c)
{
    if (c >= '0' && c <= '9')
        return c - '0';
    if (c >= 'A' && c <= 'F')
        return c - 'A' + 10;
    if (c >= 'a' && c <= 'f')
        return c - 'a' + 10;
    return std::nullopt;
}

std::string encoded(std::string_view name, bool lettersToo)
{
    if (name.empty())
        return std::string(EmptyName);
    std::string out;
    const bool reserved = isReservedWord(name);
    for (std::size_t at = 0; at < name.size();) {
        const auto point = codePointAt(name, at);
        const std::size_t length = point ? point->length : 1;
        const bool edge = (at == 0 || at + length == name.size()) && (name[at] == '.' || name[at] == ' ');
        const bool plain = point && mayStand(point->value) && !edge && !(reserved && at == 0) && !(lettersToo && isLetter(name[at]));
        for (std::size_t n = 0; n < length; ++n) {
            if (plain)
                out += name[at + n];
            else
                appendEscaped(out, name[at + n]);
        }
        at += length;
    }
    return out;
}

std::string shortened(std::string stem, std::string_view name)
{
    if (stem.size() <= LongestStem)
        return stem;
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(name.data());
    const std::string tail = std::string(ShortenedMark) + toHex(hashOf(ByteSpan(bytes, name.size()))).substr(0, 32);
    std::size_t cut = LongestStem - tail.size();
    while (cut > 0 && (static_cast<std::uint8_t>(stem[cut]) & 0xC0) == 0x80)
        --cut;
    for (std::size_t back = 1; back <= 2 && cut >= back; ++back) {
        if (stem[cut - back] == '%') {
            cut -= back;
            break;
        }
    }
    return stem.substr(0, cut) + tail;
}

} // namespace

std::string stemOf(std::string_view name)
{
    return shortened(encoded(name, false), name);
}

std::string distinctStemOf(std::string_view name)
{
    return shortened(encoded(name, true), name);
}

std::string encodedName(std::string_view name)
{
    return encoded(name, false);
}

bool isShortened(std::string_view stem)
{
    return stem.find(ShortenedMark) != std::string_view::npos;
}

std::optional<std::string> nameOfStem(std::string_view stem)
{
    if (stem == EmptyName)
        return std::string();
    std::string out;
    for (std::size_t at = 0; at < stem.size(); ++at) {
        if (stem[at] != '%') {
            out += stem[at];
            continue;
        }
        if (at + 2 >= stem.size())
            return std::nullopt;
        const auto high = hexDigit(stem[at + 1]);
        const auto low = hexDigit(stem[at + 2]);
        if (!high || !low)
            return std::nullopt;
        out += static_cast<char>(*high * 16 + *low);
        at += 2;
    }
    return out.empty() ? std::nullopt : std::optional(out);
}

std::string foldedCase(std::string_view name)
{
    std::string out(name);
    for (char& c : out) {
        if (c >= 'A' && c <= 'Z')
            c = static_cast<char>(c - 'A' + 'a');
    }
    return out;
}

std::optional<std::string_view> FilePattern::endingOf(std::string_view file) const
{
    if (file.ends_with(ending))
        return ending;
    if (!otherEnding.empty() && file.ends_with(otherEnding))
        return otherEnding;
    return std::nullopt;
}

FilePattern filePattern(ObjectKind kind)
{
    switch (kind) {
    case ObjectKind::Project: return {"", "project.toml"};
    case ObjectKind::Controller: return {"", "controller.toml"};
    case ObjectKind::Axis: return {"axes/", ".toml"};
    case ObjectKind::Network: return {"networks/", ".toml"};
    case ObjectKind::Program: return {"programs/", ".il", ".st"};
    case ObjectKind::VariableTable: return {"variables/", ".var"};
    case ObjectKind::WatchTable: return {"watches/", ".toml"};
    }
    return {};
}

} // namespace camwright
