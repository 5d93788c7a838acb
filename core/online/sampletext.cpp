#include "core/online/sampletext.h"

#include <charconv>

namespace camwright {

namespace {

template <class Number>
std::string shortest(Number number)
{
    char text[64];
    return {text, std::to_chars(text, text + sizeof text, number).ptr};
}

} // namespace

std::string secondsText(std::int64_t nanoseconds)
{
    constexpr std::uint64_t Second = 1'000'000'000;
    const bool negative = nanoseconds < 0;
    const std::uint64_t size = negative ? ~static_cast<std::uint64_t>(nanoseconds) + 1 : static_cast<std::uint64_t>(nanoseconds);
    std::string out = (negative ? "-" : "") + std::to_string(size / Second);
    std::string fraction = std::to_string(size % Second + Second).substr(1); // nine digits
    fraction.erase(fraction.find_last_not_of('0') + 1);
    return fraction.empty() ? out : out + '.' + fraction;
}

std::string sampleText(DataType type, double value)
{
    if (type == DataType::Real)
        return shortest(static_cast<float>(value));
    return type == DataType::Lreal ? shortest(value) : shortest(static_cast<std::int64_t>(value));
}

std::string csvCell(std::string_view text)
{
    if (text.find_first_of(",\"\r\n") == std::string_view::npos)
        return std::string(text);
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"')
            out += '"';
        out += c;
    }
    return out + '"';
}

} // namespace camwright
