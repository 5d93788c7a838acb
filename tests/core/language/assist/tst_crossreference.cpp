#include "core/language/assist/crossreference.h"
#include "tests/core/language/assist/assistproject.h"

#include <gtest/gtest.h>

using namespace camwright;
using namespace camwright::test;

namespace {

const char* word(UseKind kind)
{
    switch (kind) {
    case UseKind::Declares: return "declares";
    case UseKind::Reads: return "reads";
    case UseKind::Writes: return "writes";
    case UseKind::ReadsAndWrites: return "reads+writes";
    case UseKind::Calls: return "calls";
    case UseKind::Commands: return "commands";
    case UseKind::Watches: return "watches";
    }
    return "";
}

std::string show(const std::vector<Reference>& references)
{
    std::string out;
    for (const Reference& reference : references) {
        const Place& place = reference.use.place;
        out += std::string(word(reference.use.kind)) + (reference.overlaps ? "~ " : " ") + place.object.name;
        out += place.range.isValid() ? ":" + std::to_string(place.range.line) + ":" + std::to_string(place.range.column) : " " + place.field;
        out += " " + reference.use.text + "\n";
    }
    return out;
}

std::string named(const Project& project, const std::string& name)
{
    const auto context = contextOf(project);
    const auto target = targetNamed(*context, name);
    return target ? show(referencesTo(*target, crossReference(project))) : "no target";
}

/// References of what stands at '|' in the main program.
std::string under(const std::string& family, std::string marked, const std::vector<NamedProgram>& others = {})
{
    const std::size_t offset = marked.find('|');
    marked.erase(offset, 1);
    const Project project = assistProject(family, marked, {}, others);
    const auto target = targetAt(*contextOf(project), "Main", marked, offset);
    return target ? show(referencesTo(*target, crossReference(project))) : "no target";
}

TEST(CrossReferenceTest, tellsReadsFromWrites)
{
    const Project project = assistProject("kinco", "(* Network 0 *)\nLD Start\nST %M0.1\n(* Network 1 *)\nLD %M0.1\nINC %VW2\nMOVE %VW2, %VW4\n", {row("Start", DataType::Bool, "%M0.0")});
    EXPECT_EQ(named(project, "Start"), "declares Globals rows[0] Start\nreads Main:2:4 Start\n");
    EXPECT_EQ(named(project, "%M0.1"), "writes Main:3:4 %M0.1\nreads Main:5:4 %M0.1\n");
    EXPECT_EQ(named(project, "%VW2"), "reads+writes Main:6:5 %VW2\nreads Main:7:6 %VW2\n");
}

TEST(CrossReferenceTest, nameAndAddressAreOneThing)
{
    EXPECT_EQ(named(assistProject("kinco", "LD %M0.0\nST Start\n", {row("Start", DataType::Bool, "%M0.0")}), "%M0.0"),
        "declares Globals rows[0] Start\nreads Main:1:4 %M0.0\nwrites Main:2:4 Start\n");
}

TEST(CrossReferenceTest, overlapsAreMarked)
{
    const Project project = assistProject("kinco", "LD %V2.3\nMOVE %VD0, %VD8\nMOVE %VW4, %VW2\n", {row("Far", DataType::Int, "%VW6")});
    EXPECT_EQ(named(project, "%VW2"), "reads~ Main:1:4 %V2.3\nreads~ Main:2:6 %VD0\nwrites Main:3:12 %VW2\n");
    EXPECT_EQ(named(project, "%VD0"), "reads~ Main:1:4 %V2.3\nreads Main:2:6 %VD0\nwrites~ Main:3:12 %VW2\n");
    EXPECT_EQ(named(project, "%VB5"), "reads~ Main:3:6 %VW4\n");
}

TEST(CrossReferenceTest, listsCoverAsMuchAsTheirCount)
{
    const Project project = assistProject("kinco", "LD %M0.0\nMC_RPARAS %M0.1, 1, %VB100, 3, %M0.2, %M0.3, %MD8, %VD1200\n");
    EXPECT_EQ(named(project, "%VB102"), "reads~ Main:2:21 %VB100\n");
    EXPECT_EQ(named(project, "%VB103"), "");
    EXPECT_EQ(named(project, "%VR1208"), "writes~ Main:2:52 %VD1200\n");
    EXPECT_EQ(named(project, "%VR1212"), "");
}

TEST(CrossReferenceTest, wordsTakenAsDoubleWordsCoverTwo)
{
    const Project project = assistProject("invt", "LD X0\nDMOV D10 D20\nMOV D11 D30\n");
    EXPECT_EQ(named(project, "D11"), "reads~ Main:2:6 D10\nreads Main:3:5 D11\n");
    EXPECT_EQ(named(project, "D12"), "");
}

TEST(CrossReferenceTest, bitAndValueOfATimerAreOnePlace)
{
    EXPECT_EQ(under("kinco", "LD %M0.0\nTON |T5, 10\nMOVE T5, %VW0\nLD T5\nLD T6\n"), "reads+writes Main:2:5 T5\nreads Main:3:6 T5\nreads Main:4:4 T5\n");
}

TEST(CrossReferenceTest, findsAxesByNumberAndInWatchTables)
{
    const Project project = assistProject("kinco", "LD %M0.0\nMC_POWER %M0.0, 1, %M0.1, %M0.2, %MW4\nMC_POWER %M0.0, 2, %M0.1, %M0.2, %MW4\n")
                                .withContent({ObjectKind::WatchTable, "Watch"}, WatchTable{{{"axis.Feed.position", "", {}}, {"axis.2.state", "", {}}, {"plant.\"Feed\".torque", "", {}}}});
    EXPECT_EQ(named(project, "Feed"), "declares Feed  Feed\ncommands Main:2:17 1\nwatches Watch rows[0] axis.Feed.position\nwatches Watch rows[2] plant.\"Feed\".torque\n");
    EXPECT_EQ(named(project, "axis.2.position"), "declares Turn  Turn\ncommands Main:3:17 2\nwatches Watch rows[1] axis.2.state\n");
}

TEST(CrossReferenceTest, findsCalls)
{
    EXPECT_EQ(under("kinco", "LD %M0.0\nCAL |Init\n", {{"Init", "LD %M0.0\nRET\n"}}), "declares Init:1:1 Init\ncalls Main:2:5 Init\n");
}

TEST(CrossReferenceTest, localMemoryBelongsToItsProgram)
{
    EXPECT_EQ(under("kinco", "LD %|L0.0\nST %M0.0\n", {{"Init", "LD %L0.0\nST %M0.1\n"}}), "reads Main:1:4 %L0.0\n");
}

TEST(CrossReferenceTest, readsWhatItCanOfAProgramWithErrors)
{
    const Project project = assistProject("kinco", "LD %M0.0\nMOVE %VW2\nFROB %VW2\nST %M0.1\nMOVE %VW2, ???\n");
    EXPECT_EQ(named(project, "%VW2"), "reads Main:2:6 %VW2\nreads Main:5:6 %VW2\n");
}

TEST(CrossReferenceTest, variablesWithoutAddressAreFound)
{
    const Project project = assistProject("invt", "LD Lamp\nOUT Y0\nOUT Lamp\n", {row("Other", DataType::Bool, ""), row("Lamp", DataType::Bool, "")});
    EXPECT_EQ(named(project, "Lamp"), "declares Globals rows[1] Lamp\nreads Main:1:4 Lamp\nwrites Main:3:5 Lamp\n");
    EXPECT_EQ(nameOf(*contextOf(project), *targetNamed(*contextOf(project), "Lamp")), "Lamp");
}

TEST(CrossReferenceTest, nothingStandsAtInstructionsCommentsAndConstants)
{
    EXPECT_EQ(under("kinco", "M|OVE %VW0, %VW2\n"), "no target");
    EXPECT_EQ(under("kinco", "(* %VW|0 *)\nLD %M0.0\n"), "no target");
    EXPECT_EQ(under("kinco", "MOVE 1|2, %VW2\n"), "no target");
    EXPECT_EQ(under("kinco", "MOVE 12, %VW2\n|\n"), "no target");
}

TEST(CrossReferenceTest, targetsAreNamedWithTheirAddress)
{
    const Project project = assistProject("kinco", "", {row("Start", DataType::Bool, "%M0.0")});
    const auto context = contextOf(project);
    EXPECT_EQ(nameOf(*context, *targetNamed(*context, "Start")), "Start (%M0.0)");
    EXPECT_EQ(nameOf(*context, *targetNamed(*context, "%VW2")), "%VW2");
    EXPECT_EQ(nameOf(*context, AxisTarget{2}), "Turn (2)");
}

TEST(CrossReferenceTest, linesAndNetworksTellWhereAUseIs)
{
    const auto uses = crossReference(assistProject("kinco", "(* Network 0 *)\n(* Network 1 *)\r\n   LD   %M0.0 (* go *)\r\n"));
    const auto use = std::find_if(uses.begin(), uses.end(), [](const SymbolUse& u) { return u.kind == UseKind::Reads; });
    ASSERT_NE(use, uses.end());
    EXPECT_EQ(use->line, "LD   %M0.0 (* go *)");
    EXPECT_EQ(use->network, 1u);
    EXPECT_EQ(use->instruction, "LD");
}

} // namespace
