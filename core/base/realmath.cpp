#include "core/base/realmath.h"

#include <cmath>
#include <cstdint>
#include <limits>

namespace camwright {

namespace {

constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr double HalfPi = 1.57079632679489655800e+00;
constexpr double Pi = 3.14159265358979311600e+00;
constexpr double PiLow = 1.2246467991473531772e-16;
constexpr double Ln2High = 6.93147180369123816490e-01;
constexpr double Ln2Low = 1.90821492927058770002e-10;
constexpr double LargestExactAngle = 1.0e6;

/// An angle as n quarter turns and a rest of at most an eighth turn in two parts.
struct Reduced {
    int quarter = 0;
    double high = 0;
    double low = 0;
};

Reduced reduced(double x)
{
    constexpr double QuartersPerRadian = 6.36619772367581382433e-01;
    constexpr double Part1 = 1.57079632673412561417e+00;     // pi/2 in three parts; products with n are exact
    constexpr double Part2 = 6.07710050630396597660e-11;
    constexpr double Part2Rest = 2.02226624879595063154e-21;
    if (std::fabs(x) > LargestExactAngle)
        x = std::fmod(x, 2 * Pi);
    const double n = std::nearbyint(x * QuartersPerRadian);
    const double first = x - n * Part1;
    const double product = n * Part2;
    const double rest = first - product;
    const double correction = n * Part2Rest - ((first - rest) - product);
    Reduced out;
    out.quarter = static_cast<int>(static_cast<std::int64_t>(n) & 3);
    out.high = rest - correction;
    out.low = (rest - out.high) - correction;
    return out;
}

double sineOfRest(const Reduced& r)
{
    const double z = r.high * r.high;
    const double v = z * r.high;
    const double p = 8.33333333332248946124e-03
        + z * (-1.98412698298579493134e-04 + z * (2.75573137070700676789e-06 + z * (-2.50507602534068634195e-08 + z * 1.58969099521155010221e-10)));
    return r.high - ((z * (0.5 * r.low - v * p) - r.low) - v * -1.66666666666666324348e-01);
}

double cosineOfRest(const Reduced& r)
{
    const double z = r.high * r.high;
    const double w = z * z;
    const double p = z * (4.16666666666666019037e-02 + z * (-1.38888888888741095749e-03 + z * 2.48015872894767294178e-05))
        + w * w * (-2.75573143513906633035e-07 + z * (2.08757232129817482790e-09 + z * -1.13596475577881948265e-11));
    const double half = 0.5 * z;
    const double one = 1.0 - half;
    return one + (((1.0 - one) - half) + (z * p - r.high * r.low));
}

/// ln(m * 2^k) of a positive number as k and ln(m), m near 1.
double logarithmOfMantissa(double f)
{
    const double s = f / (2.0 + f);
    const double z = s * s;
    const double w = z * z;
    const double t1 = w * (3.999999999940941908e-01 + w * (2.222219843214978396e-01 + w * 1.531383769920937332e-01));
    const double t2 = z * (6.666666666666735130e-01 + w * (2.857142874366239149e-01 + w * (1.818357216161805012e-01 + w * 1.479819860511658591e-01)));
    return s * (0.5 * f * f + t1 + t2);
}

bool isOdd(double whole)
{
    return std::fabs(std::fmod(whole, 2.0)) == 1.0;
}

/// By multiplying; n at most 64.
double wholePower(double x, unsigned n)
{
    double out = 1.0;
    for (; n != 0; n >>= 1) {
        if (n & 1)
            out *= x;
        x *= x;
    }
    return out;
}

} // namespace

double sine(double x)
{
    if (!std::isfinite(x))
        return NotANumber;
    const Reduced r = reduced(x);
    const double value = (r.quarter & 1) != 0 ? cosineOfRest(r) : sineOfRest(r);
    return r.quarter >= 2 ? -value : value;
}

double cosine(double x)
{
    if (!std::isfinite(x))
        return NotANumber;
    const Reduced r = reduced(x);
    const double value = (r.quarter & 1) != 0 ? sineOfRest(r) : cosineOfRest(r);
    return r.quarter == 1 || r.quarter == 2 ? -value : value;
}

double tangent(double x)
{
    return sine(x) / cosine(x);
}

double arcTangent(double x)
{
    constexpr double High[] = {4.63647609000806093515e-01, 7.85398163397448278999e-01, 9.82793723247329054082e-01, HalfPi};
    constexpr double Low[] = {2.26987774529616870924e-17, 3.06161699786838301793e-17, 1.39033110312309984516e-17, 6.12323399573676603587e-17};
    if (x != x)
        return NotANumber;
    const double a = std::fabs(x);
    int part = -1;
    double t = a;
    if (a >= 2.4375) {
        part = 3;
        t = -1.0 / a;
    } else if (a >= 1.1875) {
        part = 2;
        t = (a - 1.5) / (1.0 + 1.5 * a);
    } else if (a >= 0.6875) {
        part = 1;
        t = (a - 1.0) / (a + 1.0);
    } else if (a >= 0.4375) {
        part = 0;
        t = (2.0 * a - 1.0) / (2.0 + a);
    }
    const double z = t * t;
    const double w = z * z;
    const double s1 = z * (3.33333333333329318027e-01 + w * (1.42857142725034663711e-01 + w * (9.09088713343650656196e-02
        + w * (6.66107313738753120669e-02 + w * (4.97687799461593236017e-02 + w * 1.62858201153657823623e-02)))));
    const double s2 = w * (-1.99999999998764832476e-01 + w * (-1.11111104054623557880e-01 + w * (-7.69187620504482999495e-02
        + w * (-5.83357013379057348645e-02 + w * -3.65315727442169155270e-02))));
    const double value = part < 0 ? t - t * (s1 + s2) : High[part] - ((t * (s1 + s2) - Low[part]) - t);
    return std::copysign(value, x);
}

double arcTangent2(double y, double x)
{
    if (x != x || y != y)
        return NotANumber;
    const bool isLeft = std::signbit(x);
    if (y == 0.0)
        return isLeft ? std::copysign(Pi, y) : y;
    if (x == 0.0)
        return std::copysign(HalfPi, y);
    if (std::isinf(x) && std::isinf(y))
        return std::copysign(isLeft ? 3 * (Pi / 4) : Pi / 4, y);
    const double angle = arcTangent(std::fabs(y / x));
    return std::copysign(isLeft ? Pi - (angle - PiLow) : angle, y);
}

double arcSine(double x)
{
    return std::fabs(x) <= 1.0 ? arcTangent2(x, std::sqrt((1.0 - x) * (1.0 + x))) : NotANumber;
}

double arcCosine(double x)
{
    return std::fabs(x) <= 1.0 ? arcTangent2(std::sqrt((1.0 - x) * (1.0 + x)), x) : NotANumber;
}

double exponential(double x)
{
    if (x != x)
        return NotANumber;
    if (x > 709.782712893383973096)
        return Infinity;
    if (x < -745.133219101941108420)
        return 0.0;
    const double k = std::nearbyint(x * 1.44269504088896338700e+00);
    const double high = x - k * Ln2High;
    const double low = k * Ln2Low;
    const double r = high - low;
    const double t = r * r;
    const double c = r - t * (1.66666666666666019037e-01 + t * (-2.77777777770155933842e-03
        + t * (6.61375632143793436117e-05 + t * (-1.65339022054652515390e-06 + t * 4.13813679705723846039e-08))));
    return std::ldexp(1.0 - ((low - (r * c) / (2.0 - c)) - high), static_cast<int>(k));
}

double naturalLogarithm(double x)
{
    if (x == 0.0)
        return -Infinity;
    if (!(x > 0.0) || std::isinf(x))
        return x > 0.0 ? Infinity : NotANumber;
    int exponent = 0;
    double mantissa = std::frexp(x, &exponent);
    if (mantissa < 0.70710678118654752440) {
        mantissa *= 2;
        --exponent;
    }
    const double f = mantissa - 1.0;
    const double k = exponent;
    const double half = 0.5 * f * f;
    return k * Ln2High - ((half - (logarithmOfMantissa(f) + k * Ln2Low)) - f);
}

double decimalLogarithm(double x)
{
    if (!(x > 0.0) || std::isinf(x))
        return naturalLogarithm(x);
    int exponent = 0;
    double mantissa = std::frexp(x, &exponent) * 2; // 1 … 2
    --exponent;
    if (exponent < 0) { // the sum then loses nothing
        mantissa /= 2;
        ++exponent;
    }
    const double y = exponent;
    const double z = y * 3.69423907715893078616e-13 + 4.34294481903251816668e-01 * naturalLogarithm(mantissa);
    return z + y * 3.01029995663611771306e-01;
}

double power(double x, double y)
{
    if (y == 0.0 || x == 1.0)
        return 1.0;
    if (x != x || y != y)
        return NotANumber;
    const bool isWhole = std::trunc(y) == y;
    const bool isNegative = isWhole && std::signbit(x) && isOdd(y);
    if (isWhole && std::fabs(y) <= 64.0) {
        const double value = wholePower(x, static_cast<unsigned>(std::fabs(y)));
        return y < 0 ? 1.0 / value : value;
    }
    const double a = std::fabs(x);
    if (x < 0.0 && !isWhole && !std::isinf(x))
        return NotANumber;
    const double value = a == 1.0 ? 1.0 : exponential(y * naturalLogarithm(a));
    return isNegative ? -value : value;
}

} // namespace camwright
