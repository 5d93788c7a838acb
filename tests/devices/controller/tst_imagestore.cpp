#include "devices/controller/imagestore.h"
#include "tests/core/storage/memoryfilesystem.h"

#include <gtest/gtest.h>

#include <random>

using namespace camwright;

namespace {

Bytes image(std::uint8_t value, std::size_t size = 5000) { return Bytes(size, value); }

TEST(ImageStoreTest, anEmptyFolderHoldsNothingAndThatIsNoTrouble)
{
    MemoryFileSystem files;
    const auto stored = ImageStore(files, "").load();
    EXPECT_TRUE(stored.image.empty() && stored.previous.empty() && stored.trouble.empty());
}

TEST(ImageStoreTest, theNewestCountsAndTheOneBeforeIsKept)
{
    MemoryFileSystem files;
    ImageStore store(files, "");
    for (std::uint8_t i = 1; i <= 5; ++i)
        ASSERT_TRUE(store.replace(image(i)));
    const auto stored = ImageStore(files, "").load();
    EXPECT_EQ(stored.image, image(5));
    EXPECT_EQ(stored.previous, image(4));
}

TEST(ImageStoreTest, anErrorAtAnyCallLeavesTheOldOrTheNewAndSaysWhich)
{
    for (unsigned failAt = 1; failAt < 20; ++failAt) {
        for (const bool afterwardsToo : {false, true}) {
            MemoryFileSystem files;
            ImageStore store(files, "");
            ASSERT_TRUE(store.replace(image(1)));
            files.failAt = files.calls + failAt;
            files.failAfterwardsToo = afterwardsToo;
            const bool done = store.replace(image(2)).ok();
            files.failAt = 0;
            const auto stored = ImageStore(files, "").load();
            EXPECT_EQ(stored.image, image(done ? 2 : 1)) << "call " << failAt;
        }
    }
}

TEST(ImageStoreTest, aCutAfterAnyStepLeavesTheOldOrTheNew)
{
    MemoryFileSystem files;
    ASSERT_TRUE(ImageStore(files, "").replace(image(1)));
    const auto before = files.files;
    files.log.clear();
    ASSERT_TRUE(ImageStore(files, "").replace(image(2)));
    const auto operations = files.log;
    bool sawOld = false, sawNew = false;
    for (std::size_t steps = 0; steps <= operations.size(); ++steps) {
        MemoryFileSystem after;
        after.files = before;
        for (std::size_t i = 0; i < steps; ++i)
            after.apply(operations[i]);
        // The step in progress may have written half of its bytes.
        if (steps < operations.size() && operations[steps].kind == FileOperation::Kind::Write) {
            FileOperation half = operations[steps];
            half.bytes.resize(half.bytes.size() / 2);
            after.apply(half);
        }
        const Bytes found = ImageStore(after, "").load().image;
        ASSERT_TRUE(found == image(1) || found == image(2)) << "after " << steps << " steps";
        (found == image(1) ? sawOld : sawNew) = true;
    }
    EXPECT_TRUE(sawOld && sawNew);
}

TEST(ImageStoreTest, goBackMakesTheOneBeforeCountAgain)
{
    MemoryFileSystem files;
    ImageStore store(files, "");
    ASSERT_TRUE(store.replace(image(1)));
    ASSERT_TRUE(store.goBack());
    EXPECT_TRUE(store.load().image.empty());
    ASSERT_TRUE(store.replace(image(1)));
    ASSERT_TRUE(store.replace(image(2)));
    ASSERT_TRUE(store.goBack());
    EXPECT_EQ(store.load().image, image(1));
}

TEST(ImageStoreTest, damagedBytesAreNeverBelieved)
{
    MemoryFileSystem whole;
    ImageStore store(whole, "");
    ASSERT_TRUE(store.replace(image(1)));
    ASSERT_TRUE(store.replace(image(2)));
    std::mt19937 random(3);
    for (int i = 0; i < 10'000; ++i) {
        MemoryFileSystem files;
        files.files = whole.files;
        auto file = std::next(files.files.begin(), static_cast<std::ptrdiff_t>(random() % files.files.size()));
        std::string& bytes = file->second;
        if (random() % 4 == 0)
            bytes.resize(random() % bytes.size());
        else
            bytes[random() % bytes.size()] ^= static_cast<char>(1 + random() % 255);
        const auto stored = ImageStore(files, "").load();
        EXPECT_TRUE(stored.image.empty() || stored.image == image(2));
        EXPECT_TRUE(stored.previous.empty() || stored.previous == image(1));
        EXPECT_TRUE(!stored.image.empty() || !stored.trouble.empty());
    }
}

} // namespace
