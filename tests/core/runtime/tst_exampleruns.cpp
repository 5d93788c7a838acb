#include "core/checks/checkproject.h"
#include "core/language/compile.h"
#include "core/runtime/engine.h"
#include "core/storage/projectstore.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <string>

namespace camwright {
namespace {

Bytes imageOf(const std::string& example)
{
    PosixFileSystem files;
    const auto loaded = openProject(files, CAMWRIGHT_SOURCE_DIR "/examples/" + example);
    if (!loaded)
        return {};
    const Validation valid = validate(loaded->project);
    Job job;
    const CompileResult compiled = compile(*valid.project, {}, job);
    for (const Diagnostic& diagnostic : compiled.diagnostics)
        ADD_FAILURE() << englishLine(diagnostic);
    return compiled.image ? write(*compiled.image) : Bytes{};
}

class ExampleRunsTest : public testing::Test {
protected:
    void load(const std::string& example)
    {
        const Result<void> loaded = engine.load(imageOf(example));
        ASSERT_TRUE(loaded) << englishText(loaded.error());
        ASSERT_TRUE(engine.apply(input::Run{}));
    }
    double number(std::string_view name) const { return engine.read(*engine.resolve(name))->asDouble(); }
    bool bit(std::string_view name) const { return number(name) != 0; }
    bool stepUntil(std::string_view name, Time limit)
    {
        for (Time t{0}; t < limit && !bit(name); t += 1ms)
            engine.step(1ms);
        return bit(name);
    }

    ControllerEngine engine;
};

TEST_F(ExampleRunsTest, TheFeederGoesThroughItsCycle)
{
    load("kinco-feeder");
    ASSERT_TRUE(stepUntil("PowerStep", 3s));
    EXPECT_NEAR(number("%VR1200"), 1200, 0.1) << "what MC_WPARAS wrote MC_RPARAS reads";
    EXPECT_EQ(number("%VD1204"), 8);
    ASSERT_TRUE(stepUntil("Ready", 20s));
    EXPECT_TRUE(bit("FeedHomed") && bit("TurnHomed"));
    ASSERT_TRUE(stepUntil("StepStep", 10s));
    EXPECT_NEAR(number("axis.Feed.position"), 200, 0.5);
    EXPECT_NEAR(number("axis.Turn.position"), 90, 0.5);
    ASSERT_TRUE(stepUntil("PauseStep", 10s));
    EXPECT_NEAR(number("axis.Feed.position"), 250, 0.5);
    ASSERT_TRUE(stepUntil("JogStep", 2s));
    engine.step(900ms);
    EXPECT_NEAR(number("axis.Turn.velocity"), -30, 1);
    ASSERT_TRUE(stepUntil("Pieces", 20s));
    EXPECT_NEAR(number("axis.Feed.position"), 0, 0.5);
    EXPECT_FALSE(bit("Fault"));
}

TEST_F(ExampleRunsTest, TheFeederRunsForAMinuteWithoutAFault)
{
    load("kinco-feeder");
    engine.step(60s);
    EXPECT_FALSE(bit("Fault"));
    EXPECT_GE(number("Pieces"), 3);
    for (const LogEntry& entry : engine.logSince(0))
        EXPECT_EQ(entry.message.severity(), Severity::Information) << englishText(entry.message);
}

TEST_F(ExampleRunsTest, TheFeederGivesTheSameBytesTwice)
{
    load("kinco-feeder");
    engine.step(8s);
    ControllerEngine again;
    ASSERT_TRUE(again.load(engine.imageBytes()));
    ASSERT_TRUE(again.apply(input::Run{}));
    again.step(8s);
    EXPECT_TRUE(engine.saveState() == again.saveState());
}

// The lamp program of the TS600 manual: each lamp 2 s
TEST_F(ExampleRunsTest, TheMarqueeAlternatesEveryTwoSeconds)
{
    load("ts600-marquee");
    engine.step(1s);
    EXPECT_FALSE(bit("Y0") || bit("Y1") || bit("Y2"));
    ASSERT_TRUE(engine.apply(input::Write{*engine.resolve("X0"), Value::ofBool(true)}));
    std::string lamps;
    for (int i = 0; i < 13; ++i) {
        engine.step(500ms);
        engine.step(500ms);
        lamps += bit("Y0") ? '0' : bit("Y1") ? '1' : bit("Y2") ? '2' : '-';
        EXPECT_EQ(bit("Y0") + bit("Y1") + bit("Y2"), 1) << i;
    }
    EXPECT_EQ(lamps.substr(0, 1), "0");
    EXPECT_EQ(lamps.substr(2, 1), "1");
    EXPECT_EQ(lamps.substr(4, 1), "2");
    EXPECT_EQ(lamps.substr(6, 1), "0");
    ASSERT_TRUE(engine.apply(input::Write{*engine.resolve("X0"), Value::ofBool(false)}));
    engine.step(10ms);
    EXPECT_FALSE(bit("Y0") || bit("Y1") || bit("Y2"));
}

// TS-MEM-09
TEST_F(ExampleRunsTest, TheTs600KeepsItsSystemFlags)
{
    load("ts600-marquee");
    engine.step(1ms);
    EXPECT_TRUE(bit("SM0") && bit("SM1"));
    engine.step(1ms);
    EXPECT_TRUE(bit("SM0"));
    EXPECT_FALSE(bit("SM1"));
    int changes = 0;
    bool clock = bit("SM12");
    for (int i = 0; i < 4000; ++i) {
        engine.step(1ms);
        changes += bit("SM12") != clock;
        clock = bit("SM12");
    }
    EXPECT_EQ(changes, 8) << "a 1 s clock";
    ASSERT_TRUE(engine.apply(input::Stop{}));
    EXPECT_FALSE(bit("SM0"));
}

TEST(ExecutorsInTheEngineTest, theExamplesRunAlikeInInterpreterAndMachineCode)
{
    for (const char* const example : {"kinco-feeder", "ts600-marquee"}) {
        ControllerEngine interpreted(EngineOptions{7, ExecutorChoice::Interpreter});
        ControllerEngine native(EngineOptions{7, ExecutorChoice::Native});
        for (ControllerEngine* engine : {&interpreted, &native}) {
            ASSERT_TRUE(engine->load(imageOf(example)));
            ASSERT_TRUE(engine->apply(input::Run{}));
        }
        for (int second = 1; second <= 12; ++second) {
            interpreted.step(1s);
            native.step(1s);
            ASSERT_TRUE(interpreted.saveState() == native.saveState()) << example << ", second " << second;
        }
    }
}

} // namespace
} // namespace camwright
