#pragma once

#include "core/base/diagnostic.h"

#include <cassert>
#include <optional>
#include <utility>
#include <variant>

namespace camwright {

/// The value asked for, or the reason there is none. Used for everything that can fail for a reason outside the
/// program (a file, a wire, what somebody typed); our own mistakes are asserts.
template <class T, class E = Diagnostic>
class [[nodiscard]] Result {
public:
    Result(T value) : m_state(std::in_place_index<0>, std::move(value)) {}
    Result(E error) : m_state(std::in_place_index<1>, std::move(error)) {}

    bool ok() const { return m_state.index() == 0; }
    explicit operator bool() const { return ok(); }

    const T& value() const& { assert(ok()); return *std::get_if<0>(&m_state); }
    T& value() & { assert(ok()); return *std::get_if<0>(&m_state); }
    T&& value() && { assert(ok()); return std::move(*std::get_if<0>(&m_state)); }
    const T& operator*() const& { return value(); }
    T& operator*() & { return value(); }
    T&& operator*() && { return std::move(*this).value(); }
    const T* operator->() const { return &value(); }
    T* operator->() { return &value(); }

    const E& error() const& { assert(!ok()); return *std::get_if<1>(&m_state); }
    E&& error() && { assert(!ok()); return std::move(*std::get_if<1>(&m_state)); }

private:
    std::variant<T, E> m_state;
};

/// Success without a value, or the reason it failed.
template <class E>
class [[nodiscard]] Result<void, E> {
public:
    Result() = default;
    Result(E error) : m_error(std::move(error)) {}

    bool ok() const { return !m_error; }
    explicit operator bool() const { return ok(); }
    const E& error() const& { assert(m_error); return *m_error; }
    E&& error() && { assert(m_error); return std::move(*m_error); }

private:
    std::optional<E> m_error;
};

} // namespace camwright
