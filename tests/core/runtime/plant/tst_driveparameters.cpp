#include "tests/core/runtime/plant/networkfixture.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

using namespace camwright;

namespace {

/// One row of the Kinco list, as kinco_drive_parameters.csv prints it.
struct Parameter {
    unsigned number;
    std::uint32_t code; ///< index, sub-index, bits
    std::int64_t minimum;
    std::int64_t maximum;
};

// KS-MC-15. The two commands, 43 and 44, have a test of their own.
const std::vector<Parameter> kParameters{
    {0, 0x60830020, 0, 268435455}, {1, 0x60840020, 0, 268435455}, {2, 0x60990120, -2147483648LL, 2147483647},
    {3, 0x60980008, -128, 127}, {4, 0x60F90110, 0, 32767}, {5, 0x60F90210, 0, 32767}, {6, 0x60FB0110, 0, 32767},
    {7, 0x60FB0210, 0, 1024}, {8, 0x23400410, 0, 32767}, {9, 0x23400510, 0, 32767}, {10, 0x23400610, 0, 32767},
    {11, 0x60730010, 0, 2048}, {12, 0x607F0020, -2147483648LL, 2147483647}, {13, 0x60990508, 0, 255}, {14, 0x607E0008, 0, 1},
    {15, 0x64100110, 0, 65535}, {16, 0x607D0120, -2147483648LL, 2147483647}, {17, 0x607D0220, -2147483648LL, 2147483647},
    {18, 0x60FB0510, 0, 255}, {19, 0x60650020, 0, 268435455}, {20, 0x60670020, 0, 268435455}, {21, 0x60680010, 0, 32767},
    {22, 0x60F90508, 0, 45}, {23, 0x60F90608, 0, 85}, {24, 0x20100110, 0, 255}, {25, 0x20100310, 0, 65535},
    {26, 0x20100410, 0, 65535}, {27, 0x20100510, 0, 65535}, {28, 0x20100610, 0, 65535}, {29, 0x20100710, 0, 65535},
    {30, 0x20100810, 0, 65535}, {31, 0x20100910, 0, 65535}, {32, 0x20101D10, 0, 65535}, {33, 0x20100D10, 0, 255},
    {34, 0x20100F10, 0, 65535}, {35, 0x20101010, 0, 65535}, {36, 0x20101110, 0, 65535}, {37, 0x20101210, 0, 65535},
    {38, 0x20101310, 0, 65535}, {39, 0x20101E10, 0, 65535}, {40, 0x20101F10, 0, 65535},
    {41, 0x25080420, -2147483648LL, 2147483647}, {42, 0x25080308, 0, 255}};

ObjectId objectOf(const Parameter& parameter)
{
    return {static_cast<std::uint16_t>(parameter.code >> 16), static_cast<std::uint8_t>(parameter.code >> 8)};
}

class DriveParameterTest : public testing::Test {
protected:
    void SetUp() override { ASSERT_TRUE(network.boot()); }
    SdoResult write(const Parameter& parameter, std::int64_t value)
    {
        return network.write(1, objectOf(parameter), value, (parameter.code & 0xFF) / 8);
    }
    Network network{1};
};

} // namespace

TEST_F(DriveParameterTest, everyObjectOfTheListHasItsWidthAndRange)
{
    const ObjectDictionary& objects = network.drive(1).objects();
    for (const Parameter& parameter : kParameters) {
        SCOPED_TRACE(parameter.number);
        const auto slot = objects.find(objectOf(parameter));
        ASSERT_NE(slot, ObjectDictionary::kNone);
        EXPECT_EQ(objects.byteSize(slot) * 8, parameter.code & 0xFF);
        EXPECT_EQ(objects.info(slot).minimum, parameter.minimum);
        EXPECT_EQ(objects.info(slot).maximum, parameter.maximum);
        EXPECT_GE(objects.info(slot).initial, parameter.minimum);
        EXPECT_LE(objects.info(slot).initial, parameter.maximum);
    }
}

TEST_F(DriveParameterTest, bothEndsOfEveryRangeAreTakenOverTheWire)
{
    for (const Parameter& parameter : kParameters) {
        SCOPED_TRACE(parameter.number);
        if (parameter.number == 3)
            continue; // homing methods have gaps
        const unsigned bytes = (parameter.code & 0xFF) / 8;
        EXPECT_EQ(write(parameter, parameter.minimum).status, SdoStatus::Done);
        EXPECT_EQ(write(parameter, parameter.maximum).status, SdoStatus::Done);
        EXPECT_EQ(network.read(1, objectOf(parameter)).data.size(), bytes);
        const bool beyondFits = parameter.minimum >= 0 && parameter.maximum + 1 < (std::int64_t{1} << (8 * bytes));
        if (beyondFits) {
            EXPECT_EQ(write(parameter, parameter.maximum + 1).abort, SdoAbort::ValueTooHigh);
        }
    }
}

TEST_F(DriveParameterTest, homingMethodsOutsideTheAgreedOnesAreRefused)
{
    for (int method = -128; method <= 127; ++method) {
        const bool taken = (method >= 1 && method <= 14) || (method >= 17 && method <= 30) || (method >= 33 && method <= 35) || method == 37;
        const SdoResult result = network.write(1, {0x6098, 0}, method, 1);
        EXPECT_EQ(result.status == SdoStatus::Done, taken) << method;
        if (!taken) {
            EXPECT_EQ(result.abort, SdoAbort::ValueRange) << method;
        }
    }
}

TEST_F(DriveParameterTest, savedParametersSurviveAPowerCycleAndOthersDoNot)
{
    ASSERT_EQ(network.write(1, {0x6083, 0}, 1111, 4).status, SdoStatus::Done);
    EXPECT_EQ(network.write(1, {0x1010, 1}, 1, 4).abort, SdoAbort::CannotTransfer);
    ASSERT_EQ(network.write(1, {0x1010, 1}, kSaveSignature, 4).status, SdoStatus::Done);
    EXPECT_EQ(network.readNumber(1, {0x1010, 1}, DataType::Udint), 1);
    ASSERT_EQ(network.write(1, {0x6084, 0}, 2222, 4).status, SdoStatus::Done);
    network.bus.powerOff();
    network.bus.powerOn(network.now);
    network.run(300ms);
    ASSERT_TRUE(network.master->restart(1, 0ms, network.now));
    ASSERT_TRUE(network.until([&] { return network.allOnline(); }, 1s));
    EXPECT_EQ(network.readNumber(1, {0x6083, 0}, DataType::Udint), 1111);
    EXPECT_EQ(network.readNumber(1, {0x6084, 0}, DataType::Udint), 200000);
}

TEST_F(DriveParameterTest, loadBringsTheDefaultsBackUnlessTheAxisIsEnabled)
{
    ASSERT_EQ(network.write(1, {0x6083, 0}, 1111, 4).status, SdoStatus::Done);
    EXPECT_EQ(network.write(1, {0x1011, 1}, kSaveSignature, 4).abort, SdoAbort::CannotTransfer);
    ASSERT_TRUE(network.enable(1, 1));
    EXPECT_EQ(network.write(1, {0x1011, 1}, kLoadSignature, 4).abort, SdoAbort::DeviceState);
    network.out(1).controlWord = 0;
    network.run(50ms);
    ASSERT_EQ(network.write(1, {0x1011, 1}, kLoadSignature, 4).status, SdoStatus::Done);
    EXPECT_EQ(network.readNumber(1, {0x6083, 0}, DataType::Udint), 200000);
    // The configuration of the network is not the drive's to forget.
    EXPECT_TRUE(network.master->isOnline(1));
    EXPECT_EQ(network.drive(1).objects().number({0x1A00, 0}), 3);
}

TEST_F(DriveParameterTest, defaultsScaleWithTheEncoder)
{
    SimulatedDriveConfig config;
    config.countsPerTurn = 131072;
    Network fine(1, 1'000'000, config);
    ASSERT_TRUE(fine.boot());
    EXPECT_EQ(fine.readNumber(1, {0x6083, 0}, DataType::Udint), 20 * 131072);
    EXPECT_EQ(fine.readNumber(1, {0x6067, 0}, DataType::Udint), 131);
}
