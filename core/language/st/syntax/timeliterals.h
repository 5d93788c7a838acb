#pragma once

#include "core/language/st/syntax/token.h"

#include <cstdint>
#include <optional>
#include <string_view>

namespace camwright::st {

/// Which literal a prefix begins: "T" and "TIME" a duration, "D" a date, "LDATE_AND_TIME" a long date and time. Any case.
std::optional<TokenKind> timeLiteralKind(std::string_view prefix);

/// What a correct one looks like: "T#1h30m2.5s".
std::string_view exampleOf(TokenKind kind);

/// What follows T#: "1d2h3m4s5ms6us7ns", units falling, a fraction in the last, underscores between, a sign in front. In ns;
/// nothing if it is no duration or longer than 292 years.
std::optional<std::int64_t> parseDuration(std::string_view text);

/// What follows D#, TOD# and DT#: "1984-06-25", "15:36:55.36", "1984-06-25-15:36:55.36". Dates in ns since 1970-01-01, times of
/// day in ns since midnight. Nothing for a day or an hour that does not exist, or a year outside 1970 … 2262.
std::optional<std::int64_t> parseDate(TokenKind kind, std::string_view text);

/// Days from 1970-01-01 to a date of the Gregorian calendar.
std::int64_t daysFromCivil(std::int64_t year, unsigned month, unsigned day);

} // namespace camwright::st
