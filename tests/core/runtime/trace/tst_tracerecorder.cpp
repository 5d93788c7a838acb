#include "core/runtime/trace/tracerecorder.h"

#include <gtest/gtest.h>

#include <functional>

namespace camwright {
namespace {

TraceSetup setupOf(TriggerKind trigger, std::uint32_t samples, double preTrigger = 0.5, std::uint32_t stride = 1)
{
    TraceSetup setup;
    setup.channels = {"axis.Feed.position"};
    setup.trigger = trigger;
    setup.triggerChannel = "axis.Feed.position";
    setup.triggerLevel = 10;
    setup.preTrigger = preTrigger;
    setup.samples = samples;
    setup.stride = stride;
    return setup;
}

class TraceRecorderTest : public testing::Test {
protected:
    void start(const TraceSetup& setup, std::uint64_t cycle = 0) { recorder.start(setup, {{"axis.Feed.position", DataType::Lreal, "mm"}}, cycle); }

    /// Cycles first … last with value(cycle) in trigger and channel.
    void run(std::uint64_t first, std::uint64_t last, const std::function<double(std::uint64_t)>& value)
    {
        for (std::uint64_t cycle = first; cycle <= last; ++cycle) {
            const double number = value(cycle);
            if (recorder.needsTrigger())
                recorder.lookAtTrigger(cycle, number);
            if (recorder.wantsRow(cycle))
                recorder.record(cycle, {&number, 1});
        }
    }

    TraceRecorder recorder;
};

double ramp(std::uint64_t cycle)
{
    return static_cast<double>(cycle);
}

TEST_F(TraceRecorderTest, RecordsEveryCycleAtOnceWithoutTrigger)
{
    start(setupOf(TriggerKind::Immediate, 0));
    run(1, 5, ramp);
    const auto block = recorder.take();
    ASSERT_TRUE(block);
    EXPECT_EQ(block->firstCycle, 1u);
    EXPECT_EQ(block->columns[0], (std::vector<double>{1, 2, 3, 4, 5}));
    EXPECT_EQ(block->channels.size(), 1u);
    EXPECT_FALSE(block->last);
    EXPECT_FALSE(recorder.take());
}

TEST_F(TraceRecorderTest, RowsStandAStrideApart)
{
    start(setupOf(TriggerKind::Immediate, 3, 0, 10), 100);
    run(101, 200, ramp);
    const auto block = recorder.take();
    ASSERT_TRUE(block);
    EXPECT_EQ(block->firstCycle, 110u);
    EXPECT_EQ(block->stride, 10u);
    EXPECT_EQ(block->columns[0], (std::vector<double>{110, 120, 130}));
    EXPECT_TRUE(block->last);
}

TEST_F(TraceRecorderTest, KeepsWhatWasBeforeARisingEdge)
{
    start(setupOf(TriggerKind::RisingEdge, 8, 0.5));
    run(1, 50, ramp);
    const auto block = recorder.take();
    ASSERT_TRUE(block);
    EXPECT_EQ(block->triggerCycle, 10);
    EXPECT_EQ(block->firstCycle, 6u);
    EXPECT_EQ(block->columns[0], (std::vector<double>{6, 7, 8, 9, 10, 11, 12, 13}));
    EXPECT_TRUE(block->last);
    EXPECT_FALSE(recorder.isRunning());
}

TEST_F(TraceRecorderTest, ARisingEdgeNeedsAValueBelowFirst)
{
    start(setupOf(TriggerKind::RisingEdge, 4));
    run(1, 20, [](std::uint64_t) { return 50.0; });
    EXPECT_FALSE(recorder.take());
}

TEST_F(TraceRecorderTest, ALevelFiresInTheFirstCycleThatFulfilsIt)
{
    start(setupOf(TriggerKind::Above, 4, 0.25));
    run(1, 20, [](std::uint64_t) { return 50.0; });
    const auto block = recorder.take();
    ASSERT_TRUE(block);
    EXPECT_EQ(block->triggerCycle, 1);
}

TEST_F(TraceRecorderTest, FallingEdgeAndBelowLookDownwards)
{
    const auto fall = [](std::uint64_t cycle) { return 20.0 - static_cast<double>(cycle); };
    start(setupOf(TriggerKind::FallingEdge, 4, 0));
    run(1, 30, fall);
    EXPECT_EQ(recorder.take()->triggerCycle, 10);
    start(setupOf(TriggerKind::Below, 4, 0));
    run(1, 30, fall);
    EXPECT_EQ(recorder.take()->triggerCycle, 11);
}

TEST_F(TraceRecorderTest, RowsNobodyTookAreCountedAsLost)
{
    start(setupOf(TriggerKind::Immediate, 0));
    run(1, TraceRecorder::kRingRows + 7, ramp);
    const auto block = recorder.take();
    ASSERT_TRUE(block);
    EXPECT_EQ(block->lostRows, 7u);
    EXPECT_EQ(block->firstCycle, 8u);
    EXPECT_EQ(block->columns[0].front(), 8.0);
    EXPECT_EQ(recorder.take()->firstCycle, 8u + TraceRecorder::kBlockRows);
}

TEST_F(TraceRecorderTest, BlocksAreNumberedAndANewStartIsANewSet)
{
    start(setupOf(TriggerKind::Immediate, 0));
    run(1, 1, ramp);
    const auto first = recorder.take();
    run(2, 2, ramp);
    const auto second = recorder.take();
    EXPECT_EQ(second->sequence, first->sequence + 1);
    EXPECT_TRUE(second->channels.empty());
    start(setupOf(TriggerKind::Immediate, 0));
    run(1, 1, ramp);
    EXPECT_EQ(recorder.take()->channelSet, first->channelSet + 1);
}

TEST_F(TraceRecorderTest, StoppingSaysSoInTheLastBlock)
{
    start(setupOf(TriggerKind::Immediate, 0));
    run(1, 3, ramp);
    recorder.stop();
    run(4, 6, ramp);
    const auto block = recorder.take();
    ASSERT_TRUE(block);
    EXPECT_EQ(block->columns[0].size(), 3u);
    EXPECT_TRUE(block->last);
    EXPECT_FALSE(recorder.take());
}

TEST_F(TraceRecorderTest, GoesOnFromSavedState)
{
    start(setupOf(TriggerKind::RisingEdge, 8, 0.5));
    run(1, 8, ramp);
    ByteWriter writer;
    recorder.save(writer);
    const auto finish = [this] {
        run(9, 40, ramp);
        return recorder.take();
    };
    const auto expected = finish();
    ByteReader reader(writer.bytes());
    recorder.restore(reader);
    ASSERT_TRUE(reader.ok());
    EXPECT_EQ(finish(), expected);
}

TEST(TraceSetupTest, RefusesWhatCannotBeRecorded)
{
    EXPECT_EQ(TraceRecorder::check({}).error().code, Code::TraceWithoutChannels);
    TraceSetup setup = setupOf(TriggerKind::Immediate, 10, 1.2);
    EXPECT_EQ(TraceRecorder::check(setup).error().code, Code::TraceBadSetting);
    setup.preTrigger = 0;
    setup.stride = 0;
    EXPECT_EQ(TraceRecorder::check(setup).error().arguments[0], "stride");
    setup.stride = 1;
    EXPECT_TRUE(TraceRecorder::check(setup));
}

} // namespace
} // namespace camwright
