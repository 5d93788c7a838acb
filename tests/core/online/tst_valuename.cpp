#include "core/online/valuename.h"

#include <gtest/gtest.h>

namespace camwright {
namespace {

using Names = std::vector<std::string>;

TEST(ValueNameTest, axisNamesWithBlanksOrDotsAreQuoted)
{
    EXPECT_EQ(axisValueName("Feed", "position"), "axis.Feed.position");
    EXPECT_EQ(axisValueName("Axis 1 name", "velocity"), "axis.\"Axis 1 name\".velocity");
    EXPECT_EQ(axisValueName("a.b", "state"), "axis.\"a.b\".state");
    EXPECT_EQ(axisValueName("Подача", "torque"), "axis.Подача.torque");
}

TEST(ValueNameTest, anAxisNameWithACommaSurvivesAList)
{
    EXPECT_EQ(splitValueNames(axisValueName("left,upper", "error") + ",Run"), (Names{"axis.\"left,upper\".error", "Run"}));
}

TEST(ValueNameTest, listsAreSplitAtCommasOutsideQuotes)
{
    EXPECT_EQ(splitValueNames(" a , axis.\"x, y\".position,,\t%M0.0 ,"), (Names{"a", "axis.\"x, y\".position", "%M0.0"}));
    EXPECT_EQ(splitValueNames("  "), Names{});
    EXPECT_EQ(splitValueNames("open\"a,b"), (Names{"open\"a,b"})); // an open quote runs to the end
}

} // namespace
} // namespace camwright
