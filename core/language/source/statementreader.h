#pragma once

#include "core/language/source/diagnosticsink.h"
#include "core/language/source/rung.h"
#include "core/language/source/token.h"

#include <span>
#include <string_view>

namespace camwright {

/// More operands than any instruction takes; a line with more is reported and kept as text.
inline constexpr std::size_t MaximumOperands = 64;

/// Makes statements of the tokens of a line, and names what copying did to them.
class StatementReader {
public:
    StatementReader(const Dialect& dialect, DiagnosticSink& sink) : m_dialect(dialect), m_sink(sink) {}

    /// `tokens` begin with a mnemonic (or a group's end) and hold no comments.
    Statement read(std::string_view line, std::uint32_t number, std::span<const Token> tokens);

    /// Reports characters that cannot be seen, blanks that are none, bytes that are no UTF-8.
    void checkCharacters(std::string_view line, std::uint32_t number, std::span<const Token> tokens);

private:
    void readOperands(std::string_view line, std::uint32_t number, std::span<const Token> tokens, Statement& statement);
    Operand readOperand(std::string_view text, const TextRange& range);

    const Dialect& m_dialect;
    DiagnosticSink& m_sink;
};

} // namespace camwright
