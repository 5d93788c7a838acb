#include "core/base/diagnostic.h"
#include "core/checks/checkproject.h"
#include "core/storage/projectstore.h"

#include <gtest/gtest.h>

using namespace camwright;

namespace {

class ExampleCheck : public testing::TestWithParam<const char*> {};

TEST_P(ExampleCheck, hasNothingToSay)
{
    PosixFileSystem files;
    const auto loaded = openProject(files, std::string(CAMWRIGHT_SOURCE_DIR "/examples/") + GetParam());
    ASSERT_TRUE(loaded.ok()) << englishLine(loaded.error().front());
    const Validation result = validate(loaded->project);
    for (const Diagnostic& d : result.diagnostics)
        ADD_FAILURE() << d.place.field << ' ' << englishLine(d);
    EXPECT_TRUE(result.project.has_value());
}

INSTANTIATE_TEST_SUITE_P(ExamplesTest, ExampleCheck, testing::Values("kinco-feeder", "ts600-marquee"));

} // namespace
