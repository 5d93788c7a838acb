#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace camwright {

/// "(* Network 3 *)" in a line.
struct NetworkHeader {
    std::uint32_t number = 0; ///< saturated; larger numbers than a program can have are reported by the parser
    std::size_t end = 0;      ///< column behind it
};

/// A network header that begins at `at`. Case and blanks do not matter.
std::optional<NetworkHeader> networkHeaderAt(std::string_view line, std::size_t at);

/// Whether a line holds a network header and nothing else: such a line ends a comment that somebody forgot to close.
bool isNetworkHeader(std::string_view line);

/// "(\* Network \* 0)" and its kin: a header that went through Markdown. The number, or nothing.
std::optional<std::uint32_t> escapedNetworkHeader(std::string_view line);

/// "(*12*)": the first line of a Kinco .ilp file, the number of networks in it.
std::optional<std::uint32_t> ilpCount(std::string_view line);

} // namespace camwright
