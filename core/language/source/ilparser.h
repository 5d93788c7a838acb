#pragma once

#include "core/base/diagnostic.h"
#include "core/language/source/declarations.h"
#include "core/language/source/diagnosticsink.h"
#include "core/language/source/rung.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace camwright {

/// A rung with the piece of text it came from. The pieces of a program, put together, are the text byte for byte.
struct ParsedRung {
    Rung rung;
    std::string source;  ///< with the comments and blank lines before it and the end of its last line
    bool edited = false; ///< true: `source` is void, the rung is written canonically
};

struct ParsedNetwork {
    std::uint32_t number = 0;         ///< as the header says, or counted where there is none
    std::string header;               ///< the header's line with its line end; empty when derived
    std::vector<ParsedRung> rungs;
    std::string tail;                 ///< blank lines and comments after the last rung
    TextRange range;                  ///< the header, or the first statement
};

/// A program as its text says it, whatever is wrong in it. Nothing of the text is lost.
struct ParsedProgram {
    DialectId dialect = DialectId::KincoIl;
    ObjectKey object;                        ///< the program's place in the project, for diagnostics
    Declarations declarations;               ///< TS600: as `prologue` has them
    std::string prologue;                    ///< before the first network, the "(*n*)" line of .ilp files included
    std::vector<ParsedNetwork> networks;
    std::string epilogue;                    ///< the END line and what follows
    bool crlf = false;                       ///< the first line ends with \r\n; edited rungs are written likewise
    Diagnostics diagnostics;                 ///< at most MaximumDiagnostics, then one that says so
};

/// Reads a program. Never fails: what is not understood becomes an Invalid statement and a diagnostic. Time and memory
/// are linear in the text. Line ends may be \n or \r\n. `object` is put into the places of the diagnostics.
ParsedProgram parseIl(const Dialect& dialect, std::string_view text, const ObjectKey& object = {});

/// The tree of a list of statements: the picture of a rung. Sets `drawable` and `tree`; the statements stay. Reports what is
/// wrong with the flow (a missing LD, ANB without two flows, an open branch) if there is a sink.
void drawRung(const Dialect& dialect, Rung& rung, DiagnosticSink* sink = nullptr);

} // namespace camwright
