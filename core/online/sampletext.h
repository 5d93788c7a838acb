#pragma once

#include "core/base/datatype.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace camwright {

/// Exact decimal seconds of a count of nanoseconds: "0.001", "12", "-1.5".
std::string secondsText(std::int64_t nanoseconds);

/// A sample as its type is written: BOOL 0 or 1, integers whole, REAL and LREAL in the shortest form that reads back the same.
std::string sampleText(DataType type, double value);

/// A cell of a CSV file (RFC 4180): in quotes, inner quotes doubled, if it holds a comma, a quote or a line end; else as it is.
std::string csvCell(std::string_view text);

} // namespace camwright
