#pragma once

#include "core/base/result.h"
#include "core/base/value.h"
#include "core/family/catalogue.h"

#include <optional>
#include <string>
#include <string_view>

namespace camwright {

/// A constant as a program writes it: 12, -3, 16#FF, 1200.0, B#16#85, DI#2000, T#5s, TRUE.
class Literal {
public:
    /// Nothing if the text has not the form of a constant. Whether it fits a type says `as`.
    static std::optional<Literal> read(std::string_view text);

    const std::string& text() const { return m_text; }
    /// Types it can have: one for a typed constant, REAL for one with a decimal point, else every integer type
    /// (KS-IL-05). Not by size.
    const TypeSet& types() const { return m_types; }
    /// Its value, or that it is outside the type's range (CW0004).
    Result<Value> as(DataType type) const { return parseValue(type, m_text); }

private:
    std::string m_text;
    TypeSet m_types;
};

} // namespace camwright
