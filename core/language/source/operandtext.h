#pragma once

#include "core/language/source/dialect.h"
#include "core/language/source/token.h"

#include <optional>
#include <string>
#include <string_view>

namespace camwright {

/// What a piece of operand text looks like: Address, Number, TypedConstant, Symbol, Missing, Empty, or Invalid. By its
/// form only; whether the address exists says the family.
TokenKind operandForm(const Dialect& dialect, std::string_view text);

/// Whether a text is a Kinco address that lacks its leading '%'.
bool lacksPercent(std::string_view text);

/// Without the backslashes that Markdown puts before punctuation: "R\_TRIG" gives "R_TRIG".
std::string withoutMarkdownEscapes(std::string_view text);
bool hasMarkdownEscapes(std::string_view text);

/// What copying from a printed manual did to an operand.
enum class OperandDamage : std::uint8_t {
    None,
    MarkdownEscape, ///< M0\.1
    Lookalike,      ///< a Cyrillic letter for a Latin one: В#16#85
    ConstantBlanks, ///< DI # 100
    StrayLetters,   ///< %адресу VW0
    SeveralOperands,///< %M0.0 %M0.1 : a comma is missing
};

struct OperandRepair {
    OperandDamage damage = OperandDamage::None;
    std::string text; ///< the operand as it was probably meant
};

/// Looks at one operand as written. Only damage that leaves a legal operand when repaired is named.
OperandRepair examineOperand(const Dialect& dialect, std::string_view text);

} // namespace camwright
