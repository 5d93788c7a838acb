#include "tests/core/runtime/kinco/kincobench.h"

#include <gtest/gtest.h>

namespace camwright {
namespace {

/// The bench's program powers axis 1 from %M0.0, moves it from %M2.0, jogs axis 2 from %M6.0, and copies nothing else.
class EngineTest : public testing::Test {
protected:
    EngineTest()
    {
        bench.call("MC_POWER", {"%M0.0", "1", "%M0.1", "%M0.2", "%MB1"});
        bench.call("MC_MABS", {"%M2.0", "1", "%VR0", "%VR4", "0", "%VW8", "%M2.1", "%M2.2", "%MB3", "%M2.3"});
        bench.call("MC_POWER", {"%M4.0", "2", "%M4.1", "%M4.2", "%MB5"});
        bench.call("MC_JOG", {"%M6.0", "2", "%VR20", "0", "%M6.1", "%M6.2", "%MB7", "%M6.3"});
    }
    ControllerEngine& engine() { return bench.engine(); }
    RunState state() { return engine().status().state; }
    ValueRef ref(std::string_view name) { return *engine().resolve(name); }
    void loaded() { ASSERT_TRUE(engine().load(bench.imageBytes())); }
    void quiet() { ASSERT_TRUE(bench.stepUntil([&] { return engine().isQuiet(); }, 10s)); }

    KincoBench bench;
};

TEST_F(EngineTest, StandsInStopAfterALoadUntilStarted)
{
    EXPECT_EQ(engine().apply(input::Run{}).error().code, Code::NoProgram);
    loaded();
    bench.step(2s);
    EXPECT_EQ(state(), RunState::Stop);
    ASSERT_TRUE(engine().apply(input::Run{}));
    EXPECT_EQ(state(), RunState::Run);
    EXPECT_EQ(engine().status().projectName, "bench");
    EXPECT_EQ(engine().status().model, "KS101M-04DX");
}

// KS-MEM-09
TEST_F(EngineTest, FirstScanBitIsOnForOneScan)
{
    loaded();
    bench.step(2s);
    ASSERT_TRUE(engine().apply(input::Run{}));
    bench.step(1ms);
    EXPECT_TRUE(bench.bit("%SM0.0"));
    EXPECT_TRUE(bench.bit("%SM0.1"));
    bench.step(1ms);
    EXPECT_TRUE(bench.bit("%SM0.0"));
    EXPECT_FALSE(bench.bit("%SM0.1"));
}

// KS-CPU-06: RUN only if switch and last command say so
TEST_F(EngineTest, SwitchAndCommandTogetherDecide)
{
    loaded();
    bench.step(2s);
    ASSERT_TRUE(engine().apply(input::RunSwitch{false}));
    EXPECT_EQ(engine().apply(input::Run{}).error().code, Code::SwitchAtStop);
    EXPECT_EQ(state(), RunState::Stop);
    ASSERT_TRUE(engine().apply(input::RunSwitch{true}));
    EXPECT_EQ(state(), RunState::Run);
    ASSERT_TRUE(engine().apply(input::RunSwitch{false}));
    EXPECT_EQ(state(), RunState::Stop);
    ASSERT_TRUE(engine().apply(input::Stop{}));
    ASSERT_TRUE(engine().apply(input::RunSwitch{true}));
    EXPECT_EQ(state(), RunState::Stop);
}

// KS-CPU-05
TEST_F(EngineTest, OutputsTakeTheirStopValues)
{
    bench.start();
    bench.set("%QB0", 255);
    bench.set("%AQW2", 1234);
    bench.step(3ms);
    EXPECT_EQ(bench.number("%QB0"), 255);
    ASSERT_TRUE(engine().apply(input::Stop{}));
    EXPECT_EQ(bench.number("%QB0"), 0);
    EXPECT_EQ(bench.number("%AQW2"), 0);
}

// CONTRACTS 23: writing an input sets its terminal
TEST_F(EngineTest, AWrittenInputIsATerminalThatStays)
{
    bench.start();
    bench.setBit("%I0.2");
    bench.step(10ms);
    EXPECT_TRUE(bench.bit("%I0.2"));
    EXPECT_FALSE(bench.bit("%I0.1"));
    ASSERT_TRUE(engine().apply(input::Stop{}));
    ASSERT_TRUE(engine().apply(input::PowerCycle{}));
    EXPECT_TRUE(bench.bit("%I0.2"));
    bench.setBit("%I0.2", false);
    EXPECT_FALSE(bench.bit("%I0.2"));
}

TEST_F(EngineTest, ListsTheTerminalsOfItsModel)
{
    loaded();
    const std::vector<Terminal> terminals = engine().terminals();
    ASSERT_EQ(terminals.size(), 4u);
    EXPECT_EQ(terminals[3].name, "%I0.3");
    EXPECT_TRUE(terminals[3].isInput);
    EXPECT_TRUE(engine().apply(input::Write{terminals[3].ref, Value::ofBool(true)}));
    EXPECT_TRUE(bench.bit("%I0.3"));
}

TEST_F(EngineTest, AForcedValueHoldsAgainstProgramAndWrites)
{
    bench.start();
    ASSERT_TRUE(engine().apply(input::Force{ref("%M0.1"), Value::ofBool(true)}));
    ASSERT_TRUE(engine().apply(input::Force{ref("%I0.1"), Value::ofBool(true)}));
    bench.step(5ms);
    EXPECT_TRUE(bench.bit("%M0.1"));
    EXPECT_TRUE(bench.bit("%I0.1"));
    bench.setBit("%M0.1", false);
    bench.step(5ms);
    EXPECT_TRUE(bench.bit("%M0.1"));
    EXPECT_EQ(engine().status().forces, 2u);
    EXPECT_EQ(engine().forced(), (std::vector<std::string>{"%I0.1", "%M0.1"}));
    EXPECT_TRUE(engine().isForced(ref("%M0.1")));
    ASSERT_TRUE(engine().apply(input::Release{ref("%I0.1")}));
    bench.step(5ms);
    EXPECT_FALSE(bench.bit("%I0.1"));
    ASSERT_TRUE(engine().apply(input::ReleaseAll{}));
    EXPECT_EQ(engine().status().forces, 0u);
}

TEST_F(EngineTest, AnImageIsTakenOnlyInStop)
{
    bench.start();
    EXPECT_EQ(engine().load(bench.imageBytes()).error().code, Code::LoadOnlyInStop);
    ASSERT_TRUE(engine().apply(input::Stop{}));
    EXPECT_TRUE(engine().load(bench.imageBytes()));
    EXPECT_EQ(engine().imageNumber(), 2u);
}

// CONTRACTS 20: the switch comes after every axis has stopped and been released
TEST_F(EngineTest, ASwitchWaitsForTheAxes)
{
    bench.start();
    bench.setBit("%M4.0");
    bench.step(500ms);
    bench.set("%VR20", 60000);
    bench.setBit("%M6.0");
    bench.step(1s);
    ASSERT_TRUE(engine().apply(input::Stop{}));
    ASSERT_TRUE(engine().load(bench.imageBytes()));
    EXPECT_TRUE(engine().switchPending());
    EXPECT_EQ(engine().imageNumber(), 1u);
    ASSERT_TRUE(bench.stepUntil([&] { return !engine().switchPending(); }, 10s));
    EXPECT_EQ(engine().imageNumber(), 2u);
    EXPECT_EQ(state(), RunState::Stop);
}

TEST_F(EngineTest, ARunThatComesWhileTheSwitchWaitsStartsTheNewProgram)
{
    bench.start();
    bench.setBit("%M4.0");
    bench.step(500ms);
    bench.set("%VR20", 60000);
    bench.setBit("%M6.0");
    bench.step(1s);
    ASSERT_TRUE(engine().apply(input::Stop{}));
    ASSERT_TRUE(engine().load(bench.imageBytes()));
    ASSERT_TRUE(engine().apply(input::Run{}));
    EXPECT_EQ(state(), RunState::Stop);
    EXPECT_EQ(engine().load(bench.imageBytes()).error().code, Code::LoadOnlyInStop);
    ASSERT_TRUE(bench.stepUntil([&] { return state() == RunState::Run; }, 10s));
    EXPECT_EQ(engine().imageNumber(), 2u);
}

TEST_F(EngineTest, ADamagedImageLeavesTheOldOne)
{
    loaded();
    Bytes damaged = bench.imageBytes();
    damaged[damaged.size() / 2] ^= 0x40;
    EXPECT_FALSE(engine().load(damaged));
    EXPECT_FALSE(engine().load({}));
    EXPECT_EQ(engine().imageNumber(), 1u);
    EXPECT_TRUE(engine().resolve("%M0.0"));
}

TEST_F(EngineTest, AReferenceIsGoodForOneImage)
{
    loaded();
    const ValueRef old = ref("%VW0");
    loaded();
    EXPECT_EQ(engine().read(old).error().code, Code::StaleReference);
    EXPECT_EQ(engine().apply(input::Write{old, Value::ofInteger(DataType::Word, 1)}).error().code, Code::StaleReference);
}

TEST_F(EngineTest, AxisValuesCannotBeWritten)
{
    loaded();
    EXPECT_EQ(engine().apply(input::Write{ref("axis.Feed.position"), Value::ofLreal(1)}).error().code, Code::NotWritable);
    EXPECT_EQ(engine().apply(input::Force{ref("axis.Feed.position"), Value::ofLreal(1)}).error().code, Code::NotWritable);
}

// CONTRACTS 10: the watchdog counts operations
TEST_F(EngineTest, TheWatchdogStopsALoopAndReleasesTheAxes)
{
    IrRoutine& main = bench.image().program.routines.front();
    IrInstruction load;
    load.op = IrOp::Load;
    load.type = DataType::Bool;
    load.dest = main.registers++;
    load.address = {2, 0, 300}; // %M300.0
    IrInstruction loop;
    loop.op = IrOp::JumpIf;
    loop.a = load.dest;
    loop.index = static_cast<std::uint32_t>(main.code.size());
    main.code.push_back(load);
    main.code.push_back(loop);
    bench.start();
    bench.setBit("%M0.0");
    bench.setBit("%QB0");
    ASSERT_TRUE(bench.stepUntil([&] { return bench.state() == 2; }, 1s));
    bench.setBit("%M300.0");
    bench.step(2ms);
    EXPECT_EQ(state(), RunState::Error);
    EXPECT_EQ(bench.number("%QB0"), 0);
    EXPECT_EQ(bench.logged(Code::WatchdogFired).size(), 1u);
    quiet();
    EXPECT_EQ(bench.state(), 0);
    bench.setBit("%M300.0", false);
    ASSERT_TRUE(engine().apply(input::Run{}));
    EXPECT_EQ(state(), RunState::Run);
}

// CONTRACTS 13
TEST_F(EngineTest, RetainedDataSurvivePowerLossAndDownload)
{
    bench.start();
    bench.set("%VD100", 4711);
    bench.set("%MD100", 815);
    ASSERT_TRUE(engine().apply(input::PowerCycle{}));
    EXPECT_EQ(bench.number("%VD100"), 4711);
    EXPECT_EQ(bench.number("%MD100"), 0);
    EXPECT_EQ(state(), RunState::Stop) << "the bus starts first";
    ASSERT_TRUE(bench.stepUntil([&] { return state() == RunState::Run; }, 3s)) << "the last command was RUN";
    ASSERT_TRUE(engine().apply(input::Stop{}));
    quiet();
    loaded();
    EXPECT_EQ(bench.number("%VD100"), 4711);
}

TEST_F(EngineTest, RetainedDataPassFromOneRunToTheNext)
{
    bench.start();
    bench.set("%VD100", 4711);
    const Bytes kept = engine().retained();
    KincoBench other;
    ASSERT_TRUE(other.engine().load(other.imageBytes()));
    ASSERT_TRUE(other.engine().restoreRetained(kept));
    EXPECT_EQ(other.number("%VD100"), 4711);
    for (std::size_t size = 0; size < kept.size(); size += 97)
        EXPECT_EQ(other.engine().restoreRetained({kept.data(), size}).error().code, Code::RetainedDamaged);
}

TEST_F(EngineTest, RetainedVariablesAreKeyedByNameAndType)
{
    const auto retain = [](KincoBench& b, const char* name, std::uint32_t byte, DataType type) {
        b.image().layout.areas.push_back({VariablesArea, "", 64, 0, 0});
        b.image().symbols = {{name, valueAddress(VariablesArea, byte, type), true}};
    };
    retain(bench, "Count", 0, DataType::Int);
    loaded();
    bench.set("Count", 12);
    KincoBench moved;
    retain(moved, "Count", 8, DataType::Int);
    ASSERT_TRUE(engine().load(moved.imageBytes()));
    EXPECT_EQ(bench.number("Count"), 12);
    KincoBench retyped;
    retain(retyped, "Count", 8, DataType::Real);
    ASSERT_TRUE(engine().load(retyped.imageBytes()));
    EXPECT_EQ(bench.number("Count"), 0);
}

TEST_F(EngineTest, InputsTakeEffectBeforeTheirCycle)
{
    bench.start();
    const std::uint64_t cycle = engine().cycle();
    EXPECT_EQ(engine().post({cycle + 5, input::Write{ref("%VW50"), Value::ofInteger(DataType::Word, 7)}}), cycle + 5);
    EXPECT_EQ(engine().post({0, input::Write{ref("%VW52"), Value::ofInteger(DataType::Word, 8)}}), cycle + 1);
    bench.step(4ms);
    EXPECT_EQ(bench.number("%VW50"), 0);
    EXPECT_EQ(bench.number("%VW52"), 8);
    bench.step(1ms);
    EXPECT_EQ(bench.number("%VW50"), 7);
}

TEST_F(EngineTest, APostedInputThatIsRefusedGoesToTheLog)
{
    bench.start();
    engine().post({0, input::LoadImage{bench.imageBytes()}});
    bench.step(1ms);
    EXPECT_EQ(bench.logged(Code::LoadOnlyInStop).size(), 1u);
}

TEST_F(EngineTest, StepsOfAnyLengthGiveTheSameCycles)
{
    bench.start();
    const std::uint64_t cycle = engine().cycle();
    for (int i = 0; i < 30; ++i)
        bench.step(100us);
    EXPECT_EQ(engine().cycle(), cycle + 3);
    bench.step(10ms);
    EXPECT_EQ(engine().cycle(), cycle + 13);
}

TEST_F(EngineTest, LateCyclesAreCountedAndLoggedNowAndThen)
{
    loaded();
    engine().countLateCycles(0);
    EXPECT_TRUE(bench.logged(Code::LateCycles).empty());
    engine().countLateCycles(3);
    bench.step(1s);
    engine().countLateCycles(4);
    EXPECT_EQ(engine().status().lateCycles, 7u);
    EXPECT_EQ(bench.logged(Code::LateCycles).size(), 1u);
    bench.step(10s);
    engine().countLateCycles(1);
    EXPECT_EQ(bench.logged(Code::LateCycles).back().message.arguments[0], "5");
}

TEST_F(EngineTest, AConstantPeriodCountsFromBeginningToBeginning)
{
    bench.image().configuration.scanPeriod = 10ms;
    bench.start();
    int firstScans = 0;
    ASSERT_TRUE(engine().apply(input::Stop{}));
    quiet();
    ASSERT_TRUE(engine().apply(input::Run{}));
    for (int i = 0; i < 30; ++i) {
        bench.step(1ms);
        firstScans += bench.bit("%SM0.1");
    }
    EXPECT_EQ(firstScans, 10);
}

} // namespace
} // namespace camwright
