#pragma once

#include "core/language/source/ilparser.h"

#include <functional>
#include <optional>
#include <string>

namespace camwright {

/// The way out of a group that strict Kinco does not take (CONTRACTS 32): writes each AND( OR( group of a network to a marker
/// bit in a network of its own before, and uses the bit instead. `freeMarker` gives a new free bit address at each call.
/// The text that takes the place of the network, its networks numbered from the network's own number on; the caller numbers
/// those behind anew. Nothing if the network has no group, or a group that holds more than contacts and comparisons.
std::optional<std::string> splitGroups(const ParsedNetwork& network, const std::function<std::string()>& freeMarker);

} // namespace camwright
