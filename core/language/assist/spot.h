#pragma once

#include "core/language/check/context.h"
#include "core/language/source/token.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace camwright {

/// What stands at a place of a program's text.
struct Spot {
    std::size_t begin = 0;                    ///< byte offsets of the word at the place; begin == end: none
    std::size_t end = 0;
    std::string word;                         ///< its text
    TokenKind kind = TokenKind::Invalid;      ///< only where there is a word
    bool isMnemonic = false;                  ///< the place where an instruction's name stands or may be typed
    bool isComment = false;
    const Instruction* instruction = nullptr; ///< of the line, if known
    const Pin* pin = nullptr;                 ///< the operand's pin, by place or by name, if there is one
};

/// Looks at one place, in the word or directly behind it. `offset` counts bytes and may be the end of the text.
Spot spotAt(const LanguageContext& context, std::string_view text, std::size_t offset);

} // namespace camwright
