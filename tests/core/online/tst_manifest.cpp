#include "core/online/manifest.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace camwright;

namespace {

Hash digest(std::uint8_t seed)
{
    Hash out;
    out.bytes.fill(seed);
    return out;
}

Manifest sample()
{
    return {digest(1), "kinco", "KS101M-04DX",
            {{PartKind::Program, "Main", digest(2)}, {PartKind::Program, "Sub", digest(3)}, {PartKind::Axis, "Feed", digest(4)},
             {PartKind::Retained, "Count", digest(5)}}};
}

std::vector<Code> codes(const DownloadPlan& plan)
{
    std::vector<Code> out;
    for (const PlanLine& line : plan.lines)
        out.push_back(line.message.code);
    return out;
}

TEST(DownloadPlanTest, theSameProgramChangesNothing)
{
    const DownloadPlan plan = planDownload(sample(), sample(), {});
    EXPECT_TRUE(plan.sameProgram);
    EXPECT_FALSE(plan.mustStop);
    EXPECT_TRUE(plan.lines.empty());
}

TEST(DownloadPlanTest, namesEachChangedAddedAndRemovedPart)
{
    Manifest next = sample();
    next.program = digest(9);
    next.parts[0].hash = digest(20);
    next.parts[1] = {PartKind::Program, "Other", digest(3)};
    next.parts[2].hash = digest(40);
    next.parts[3].hash = digest(50);
    const DownloadPlan plan = planDownload(sample(), next, {});
    EXPECT_FALSE(plan.sameProgram);
    EXPECT_EQ(codes(plan), (std::vector{Code::PlanProgramChanged, Code::PlanProgramAdded, Code::PlanAxisChanged, Code::PlanRetainedLost,
                                        Code::PlanProgramRemoved}));
    EXPECT_EQ(plan.lines[0].what, "program Main");
    EXPECT_EQ(plan.lines[0].effect, "Program \"Main\" changes.");
}

TEST(DownloadPlanTest, saysWhatStopsAndWhatIsLost)
{
    ControllerStatus status;
    status.state = RunState::Run;
    status.forces = 2;
    status.axes.resize(2);
    status.axes[0].name = "Feed";
    status.axes[0].enabled = status.axes[0].homed = true;
    status.axes[1].name = "Turn";
    const DownloadPlan plan = planDownload(sample(), sample(), status);
    EXPECT_TRUE(plan.mustStop);
    EXPECT_EQ(codes(plan), (std::vector{Code::PlanStops, Code::PlanAxisReleased, Code::PlanHomeLost, Code::PlanForcesDropped}));
}

TEST(DownloadPlanTest, anEmptyControllerGetsEverythingNewWithoutLosses)
{
    const DownloadPlan plan = planDownload({}, sample(), {});
    EXPECT_FALSE(plan.sameProgram);
    EXPECT_EQ(codes(plan), (std::vector{Code::PlanProgramAdded, Code::PlanProgramAdded, Code::PlanAxisAdded}));
}

} // namespace
