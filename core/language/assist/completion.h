#pragma once

#include "core/language/check/context.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace camwright {

enum class CompletionKind : std::uint8_t { Instruction, Variable, Program, Axis, Area, Pin, Placeholder };

struct CompletionItem {
    CompletionKind kind = CompletionKind::Instruction;
    std::string text;   ///< what is inserted
    std::string detail; ///< signature of an instruction, type and address of a variable, name of an axis …
    std::string help;   ///< a sentence in the language asked for; may be empty

    bool operator==(const CompletionItem&) const = default;
};

struct Completion {
    std::size_t begin = 0; ///< what the item chosen replaces, in bytes
    std::size_t end = 0;
    std::vector<CompletionItem> items;
};

/// What may be typed at a place: instructions where one begins, else what the operand's pin takes (variables of its types,
/// axis numbers, subroutines, memory areas, names of pins, ??? and _). Items begin with what is typed already (case does
/// not count), at most MaximumCompletions, in alphabetical order. None inside comments.
Completion completeAt(const LanguageContext& context, std::string_view text, std::size_t offset, TextLanguage language);

inline constexpr std::size_t MaximumCompletions = 200;

} // namespace camwright
