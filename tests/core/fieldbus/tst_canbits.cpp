#include "core/fieldbus/canbits.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

using namespace camwright;

namespace {

CanFrame frameOf(std::uint32_t id, std::vector<std::uint8_t> data, bool extended = false)
{
    CanFrame frame;
    frame.id = id;
    frame.extended = extended;
    frame.length = static_cast<std::uint8_t>(data.size());
    std::copy(data.begin(), data.end(), frame.data.begin());
    return frame;
}

CanFrame remoteOf(std::uint32_t id, std::uint8_t length, bool extended = false)
{
    CanFrame frame;
    frame.id = id;
    frame.remote = true;
    frame.extended = extended;
    frame.length = length;
    return frame;
}

struct Row {
    const char* name;
    CanFrame frame;
    unsigned unstuffed;
    unsigned bits;
    unsigned checksum;
};

class KnownFrame : public testing::TestWithParam<Row> {};

// Lengths and checksums from a separate program that divides the bit string by the polynomial on paper's way.
INSTANTIATE_TEST_SUITE_P(CanBitsTest, KnownFrame,
    testing::Values(Row{"empty", frameOf(0, {}), 47, 53, 0},
        Row{"allOnes", frameOf(0x7FF, std::vector<std::uint8_t>(8, 0xFF)), 111, 126, 19593},
        Row{"allZeros", frameOf(0, std::vector<std::uint8_t>(8, 0)), 111, 127, 5211},
        Row{"counting", frameOf(0x123, {1, 2, 3, 4, 5, 6, 7, 8}), 111, 119, 25839},
        Row{"sdoRequest", frameOf(0x601, {0x40, 0x41, 0x60, 0, 0, 0, 0, 0}), 111, 123, 10706},
        Row{"guardRequest", remoteOf(0x701, 1), 47, 51, 31200},
        Row{"statusPdo", frameOf(0x181, {0x37, 0x06, 0x01, 0, 0, 0, 0}), 103, 113, 30270},
        Row{"extended", frameOf(0x12345678, {0xDE, 0xAD, 0xBE, 0xEF}, true), 99, 101, 13083},
        Row{"extendedRemote", remoteOf(0, 0, true), 67, 73, 13781},
        Row{"extendedZeros", frameOf(0x1FFFFFFF, std::vector<std::uint8_t>(8, 0), true), 131, 151, 32163},
        Row{"oneByte", frameOf(0x014, {1}), 55, 58, 30547},
        Row{"alternating", frameOf(0x555, std::vector<std::uint8_t>(8, 0x55)), 111, 112, 6916}),
    [](const auto& row) { return row.param.name; });

TEST_P(KnownFrame, hasItsExactLengthAndChecksum)
{
    const Row& row = GetParam();
    EXPECT_EQ(unstuffedFrameBits(row.frame), row.unstuffed);
    EXPECT_EQ(frameBits(row.frame), row.bits);
    EXPECT_EQ(frameChecksum(row.frame), row.checksum);
}

} // namespace

TEST(CanBitsTest, aFullStandardFrameHas111To135Bits)
{
    const CanFrame frame = frameOf(1, std::vector<std::uint8_t>(8, 7));
    EXPECT_EQ(unstuffedFrameBits(frame), 111U);
    EXPECT_EQ(worstCaseFrameBits(frame), 135U);
}

TEST(CanBitsTest, aFullExtendedFrameHas131To160Bits)
{
    const CanFrame frame = frameOf(1, std::vector<std::uint8_t>(8, 7), true);
    EXPECT_EQ(unstuffedFrameBits(frame), 131U);
    EXPECT_EQ(worstCaseFrameBits(frame), 160U);
}

TEST(CanBitsTest, everyFrameLiesBetweenUnstuffedAndWorstCase)
{
    std::uint64_t state = 20261122;
    for (int i = 0; i < 20000; ++i) {
        state = state * 6364136223846793005ULL + 1442695040888963407ULL;
        CanFrame frame;
        frame.extended = (state >> 20 & 1) != 0;
        frame.remote = (state >> 21 & 3) == 0;
        frame.id = static_cast<std::uint32_t>(state >> 33) & (frame.extended ? 0x1FFFFFFFU : 0x7FFU);
        frame.length = static_cast<std::uint8_t>((state >> 24) % 9);
        for (unsigned byte = 0; byte < frame.length; ++byte)
            frame.data[byte] = (state >> 30 & 1) != 0 ? static_cast<std::uint8_t>(state >> (8 * byte)) : 0;
        ASSERT_GE(frameBits(frame), unstuffedFrameBits(frame));
        ASSERT_LE(frameBits(frame), worstCaseFrameBits(frame));
    }
}

TEST(CanBitsTest, aMegabitGivesAMicrosecondABit)
{
    EXPECT_EQ(bitTime(111, 1'000'000), 111us);
    EXPECT_EQ(bitTime(1, 3), 333333334ns); // never shorter than it is
}

TEST(CanBitsTest, theLowerIdentifierWins)
{
    EXPECT_LT(arbitrationKey(frameOf(0x080, {})), arbitrationKey(frameOf(0x081, {})));
    EXPECT_LT(arbitrationKey(frameOf(0x7FF, {})), arbitrationKey(remoteOf(0x7FF, 0)));
    // A standard frame beats the extended ones that begin with its identifier, and loses against a smaller beginning.
    EXPECT_LT(arbitrationKey(remoteOf(0x100, 0)), arbitrationKey(frameOf(0x100U << 18, {}, true)));
    EXPECT_LT(arbitrationKey(frameOf(0x0FFU << 18 | 0x3FFFF, {}, true)), arbitrationKey(frameOf(0x100, {})));
    EXPECT_LT(arbitrationKey(frameOf(5, {}, true)), arbitrationKey(remoteOf(5, 0, true)));
}
