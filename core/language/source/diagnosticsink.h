#pragma once

#include "core/base/diagnostic.h"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace camwright {

/// Diagnostics a stage collects before it says that there are more.
inline constexpr std::size_t MaximumDiagnostics = 300;
/// Of these at most so many that are no errors: a program with many warnings can still be built.
inline constexpr std::size_t MaximumWarnings = 100;

/// Collects the diagnostics of one object up to the limits above, then adds one that says so.
class DiagnosticSink {
public:
    DiagnosticSink(Diagnostics& out, ObjectKey object) : m_out(out), m_object(std::move(object)) {}

    void add(Code code, const TextRange& range, std::vector<std::string> arguments = {}, const TextRange& related = {});
    void add(Diagnostic diagnostic);
    /// Adds a second place to the diagnostic added last.
    void relate(Place place);
    /// Puts them into the order of the text.
    void sort();
    bool isFull() const { return m_out.size() >= MaximumDiagnostics; }
    const ObjectKey& object() const { return m_object; }

private:
    Diagnostics& m_out;
    ObjectKey m_object;
};

} // namespace camwright
