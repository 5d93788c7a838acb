#include "core/language/image/container.h"
#include "core/language/image/imageparts.h"
#include "core/runtime/executor/executor.h"
#include "tests/core/language/image/sampleimage.h"

#include <gtest/gtest.h>

using namespace camwright;
using namespace camwright::test;

namespace {

TEST(ImageTest, everyFieldComesBack)
{
    const ControllerImage image = sampleImage();
    const Bytes bytes = write(image);
    const Result<ControllerImage> read = readImage(bytes);
    ASSERT_TRUE(read.ok()) << englishText(read.error());
    EXPECT_EQ(*read, image);
    EXPECT_EQ(write(*read), bytes);
}

TEST(ImageTest, aCutImageIsRefusedAtEveryByte)
{
    const Bytes bytes = write(sampleImage());
    for (std::size_t size = 0; size < bytes.size(); ++size)
        ASSERT_FALSE(readImage(ByteSpan(bytes).first(size)).ok()) << size;
}

TEST(ImageTest, bytesBehindTheEndAreRefused)
{
    Bytes bytes = write(sampleImage());
    bytes.push_back(0);
    const Result<ControllerImage> read = readImage(bytes);
    ASSERT_FALSE(read.ok());
    EXPECT_EQ(read.error().code, Code::ImageCutShort);
}

TEST(ImageTest, oneChangedByteAnywhereIsNoticed)
{
    const Bytes bytes = write(sampleImage());
    for (std::size_t at = 0; at < bytes.size(); ++at) {
        for (const int change : {0x01, 0x80, 0xFF}) {
            Bytes damaged = bytes;
            damaged[at] = static_cast<std::uint8_t>(damaged[at] ^ change);
            ASSERT_FALSE(readImage(damaged).ok()) << at;
        }
    }
}

TEST(ImageTest, saysWhatIsWrong)
{
    const auto codeOf = [](Bytes bytes) { return readImage(bytes).error().code; };
    const Bytes bytes = write(sampleImage());
    Bytes other = bytes;
    other[0] = 'X';
    EXPECT_EQ(codeOf(other), Code::NotAnImage);
    other = bytes;
    other[8] = 9;
    EXPECT_EQ(codeOf(other), Code::ImageVersionUnknown);
    other = bytes;
    other.back() ^= 1;
    EXPECT_EQ(codeOf(other), Code::ImagePartDamaged);
    other.resize(30);
    EXPECT_EQ(codeOf(other), Code::ImageCutShort);
    EXPECT_EQ(codeOf({}), Code::ImageCutShort);
    ControllerImage unsafe = sampleImage();
    unsafe.program.routines[0].code[0].address.byte = 1024;
    EXPECT_EQ(codeOf(write(unsafe)), Code::ImageUnsafe);
}

TEST(ImageTest, commentsAndPlacesDoNotChangeTheProgramsHash)
{
    const ControllerImage image = sampleImage();
    ControllerImage moved = image;
    moved.source[0].text += "(* a comment *)\n";
    moved.debug.sources[1].range.line = 99;
    moved.debug.projectName = "other";
    moved.program.routines[0].code[3].source = 1;
    EXPECT_EQ(programHash(moved), programHash(image));
    EXPECT_NE(write(moved), write(image));
    moved.configuration.axes[0].lifeFactor = 4;
    EXPECT_NE(programHash(moved), programHash(image));
    moved = image;
    moved.program.routines[1].code[1].constant = 2;
    EXPECT_NE(programHash(moved), programHash(image));
    const Result<std::vector<ImagePartInfo>> parts = readPartTable(write(image));
    ASSERT_TRUE(parts.ok());
    EXPECT_EQ(programHash(*parts), programHash(image));
}

TEST(ImageTest, findsVariablesAndPlaces)
{
    const ControllerImage image = sampleImage();
    ASSERT_NE(findSymbol(image, "Speed"), nullptr);
    EXPECT_TRUE(findSymbol(image, "Speed")->retain);
    EXPECT_EQ(findSymbol(image, "speed"), nullptr);
    EXPECT_EQ(findSymbol(image, ""), nullptr);
    EXPECT_EQ(sourceOf(image, 1, 0), Place{}) << "source 0 is nowhere";
    EXPECT_EQ(sourceOf(image, 1, 1).object.name, "Main");
    EXPECT_EQ(sourceOf(image, 1, 1).range.line, 1u);
    EXPECT_EQ(sourceOf(image, 9, 0), Place{});
    EXPECT_EQ(sourceOf(image, 0, 9999), Place{});
}

/// Small deterministic random numbers.
struct Random {
    std::uint64_t state;
    std::uint32_t next(std::uint32_t below)
    {
        state = state * 6364136223846793005u + 1442695040888963407u;
        return static_cast<std::uint32_t>((state >> 33) % below);
    }
};

void mutate(Bytes& bytes, Random& random)
{
    if (bytes.empty())
        return;
    const std::uint32_t at = random.next(static_cast<std::uint32_t>(bytes.size()));
    switch (random.next(4)) {
    case 0: bytes[at] = static_cast<std::uint8_t>(random.next(256)); break;
    case 1: bytes[at] ^= static_cast<std::uint8_t>(1u << random.next(8)); break;
    case 2: bytes.erase(bytes.begin() + at); break;
    default: bytes.insert(bytes.begin() + at, static_cast<std::uint8_t>(random.next(256))); break;
    }
}

// The hashes are right here, so everything behind them is attacked: whatever is still taken must also run.
TEST(ImageTest, forgedPartsAreRefusedOrSafeToRun)
{
    const std::vector<ImagePart> parts = imageParts(sampleImage());
    Random random{12345};
    unsigned taken = 0;
    for (int round = 0; round < 8000; ++round) {
        std::vector<ImagePart> forged = parts;
        for (std::uint32_t i = 0, n = 1 + random.next(3); i < n; ++i)
            mutate(forged[random.next(static_cast<std::uint32_t>(forged.size()))].bytes, random);
        const Result<ControllerImage> read = readImage(writeContainer(forged));
        if (!read)
            continue;
        ++taken;
        Result<ScanExecutor> executor = ScanExecutor::load(std::make_shared<const ControllerImage>(*read));
        ASSERT_TRUE(executor.ok());
        for (int scan = 0; scan < 3; ++scan) {
            ScanInput input;
            input.now = scan * 7ms;
            input.operations = 500;
            std::ranges::fill(executor->memory().area(A), static_cast<std::uint8_t>(random.next(256)));
            executor->scan(input);
        }
    }
    EXPECT_GT(taken, 400u) << "the attack must get through to the program";
}

} // namespace
