#pragma once

#include "core/base/datatype.h"
#include "core/language/source/diagnosticsink.h"
#include "core/language/source/dialect.h"
#include "core/language/source/token.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace camwright {

/// How a variable of a subroutine's table is passed (TS-SBR-03).
enum class ParameterKind : std::uint8_t { In, Out, InOut, Temp };

struct Parameter {
    std::string name;
    ParameterKind kind = ParameterKind::In;
    DataType type = DataType::Int;
    TextRange range;

    bool operator==(const Parameter&) const = default;
};

/// What starts an interrupt routine, as written behind EVENT: "X0 RISING", "10 ms".
struct EventText {
    std::string text;
    TextRange range;

    bool operator==(const EventText&) const = default;
};

/// What stands at the top of a TS600 program before its first network: the variable table of a subroutine, the event of an
/// interrupt routine. The manual has dialogs for both and no text (TS-SBR-03, TS-INT-01); the form is ours:
///
///     VAR_INPUT            EVENT X0 RISING
///       IN1 : INT;         EVENT 10 ms
///     END_VAR
struct Declarations {
    std::vector<Parameter> parameters;
    std::optional<EventText> event;

    bool operator==(const Declarations&) const = default;
};

/// Reads declarations line by line.
class DeclarationReader {
public:
    DeclarationReader(const Dialect& dialect, Declarations& out, DiagnosticSink* sink) : m_dialect(dialect), m_out(out), m_sink(sink) {}

    /// Whether the line (without comments) belongs to the declarations; if so it has been read.
    bool read(std::string_view line, std::uint32_t number);

private:
    bool begin(std::string_view line, std::uint32_t number);
    bool readParameter(std::string_view line, std::uint32_t number);
    void report(Code code, std::string_view line, std::uint32_t number, std::vector<std::string> arguments);

    const Dialect& m_dialect;
    Declarations& m_out;
    DiagnosticSink* m_sink;
    std::optional<ParameterKind> m_section;
};

/// The line with blanks in the place of its comments.
std::string withoutComments(std::string_view line, const std::vector<Token>& tokens);

/// The declarations of a program whose text is not read otherwise. What is wrong in them is left out.
Declarations declarationsOf(const Dialect& dialect, std::string_view text);

} // namespace camwright
