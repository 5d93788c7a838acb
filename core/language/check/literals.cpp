#include "core/language/check/literals.h"

#include "core/language/source/letters.h"

#include <algorithm>

namespace camwright {

namespace {

constexpr TypeSet Integers{DataType::Byte, DataType::Word, DataType::Dword, DataType::Sint, DataType::Int, DataType::Dint,
    DataType::Usint, DataType::Uint, DataType::Udint, DataType::Lint, DataType::Ulint, DataType::Lword};
constexpr TypeSet Reals{DataType::Real, DataType::Lreal};

std::optional<DataType> typeOfPrefix(std::string_view prefix)
{
    struct Short {
        std::string_view prefix;
        DataType type;
    };
    static constexpr Short Shorts[] = {{"B", DataType::Byte}, {"I", DataType::Int}, {"W", DataType::Word},
        {"DI", DataType::Dint}, {"DW", DataType::Dword}, {"R", DataType::Real}, {"T", DataType::Time}};
    for (const Short& entry : Shorts)
        if (entry.prefix == prefix)
            return entry.type;
    return dataTypeByName(prefix);
}

std::size_t digitsAt(std::string_view text, std::size_t at, unsigned base)
{
    std::size_t n = 0;
    for (; at + n < text.size(); ++n) {
        const char c = text[at + n];
        const unsigned digit = isDigit(c) ? static_cast<unsigned>(c - '0') : c >= 'A' && c <= 'F' ? static_cast<unsigned>(c - 'A' + 10) : 99;
        if (digit >= base && !(c == '_' && n > 0))
            break;
    }
    return n;
}

std::string_view withoutSign(std::string_view text)
{
    if (text.starts_with('-') || text.starts_with('+'))
        text.remove_prefix(1);
    return text;
}

bool isInteger(std::string_view text)
{
    text = withoutSign(text);
    for (const auto& [prefix, base] : {std::pair{"16#", 16u}, {"8#", 8u}, {"2#", 2u}})
        if (text.starts_with(prefix)) {
            const std::size_t begin = std::string_view(prefix).size();
            const std::size_t n = digitsAt(text, begin, base);
            return n > 0 && begin + n == text.size();
        }
    return !text.empty() && digitsAt(text, 0, 10) == text.size();
}

bool isReal(std::string_view text)
{
    text = withoutSign(text);
    const std::size_t whole = digitsAt(text, 0, 10);
    if (whole == 0 || whole >= text.size() || text[whole] != '.')
        return false;
    const std::size_t fraction = digitsAt(text, whole + 1, 10);
    std::string_view rest = text.substr(whole + 1 + fraction);
    if (fraction == 0 || rest.empty())
        return fraction > 0;
    if (rest.front() != 'E')
        return false;
    rest = withoutSign(rest.substr(1));
    return !rest.empty() && digitsAt(rest, 0, 10) == rest.size();
}

} // namespace

std::optional<Literal> Literal::read(std::string_view text)
{
    Literal out;
    out.m_text = upperCase(text);
    const std::string_view all = out.m_text;
    if (all == "TRUE" || all == "FALSE") {
        out.m_types = {DataType::Bool};
        return out;
    }
    if (isInteger(all)) {
        out.m_types = Integers;
        if (all == "0" || all == "1")
            out.m_types.insert(DataType::Bool);
        return out;
    }
    if (isReal(all)) {
        out.m_types = Reals;
        return out;
    }
    const std::size_t hash = all.find('#');
    if (hash == std::string_view::npos)
        return std::nullopt;
    const auto type = typeOfPrefix(all.substr(0, hash));
    const std::string_view rest = all.substr(hash + 1);
    if (!type)
        return std::nullopt;
    const bool fits = isFloat(*type) ? isReal(rest) || isInteger(rest) : *type == DataType::Time ? parseValue(*type, all).ok() : isInteger(rest);
    if (!fits)
        return std::nullopt;
    out.m_types = {*type};
    return out;
}

} // namespace camwright
