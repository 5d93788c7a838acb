#include "core/motion/units.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace camwright;

namespace {
const AxisScale kFeed{10000, 100};
const AxisScale kTurn{10000, 45};
}

// The vectors of Appendix B (KS-MCN-12).
TEST(AxisScaleTest, converts250MillimetresInto25000Pulses) { EXPECT_EQ(kFeed.toCounts(250), 25000); }
TEST(AxisScaleTest, converts90DegreesInto20000Pulses) { EXPECT_EQ(kTurn.toCounts(90), 20000); }
TEST(AxisScaleTest, converts6000MillimetresAMinuteIntoTurnsAndPulses)
{
    EXPECT_EQ(kFeed.perMinuteToTurnsPerMinute(6000), 60);
    EXPECT_EQ(kFeed.perMinuteToCountsPerSecond(6000), 10000);
    EXPECT_EQ(kFeed.countsPerSecondToPerMinute(10000), 6000);
}
TEST(AxisScaleTest, comesBackFromCountsToUnits) { EXPECT_EQ(kTurn.toUnits(kTurn.toCounts(-12.5)), -12.5); }
TEST(AxisScaleTest, refusesScalesThatAreNoNumbers)
{
    EXPECT_TRUE(kFeed.isValid());
    EXPECT_FALSE((AxisScale{0, 1}).isValid());
    EXPECT_FALSE((AxisScale{10000, -1}).isValid());
    EXPECT_FALSE((AxisScale{10000, std::nan("")}).isValid());
    EXPECT_FALSE((AxisScale{std::numeric_limits<double>::infinity(), 1}).isValid());
}

TEST(RoundingTest, saturatesAndTakesNanForZero)
{
    EXPECT_EQ(roundToInt32(2147483647.4), 2147483647);
    EXPECT_EQ(roundToInt32(2147483648.0), 2147483647);
    EXPECT_EQ(roundToInt32(-1e300), std::numeric_limits<std::int32_t>::min());
    EXPECT_EQ(roundToInt32(std::nan("")), 0);
    EXPECT_EQ(roundToUint32(-1), 0U);
    EXPECT_EQ(roundToUint32(4294967295.4), 4294967295U);
    EXPECT_EQ(roundToInt64(1e19), std::numeric_limits<std::int64_t>::max());
    EXPECT_EQ(roundToInt64(-1e19), std::numeric_limits<std::int64_t>::min());
}
TEST(RoundingTest, roundsHalvesAwayFromZero)
{
    EXPECT_EQ(roundToInt32(2.5), 3);
    EXPECT_EQ(roundToInt32(-2.5), -3);
}

TEST(DriveQuantityTest, knowsEveryRealAndSpeedParameterOfTheKincoList)
{
    for (unsigned number = 0; number < 45; ++number) {
        const bool converted = number <= 2 || number == 6 || number == 7 || number == 10 || number == 12 || number == 16 || number == 17 || number == 22;
        EXPECT_EQ(kincoParameterQuantity(number) != DriveQuantity::Raw, converted) << number;
    }
    EXPECT_EQ(kincoObjectQuantity(0x6083, 0), DriveQuantity::Acceleration);
    EXPECT_EQ(kincoObjectQuantity(0x6099, 1), DriveQuantity::SpeedPerMinute);
    EXPECT_EQ(kincoObjectQuantity(0x6099, 5), DriveQuantity::Raw);
}
TEST(DriveQuantityTest, everyConversionComesBack)
{
    for (const auto quantity : {DriveQuantity::Raw, DriveQuantity::Position, DriveQuantity::SpeedPerMinute, DriveQuantity::Acceleration,
             DriveQuantity::GainHz, DriveQuantity::FeedForwardPercent, DriveQuantity::FilterHz}) {
        for (const std::int64_t drive : {0, 1, 17, 32767})
            EXPECT_EQ(processToDrive(quantity, driveToProcess(quantity, static_cast<double>(drive), kTurn), kTurn), drive);
    }
}
TEST(DriveQuantityTest, writesAnAccelerationInCountsPerSecondSquared)
{
    EXPECT_EQ(processToDrive(DriveQuantity::Acceleration, 500, kFeed), 50000);
    EXPECT_EQ(processToDrive(DriveQuantity::Acceleration, std::nan(""), kFeed), 0);
}
