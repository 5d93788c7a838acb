#include "core/checks/checkproject.h"
#include "core/language/compile.h"
#include "core/runtime/engine.h"

#include <gtest/gtest.h>

namespace camwright {
namespace {

/// Programs in text, compiled and run by the engine as a project's are.
class InterruptTest : public testing::Test {
protected:
    void use(const char* family, const char* model)
    {
        ControllerSettings settings;
        settings.family = family;
        settings.model = model;
        put(controllerKey(), settings);
        put(projectKey(), ProjectSettings{"bench", {}});
    }
    void put(const ObjectKey& key, ObjectContent content)
    {
        m_project = m_project.with(key, std::make_shared<const Object>(Object{key, ++m_order, std::move(content), {}}));
    }
    void program(const std::string& name, ProgramRole role, const std::string& text)
    {
        put({ObjectKind::Program, name}, Program{role, ProgramLanguage::InstructionList, text});
    }
    void run()
    {
        const Validation valid = validate(m_project);
        ASSERT_TRUE(valid.project);
        Job job;
        const CompileResult compiled = compile(*valid.project, {}, job);
        for (const Diagnostic& d : compiled.diagnostics)
            EXPECT_NE(d.severity(), Severity::Error) << englishLine(d);
        ASSERT_TRUE(compiled.image);
        image = write(*compiled.image);
        ASSERT_TRUE(engine.load(image));
        engine.step(2s); // the bus looks for its nodes
        ASSERT_TRUE(engine.apply(input::Run{}));
        engine.step(1ms);
    }
    double number(ControllerEngine& of, std::string_view name) const { return of.read(*of.resolve(name))->asDouble(); }
    double number(std::string_view name) { return number(engine, name); }
    void set(std::string_view name, bool on) { ASSERT_TRUE(engine.apply(input::Write{*engine.resolve(name), Value::ofBool(on)})); }

    ControllerEngine engine;
    Bytes image;

private:
    Project m_project;
    std::int64_t m_order = 0;
};

/// KS-IL-12, KS-CPU (2 timed interrupts, base 0.1 ms): events 3 and 4 by SMW22 and SMW24.
TEST_F(InterruptTest, aKincoTimedInterruptComesWithItsPeriod)
{
    use("kinco", "KS101M-04DX");
    program("Main", ProgramRole::Main, "(* Network 0 *)\nLD %SM0.1\nMOVE W#100, %SMW22\nMOVE W#5, %SMW24\nATCH Slow, 3\nATCH Fast, 4\n");
    program("Slow", ProgramRole::Interrupt, "(* Network 0 *)\nLD %SM0.0\nINC %VW0\n");
    program("Fast", ProgramRole::Interrupt, "(* Network 0 *)\nLD %SM0.0\nINC %VW2\n");
    run();
    engine.step(100ms);
    EXPECT_EQ(number("%VW0"), 10) << "every 10 ms";
    EXPECT_EQ(number("%VW2"), 200) << "every 0.5 ms: twice a cycle";
    ASSERT_TRUE(engine.apply(input::Stop{}));
    engine.step(100ms);
    EXPECT_EQ(number("%VW0"), 10) << "not in STOP";
}

/// KS-CPU-21: rising and falling edges of I0.0 … I0.3.
TEST_F(InterruptTest, aKincoEdgeStartsItsRoutineOnce)
{
    use("kinco", "KS101M-04DX");
    program("Main", ProgramRole::Main, "(* Network 0 *)\nLD %SM0.1\nATCH Up, 25\nATCH Down, 20\n(* Network 1 *)\nLD %M0.0\nDTCH 25\n");
    program("Up", ProgramRole::Interrupt, "(* Network 0 *)\nLD %SM0.0\nINC %VW0\n");
    program("Down", ProgramRole::Interrupt, "(* Network 0 *)\nLD %SM0.0\nINC %VW2\n");
    run();
    set("%I0.0", true);
    set("%I0.3", true);
    engine.step(5ms);
    EXPECT_EQ(number("%VW0"), 1);
    EXPECT_EQ(number("%VW2"), 0);
    set("%I0.0", false);
    set("%I0.3", false);
    engine.step(5ms);
    EXPECT_EQ(number("%VW0"), 1);
    EXPECT_EQ(number("%VW2"), 1);
    set("%M0.0", true);
    engine.step(2ms);
    set("%I0.0", true);
    engine.step(5ms);
    EXPECT_EQ(number("%VW0"), 1) << "detached";
}

TEST_F(InterruptTest, aDisabledKincoInterruptWaitsOnce)
{
    use("kinco", "KS101M-04DX");
    program("Main", ProgramRole::Main, "(* Network 0 *)\nLD %SM0.1\nATCH Up, 25\nDISI\n(* Network 1 *)\nLD %M0.0\nENI\n");
    program("Up", ProgramRole::Interrupt, "(* Network 0 *)\nLD %SM0.0\nINC %VW0\n");
    run();
    for (const bool on : {true, false, true, false, true}) {
        set("%I0.0", on);
        engine.step(3ms);
    }
    EXPECT_EQ(number("%VW0"), 0);
    set("%M0.0", true);
    engine.step(3ms);
    EXPECT_EQ(number("%VW0"), 1);
}

/// TS-INT-01 … 04.
TEST_F(InterruptTest, aTs600RoutineRunsAtItsEventAfterEi)
{
    use("invt", "TS635");
    program("Main", ProgramRole::Main, "LD M0\nEI\nLD M1\nDI\n");
    program("Beat", ProgramRole::Interrupt, "EVENT 20 ms\nLD SM0\nINC D0\n");
    program("Rise", ProgramRole::Interrupt, "EVENT X1 RISING\nLD SM0\nINC D1\n");
    program("Fall", ProgramRole::Interrupt, "(* the other edge *)\nEVENT X1 FALLING // ours\n\nLD SM0\nINC D2\n");
    run();
    engine.step(50ms);
    EXPECT_EQ(number("D0"), 0) << "disabled at the start";
    set("M0", true);
    engine.step(2ms);
    set("M0", false);
    EXPECT_EQ(number("D0"), 1) << "one was waiting";
    engine.step(100ms);
    EXPECT_EQ(number("D0"), 6);
    set("X1", true);
    engine.step(1ms);
    EXPECT_EQ(number("D1"), 1) << "at once";
    engine.step(10ms);
    set("X1", false);
    engine.step(10ms);
    EXPECT_EQ(number("D1"), 1);
    EXPECT_EQ(number("D2"), 1);
    set("M1", true);
    engine.step(2ms);
    const double last = number("D0");
    engine.step(100ms);
    EXPECT_EQ(number("D0"), last);
}

TEST_F(InterruptTest, anEndlessRoutineEndsInTheWatchdog)
{
    use("invt", "TS635");
    program("Main", ProgramRole::Main, "LD SM0\nEI\n");
    program("Beat", ProgramRole::Interrupt, "EVENT 5 ms\nLBL 1\nLD SM0\nINC D0\nCJ 1\n");
    run();
    engine.step(20ms);
    EXPECT_EQ(engine.status().state, RunState::Error);
}

/// CONTRACTS 11.
TEST_F(InterruptTest, aRestoredControllerGoesOnWithTheSameBytes)
{
    use("kinco", "KS101M-04DX");
    program("Main", ProgramRole::Main, "(* Network 0 *)\nLD %SM0.1\nMOVE W#33, %SMW22\nATCH Beat, 3\nRTC_W 2026, 11, 22, 10, 30, 0, %V10.0\n"
            "(* Network 1 *)\nLD %SM0.0\nREAD_RTC %VB20\n");
    program("Beat", ProgramRole::Interrupt, "(* Network 0 *)\nLD %SM0.0\nINC %VW0\n");
    run();
    engine.step(1234ms);
    const Bytes saved = engine.saveState();
    ControllerEngine other;
    ASSERT_TRUE(other.restoreState(saved));
    engine.step(3s);
    other.step(3s);
    EXPECT_EQ(engine.saveState(), other.saveState());
    EXPECT_EQ(number("%VW0"), number(other, "%VW0"));
    EXPECT_EQ(number("%VB25"), 4) << "seconds, BCD";
}

} // namespace
} // namespace camwright
