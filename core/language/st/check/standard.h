#pragma once

#include "core/language/st/check/types.h"

#include <cstdint>
#include <string_view>

namespace camwright::st {

/// The standard functions. What types they take is checked in standardcalls.cpp, what they become in the IR in
/// lowering/standardlowering.cpp.
enum class Standard : std::uint32_t {
    None, Abs, Sqrt, Add, Sub, Mul, Div, Mod, Expt, Move, Shl, Shr, Rol, Ror, And, Or, Xor, Not,
    Sel, Max, Min, Limit, Mux, Gt, Ge, Eq, Le, Lt, Ne, Trunc, Convert, Ref, Now,
    Sin, Cos, Tan, Asin, Acos, Atan, Atan2, Exp, Ln, Log,
};

/// A conversion's number holds its two types: INT_TO_REAL. `from` None: any (TO_REAL). `truncates`: REAL_TRUNC_INT, TRUNC_INT.
constexpr std::uint32_t conversionNumber(Elementary from, Elementary to, bool truncates)
{
    return static_cast<std::uint32_t>(Standard::Convert) | static_cast<std::uint32_t>(from) << 8 | static_cast<std::uint32_t>(to) << 16
        | (truncates ? 1u << 24 : 0u);
}
constexpr Standard standardOf(std::uint32_t number) { return static_cast<Standard>(number & 0xFF); }
constexpr Elementary convertsFrom(std::uint32_t number) { return static_cast<Elementary>(number >> 8 & 0xFF); }
constexpr Elementary convertsTo(std::uint32_t number) { return static_cast<Elementary>(number >> 16 & 0xFF); }
constexpr bool convertTruncates(std::uint32_t number) { return (number >> 24 & 1) != 0; }

/// The number of a standard function by its name, conversions included; 0 if there is none.
std::uint32_t findStandard(std::string_view name);

/// An elementary type by its name, long forms (TIME_OF_DAY) included; None if there is none.
Elementary findElementary(std::string_view name);

/// The standard function blocks in ST.
std::string_view standardBlocks();

} // namespace camwright::st
