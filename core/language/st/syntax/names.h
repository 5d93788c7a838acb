#pragma once

#include "core/language/st/syntax/arena.h"

#include <cstdint>
#include <string_view>
#include <vector>

namespace camwright::st {

/// A name as a number: the same for the same name in upper or lower case. 0: no name.
using NameId = std::uint32_t;

/// The reserved words. Their values are the numbers of their names.
enum class Word : std::uint8_t {
    None,
#define CAMWRIGHT_ST_WORD(word) word,
#include "core/language/st/syntax/words.h"
#undef CAMWRIGHT_ST_WORD
    Count
};

/// All names of one compilation, each once. The reserved words come first.
class Names {
public:
    Names();

    NameId intern(std::string_view text);
    /// As it was first written; of reserved words in capital letters.
    std::string_view text(NameId name) const { return m_texts[name]; }
    std::size_t count() const { return m_texts.size(); }
    static Word wordOf(NameId name) { return name < static_cast<NameId>(Word::Count) ? static_cast<Word>(name) : Word::None; }

private:
    struct Slot {
        std::uint32_t hash = 0;
        NameId name = 0;
    };

    void grow();

    Arena m_arena;
    std::vector<std::string_view> m_texts;
    std::vector<Slot> m_slots; ///< open addressing; the size is a power of two
};

/// "END_IF"
std::string_view wordText(Word word);

/// Whether two texts are the same name: letters compare without their case.
bool isSameName(std::string_view a, std::string_view b);

} // namespace camwright::st
