#include "core/base/value.h"

#include <bit>
#include <charconv>
#include <cmath>
#include <limits>
#include <vector>

namespace camwright {

namespace {

std::uint64_t maskOf(DataType type)
{
    const unsigned bits = bitWidth(type);
    return bits == 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << bits) - 1;
}

struct IntegerRange {
    std::int64_t low;
    std::uint64_t high;
};

IntegerRange rangeOf(DataType type)
{
    const unsigned bits = bitWidth(type);
    if (isSigned(type))
        return {bits == 64 ? std::numeric_limits<std::int64_t>::min() : -(std::int64_t{1} << (bits - 1)),
                (std::uint64_t{1} << (bits - 1)) - 1};
    return {0, maskOf(type)};
}

constexpr std::uint64_t RealNaN = 0x7FC00000;
constexpr std::uint64_t LrealNaN = 0x7FF8000000000000;

} // namespace

Value Value::ofReal(float value)
{
    return {DataType::Real, std::isnan(value) ? RealNaN : std::bit_cast<std::uint32_t>(value)};
}

Value Value::ofLreal(double value)
{
    return {DataType::Lreal, std::isnan(value) ? LrealNaN : std::bit_cast<std::uint64_t>(value)};
}

Value Value::ofInteger(DataType type, std::int64_t value)
{
    if (type == DataType::Real)
        return ofReal(static_cast<float>(value));
    if (type == DataType::Lreal)
        return ofLreal(static_cast<double>(value));
    if (type == DataType::Bool)
        return ofBool(value != 0);
    return {type, static_cast<std::uint64_t>(value) & maskOf(type)};
}

Value Value::ofDouble(DataType type, double value)
{
    if (type == DataType::Real)
        return ofReal(static_cast<float>(value));
    if (type == DataType::Lreal)
        return ofLreal(value);
    if (type == DataType::Bool)
        return ofBool(value != 0.0);
    if (std::isnan(value))
        return {type, 0};
    const double rounded = std::nearbyint(value);
    const auto [low, high] = rangeOf(type);
    if (rounded <= static_cast<double>(low))
        return ofInteger(type, low);
    if (rounded >= static_cast<double>(high))
        return {type, high};
    return isSigned(type) ? ofInteger(type, static_cast<std::int64_t>(rounded))
                          : Value{type, static_cast<std::uint64_t>(rounded)};
}

std::int64_t Value::asInteger() const
{
    if (isFloat(type))
        return ofDouble(DataType::Lint, asDouble()).asInteger();
    const unsigned width = bitWidth(type);
    if (!isSigned(type) || width == 64)
        return static_cast<std::int64_t>(bits);
    const unsigned shift = 64 - width;
    return static_cast<std::int64_t>(bits << shift) >> shift;
}

double Value::asDouble() const
{
    if (type == DataType::Real)
        return std::bit_cast<float>(static_cast<std::uint32_t>(bits));
    if (type == DataType::Lreal)
        return std::bit_cast<double>(bits);
    if (!isSigned(type))
        return static_cast<double>(bits);
    return static_cast<double>(asInteger());
}

// Writing

namespace {

std::string digits(std::uint64_t bits, int base)
{
    char buffer[72];
    const auto end = std::to_chars(buffer, buffer + sizeof buffer, bits, base).ptr;
    std::string out(buffer, end);
    for (char& c : out) {
        if (c >= 'a' && c <= 'f')
            c = static_cast<char>(c - 'a' + 'A');
    }
    return out;
}

template <class T>
std::string shortest(T value)
{
    if (std::isnan(value))
        return "NaN";
    if (std::isinf(value))
        return value < 0 ? "-Infinity" : "Infinity";
    char buffer[64];
    std::string out(buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr);
    if (out.find_first_of(".e") == std::string::npos)
        out += ".0";
    return out;
}

std::string formatTime(std::int64_t milliseconds)
{
    std::string out = "T#";
    std::uint64_t rest = static_cast<std::uint64_t>(milliseconds);
    if (milliseconds < 0) {
        out += '-';
        rest = ~rest + 1;
    }
    struct Unit { std::uint64_t size; const char* name; };
    static constexpr Unit Units[] = {{86400000, "d"}, {3600000, "h"}, {60000, "m"}, {1000, "s"}, {1, "ms"}};
    bool any = false;
    for (const Unit& unit : Units) {
        if (const std::uint64_t count = rest / unit.size; count != 0) {
            out += digits(count, 10) + unit.name;
            rest %= unit.size;
            any = true;
        }
    }
    return any ? out : out + "0ms";
}

} // namespace

std::string formatValue(const Value& value, NumberBase base)
{
    if (value.type == DataType::Bool)
        return value.bits ? "TRUE" : "FALSE";
    if (value.type == DataType::Real)
        return shortest(static_cast<float>(value.asDouble()));
    if (value.type == DataType::Lreal)
        return shortest(value.asDouble());
    switch (base) {
    case NumberBase::Hexadecimal: return "16#" + digits(value.bits, 16);
    case NumberBase::Binary: return "2#" + digits(value.bits, 2);
    case NumberBase::Octal: return "8#" + digits(value.bits, 8);
    case NumberBase::Decimal: break;
    }
    if (value.type == DataType::Time)
        return formatTime(value.asInteger());
    if (!isSigned(value.type))
        return digits(value.bits, 10);
    return std::to_string(value.asInteger());
}

// Reading

namespace {

const char* exampleOf(DataType type)
{
    switch (type) {
    case DataType::Bool: return "TRUE or 0";
    case DataType::Real:
    case DataType::Lreal: return "1.5 or 2.5k";
    case DataType::Time: return "T#1m5s250ms";
    default: return "12, 16#FF or 2#101";
    }
}

std::string normalised(std::string_view text)
{
    std::string out;
    for (char c : text) {
        if (c == ' ' || c == '\t' || c == '_')
            continue;
        out += c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    }
    return out;
}

/// Removes "INT#", "DI#", "B#" and the like; false when the prefix names no type.
bool dropTypePrefix(std::string& text)
{
    const auto hash = text.find('#');
    if (hash == std::string::npos || text.empty() || (text[0] >= '0' && text[0] <= '9') || text[0] == '-')
        return true;
    const std::string prefix = text.substr(0, hash);
    static constexpr std::string_view Short[] = {"B", "I", "W", "DI", "DW", "R"};
    bool known = dataTypeByName(prefix).has_value();
    for (std::string_view s : Short)
        known = known || s == prefix;
    if (known)
        text.erase(0, hash + 1);
    return known;
}

std::optional<double> parseDouble(std::string text)
{
    for (char& c : text) {
        if (c == ',')
            c = '.';
    }
    double factor = 1;
    if (!text.empty() && (text.back() == 'K' || text.back() == 'M')) {
        factor = text.back() == 'K' ? 1e3 : 1e6;
        text.pop_back();
    }
    const char* begin = text.data();
    if (!text.empty() && text[0] == '+')
        ++begin;
    double out = 0;
    const auto [end, error] = std::from_chars(begin, text.data() + text.size(), out);
    if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(out * factor))
        return std::nullopt;
    return out * factor;
}

struct Magnitude {
    bool negative = false;
    std::uint64_t size = 0;
};

std::optional<Magnitude> parseInteger(const std::string& text, bool& overflow)
{
    Magnitude out;
    std::size_t at = 0;
    if (at < text.size() && (text[at] == '-' || text[at] == '+'))
        out.negative = text[at++] == '-';
    int base = 10;
    for (const auto& [prefix, value] : {std::pair{"16#", 16}, {"2#", 2}, {"8#", 8}}) {
        if (text.compare(at, std::string_view(prefix).size(), prefix) == 0) {
            base = value;
            at += std::string_view(prefix).size();
            break;
        }
    }
    const char* end = text.data() + text.size();
    if (at >= text.size() || text[at] == '-')
        return std::nullopt;
    const auto result = std::from_chars(text.data() + at, end, out.size, base);
    overflow = result.ec == std::errc::result_out_of_range;
    if (result.ptr != end || (result.ec != std::errc{} && !overflow))
        return std::nullopt;
    return out;
}

/// "T#1m5s250ms" or "TIME#5s", the prefix already gone; in milliseconds.
std::optional<std::int64_t> parseDuration(std::string_view text)
{
    bool negative = false;
    if (!text.empty() && text[0] == '-') {
        negative = true;
        text.remove_prefix(1);
    }
    if (text.empty())
        return std::nullopt;
    double total = 0;
    while (!text.empty()) {
        std::size_t length = 0;
        while (length < text.size() && ((text[length] >= '0' && text[length] <= '9') || text[length] == '.'))
            ++length;
        const auto number = parseDouble(std::string(text.substr(0, length)));
        text.remove_prefix(length);
        if (!number)
            return std::nullopt;
        std::size_t unitLength = text.starts_with("MS") ? 2 : 1;
        const std::string_view unit = text.substr(0, unitLength);
        const double size = unit == "MS" ? 1 : unit == "S" ? 1000 : unit == "M" ? 60000 : unit == "H" ? 3600000 : unit == "D" ? 86400000 : 0;
        if (size == 0)
            return std::nullopt;
        text.remove_prefix(unitLength);
        total += *number * size;
    }
    if (total > 9e15)
        return std::nullopt;
    const auto rounded = static_cast<std::int64_t>(std::nearbyint(total));
    return negative ? -rounded : rounded;
}

Diagnostic notAValue(DataType type, std::string_view text)
{
    return diagnostic(Code::NotAValue, {std::string(text), std::string(name(type)), exampleOf(type)});
}

Diagnostic outOfRange(DataType type, std::string_view text)
{
    const auto [low, high] = rangeOf(type);
    return diagnostic(Code::ValueOutOfRange, {std::string(text), std::string(name(type)), std::to_string(low), std::to_string(high)});
}

} // namespace

Result<Value> parseValue(DataType type, std::string_view typed)
{
    std::string text = normalised(typed);
    if (type == DataType::Time) {
        for (std::string_view prefix : {"TIME#", "T#"}) {
            if (text.starts_with(prefix)) {
                const auto duration = parseDuration(std::string_view(text).substr(prefix.size()));
                if (!duration)
                    return notAValue(type, typed);
                if (*duration > std::numeric_limits<std::int32_t>::max() || *duration < std::numeric_limits<std::int32_t>::min())
                    return outOfRange(type, typed);
                return Value::ofInteger(type, *duration);
            }
        }
    }
    if (!dropTypePrefix(text) || text.empty())
        return notAValue(type, typed);
    if (type == DataType::Bool) {
        if (text == "TRUE" || text == "ON" || text == "1")
            return Value::ofBool(true);
        if (text == "FALSE" || text == "OFF" || text == "0")
            return Value::ofBool(false);
        return notAValue(type, typed);
    }
    if (isFloat(type)) {
        const auto number = parseDouble(text);
        if (!number)
            return notAValue(type, typed);
        const Value out = Value::ofDouble(type, *number);
        return std::isfinite(out.asDouble()) ? Result<Value>(out) : Result<Value>(notAValue(type, typed));
    }
    bool overflow = false;
    auto magnitude = parseInteger(text, overflow);
    if (!magnitude && !text.empty() && (text.back() == 'K' || text.back() == 'M')) {
        if (const auto number = parseDouble(text); number && std::nearbyint(*number) == *number && std::abs(*number) < 1e18)
            magnitude = Magnitude{*number < 0, static_cast<std::uint64_t>(std::abs(*number))};
    }
    if (!magnitude)
        return notAValue(type, typed);
    const auto [low, high] = rangeOf(type);
    const std::uint64_t limit = magnitude->negative ? ~static_cast<std::uint64_t>(low) + 1 : high;
    if (overflow || magnitude->size > limit)
        return outOfRange(type, typed);
    return Value{type, (magnitude->negative ? ~magnitude->size + 1 : magnitude->size) & maskOf(type)};
}

} // namespace camwright
