#include "core/base/realmath.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>

using namespace camwright;

namespace {

/// Distance in units of the last place.
double unitsBetween(double a, double b)
{
    if (a == b || (a != a && b != b))
        return 0;
    const double unit = std::nextafter(std::fabs(b), HUGE_VAL) - std::fabs(b);
    return std::fabs(a - b) / unit;
}

/// Numbers of all sizes with a fixed seed.
template <class Visitor>
void forNumbers(double least, double most, Visitor visit)
{
    std::uint64_t state = 0x9E3779B97F4A7C15u;
    for (int i = 0; i < 20'000; ++i) {
        state = state * 6364136223846793005u + 1442695040888963407u;
        visit(least + (most - least) * (static_cast<double>(state >> 11) / 9007199254740992.0));
    }
}

// The library at hand is right to less than a unit; the distance between the two shows any mistake of ours.
TEST(RealMathTest, sineAndCosineAreRightToTwoUnits)
{
    for (const double most : {1.0, 10.0, 1000.0, 1.0e6}) {
        forNumbers(-most, most, [](double x) {
            EXPECT_LE(unitsBetween(sine(x), std::sin(x)), 2) << x;
            EXPECT_LE(unitsBetween(cosine(x), std::cos(x)), 2) << x;
            EXPECT_LE(unitsBetween(tangent(x), std::tan(x)), 4) << x;
        });
    }
}

TEST(RealMathTest, inverseFunctionsAreRightToTwoUnits)
{
    forNumbers(-1, 1, [](double x) {
        EXPECT_LE(unitsBetween(arcSine(x), std::asin(x)), 3) << x;
        EXPECT_LE(unitsBetween(arcCosine(x), std::acos(x)), 3) << x;
    });
    forNumbers(-20, 20, [](double x) {
        EXPECT_LE(unitsBetween(arcTangent(x), std::atan(x)), 2) << x;
        EXPECT_LE(unitsBetween(arcTangent2(x, 3.5), std::atan2(x, 3.5)), 2) << x;
        EXPECT_LE(unitsBetween(arcTangent2(x, -3.5), std::atan2(x, -3.5)), 2) << x;
    });
}

TEST(RealMathTest, exponentialAndLogarithmsAreRightToTwoUnits)
{
    forNumbers(-700, 700, [](double x) { EXPECT_LE(unitsBetween(exponential(x), std::exp(x)), 2) << x; });
    forNumbers(-300, 300, [](double x) {
        const double number = std::exp(x);
        EXPECT_LE(unitsBetween(naturalLogarithm(number), std::log(number)), 2) << number;
        EXPECT_LE(unitsBetween(decimalLogarithm(number), std::log10(number)), 3) << number;
    });
    for (int i = -20; i <= 20; ++i)
        EXPECT_NEAR(decimalLogarithm(std::pow(10.0, i)), i, 1e-14) << i;
}

TEST(RealMathTest, powersFollowTheirDefinition)
{
    forNumbers(0.01, 30, [](double x) {
        EXPECT_LE(unitsBetween(power(x, 2.5), std::pow(x, 2.5)), 3 + 1.5 * std::fabs(2.5 * std::log(x))) << x;
        EXPECT_LE(unitsBetween(power(x, -3), std::pow(x, -3)), 3) << x;
    });
    EXPECT_EQ(power(-2, 3), -8);
    EXPECT_EQ(power(-2, 101), -power(2, 101));
    EXPECT_TRUE(std::isnan(power(-2, 0.5)));
    EXPECT_EQ(power(0, 0), 1);
}

TEST(RealMathTest, edgesHaveTheirValues)
{
    const double infinity = HUGE_VAL;
    EXPECT_TRUE(std::isnan(sine(infinity)));
    EXPECT_TRUE(std::isnan(arcSine(1.5)));
    EXPECT_TRUE(std::isnan(naturalLogarithm(-1)));
    EXPECT_EQ(naturalLogarithm(0), -infinity);
    EXPECT_EQ(exponential(1000), infinity);
    EXPECT_EQ(exponential(-1000), 0);
    EXPECT_EQ(exponential(0), 1);
    EXPECT_EQ(arcTangent2(0, 0), 0);
    EXPECT_EQ(std::bit_cast<std::uint64_t>(sine(0.5)), 0x3FDEAEE8744B05F0u);
}

} // namespace
