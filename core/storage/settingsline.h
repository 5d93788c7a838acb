#pragma once

#include "core/base/result.h"

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace camwright {

/// The first line of a program or a table of variables: `(* camwright: role=main, order=1 *)`. It is no part of the text
/// an editor shows.
struct SettingsLine {
    std::map<std::string, std::string> values; ///< as written: a bare word or a quoted text
    std::size_t length = 0;                    ///< bytes of the line with its end
};

/// `example` is what a file of this kind begins with, for the message when the line is missing.
Result<SettingsLine> readSettingsLine(std::string_view text, const std::string& file, std::string_view example);

/// The line without its end; `order` of the pairs is kept.
std::string writeSettingsLine(const std::vector<std::pair<std::string, std::string>>& values);

std::string settingText(std::string_view value);   ///< quoted unless it is a bare word
std::string settingValue(std::string_view text);   ///< the opposite

} // namespace camwright
