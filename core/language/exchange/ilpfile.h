#pragma once

#include "core/base/diagnostic.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace camwright {

/// A Kinco .ilp file as program source. The form of the file is not in the manuals; it is the one KincoBuilder is known to
/// write: a line "(*n*)" with the number of networks, the networks, a line END.
struct IlpImport {
    std::string source;       ///< the networks; lines end with \n
    Diagnostics diagnostics;  ///< what is not as such a file should be; nothing of the text is left out because of it
};

/// `name` goes into the places of the diagnostics as the file's name.
IlpImport importIlp(std::string_view text, const std::string& name = {});

/// The text of a program as an .ilp file: count, networks as they stand, END; lines end with \r\n.
std::string exportIlp(std::string_view source);

} // namespace camwright
