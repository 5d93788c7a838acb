#include "core/storage/settingsline.h"

#include "core/storage/quotedtext.h"

#include <algorithm>

namespace camwright {

namespace {

constexpr std::string_view Opening = "(* camwright:";

bool isBareCharacter(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '.' || c == '-' || c == '+';
}

std::size_t bareLength(std::string_view text)
{
    return static_cast<std::size_t>(std::find_if_not(text.begin(), text.end(), isBareCharacter) - text.begin());
}

void skipBlanks(std::string_view& rest)
{
    rest.remove_prefix(std::min(rest.find_first_not_of(" \t"), rest.size()));
}

/// `key=value` at the beginning of `rest`, which moves behind it; false when there is none.
bool readSetting(std::string_view& rest, std::map<std::string, std::string>& values)
{
    skipBlanks(rest);
    const std::size_t keyLength = bareLength(rest);
    const std::string key(rest.substr(0, keyLength));
    rest.remove_prefix(keyLength);
    if (key.empty() || !rest.starts_with('='))
        return false;
    rest.remove_prefix(1);
    const std::size_t length = rest.starts_with('"') ? quotedLength(rest).value_or(0) : bareLength(rest);
    if (length == 0)
        return false;
    const bool added = values.emplace(key, rest.substr(0, length)).second;
    rest.remove_prefix(length);
    skipBlanks(rest);
    return added;
}

} // namespace

Result<SettingsLine> readSettingsLine(std::string_view text, const std::string& file, std::string_view example)
{
    SettingsLine out;
    const std::size_t newline = text.find('\n');
    std::string_view rest = text.substr(0, newline);
    out.length = newline == std::string_view::npos ? text.size() : newline + 1;
    Place place;
    place.file = file;
    place.range = {1, 1, 1, static_cast<std::uint32_t>(rest.size() + 1)};
    const Diagnostic missing = diagnostic(Code::SettingsLineMissing, {std::string(example)}, place);
    if (!rest.starts_with(Opening))
        return missing;
    rest.remove_prefix(Opening.size());
    do {
        if (!readSetting(rest, out.values))
            return missing;
        if (!rest.starts_with(','))
            break;
        rest.remove_prefix(1);
    } while (true);
    if (!rest.starts_with("*)"))
        return missing;
    rest.remove_prefix(2);
    skipBlanks(rest);
    return rest.empty() ? Result<SettingsLine>(std::move(out)) : Result<SettingsLine>(missing);
}

std::string writeSettingsLine(const std::vector<std::pair<std::string, std::string>>& values)
{
    std::string out(Opening);
    for (const auto& [key, value] : values) {
        out += &values.front().first == &key ? " " : ", ";
        out += key + '=' + value;
    }
    return out + " *)";
}

std::string settingText(std::string_view value)
{
    return !value.empty() && bareLength(value) == value.size() ? std::string(value) : quoted(value);
}

std::string settingValue(std::string_view text)
{
    return text.size() >= 2 && text.starts_with('"') ? unescaped(text.substr(1, text.size() - 2)) : std::string(text);
}

} // namespace camwright
