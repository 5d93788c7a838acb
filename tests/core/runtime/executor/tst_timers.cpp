#include "core/runtime/executor/executor.h"
#include "tests/core/runtime/executor/irbuilder.h"

#include <gtest/gtest.h>

using namespace camwright;
using namespace camwright::test;

namespace {

/// One timer with a base of 10 ms: input V0.0, preset VW2, value VW4, bit V6.0, result V7.0; reset V0.1.
class TimerBench {
public:
    explicit TimerBench(TimerKind kind) : m_executor(make(kind)) {}

    /// Runs a scan `after` the one before, with the input.
    void scan(camwright::Time after, bool input)
    {
        m_now += after;
        m_executor->memory().write(bitAddress(A, 0, 0), Value::ofBool(input));
        ScanInput in;
        in.now = m_now;
        m_executor->scan(in);
        EXPECT_EQ(output(), m_executor->memory().read(bitAddress(A, 7, 0)).asBool()) << "result and bit agree";
    }
    void reset()
    {
        m_executor->memory().write(bitAddress(A, 0, 1), Value::ofBool(true));
    }
    void preset(int value) { m_executor->memory().write(valueAddress(A, 2, Int), Value::ofInteger(Int, value)); }
    void setValue(int value) { m_executor->memory().write(valueAddress(A, 4, Int), Value::ofInteger(Int, value)); }
    int value() const { return static_cast<int>(m_executor->memory().read(valueAddress(A, 4, Int)).asInteger()); }
    bool output() const { return m_executor->memory().read(bitAddress(A, 6, 0)).asBool(); }
    ScanExecutor& executor() { return *m_executor; }

private:
    static std::unique_ptr<ScanExecutor> make(TimerKind kind)
    {
        IrBuilder b;
        b.image().program.stateBytes = TimerStateBytes;
        b.image().program.timers = {{kind, byteAt(4), bitAt(6, 0), 0, 10'000'000}};
        const IrRegister out = b.indexed(IrOp::Timer, Int, 0, b.bit(bitAt(0, 0)), b.load(Int, byteAt(2)));
        b.store(Bool, bitAt(7, 0), out);
        const std::size_t skip = b.control(IrOp::JumpIfNot, 0, b.bit(bitAt(0, 1)));
        b.control(IrOp::TimerReset, 0, b.constant(Bool, 1));
        b.store(Bool, bitAt(7, 0), b.constant(Bool, 0));
        b.store(Bool, bitAt(0, 1), b.constant(Bool, 0));
        b.land(skip);
        Result<ScanExecutor> executor = ScanExecutor::load(b.share());
        EXPECT_TRUE(executor.ok());
        return std::make_unique<ScanExecutor>(std::move(executor).value());
    }

    camwright::Time m_now{};
    std::unique_ptr<ScanExecutor> m_executor;
};

TEST(TimerTest, tonIsOnWhenThePresetHasPassedAndFallsWithTheInput)
{
    TimerBench t(TimerKind::Ton);
    t.preset(3);
    t.scan(1ms, true);
    EXPECT_EQ(t.value(), 0);
    t.scan(29ms, true);
    EXPECT_EQ(t.value(), 2);
    EXPECT_FALSE(t.output());
    t.scan(1ms, true);
    EXPECT_EQ(t.value(), 3);
    EXPECT_TRUE(t.output());
    t.scan(1ms, false);
    EXPECT_EQ(t.value(), 0);
    EXPECT_FALSE(t.output());
    t.scan(5ms, true);
    t.scan(29ms, true);
    EXPECT_FALSE(t.output()) << "fractions of the first run are forgotten";
}

TEST(TimerTest, tonValueStopsAt32767)
{
    for (const TimerKind kind : {TimerKind::Ton, TimerKind::T600Ton, TimerKind::T600Tonr}) {
        TimerBench t(kind);
        t.preset(10);
        t.scan(1ms, true);
        t.scan(1ms, true);
        t.scan(camwright::Time(400'000'000'000), true);
        EXPECT_EQ(t.value(), 32767);
        t.scan(1s, true);
        EXPECT_EQ(t.value(), 32767);
        EXPECT_TRUE(t.output());
    }
}

TEST(TimerTest, tonCountsScansShorterThanItsBase)
{
    TimerBench t(TimerKind::Ton);
    t.preset(5);
    t.scan(0ms, true);
    for (int i = 0; i < 49; ++i)
        t.scan(1ms, true);
    EXPECT_FALSE(t.output());
    t.scan(1ms, true);
    EXPECT_TRUE(t.output());
}

TEST(TimerTest, tofHoldsForThePresetAfterTheInputFell)
{
    TimerBench t(TimerKind::Tof);
    t.preset(2);
    t.scan(1ms, false);
    EXPECT_FALSE(t.output()) << "never on before";
    t.scan(1ms, true);
    EXPECT_TRUE(t.output());
    t.scan(100ms, false);
    t.scan(19ms, false);
    EXPECT_TRUE(t.output());
    t.scan(1ms, false);
    EXPECT_FALSE(t.output());
    EXPECT_EQ(t.value(), 2);
    t.scan(1s, false);
    EXPECT_EQ(t.value(), 2) << "stays at the preset";
}

TEST(TimerTest, tpIsOnForThePresetWhateverTheInputDoes)
{
    TimerBench t(TimerKind::Tp);
    t.preset(3);
    t.scan(1ms, true);
    EXPECT_TRUE(t.output());
    t.scan(10ms, false);
    t.scan(10ms, true);
    EXPECT_TRUE(t.output());
    t.scan(10ms, true);
    EXPECT_FALSE(t.output());
    EXPECT_EQ(t.value(), 3);
    t.scan(10ms, true);
    EXPECT_FALSE(t.output()) << "a held input starts no second pulse";
    t.scan(10ms, false);
    EXPECT_EQ(t.value(), 0);
    t.scan(10ms, true);
    EXPECT_TRUE(t.output());
}

TEST(TimerTest, aPresetOfZeroActsAtOnce)
{
    TimerBench on(TimerKind::Ton);
    on.scan(1ms, true);
    EXPECT_TRUE(on.output());
    TimerBench off(TimerKind::Tof);
    off.scan(1ms, true);
    off.scan(1ms, false);
    EXPECT_FALSE(off.output());
    TimerBench pulse(TimerKind::Tp);
    pulse.scan(1ms, true);
    EXPECT_FALSE(pulse.output());
}

// TS-TMR-01
TEST(TimerTest, ts600TonIsResetByItsFirstExecutionAndByFlowOff)
{
    TimerBench t(TimerKind::T600Ton);
    t.preset(2);
    t.setValue(500);
    t.scan(1ms, true);
    EXPECT_EQ(t.value(), 0);
    EXPECT_FALSE(t.output());
    t.scan(20ms, true);
    EXPECT_TRUE(t.output());
    t.scan(10ms, true);
    EXPECT_EQ(t.value(), 3) << "goes on beyond S";
    t.scan(10ms, false);
    EXPECT_EQ(t.value(), 0);
    EXPECT_FALSE(t.output());
}

// TS-TMR-02
TEST(TimerTest, ts600TonrKeepsValueAndOutputWhileFlowIsOff)
{
    TimerBench t(TimerKind::T600Tonr);
    t.preset(4);
    t.scan(1ms, true);
    t.scan(25ms, true);
    EXPECT_EQ(t.value(), 2);
    t.scan(1s, false);
    t.scan(1s, false);
    EXPECT_EQ(t.value(), 2);
    t.scan(1s, true);
    EXPECT_EQ(t.value(), 2) << "the pause does not count";
    t.scan(15ms, true);
    EXPECT_EQ(t.value(), 4) << "with the 5 ms from before the pause";
    EXPECT_TRUE(t.output());
    t.scan(1ms, false);
    EXPECT_TRUE(t.output());
    t.reset();
    t.scan(1ms, false);
    EXPECT_EQ(t.value(), 0);
    EXPECT_FALSE(t.output());
}

// TS-TMR-03
TEST(TimerTest, ts600TofStartsOnlyWithAFallingEdge)
{
    TimerBench t(TimerKind::T600Tof);
    t.preset(3);
    t.scan(1ms, false);
    t.scan(1s, false);
    EXPECT_EQ(t.value(), 0) << "never started";
    EXPECT_FALSE(t.output());
    t.scan(1ms, true);
    EXPECT_TRUE(t.output());
    EXPECT_EQ(t.value(), 0);
    t.scan(1ms, false);
    t.scan(20ms, false);
    EXPECT_TRUE(t.output());
    t.scan(10ms, false);
    EXPECT_FALSE(t.output());
    EXPECT_EQ(t.value(), 3);
    t.scan(1s, false);
    EXPECT_EQ(t.value(), 3) << "stays at S";
    t.scan(1ms, true);
    EXPECT_EQ(t.value(), 0);
}

// TS-TMR-04
TEST(TimerTest, ts600TmonTimesOncePerEdgeFromItsValue)
{
    TimerBench t(TimerKind::T600Tmon);
    t.preset(3);
    t.scan(1ms, true);
    EXPECT_TRUE(t.output());
    t.scan(10ms, false);
    t.scan(10ms, true);
    EXPECT_TRUE(t.output()) << "not retriggered";
    EXPECT_EQ(t.value(), 2);
    t.scan(10ms, true);
    EXPECT_FALSE(t.output());
    EXPECT_EQ(t.value(), 0);
    t.scan(1s, true);
    EXPECT_FALSE(t.output());
    t.scan(1ms, false);
    t.setValue(2);
    t.scan(1ms, true);
    EXPECT_TRUE(t.output());
    t.scan(10ms, true);
    EXPECT_FALSE(t.output()) << "began at 2 of 3";
}

TEST(TimerTest, hostileHiddenStateDoesNoHarm)
{
    for (const TimerKind kind : {TimerKind::Ton, TimerKind::Tof, TimerKind::Tp, TimerKind::T600Tonr, TimerKind::T600Tmon}) {
        TimerBench t(kind);
        t.preset(3);
        std::uint8_t* state = t.executor().memory().data() + t.executor().memory().stateOffset();
        for (const std::uint8_t fill : {0xFF, 0x7F, 0x80}) {
            std::fill_n(state, TimerStateBytes, fill);
            t.setValue(-32768);
            t.scan(1ms, true);
            t.scan(10ms, true);
            t.scan(10ms, false);
        }
    }
}

/// One counter: count input V0.0, reset or load V0.1, down or direction V0.2, preset VD4, value VD8, bit V12.0.
class CounterBench {
public:
    CounterBench(CounterKind kind, DataType type) : m_type(type), m_executor(make(kind, type)) {}

    void scan(bool count, bool reset = false, bool down = false)
    {
        const std::uint64_t bits = (count ? 1u : 0u) | (reset ? 2u : 0u) | (down ? 4u : 0u);
        m_executor->memory().write(valueAddress(A, 0, Byte), {Byte, bits});
        m_executor->scan({});
    }
    void pulse(bool reset = false, bool down = false)
    {
        scan(true, reset, down);
        scan(false, reset, false);
    }
    void preset(std::int64_t value) { m_executor->memory().write(valueAddress(A, 4, m_type), Value::ofInteger(m_type, value)); }
    void setValue(std::int64_t value) { m_executor->memory().write(valueAddress(A, 8, m_type), Value::ofInteger(m_type, value)); }
    std::int64_t value() const { return m_executor->memory().read(valueAddress(A, 8, m_type)).asInteger(); }
    bool output() const { return m_executor->memory().read(bitAddress(A, 12, 0)).asBool(); }

private:
    static std::unique_ptr<ScanExecutor> make(CounterKind kind, DataType type)
    {
        IrBuilder b;
        b.image().program.stateBytes = CounterStateBytes;
        b.image().program.counters = {{kind, type, byteAt(8), bitAt(12, 0), 0}};
        b.control(IrOp::CounterArm, 0, b.bit(bitAt(0, 1)), b.bit(bitAt(0, 2)));
        b.indexed(IrOp::Counter, type, 0, b.bit(bitAt(0, 0)), b.load(type, byteAt(4)));
        Result<ScanExecutor> executor = ScanExecutor::load(b.share());
        EXPECT_TRUE(executor.ok());
        return std::make_unique<ScanExecutor>(std::move(executor).value());
    }

    DataType m_type;
    std::unique_ptr<ScanExecutor> m_executor;
};

TEST(CounterTest, upCountsEdgesAndStopsAtTheEnd)
{
    CounterBench c(CounterKind::Up, Int);
    c.preset(2);
    c.scan(true);
    c.scan(true);
    EXPECT_EQ(c.value(), 1);
    EXPECT_FALSE(c.output());
    c.scan(false);
    c.scan(true);
    EXPECT_TRUE(c.output());
    c.setValue(32767);
    c.pulse();
    EXPECT_EQ(c.value(), 32767);
    c.pulse(true);
    EXPECT_EQ(c.value(), 0);
    EXPECT_FALSE(c.output());
}

TEST(CounterTest, downLoadsItsPresetAndEndsAtZero)
{
    CounterBench c(CounterKind::Down, Int);
    c.preset(2);
    c.scan(false, true);
    EXPECT_EQ(c.value(), 2);
    EXPECT_FALSE(c.output());
    c.pulse();
    c.pulse();
    EXPECT_EQ(c.value(), 0);
    EXPECT_TRUE(c.output());
    c.pulse();
    EXPECT_EQ(c.value(), 0);
}

TEST(CounterTest, upDownTakesBothEdgesAsNone)
{
    CounterBench c(CounterKind::UpDown, Int);
    c.preset(1);
    c.pulse();
    EXPECT_EQ(c.value(), 1);
    EXPECT_TRUE(c.output());
    c.scan(true, false, true);
    EXPECT_EQ(c.value(), 1);
    c.scan(false);
    c.scan(false, false, true);
    c.scan(false);
    c.scan(false, false, true);
    EXPECT_EQ(c.value(), -1);
    EXPECT_FALSE(c.output());
}

// TS-MEM-04
TEST(CounterTest, ts600CountsIn32BitsAndByDirection)
{
    CounterBench c(CounterKind::T600UpDown, Dint);
    c.preset(40001);
    c.setValue(40000);
    c.pulse();
    EXPECT_EQ(c.value(), 40001);
    EXPECT_TRUE(c.output());
    c.pulse(false, true);
    EXPECT_EQ(c.value(), 40000);
    EXPECT_FALSE(c.output());
    c.pulse(false, true);
    EXPECT_EQ(c.value(), 39999);
}

} // namespace
