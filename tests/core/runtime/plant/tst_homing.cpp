#include "core/runtime/plant/homing.h"

#include "tests/core/runtime/plant/networkfixture.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

using namespace camwright;

namespace {

// The machine of these tests: limits at -30000 and 30000, home switch at 3000 (a cam to 5500 where the method wants one),
// index pulses at 2500 in every turn of 10000: ..., -7500, 2500, 12500, ...
constexpr double kHome = 3000;
constexpr double kCam = 2500;
constexpr double kLower = -30000;
constexpr double kUpper = 30000;

/// Where each method finds its reference (CiA 402), worked out by hand for this machine.
struct Expected {
    int method;
    double place;
};
const std::vector<Expected> kExpected{
    {1, -27500}, {2, 22500}, {3, 2500}, {4, 12500}, {5, 12500}, {6, 2500},
    {7, 2500}, {8, 12500}, {9, 2500}, {10, 12500}, {11, 12500}, {12, 2500}, {13, 12500}, {14, 2500},
    {17, kLower}, {18, kUpper}, {19, kHome}, {20, kHome}, {21, kHome}, {22, kHome},
    {23, kHome}, {24, kHome}, {25, kHome + kCam}, {26, kHome + kCam},
    {27, kHome + kCam}, {28, kHome + kCam}, {29, kHome}, {30, kHome}};

class HomingMethod : public testing::TestWithParam<Expected> {};
INSTANTIATE_TEST_SUITE_P(HomingTest, HomingMethod, testing::ValuesIn(kExpected),
    [](const auto& row) { return "method" + std::to_string(row.param.method); });

SimulatedDriveConfig machineAt(double start)
{
    SimulatedDriveConfig config;
    config.startPosition = start;
    config.homeSwitch = kHome;
    config.homeCamWidth = kCam;
    config.lowerLimitSwitch = kLower;
    config.upperLimitSwitch = kUpper;
    return config;
}

/// Runs a homing over the wire; false when the drive reports an error or nothing in a minute.
bool home(Network& network, int method, std::int32_t offset = 0)
{
    if (!network.boot() || network.write(1, {0x6098, 0}, method, 1).status != SdoStatus::Done)
        return false;
    network.write(1, {0x6099, 1}, 20000, 4);
    network.write(1, {0x6099, 2}, 4000, 4);
    network.write(1, {0x607C, 0}, offset, 4);
    if (!network.enable(1, 6))
        return false;
    network.out(1).controlWord = 0x1F;
    network.until([&] { return (network.in(1).statusWord & 0x3000) != 0; }, 60s);
    return network.status(1, 0x3400, 0x1400);
}

} // namespace

// From below, above, on the switch and on the limit switches: the place is always the same.
TEST_P(HomingMethod, findsItsPlaceFromAnywhere)
{
    const Expected& expected = GetParam();
    for (const double start : {-12000.0, 2999.0, 3000.0, 4000.0, 5501.0, 14000.0, -30100.0, 30100.0}) {
        Network network(1, 1'000'000, machineAt(start));
        ASSERT_TRUE(home(network, expected.method)) << "from " << start;
        EXPECT_NEAR(network.drive(1).plantPosition(), expected.place, 11) << "from " << start;
        EXPECT_NEAR(network.in(1).position, 0, 11);
        EXPECT_TRUE(network.drive(1).isHomed());
    }
}

TEST(HomingTest, nearestIndexPulses)
{
    for (const auto& [method, place] : {std::pair{33, -7500.0}, std::pair{34, 2500.0}}) {
        Network network(1, 1'000'000, machineAt(100));
        ASSERT_TRUE(home(network, method));
        EXPECT_NEAR(network.drive(1).plantPosition(), place, 11);
    }
}

TEST(HomingTest, theCurrentPositionWithoutMoving)
{
    for (const int method : {35, 37}) {
        Network network(1, 1'000'000, machineAt(1234));
        ASSERT_TRUE(home(network, method, -777));
        EXPECT_NEAR(network.drive(1).plantPosition(), 1234, 0.5);
        EXPECT_EQ(network.in(1).position, -777);
    }
}

TEST(HomingTest, theReferenceGetsTheHomeOffset)
{
    Network network(1, 1'000'000, machineAt(0));
    ASSERT_TRUE(home(network, 19, 50000));
    EXPECT_NEAR(network.in(1).position, 50000, 11);
    EXPECT_NEAR(network.drive(1).plantPosition(), kHome, 11);
}

TEST(HomingTest, homeOffsetModeOneStaysWhereItStopped)
{
    Network network(1, 1'000'000, machineAt(0));
    network.powerOn();
    ASSERT_TRUE(network.until([&] { return network.allOnline(); }, 1s));
    ASSERT_EQ(network.write(1, {0x6099, 5}, 1, 1).status, SdoStatus::Done);
    ASSERT_EQ(network.write(1, {0x6098, 0}, 20, 1).status, SdoStatus::Done);
    ASSERT_TRUE(network.enable(1, 6));
    network.out(1).controlWord = 0x1F;
    ASSERT_TRUE(network.until([&] { return network.status(1, 0x1400, 0x1400); }, 20s));
    network.run(200ms);
    EXPECT_GT(network.in(1).position, 20); // it braked behind the edge
    EXPECT_NEAR(network.in(1).position, network.drive(1).plantPosition() - kHome, 2);
}

TEST(HomingTest, aReversedDriveHomesInItsOwnDirection)
{
    Network network(1, 1'000'000, machineAt(0));
    network.powerOn();
    ASSERT_TRUE(network.until([&] { return network.allOnline(); }, 1s));
    ASSERT_EQ(network.write(1, {0x607E, 0}, 1, 1).status, SdoStatus::Done);
    ASSERT_EQ(network.write(1, {0x6098, 0}, 17, 1).status, SdoStatus::Done);
    ASSERT_TRUE(network.enable(1, 6));
    network.out(1).controlWord = 0x1F;
    ASSERT_TRUE(network.until([&] { return network.status(1, 0x1400, 0x1400); }, 30s));
    EXPECT_NEAR(network.drive(1).plantPosition(), kUpper, 11); // the drive's negative end
}

TEST(HomingTest, haltPausesAndGoesOn)
{
    Network network(1, 1'000'000, machineAt(-25000));
    ASSERT_TRUE(network.boot());
    ASSERT_EQ(network.write(1, {0x6098, 0}, 19, 1).status, SdoStatus::Done);
    ASSERT_TRUE(network.enable(1, 6));
    network.out(1).controlWord = 0x1F;
    network.run(500ms);
    EXPECT_NE(network.in(1).velocity, 0);
    network.out(1).controlWord = 0x11F;
    network.run(1s);
    EXPECT_EQ(network.in(1).velocity, 0);
    EXPECT_TRUE(network.status(1, 0x3000, 0));
    network.out(1).controlWord = 0x1F;
    EXPECT_TRUE(network.until([&] { return network.status(1, 0x1400, 0x1400); }, 20s));
    EXPECT_NEAR(network.drive(1).plantPosition(), kHome, 11);
}

TEST(HomingTest, takingTheStartBitBackEndsIt)
{
    Network network(1, 1'000'000, machineAt(-25000));
    ASSERT_TRUE(network.boot());
    ASSERT_EQ(network.write(1, {0x6098, 0}, 19, 1).status, SdoStatus::Done);
    ASSERT_TRUE(network.enable(1, 6));
    network.out(1).controlWord = 0x1F;
    network.run(500ms);
    network.out(1).controlWord = 0x0F;
    network.run(1s);
    EXPECT_TRUE(network.status(1, 0x3400, 0x0400)); // standing, neither attained nor failed
    EXPECT_FALSE(network.drive(1).isHomed());
}

TEST(HomingTest, aHomeSwitchBehindALimitIsAnError)
{
    SimulatedDriveConfig config = machineAt(0);
    config.upperLimitSwitch = 2000; // in front of the home switch
    Network network(1, 1'000'000, config);
    EXPECT_FALSE(home(network, 19));
    EXPECT_TRUE(network.status(1, 0x2000, 0x2000));
    network.run(500ms);
    EXPECT_EQ(network.in(1).velocity, 0);
    EXPECT_FALSE(network.drive(1).isHomed());
    EXPECT_EQ(network.drive(1).state(), DriveState::OperationEnabled);
}

TEST(HomingTest, aModeChangeClearsTheResultOfTheLastHoming)
{
    Network network(1, 1'000'000, machineAt(0));
    ASSERT_TRUE(home(network, 37));
    network.out(1).controlWord = 0x0F;
    network.out(1).mode = 1;
    ASSERT_TRUE(network.until([&] { return network.in(1).mode == 1; }, 1s));
    network.out(1).mode = 6;
    ASSERT_TRUE(network.until([&] { return network.in(1).mode == 6; }, 1s));
    EXPECT_TRUE(network.status(1, 0x3000, 0));
    EXPECT_TRUE(network.drive(1).isHomed());
}
