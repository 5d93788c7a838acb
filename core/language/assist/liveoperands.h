#pragma once

#include "core/base/value.h"
#include "core/language/check/context.h"
#include "core/language/source/token.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace camwright {

/// An operand of a program whose value a controller can tell.
struct LiveOperand {
    std::uint32_t line = 0;         ///< from 1
    std::uint32_t column = 0;       ///< bytes from the start of the line, from 0
    std::uint32_t length = 0;
    std::vector<std::string> names; ///< what the controller is asked for: one name, or the two words of a long value, low one first
    DataType type = DataType::Bool; ///< what the instruction takes it as
    std::string pin;                ///< the operand's name: "EXEC"

    bool operator==(const LiveOperand&) const = default;
};

/// The operands of some lines of a program, by place: variables and addresses. Not constants, lists, memory that belongs to the
/// block that runs (it has no value outside), nor what follows the end of a comment on its line. `before` is the state of
/// the lexer before the first line, which has the number `firstLine`. Linear in the text, cheap enough for every scroll.
std::vector<LiveOperand> liveOperands(const LanguageContext& context, std::string_view lines, LineState before, std::uint32_t firstLine);

/// The operand's value made of those of its names, which are as many.
Value liveValue(const LiveOperand& operand, std::span<const Value> values);

} // namespace camwright
