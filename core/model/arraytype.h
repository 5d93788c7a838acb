#pragma once

#include "core/base/datatype.h"
#include "core/model/field.h"

#include <cstdint>
#include <optional>

namespace camwright {

/// A row of equal elements, written TYPE[n] in a variable's type (TS-VAR-05): "INT[10]", with elements from 0.
struct ArrayType {
    DataType element = DataType::Int;
    std::uint32_t length = 1; ///< 1 … MaximumArrayLength

    bool operator==(const ArrayType&) const = default;
};

/// As many words as the controller retains of variables (TS-VAR-07: 128k bytes).
inline constexpr std::uint32_t MaximumArrayLength = 65536;

/// What a variable's type says if it is an array; nothing for an elementary type and for any other text.
std::optional<ArrayType> arrayTypeOf(const Field<DataType>& type);

} // namespace camwright
