#include "devices/protocol/framing.h"

#include <gtest/gtest.h>

#include <random>

using namespace camwright;

namespace {

Bytes bytes(std::size_t size, std::uint8_t value) { return Bytes(size, value); }

TEST(FramingTest, framesComeOutHoweverTheStreamIsCut)
{
    std::mt19937 random(7);
    Bytes stream;
    for (std::size_t i = 1; i < 200; ++i) {
        const Bytes frame = frameOf(bytes(i, static_cast<std::uint8_t>(i)));
        stream.insert(stream.end(), frame.begin(), frame.end());
    }
    FrameReader reader(1000);
    std::size_t expected = 1, position = 0;
    while (position < stream.size()) {
        const std::size_t size = std::min<std::size_t>(1 + random() % 300, stream.size() - position);
        reader.feed(ByteSpan(stream).subspan(position, size));
        position += size;
        for (auto frame = reader.next(); frame.ok() && *frame; frame = reader.next(), ++expected)
            ASSERT_EQ(**frame, bytes(expected, static_cast<std::uint8_t>(expected)));
    }
    EXPECT_EQ(expected, 200u);
    EXPECT_FALSE(reader.isInsideFrame());
}

TEST(FramingTest, aHugeLengthBreaksTheStreamForGood)
{
    FrameReader reader(1000);
    reader.feed(Bytes{0xFF, 0xFF, 0xFF, 0xFF});
    EXPECT_FALSE(reader.next().ok());
    reader.feed(frameOf(bytes(1, 1)));
    EXPECT_FALSE(reader.next().ok());
}

TEST(FramingTest, anEmptyFrameIsRefused)
{
    FrameReader reader(1000);
    reader.feed(Bytes{0, 0, 0, 0});
    EXPECT_EQ(reader.next().error(), "a frame of 0 bytes, where 1 to 1000 are allowed");
}

TEST(FramingTest, halfAFrameWaits)
{
    FrameReader reader(1000);
    reader.feed(Bytes{0, 0, 0, 5, 1, 2});
    const auto next = reader.next();
    ASSERT_TRUE(next.ok());
    EXPECT_FALSE(next->has_value());
    EXPECT_TRUE(reader.isInsideFrame());
}

} // namespace
