#pragma once

#include "core/base/codes.h"
#include "core/base/place.h"

#include <optional>
#include <string>
#include <vector>

namespace camwright {

/// Something a user should know: a code, its arguments, where it is, and perhaps a second place that explains it.
/// It carries no sentence; a view puts it into words (editors/words), `englishText` serves logs and tests.
struct Diagnostic {
    Code code = Code::InternalError;
    std::vector<std::string> arguments;
    Place place;
    std::optional<Place> related;

    Severity severity() const { return codeInfo(code).severity; }
    bool operator==(const Diagnostic&) const = default;
};

using Diagnostics = std::vector<Diagnostic>;

inline Diagnostic diagnostic(Code code, std::vector<std::string> arguments = {}, Place place = {})
{
    return {code, std::move(arguments), std::move(place), std::nullopt};
}

bool hasErrors(const Diagnostics& diagnostics);

/// The text of the code with %1 … %9 replaced. A '%' in an argument is not looked at again.
std::string fillTemplate(std::string_view text, const std::vector<std::string>& arguments);
std::string englishText(const Diagnostic& diagnostic);

/// "file:line:column: error CW3001: text", the form compilers use; parts that are not known are left out.
std::string englishLine(const Diagnostic& diagnostic);

} // namespace camwright
