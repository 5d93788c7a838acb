#pragma once

#include "core/language/source/dialect.h"

#include <cstdint>
#include <string_view>
#include <vector>

namespace camwright {

enum class TokenKind : std::uint8_t {
    Mnemonic,      ///< the first word of a statement
    Address,       ///< %M0.1, D100, X17, D0.3
    Number,        ///< 12, -3, 1200.0, 16#FF
    TypedConstant, ///< B#16#85, DI#100, T#5s, K10 is not one
    Symbol,        ///< a name: variable, subroutine, label
    Pin,           ///< the name before := (our extension)
    Separator,     ///< "," or ":="
    Missing,       ///< ??? : an operand still to be filled in
    Empty,         ///< _ : an optional operand left out
    Comment,       ///< (* … *) or // …; a comment over several lines is one token a line
    NetworkHeader, ///< (* Network 3 *)
    Group,         ///< ")" ending AND( or OR(
    Invalid,       ///< text that has no meaning here
};

/// A stretch of one line. Columns are byte offsets from the start of the line, counted from 0.
struct Token {
    TokenKind kind = TokenKind::Invalid;
    std::uint32_t line = 0;   ///< counted from 0; 0 for tokens of tokenizeLine
    std::uint32_t column = 0;
    std::uint32_t length = 0;

    bool operator==(const Token&) const = default;
};

/// What the lexer must know of the lines before: whether a comment is still open. Plain, so that an editor can keep one
/// number a line and colour again only what changed.
enum class LineState : std::uint8_t { Code = 0, Comment = 1 };

/// Splits one line (without its line end) and returns the state for the next. Blanks get no token. Linear in the length.
/// An open comment ends by itself before a line that is nothing but a network header: the parser reports it.
LineState tokenizeLine(const Dialect& dialect, std::string_view line, LineState state, std::vector<Token>& tokens);

/// All tokens of a text.
std::vector<Token> tokenize(const Dialect& dialect, std::string_view text);

} // namespace camwright
