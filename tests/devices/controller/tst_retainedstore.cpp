#include "devices/controller/retainedstore.h"
#include "tests/core/storage/memoryfilesystem.h"

#include <gtest/gtest.h>

using namespace camwright;

namespace {

TEST(RetainedStoreTest, theNewestSetComesBack)
{
    MemoryFileSystem files;
    RetainedStore store(files, "");
    for (std::uint8_t i = 1; i <= 9; ++i)
        ASSERT_TRUE(store.save(Bytes(10, i)));
    EXPECT_EQ(RetainedStore(files, "").load().data, Bytes(10, 9));
}

TEST(RetainedStoreTest, aSetThatDidNotChangeIsNotWrittenAgain)
{
    MemoryFileSystem files;
    RetainedStore store(files, "");
    ASSERT_TRUE(store.save(Bytes(10, 1)));
    const unsigned calls = files.calls;
    ASSERT_TRUE(store.save(Bytes(10, 1)));
    EXPECT_EQ(files.calls, calls);
}

TEST(RetainedStoreTest, aCutDuringAWriteLeavesTheSetBefore)
{
    MemoryFileSystem files;
    RetainedStore store(files, "");
    ASSERT_TRUE(store.save(Bytes(10, 1)));
    ASSERT_TRUE(store.save(Bytes(10, 2)));
    const auto before = files.files;
    files.log.clear();
    ASSERT_TRUE(store.save(Bytes(10, 3)));
    const FileOperation write = files.log.at(0);
    for (std::size_t size = 0; size < write.bytes.size(); ++size) {
        MemoryFileSystem after;
        after.files = before;
        FileOperation part = write;
        part.bytes.resize(size);
        after.apply(part);
        RetainedStore restarted(after, "");
        ASSERT_EQ(restarted.load().data, Bytes(10, 2)) << size;
        // and the next write must not touch the only whole set
        const std::string whole = after.files.at(write.path == "/retained.a" ? "/retained.b" : "/retained.a");
        ASSERT_TRUE(restarted.save(Bytes(10, 4)));
        ASSERT_EQ(after.files.at(write.path == "/retained.a" ? "/retained.b" : "/retained.a"), whole);
    }
}

TEST(RetainedStoreTest, twoDamagedSetsAreTold)
{
    MemoryFileSystem files;
    files.files["/retained.a"] = "x";
    files.files["/retained.b"] = "";
    const auto stored = RetainedStore(files, "").load();
    EXPECT_TRUE(stored.damaged && stored.data.empty());
}

} // namespace
