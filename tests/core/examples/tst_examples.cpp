#include "core/checks/checkproject.h"
#include "core/language/compile.h"
#include "core/runtime/engine.h"
#include "core/storage/objecttext.h"
#include "core/storage/projectstore.h"

#include <gtest/gtest.h>

using namespace camwright;

namespace {

LoadedProject example(const std::string& name)
{
    PosixFileSystem files;
    auto loaded = openProject(files, CAMWRIGHT_SOURCE_DIR "/examples/" + name);
    EXPECT_TRUE(loaded.ok()) << (loaded.ok() ? "" : englishLine(loaded.error().front()));
    return loaded ? *loaded : LoadedProject{};
}

Bytes imageOf(const std::string& name)
{
    const Validation valid = validate(example(name).project);
    for (const Diagnostic& d : valid.diagnostics)
        ADD_FAILURE() << englishLine(d);
    Job job;
    const CompileResult built = valid.project ? compile(*valid.project, {}, job) : CompileResult{};
    for (const Diagnostic& d : built.diagnostics)
        ADD_FAILURE() << englishLine(d);
    return built.image ? write(*built.image) : Bytes{};
}

/// The example on the virtual controller, in RUN since time 0 of the test.
class Machine {
public:
    explicit Machine(const std::string& name)
    {
        const auto loaded = engine.load(imageOf(name));
        EXPECT_TRUE(loaded.ok()) << (loaded.ok() ? "" : englishLine(loaded.error()));
        EXPECT_TRUE(engine.apply(input::Run{}).ok());
    }
    Value value(const char* name) { return *engine.read(*engine.resolve(name)); }
    bool isOn(const char* name) { return value(name).asBool(); }
    double number(const char* name) { return value(name).asDouble(); }
    void set(const char* name, bool on) { EXPECT_TRUE(engine.apply(input::Write{*engine.resolve(name), Value::ofBool(on)}).ok()); }
    /// Runs until the bit has the value; the time it took, or a failure after `limit`.
    Time runUntil(const char* bit, bool on, Time limit)
    {
        const Time start = engine.now();
        while (isOn(bit) != on && engine.now() - start < limit)
            engine.step(1ms);
        EXPECT_EQ(isOn(bit), on) << bit << " after " << seconds(limit) << " s";
        return engine.now() - start;
    }

    ControllerEngine engine;
};

class ExampleProject : public testing::TestWithParam<const char*> {};

TEST_P(ExampleProject, isWrittenCanonically)
{
    const LoadedProject loaded = example(GetParam());
    EXPECT_EQ(loaded.project.name(), GetParam());
    for (const auto& [path, file] : loaded.files) {
        EXPECT_EQ(toText(*file.object), file.text) << path;
        EXPECT_EQ(fileOf(file.object->key, loaded.project), path);
    }
}

TEST_P(ExampleProject, isCheckedAndBuiltWithoutARemark)
{
    EXPECT_FALSE(imageOf(GetParam()).empty());
}

INSTANTIATE_TEST_SUITE_P(ExamplesTest, ExampleProject, testing::Values("kinco-feeder", "ts600-marquee"));

TEST(FeederTest, readsBackWhatItWroteIntoTheDrives) // KS-MC-11, KS-MC-12, KS-MC-14
{
    Machine machine("kinco-feeder");
    machine.runUntil("PowerStep", true, 2s);
    EXPECT_NEAR(machine.number("%VR300"), 1200.0, 0.01);
    EXPECT_EQ(machine.number("%VW304"), 8);
    EXPECT_EQ(machine.number("%VW308"), 2000);
    EXPECT_TRUE(machine.isOn("%M3.0"));
    EXPECT_NEAR(machine.number("%VR1220"), 900.0, 0.01);
    EXPECT_EQ(machine.number("%VD1224"), 35);
    EXPECT_EQ(machine.number("WriteFeedErrorId"), 0);
}

TEST(FeederTest, eachStepEndsWhereItIsToEnd) // KS-MC-18, KS-MC-19, KS-MC-20
{
    Machine machine("kinco-feeder");
    for (int cycle = 0; cycle < 3; ++cycle) {
        machine.runUntil("StepStep", true, 10s);
        EXPECT_NEAR(machine.number("axis.Feed.position"), 200.0, 0.1) << "cycle " << cycle;
        EXPECT_NEAR(machine.number("axis.Turn.position"), 90.0, 0.1);
        machine.runUntil("PauseStep", true, 5s);
        EXPECT_NEAR(machine.number("axis.Feed.position"), 250.0, 0.1);
        machine.runUntil("BackStep", true, 5s);
        EXPECT_NEAR(machine.number("axis.Turn.position"), 60.0, 2.0) << "1 s at 1800 degrees/min";
        machine.runUntil("BackStep", false, 5s);
        EXPECT_NEAR(machine.number("FeedPosition"), 0.0, 0.1);
        EXPECT_NEAR(machine.number("TurnPosition"), 0.0, 0.1);
        EXPECT_EQ(machine.number("Pieces"), cycle + 1);
        EXPECT_FALSE(machine.isOn("Fault"));
    }
}

TEST(FeederTest, waitsWhenStartIsTakenAway)
{
    Machine machine("kinco-feeder");
    machine.runUntil("OutStep", true, 10s);
    machine.set("Start", false);
    machine.runUntil("Ready", true, 10s);
    machine.engine.step(3s);
    EXPECT_TRUE(machine.isOn("Ready"));
    EXPECT_EQ(machine.number("Pieces"), 1);
}

TEST(FeederTest, runsAgainAfterAStopInTheMiddle) // KS-CPU-05
{
    Machine machine("kinco-feeder");
    machine.runUntil("PauseStep", true, 10s);
    ASSERT_TRUE(machine.engine.apply(input::Stop{}).ok());
    machine.engine.step(2s);
    ASSERT_TRUE(machine.engine.apply(input::Run{}).ok());
    machine.runUntil("HomeStep", true, 5s);
    machine.runUntil("Ready", true, 15s);
    machine.runUntil("StepStep", true, 5s);
    EXPECT_NEAR(machine.number("axis.Feed.position"), 200.0, 0.1);
    EXPECT_FALSE(machine.isOn("Fault"));
}

TEST(FeederTest, aLostDriveEndsInAFaultThatSaysWhich)
{
    Machine machine("kinco-feeder");
    machine.runUntil("OutStep", true, 10s);
    ASSERT_TRUE(machine.engine.apply(input::InjectFault{0, input::InjectedFault::NodeLoss}).ok());
    machine.runUntil("Fault", true, 10s);
    EXPECT_TRUE(machine.isOn("OutFeedError"));
    machine.engine.step(1s);
    EXPECT_FALSE(machine.isOn("OutStep"));
}

TEST(MarqueeTest, theLampsAlternateEveryTwoSeconds) // TS-TMR-01
{
    Machine machine("ts600-marquee");
    machine.engine.step(100ms);
    EXPECT_FALSE(machine.isOn("Y0"));
    machine.set("X0", true);
    machine.runUntil("Y0", true, 100ms);
    for (int round = 0; round < 3; ++round) {
        for (const auto& [lamp, next] : {std::pair{"Y0", "Y1"}, {"Y1", "Y2"}, {"Y2", "Y0"}}) {
            EXPECT_TRUE(machine.isOn(lamp));
            const Time lit = machine.runUntil(next, true, 3s);
            EXPECT_NEAR(seconds(lit), 2.0, 0.005);
            EXPECT_FALSE(machine.isOn(lamp));
        }
    }
    machine.set("X0", false);
    machine.engine.step(100ms);
    EXPECT_FALSE(machine.isOn("Y0") || machine.isOn("Y1") || machine.isOn("Y2"));
}

} // namespace
