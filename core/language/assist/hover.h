#pragma once

#include "core/base/value.h"
#include "core/language/check/context.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace camwright {

/// What is known of a place in a program, for a tool tip. Words of the catalogue are in the language asked for; the rest
/// are names and numbers, which a view puts into sentences.
struct Hover {
    std::size_t begin = 0;                     ///< the word it is about, in bytes
    std::size_t end = 0;
    const Instruction* instruction = nullptr;  ///< of the line
    std::string signature;                     ///< "MOVE IN, OUT"; where the word is the instruction
    std::string help;                          ///< of the instruction, or of the pin where the word is an operand
    std::string group;                         ///< of the instruction: "Motion"
    std::string whyNotSimulated;               ///< empty if the virtual controller runs it
    const Pin* pin = nullptr;                  ///< the operand's pin
    std::string types;                         ///< "INT/WORD": what the pin takes
    std::string areas;                         ///< "V, M, L"
    const KnownVariable* variable = nullptr;   ///< the variable named, or the one that lies at the address
    std::optional<Address> address;            ///< the place in memory the operand stands for
    std::string areaMeaning;                   ///< "Markers"
    std::optional<Value> constant;             ///< the constant, in the type the pin prefers
};

/// Nothing where there is no word, in comments, and at words that mean nothing.
std::optional<Hover> hoverAt(const LanguageContext& context, std::string_view text, std::size_t offset, TextLanguage language);

} // namespace camwright
