#include "core/model/arraytype.h"

#include <charconv>
#include <string_view>

namespace camwright {

namespace {

std::string_view withoutBlanks(std::string_view text)
{
    while (!text.empty() && text.front() == ' ')
        text.remove_prefix(1);
    while (!text.empty() && text.back() == ' ')
        text.remove_suffix(1);
    return text;
}

} // namespace

std::optional<ArrayType> arrayTypeOf(const Field<DataType>& type)
{
    if (type.isValid())
        return std::nullopt;
    const std::string whole = type.text();
    const std::string_view text = withoutBlanks(whole);
    const std::size_t bracket = text.find('[');
    if (bracket == std::string_view::npos || !text.ends_with(']'))
        return std::nullopt;
    const auto element = dataTypeByName(withoutBlanks(text.substr(0, bracket)));
    const std::string_view number = withoutBlanks(text.substr(bracket + 1, text.size() - bracket - 2));
    std::uint32_t length = 0;
    const auto read = std::from_chars(number.data(), number.data() + number.size(), length);
    if (!element || read.ec != std::errc{} || read.ptr != number.data() + number.size() || length == 0 || length > MaximumArrayLength)
        return std::nullopt;
    return ArrayType{*element, length};
}

} // namespace camwright
