#include "core/base/diagnostic.h"

#include <algorithm>

namespace camwright {

bool hasErrors(const Diagnostics& diagnostics)
{
    return std::ranges::any_of(diagnostics, [](const Diagnostic& d) { return d.severity() == Severity::Error; });
}

std::string fillTemplate(std::string_view text, const std::vector<std::string>& arguments)
{
    std::string out;
    out.reserve(text.size());
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '%' || i + 1 >= text.size() || text[i + 1] < '1' || text[i + 1] > '9') {
            out += text[i];
            continue;
        }
        const std::size_t index = static_cast<std::size_t>(text[++i] - '1');
        if (index < arguments.size())
            out += arguments[index];
    }
    return out;
}

std::string englishText(const Diagnostic& diagnostic)
{
    return fillTemplate(codeInfo(diagnostic.code).text, diagnostic.arguments);
}

static const char* severityName(Severity severity)
{
    switch (severity) {
    case Severity::Information: return "information";
    case Severity::Warning: return "warning";
    case Severity::Error: return "error";
    }
    return "";
}

std::string englishLine(const Diagnostic& d)
{
    std::string out;
    if (!d.place.file.empty())
        out += d.place.file + ':';
    else if (!d.place.object.name.empty())
        out += std::string(kindName(d.place.object.kind)) + ' ' + d.place.object.name + ':';
    if (d.place.range.isValid())
        out += std::to_string(d.place.range.line) + ':' + std::to_string(d.place.range.column) + ':';
    else if (!d.place.field.empty())
        out += d.place.field + ':';
    if (!out.empty())
        out += ' ';
    const CodeInfo& info = codeInfo(d.code);
    out += severityName(info.severity);
    out += ' ';
    out += info.id;
    out += ": ";
    return out + englishText(d);
}

} // namespace camwright
