#pragma once

#include <QString>

namespace camwright {

/// Shipped files: `<executable>/../share/camwright/NAME` (CONTRACTS 25). Empty when it is not there.
QString sharedPath(const QString& name);

namespace words {

/// The file of the page that explains a message: `code` as printed ("CW3001"), in `language`, or in English where that
/// language has none. Empty when no page is installed.
QString explanationPath(const QString& code, const QString& language);
/// The same in the current language.
QString explanationPath(const QString& code);

} // namespace words
} // namespace camwright
