#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace camwright {

/// One character of UTF-8 text. An illegal byte is a character of its own with `legal` false.
struct Utf8Character {
    std::uint32_t code = 0;
    std::uint32_t length = 1; ///< bytes
    bool legal = true;
};

/// Decodes the character that starts at `offset` (inside the text).
Utf8Character characterAt(std::string_view text, std::size_t offset);

/// Whether a character may not stand in a program: invisible, changes the reading direction, or a control. Tab, \n and \r
/// are legal.
bool isOddCharacter(std::uint32_t code);

/// A character that looks like a blank and is none (no-break space and its kin).
bool isOddBlank(std::uint32_t code);

/// The text with every such character replaced by blanks, as many as it has bytes.
std::string withPlainBlanks(std::string_view text);

bool isCyrillic(std::uint32_t code);
bool hasCyrillic(std::string_view text);

/// The Latin letter a Cyrillic or Greek or full-width one looks like.
std::optional<char> latinLookalike(std::uint32_t code);

/// The text with every look-alike replaced by its Latin letter.
std::string withLatinLetters(std::string_view text);
/// The first look-alike in the text, as "U+0412", or empty.
std::string firstLookalike(std::string_view text);
/// "U+0412"
std::string codePointName(std::uint32_t code);

/// At most `limit` bytes of a text for a message, cut between characters, "…" where it was cut, control characters as
/// blanks.
std::string shortened(std::string_view text, std::size_t limit = 60);

inline bool isBlank(char c) { return c == ' ' || c == '\t'; }
inline bool isDigit(char c) { return c >= '0' && c <= '9'; }
inline bool isAsciiLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
inline bool isAscii(char c) { return static_cast<unsigned char>(c) < 0x80; }

/// ASCII only; other bytes stay.
std::string upperCase(std::string_view text);
/// Without blanks at both ends.
std::string_view trimmed(std::string_view text);

} // namespace camwright
