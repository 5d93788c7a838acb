#include "core/fieldbus/busload.h"

#include <gtest/gtest.h>

#include <vector>

using namespace camwright;

// The vectors of Appendix B (KS-CAN-04), at 1 Mbit/s.
TEST(BusLoadTest, onePdoEveryTenMilliseconds)
{
    const std::vector<Time> intervals{10ms};
    EXPECT_DOUBLE_EQ(busLoad(intervals, 1'000'000), 0.0111);
}
TEST(BusLoadTest, sixteenAxesWithTwoPdos)
{
    const std::vector<Time> intervals(32, 10ms);
    EXPECT_NEAR(busLoad(intervals, 1'000'000), 0.3552, 1e-12);
}
TEST(BusLoadTest, thirtyTwoAxesWithThreePdosAreTooMany)
{
    const std::vector<Time> inhibitTimes(32, 10ms);
    EXPECT_NEAR(axisBusLoad(inhibitTimes, 1'000'000), 1.0656, 1e-12);
}
TEST(BusLoadTest, aSlowerBusIsFullerInProportion)
{
    const std::vector<Time> intervals{10ms};
    EXPECT_DOUBLE_EQ(busLoad(intervals, 125'000), 8 * 0.0111);
}
TEST(BusLoadTest, anIntervalOfZeroCountsNothing)
{
    const std::vector<Time> intervals{0ms, 10ms};
    EXPECT_DOUBLE_EQ(busLoad(intervals, 1'000'000), 0.0111);
}
TEST(BusLoadTest, anAxisWithoutInhibitTimeSendsEveryMillisecond)
{
    const std::vector<Time> inhibitTimes{0ms};
    EXPECT_NEAR(axisBusLoad(inhibitTimes, 1'000'000), 0.333, 1e-12);
}
