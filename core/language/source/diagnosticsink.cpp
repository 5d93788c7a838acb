#include "core/language/source/diagnosticsink.h"

#include <algorithm>

namespace camwright {

void DiagnosticSink::add(Code code, const TextRange& range, std::vector<std::string> arguments, const TextRange& related)
{
    Diagnostic out = diagnostic(code, std::move(arguments), Place{m_object, {}, range, {}});
    if (related.isValid())
        out.related = Place{m_object, {}, related, {}};
    add(std::move(out));
}

void DiagnosticSink::add(Diagnostic diagnostic)
{
    if (m_out.size() > MaximumDiagnostics)
        return;
    if (diagnostic.severity() != Severity::Error && m_out.size() >= MaximumWarnings) {
        const auto warnings = static_cast<std::size_t>(std::count_if(m_out.begin(), m_out.end(),
            [](const Diagnostic& d) { return d.severity() != Severity::Error; }));
        if (warnings > MaximumWarnings)
            return;
        if (warnings == MaximumWarnings)
            diagnostic = camwright::diagnostic(Code::TooManyWarnings, {std::to_string(MaximumWarnings)}, diagnostic.place);
    }
    if (m_out.size() == MaximumDiagnostics) {
        m_out.push_back(camwright::diagnostic(Code::TooManyDiagnostics, {std::to_string(MaximumDiagnostics)}, diagnostic.place));
        return;
    }
    m_out.push_back(std::move(diagnostic));
}

void DiagnosticSink::relate(Place place)
{
    if (!m_out.empty() && m_out.size() <= MaximumDiagnostics)
        m_out.back().related = std::move(place);
}

void DiagnosticSink::sort()
{
    // By place, equal places in the order they were found. (stable_sort of the library in use calls what it deprecates.)
    const std::size_t count = std::min(m_out.size(), MaximumDiagnostics);
    std::vector<std::size_t> order(count);
    for (std::size_t i = 0; i < count; ++i)
        order[i] = i;
    std::sort(order.begin(), order.end(), [this](std::size_t a, std::size_t b) {
        return std::pair(m_out[a].place.range, a) < std::pair(m_out[b].place.range, b);
    });
    Diagnostics sorted;
    for (const std::size_t index : order)
        sorted.push_back(std::move(m_out[index]));
    std::move(sorted.begin(), sorted.end(), m_out.begin());
}

} // namespace camwright
