#include "core/storage/objecttext.h"
#include "core/storage/projectstore.h"

#include <gtest/gtest.h>

using namespace camwright;

namespace {

class ExampleProject : public testing::TestWithParam<const char*> {};

TEST_P(ExampleProject, isWrittenCanonically)
{
    PosixFileSystem files;
    const auto loaded = openProject(files, std::string(CAMWRIGHT_SOURCE_DIR "/examples/") + GetParam());
    ASSERT_TRUE(loaded.ok()) << englishLine(loaded.error().front());
    EXPECT_EQ(loaded->project.name(), GetParam());
    for (const auto& [path, file] : loaded->files) {
        EXPECT_EQ(toText(*file.object), file.text) << path;
        EXPECT_EQ(fileOf(file.object->key, loaded->project), path);
    }
}

INSTANTIATE_TEST_SUITE_P(ExamplesTest, ExampleProject, testing::Values("kinco-feeder", "ts600-marquee"));

} // namespace
