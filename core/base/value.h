#pragma once

#include "core/base/datatype.h"
#include "core/base/result.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace camwright {

/// A typed elementary value, as watch tables, writes, traces and constants carry it. `bits` holds the value as it lies in
/// memory, little-endian, zero-extended; REAL in the low 32 bits.
struct Value {
    DataType type = DataType::Bool;
    std::uint64_t bits = 0;

    static Value ofBool(bool value) { return {DataType::Bool, value ? 1u : 0u}; }
    static Value ofReal(float value);
    static Value ofLreal(double value);
    /// Truncated to the width of the type; for float types converted.
    static Value ofInteger(DataType type, std::int64_t value);
    /// Saturating for integers (NaN gives 0), rounded to nearest even; CONTRACTS 12.
    static Value ofDouble(DataType type, double value);

    bool asBool() const { return bits != 0; }
    std::int64_t asInteger() const; ///< sign-extended where the type is signed; floats saturate
    double asDouble() const;
    bool operator==(const Value&) const = default;
};

enum class NumberBase : std::uint8_t { Decimal, Hexadecimal, Binary, Octal };

/// "TRUE", "-12", "16#FF", "2#1010", "1.5", "T#5s250ms". Floats print the shortest form that reads back the same.
std::string formatValue(const Value& value, NumberBase base = NumberBase::Decimal);

/// Reads what people type for a value of `type`: TRUE/FALSE/1/0, decimal, 16#…, 2#…, 8#…, typed literals (INT#5, DI#5, B#16#85),
/// 1.5 and 1,5, 1e3, 2.5k, T#1m5s250ms. A value outside the type's range is an error that names the range.
Result<Value> parseValue(DataType type, std::string_view text);

} // namespace camwright
