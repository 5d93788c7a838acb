#pragma once

#include <bit>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <utility>

namespace camwright {

// Arithmetic that is defined for every input and the same on every machine: integers wrap around, floats have one NaN,
// conversions saturate (CONTRACTS 12). Computing in 64 bits without a sign avoids the promotions of C.

template <class T>
inline T canonical(T value)
{
    if constexpr (std::is_floating_point_v<T>)
        return value != value ? std::numeric_limits<T>::quiet_NaN() : value;
    else
        return value;
}

template <class T>
inline std::uint64_t wide(T value)
{
    return static_cast<std::uint64_t>(value);
}

template <class T>
inline T sum(T a, T b)
{
    if constexpr (std::is_floating_point_v<T>)
        return canonical(a + b);
    else
        return static_cast<T>(wide(a) + wide(b));
}

template <class T>
inline T difference(T a, T b)
{
    if constexpr (std::is_floating_point_v<T>)
        return canonical(a - b);
    else
        return static_cast<T>(wide(a) - wide(b));
}

template <class T>
inline T product(T a, T b)
{
    if constexpr (std::is_floating_point_v<T>)
        return canonical(a * b);
    else
        return static_cast<T>(wide(a) * wide(b));
}

template <class T>
inline T divided(T a, T b)
{
    if constexpr (std::is_floating_point_v<T>) {
        return canonical(a / b);
    } else {
        if (b == T{0})
            return T{0};
        if constexpr (std::is_signed_v<T>) {
            if (b == T{-1})
                return difference(T{0}, a);
        }
        return static_cast<T>(a / b);
    }
}

template <class T>
inline T remainder(T a, T b)
{
    if constexpr (std::is_floating_point_v<T>) {
        return std::numeric_limits<T>::quiet_NaN();
    } else {
        if (b == T{0})
            return T{0};
        if constexpr (std::is_signed_v<T>) {
            if (b == T{-1})
                return T{0};
        }
        return static_cast<T>(a % b);
    }
}

template <class T>
inline T absolute(T a)
{
    if constexpr (std::is_floating_point_v<T>)
        return canonical(std::fabs(a));
    else if constexpr (std::is_signed_v<T>)
        return a < T{0} ? difference(T{0}, a) : a;
    else
        return a;
}

/// IEEE 754 fixes the square root to the last bit.
template <class T>
inline T squareRoot(T a)
{
    if constexpr (std::is_floating_point_v<T>)
        return canonical(std::sqrt(a));
    else
        return T{0};
}

/// With a NaN: NaN.
template <class T>
inline T smaller(T a, T b)
{
    return a != a || b != b ? canonical(static_cast<T>(a + b)) : b < a ? b : a;
}

template <class T>
inline T larger(T a, T b)
{
    return a != a || b != b ? canonical(static_cast<T>(a + b)) : a < b ? b : a;
}

template <class T>
inline T bitAnd(T a, T b)
{
    if constexpr (std::is_integral_v<T>)
        return static_cast<T>(wide(a) & wide(b));
    else
        return a;
}

template <class T>
inline T bitOr(T a, T b)
{
    if constexpr (std::is_integral_v<T>)
        return static_cast<T>(wide(a) | wide(b));
    else
        return a;
}

template <class T>
inline T bitXor(T a, T b)
{
    if constexpr (std::is_integral_v<T>)
        return static_cast<T>(wide(a) ^ wide(b));
    else
        return a;
}

template <class T>
inline T bitNot(T a)
{
    if constexpr (std::is_integral_v<T>)
        return static_cast<T>(~wide(a));
    else
        return a;
}

template <class T>
inline T shiftedLeft(T a, std::uint32_t count)
{
    if constexpr (std::is_integral_v<T>)
        return count >= 8 * sizeof(T) ? T{0} : static_cast<T>(wide(a) << count);
    else
        return a;
}

template <class T>
inline T shiftedRight(T a, std::uint32_t count)
{
    if constexpr (std::is_integral_v<T>)
        return count >= 8 * sizeof(T) ? T{0} : static_cast<T>(wide(static_cast<std::make_unsigned_t<T>>(a)) >> count);
    else
        return a;
}

/// `count` modulo the width; a negative one, as 2^32 minus it, turns right: every width divides 2^32.
template <class T>
inline T rotatedLeft(T a, std::uint32_t count)
{
    if constexpr (std::is_integral_v<T>)
        return static_cast<T>(std::rotl(static_cast<std::make_unsigned_t<T>>(a), static_cast<int>(count % (8 * sizeof(T)))));
    else
        return a;
}

/// A whole number in floating point as an integer, the nearest end where it does not fit, 0 for NaN.
template <class To, class From>
inline To saturatedFromWhole(From whole)
{
    if (whole != whole)
        return To{0};
    // 2^digits is exact in floating point, the largest integer may not be.
    const From beyond = std::ldexp(From{1}, std::numeric_limits<To>::digits);
    if (whole >= beyond)
        return std::numeric_limits<To>::max();
    if (whole < (std::is_signed_v<To> ? -beyond : From{0}))
        return std::numeric_limits<To>::min();
    return static_cast<To>(whole);
}

template <class To, class From>
inline To saturatedInteger(From value)
{
    if (std::cmp_greater(value, std::numeric_limits<To>::max()))
        return std::numeric_limits<To>::max();
    if (std::cmp_less(value, std::numeric_limits<To>::min()))
        return std::numeric_limits<To>::min();
    return static_cast<To>(value);
}

struct ConvertRounding {
    template <class To, class From>
    static To convert(From value)
    {
        if constexpr (std::is_floating_point_v<To>)
            return canonical(static_cast<To>(value));
        else if constexpr (std::is_floating_point_v<From>)
            return saturatedFromWhole<To>(std::nearbyint(value));
        else
            return static_cast<To>(value);
    }
};

struct ConvertTruncating {
    template <class To, class From>
    static To convert(From value)
    {
        if constexpr (std::is_floating_point_v<From> && std::is_integral_v<To>)
            return saturatedFromWhole<To>(std::trunc(value));
        else
            return ConvertRounding::convert<To>(value);
    }
};

struct ConvertSaturating {
    template <class To, class From>
    static To convert(From value)
    {
        if constexpr (std::is_integral_v<From> && std::is_integral_v<To>)
            return saturatedInteger<To>(value);
        else
            return ConvertRounding::convert<To>(value);
    }
};

} // namespace camwright
