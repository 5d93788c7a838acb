#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace camwright {

/// "text" with \" \\ \n \r \t and \uXXXX for other control characters; `*` is \u002A so that no comment ends inside.
std::string quoted(std::string_view text);
/// The same replacements without the quotes, for a comment that goes to the end of its line; `*` and " stay.
std::string escapedLine(std::string_view text);

/// Undoes the replacements; a backslash before anything else stands for itself.
std::string unescaped(std::string_view text);

/// Length of the quoted text at the beginning of `text`, both quotes included; nothing when it does not end in its line.
std::optional<std::size_t> quotedLength(std::string_view text);

} // namespace camwright
