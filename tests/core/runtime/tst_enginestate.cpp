#include "tests/core/runtime/kinco/kincobench.h"

#include <gtest/gtest.h>

namespace camwright {
namespace {

/// Two axes at work, a panel, forces and a trace: a state with something everywhere.
class EngineStateTest : public testing::Test {
protected:
    EngineStateTest()
    {
        bench.call("MC_POWER", {"%M0.0", "1", "%M0.1", "%M0.2", "%MB1"});
        bench.call("MC_MABS", {"%M2.0", "1", "%VR0", "%VR4", "0", "1", "%M2.1", "%M2.2", "%MB3", "%M2.3"});
        bench.call("MC_WPARAS", {"%M8.0", "2", "%VB200", "%VD204", "2", "%M8.1", "%M8.2", "%MD10"});
        bench.call("MC_HOME", {"%M14.0", "1", "0.0", "30000", "%M14.1", "%M14.2", "%MB15"});
        bench.call("MC_MREL", {"%M16.0", "1", "%VR10", "%VR14", "%M16.1", "%M16.2", "%MB17", "%M16.3"});
        bench.axis(0).eventTimerMs = 7;
    }

    void post(std::uint64_t at, EngineInputContent content) { bench.engine().post({start + at, std::move(content)}); }
    EngineInputContent write(std::string_view name, double value)
    {
        return input::Write{*bench.engine().resolve(name), Value::ofLreal(value)};
    }
    /// What happens in the ten seconds from `start`.
    void postScript()
    {
        post(10, write("%M0.0", 1));
        post(500, write("%VR0", 120));
        post(500, write("%VR4", 6000));
        post(500, write("%M2.0", 1));
        post(1300, write("%VR0", 20));
        post(2000, input::Force{*bench.engine().resolve("%VW60"), Value::ofInteger(DataType::Word, 3)});
        post(2500, input::Panel{1, AxisCommandKind::Enable, 0, 0, 0});
        post(3000, input::Panel{1, AxisCommandKind::Arm, 0, 0, 0});
        post(3000, input::Panel{1, AxisCommandKind::Jog, 0, 90, 0});
        for (std::uint64_t beat = 3000; beat < 6000; beat += 20)
            post(beat, input::Heartbeat{start + beat - 2});
        post(7000, write("%M8.0", 1));
        post(8000, write("%VR4", 0));
        post(9000, input::InjectFault{0, input::InjectedFault::DriveAlarm});
    }
    void startEverything(KincoBench& b)
    {
        b.start();
        TraceSetup setup;
        setup.channels = {"axis.Feed.position", "axis.2.velocity", "%MB3"};
        setup.trigger = TriggerKind::RisingEdge;
        setup.triggerChannel = "axis.Feed.position";
        setup.triggerLevel = 60;
        setup.samples = 5000;
        ASSERT_TRUE(b.engine().startTrace(setup));
        start = b.engine().cycle();
    }

    KincoBench bench;
    std::uint64_t start = 0;
};

// CONTRACTS 11: run 10 s, save, run 10 s, restore, replay: equal bytes
TEST_F(EngineStateTest, RestoreAndReplayGivesEqualBytes)
{
    startEverything(bench);
    postScript();
    bench.step(10s);
    EXPECT_EQ(bench.state(), 1);
    EXPECT_EQ(bench.logged(Code::DeadManStop).size(), 1u);
    const Bytes saved = bench.engine().saveState();
    start = bench.engine().cycle();
    const auto replay = [this] {
        postScript();
        bench.step(10s);
        return bench.engine().saveState();
    };
    const Bytes expected = replay();
    ASSERT_TRUE(bench.engine().restoreState(saved));
    EXPECT_EQ(bench.engine().saveState(), saved);
    EXPECT_EQ(bench.engine().cycle(), start);
    EXPECT_TRUE(replay() == expected);
}

// At any moment, in the middle of handshakes and transfers, and into another engine
TEST_F(EngineStateTest, AnyMomentCanBeSavedAndRestored)
{
    startEverything(bench);
    postScript();
    std::vector<Bytes> moments;
    for (int i = 0; i < 40; ++i) {
        bench.step(i < 20 ? 33ms : 409ms);
        moments.push_back(bench.engine().saveState());
    }
    ControllerEngine other;
    for (std::size_t i = 0; i + 1 < moments.size(); ++i) {
        ASSERT_TRUE(other.restoreState(moments[i])) << i;
        other.step(i + 1 < 20 ? 33ms : 409ms);
        EXPECT_TRUE(other.saveState() == moments[i + 1]) << i;
    }
}

// CONTRACTS 12
TEST_F(EngineStateTest, TwoRunsGiveIdenticalBytes)
{
    const auto run = [this] {
        KincoBench fresh;
        fresh.image() = bench.image();
        startEverything(fresh);
        fresh.setBit("%M0.0");
        fresh.step(1s);
        fresh.set("%VR0", 80);
        fresh.set("%VR4", 6000);
        fresh.setBit("%M2.0");
        fresh.step(3s);
        return fresh.engine().saveState();
    };
    EXPECT_TRUE(run() == run());
}

TEST_F(EngineStateTest, TheSeedChangesThePlantOnly)
{
    ControllerEngine one({1}), two({2});
    for (ControllerEngine* engine : {&one, &two}) {
        ASSERT_TRUE(engine->load(bench.imageBytes()));
        engine->step(500ms);
    }
    EXPECT_EQ(one.status().program, two.status().program);
    EXPECT_FALSE(one.saveState() == two.saveState());
}

TEST_F(EngineStateTest, DamagedStateIsRefusedAndChangesNothing)
{
    startEverything(bench);
    postScript();
    bench.step(300ms);
    const Bytes saved = bench.engine().saveState();
    for (std::size_t size = 0; size < saved.size(); size += 331)
        EXPECT_FALSE(bench.engine().restoreState({saved.data(), size})) << size;
    EXPECT_TRUE(bench.engine().saveState() == saved);
    Bytes newer = saved;
    newer[4] = 99;
    EXPECT_EQ(bench.engine().restoreState(newer).error().code, Code::StateVersion);
}

TEST_F(EngineStateTest, EveryInputSurvivesItsBytes)
{
    ValueRef ref{ValueRef::Source::Memory, DataType::Word, 3, 2, false, 0, 77, 1, AxisField::Torque};
    const std::vector<EngineInputContent> contents{input::Run{}, input::Stop{}, input::RunSwitch{false},
        input::Write{ref, Value::ofInteger(DataType::Word, 5)}, input::Force{ref, Value::ofReal(1.5f)}, input::Release{ref},
        input::ReleaseAll{}, input::Panel{2, AxisCommandKind::MoveRelative, 1.5, -2.5, 3.5}, input::Heartbeat{123456789012},
        input::StopAllAxes{}, input::LoadImage{{1, 2, 3}}, input::PowerCycle{}, input::InjectFault{1, input::InjectedFault::NodeLoss}};
    ASSERT_EQ(contents.size(), std::variant_size_v<EngineInputContent>);
    for (const EngineInputContent& content : contents) {
        const EngineInput input{42, content};
        ByteWriter writer;
        camwright::write(writer, input);
        ByteReader reader(writer.bytes());
        EXPECT_EQ(readEngineInput(reader), input) << content.index();
        EXPECT_TRUE(reader.ok() && reader.atEnd()) << content.index();
    }
}

} // namespace
} // namespace camwright
