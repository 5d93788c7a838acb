#include "tests/core/runtime/kinco/kincobench.h"

#include <gtest/gtest.h>

namespace camwright {
namespace {

class ValueNamesTest : public testing::Test {
protected:
    ValueNamesTest()
    {
        bench.axis(0).name = "Axis 1 name";
        bench.image().symbols = {{"Ready", bitAddress(2, 5, 3), false}, {"Speed", valueAddress(3, 40, DataType::Real), false}};
        EXPECT_TRUE(bench.engine().load(bench.imageBytes()));
        bench.step(500ms);
    }
    Code errorOf(std::string_view name) { return bench.engine().resolve(name).error().code; }

    KincoBench bench;
};

TEST_F(ValueNamesTest, FindsVariablesAndAddresses)
{
    bench.setBit("Ready");
    EXPECT_TRUE(bench.bit("%M5.3"));
    bench.set("%VR40", 2.5);
    EXPECT_EQ(bench.number("Speed"), 2.5);
    EXPECT_EQ(bench.engine().resolve("Speed")->type, DataType::Real);
    EXPECT_EQ(bench.number("VR40"), 2.5) << "a missing % is forgiven";
}

// CONTRACTS 18
TEST_F(ValueNamesTest, FindsAxesByQuotedNamePlainNameAndNumber)
{
    const ValueRef quoted = *bench.engine().resolve("axis.\"Axis 1 name\".position");
    EXPECT_EQ(quoted, *bench.engine().resolve("axis.1.position"));
    EXPECT_EQ(*bench.engine().resolve("axis.Turn.velocity"), *bench.engine().resolve("axis.2.velocity"));
    EXPECT_EQ(bench.engine().resolve("plant.Turn.position")->source, ValueRef::Source::Plant);
}

TEST_F(ValueNamesTest, TellsUnits)
{
    const auto unit = [&](std::string_view name) { return bench.engine().unitOf(*bench.engine().resolve(name)); };
    EXPECT_EQ(unit("axis.1.position"), "mm");
    EXPECT_EQ(unit("axis.1.velocity"), "mm/s");
    EXPECT_EQ(unit("axis.2.followingError"), "°");
    EXPECT_EQ(unit("axis.2.torque"), "%");
    EXPECT_EQ(unit("axis.2.state"), "");
    EXPECT_EQ(unit("%VW0"), "");
}

TEST_F(ValueNamesTest, SaysWhatIsWrongWithAName)
{
    EXPECT_EQ(errorOf("Redy"), Code::NameUnknown);
    EXPECT_EQ(errorOf("axis.Feeed.position"), Code::NoSuchAxis);
    EXPECT_EQ(errorOf("axis.3.position"), Code::NoSuchAxis);
    EXPECT_EQ(errorOf("axis.1.speed"), Code::UnknownAxisField);
    EXPECT_EQ(errorOf("axis."), Code::NameUnknown);
    EXPECT_EQ(errorOf("axis.\"Axis 1 name"), Code::NameUnknown);
    EXPECT_FALSE(bench.engine().resolve("%VW99999"));
    EXPECT_EQ(errorOf(""), Code::NameUnknown);
}

TEST_F(ValueNamesTest, EveryListedNameResolves)
{
    const std::vector<std::string> names = bench.engine().names();
    EXPECT_EQ(names.size(), 2u + 2u * 7u);
    for (const std::string& name : names)
        EXPECT_TRUE(bench.engine().resolve(name)) << name;
}

TEST_F(ValueNamesTest, ATraceSaysWhichChannelItDoesNotKnow)
{
    TraceSetup setup;
    setup.channels = {"axis.1.position", "Nothing"};
    EXPECT_EQ(bench.engine().startTrace(setup).error().code, Code::NameUnknown);
    setup.channels = {"axis.1.position", "Speed"};
    ASSERT_TRUE(bench.engine().startTrace(setup));
    bench.step(10ms);
    const auto block = bench.engine().takeSamples();
    ASSERT_TRUE(block);
    EXPECT_EQ(block->columns.size(), 2u);
    EXPECT_EQ(block->columns[0].size(), 10u);
    EXPECT_EQ(block->channels[0].unit, "mm");
    EXPECT_EQ(block->firstCycle, bench.engine().cycle() - 9);
}

} // namespace
} // namespace camwright
