#pragma once

#include <optional>
#include <string>
#include <utility>
#include <variant>

namespace camwright {

/// What somebody typed into an editable field: a legal value, or the text as it was typed (CONTRACTS 3). Nothing typed is
/// lost: the text is saved, journalled and undone like a value; checks turn it into a diagnostic.
template <class T>
class Field {
public:
    Field() : m_state(T{}) {}
    Field(T value) : m_state(std::in_place_index<0>, std::move(value)) {}

    static Field typed(std::string text)
    {
        Field out;
        out.m_state.template emplace<1>(Typed{std::move(text)});
        return out;
    }

    bool isValid() const { return m_state.index() == 0; }
    /// The value; only when isValid().
    const T& value() const { return std::get<0>(m_state); }
    T valueOr(T fallback) const { return isValid() ? value() : fallback; }
    /// The text as typed; only when not isValid().
    const std::string& text() const { return std::get<1>(m_state).text; }

    bool operator==(const Field&) const = default;

private:
    struct Typed {
        std::string text;
        bool operator==(const Typed&) const = default;
    };
    std::variant<T, Typed> m_state;
};

} // namespace camwright
