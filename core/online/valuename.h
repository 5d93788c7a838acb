#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace camwright {

/// The name of an axis value: axis.Feed.position, or axis."Axis 1 name".position where the axis' name has a blank or a dot
/// (CONTRACTS 18).
std::string axisValueName(std::string_view axis, std::string_view value);

/// Names from a list with commas between them, blanks around each dropped, empty ones left out. A comma inside quotes
/// belongs to the name: axis."Long, name".position stays one.
std::vector<std::string> splitValueNames(std::string_view list);

} // namespace camwright
