#pragma once

#include "core/language/source/diagnosticsink.h"
#include "core/language/st/syntax/textlines.h"
#include "core/language/st/syntax/token.h"

#include <string_view>

namespace camwright::st {

inline constexpr std::size_t LongestName = 128; ///< letters of a name; ours

/// Turns text into tokens, one call a token, each byte looked at once. Comments nest ((* *) and /* */); pragmas in braces
/// are passed over. What is wrong is reported where it is and read on.
class Lexer {
public:
    Lexer(const TextLines& lines, Names& names, DiagnosticSink& sink) : m_text(lines.text()), m_lines(lines), m_names(names), m_sink(sink)
    {
        if (m_text.starts_with("\xEF\xBB\xBF")) // a byte order mark
            m_at = 3;
    }

    Token next();
    /// Whether a comment or pragma without an end has swallowed the rest of the text.
    bool endsEarly() const { return m_endsEarly; }
    /// Text of a token.
    std::string_view textOf(const Token& token) const { return m_text.substr(token.offset, token.end - token.offset); }

private:
    char at(std::size_t offset) const { return offset < m_text.size() ? m_text[offset] : '\0'; }
    bool startsWith(std::string_view text) const { return m_text.substr(m_at, text.size()) == text; }

    bool skipBlanks();
    bool skipComment();
    void skipNested(std::string_view open, std::string_view close);
    void skipPragma();
    void checkForeign();

    void readWord(Token& token);
    void readNumber(Token& token);
    void readBased(Token& token, unsigned base);
    void readReal(Token& token);
    void readText(Token& token);
    void readAddress(Token& token);
    void readForeign(Token& token);
    void readSymbol(Token& token);
    bool readPrefixed(Token& token);
    void skipDigits();
    void skipLiteral(std::string_view allowed);

    void report(Code code, std::size_t from, std::size_t to, std::vector<std::string> arguments = {});

    std::string_view m_text;
    const TextLines& m_lines;
    Names& m_names;
    DiagnosticSink& m_sink;
    std::size_t m_at = 0;
    bool m_startsLine = true;
    bool m_endsEarly = false;
};

} // namespace camwright::st
