#pragma once

namespace camwright {

/// Numbers of the marks the code view draws over its text; Scintilla leaves those from 8 on to its users.
inline constexpr int ErrorIndicator = 8, WarningIndicator = 9, SearchIndicator = 10, EnergisedIndicator = 11;

} // namespace camwright
