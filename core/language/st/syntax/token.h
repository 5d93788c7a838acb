#pragma once

#include "core/language/st/syntax/names.h"

#include <cstdint>

namespace camwright::st {

enum class TokenKind : std::uint8_t {
    End, Name, Word,
    Integer, Real, Duration, LongDuration, Date, LongDate, TimeOfDay, LongTimeOfDay, DateTime, LongDateTime, Text, WideText, Address,
    Assign, Attempt, Output, Equal, NotEqual, Less, LessEqual, Greater, GreaterEqual,
    Plus, Minus, Times, Power, Divide, Ampersand, OpenParen, CloseParen, OpenBracket, CloseBracket,
    Comma, Semicolon, Colon, Dot, Range, Caret, Hash,
    Bad, ///< reported already
};

/// One token. `value`: of integers the number, of reals its bits as LREAL; durations count ns (signed), dates ns since
/// 1970-01-01, times of day ns since midnight. Addresses, names and strings are read from the text.
struct Token {
    TokenKind kind = TokenKind::End;
    Word word = Word::None;      ///< of Word
    bool startsLine = false;     ///< nothing but blanks and comments before it on its line
    bool isBased = false;        ///< Integer: written with a base, as 16#FF
    NameId name = 0;             ///< of Name and Word
    std::uint32_t offset = 0;
    std::uint32_t end = 0;
    std::uint64_t value = 0;

    bool is(Word w) const { return kind == TokenKind::Word && word == w; }
    bool is(TokenKind k) const { return kind == k; }
};

} // namespace camwright::st
