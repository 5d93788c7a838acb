#include "core/online/valuename.h"

namespace camwright {

namespace {

std::string_view trimmed(std::string_view text)
{
    constexpr std::string_view Blanks = " \t\r\n";
    const std::size_t first = text.find_first_not_of(Blanks);
    return first == std::string_view::npos ? std::string_view() : text.substr(first, text.find_last_not_of(Blanks) - first + 1);
}

} // namespace

std::string axisValueName(std::string_view axis, std::string_view value)
{
    const std::string_view quote = axis.find_first_of(" .,") == std::string_view::npos ? "" : "\"";
    std::string out = "axis.";
    out.append(quote).append(axis).append(quote).append(".").append(value);
    return out;
}

std::vector<std::string> splitValueNames(std::string_view list)
{
    std::vector<std::string> out;
    const auto take = [&out](std::string_view name) {
        if (name = trimmed(name); !name.empty())
            out.emplace_back(name);
    };
    bool quoted = false;
    std::size_t begin = 0;
    for (std::size_t i = 0; i < list.size(); ++i) {
        if (list[i] == '"')
            quoted = !quoted;
        if (list[i] != ',' || quoted)
            continue;
        take(list.substr(begin, i - begin));
        begin = i + 1;
    }
    take(list.substr(begin));
    return out;
}

} // namespace camwright
