#include "core/model/fieldlist.h"
#include "core/model/project.h"

#include <gtest/gtest.h>

#include <set>

using namespace camwright;

namespace {

ObjectKey axisKey(const char* name) { return {ObjectKind::Axis, name}; }

TEST(ProjectTest, changingOneObjectSharesAllOthers)
{
    const Project before = Project().withName("Press").withContent(axisKey("Feed"), Axis{}).withContent(axisKey("Turn"), Axis{});
    Axis changed;
    changed.number = 7;
    const Project after = before.withContent(axisKey("Feed"), changed);
    EXPECT_EQ(before.find(axisKey("Turn")), after.find(axisKey("Turn")));
    EXPECT_EQ(after.content<Axis>(axisKey("Feed"))->number.value(), 7);
    EXPECT_EQ(before.content<Axis>(axisKey("Feed"))->number.value(), 1);
    EXPECT_EQ(after.name(), "Press");
}

TEST(ProjectTest, comparesValuesNotPointers)
{
    const Project one = Project().withContent(axisKey("Feed"), Axis{});
    const Project two = Project().withContent(axisKey("Feed"), Axis{});
    EXPECT_NE(one.find(axisKey("Feed")), two.find(axisKey("Feed")));
    EXPECT_EQ(one, two);
    EXPECT_FALSE(one == two.withName("other"));
}

TEST(ProjectTest, newObjectsGoLastAndListsFollowTheOrder)
{
    const Project project = Project().withContent(axisKey("Zeta"), Axis{}).withContent(axisKey("Alpha"), Axis{});
    const auto axes = project.objects(ObjectKind::Axis);
    ASSERT_EQ(axes.size(), 2u);
    EXPECT_EQ(axes[0]->key.name, "Zeta");
    EXPECT_EQ(axes[1]->order, 2);
}

TEST(ProjectTest, replacingContentKeepsOrderAndUnknownKeys)
{
    auto object = std::make_shared<const Object>(Object{axisKey("Feed"), 4, Axis{}, {{"colour", "\"red\""}}});
    const Project project = Project().with(axisKey("Feed"), object).withContent(axisKey("Feed"), Axis{});
    EXPECT_EQ(project.find(axisKey("Feed"))->order, 4);
    EXPECT_EQ(project.find(axisKey("Feed"))->unknown, object->unknown);
}

TEST(FieldListTest, givesEveryFieldOfAnAxisItsOwnKey)
{
    Axis axis;
    std::set<std::string> keys;
    visitFields(axis, [&](const char* key, auto&) { EXPECT_TRUE(keys.insert(key).second) << key; });
    EXPECT_EQ(keys.size(), 14u);
}

} // namespace
