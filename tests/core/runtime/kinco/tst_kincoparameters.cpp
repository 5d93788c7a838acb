#include "tests/core/runtime/kinco/kincobench.h"

#include <gtest/gtest.h>

namespace camwright {
namespace {

/// 16#FFFFFFFF in a cell that reads as DINT.
constexpr double kNothing = -1;

class KincoParametersTest : public testing::Test {
protected:
    KincoParametersTest()
    {
        bench.call("MC_RPARAS", {"%M0.0", "%MW2", "%VB100", "%MW4", "%M0.1", "%M0.2", "%MD8", "%VD1200"}, "%M0.7");
        bench.call("MC_WPARAS", {"%M1.0", "%MW12", "%VB200", "%VD2000", "%MW14", "%M1.1", "%M1.2", "%MD18"}, "%M1.7");
        bench.call("MC_RESTART", {"%M3.0", "%MW22", "%MW24", "%M3.1", "%M3.2", "%MB26"});
        bench.call("MC_RESTART", {"%M3.3", "%MW22", "%MW24", "%M3.4", "%M3.5", "%MB27"});
        bench.call("MC_STATE", {"1", "%M30.0", "%M30.1", "%M30.2", "%M30.3", "%M30.4", "%M30.5", "%MW32", "%M30.6", "%MW34", "%VR40",
                                   "%VR44", "%MB36"});
    }
    void started()
    {
        bench.start();
        bench.setBit("%M0.7");
        bench.setBit("%M1.7");
        bench.set("%MW2", 1);
        bench.set("%MW12", 1);
    }
    void list(int base, std::initializer_list<int> numbers)
    {
        for (const int number : numbers)
            bench.set("%VB" + std::to_string(base++), number);
    }
    void write(std::initializer_list<int> numbers)
    {
        list(200, numbers);
        bench.set("%MW14", static_cast<double>(numbers.size()));
        bench.setBit("%M1.0");
        bench.step(2ms);
        ASSERT_TRUE(bench.stepUntil([&] { return bench.bit("%M1.1"); }, 5s));
        bench.setBit("%M1.0", false);
        bench.step(2ms);
    }
    void read(std::initializer_list<int> numbers)
    {
        list(100, numbers);
        bench.set("%MW4", static_cast<double>(numbers.size()));
        bench.setBit("%M0.0");
        bench.step(2ms);
        ASSERT_TRUE(bench.stepUntil([&] { return bench.bit("%M0.1"); }, 5s));
    }

    KincoBench bench;
};

// KS-MC-12, KS-MC-11, KS-MC-14: the values of Appendix A, EX2 and EX1
TEST_F(KincoParametersTest, WhatIsWrittenIsReadBackInProcessUnits)
{
    started();
    bench.set("%VR2000", 1200);
    bench.set("%VD2004", 8);
    bench.set("%VD2008", 2000);
    write({0, 3, 8});
    EXPECT_FALSE(bench.bit("%M1.2"));
    EXPECT_EQ(bench.number("%MD18"), 0);
    read({0, 3, 8});
    EXPECT_FALSE(bench.bit("%M0.2"));
    EXPECT_NEAR(bench.number("%VR1200"), 1200, 0.01);
    EXPECT_EQ(bench.number("%VD1204"), 8);
    EXPECT_EQ(bench.number("%VD1208"), 2000);
}

// KS-MC-13, KS-MC-11: a failed one leaves its cell and sets its bit, the rest goes on
TEST_F(KincoParametersTest, AFailedParameterSetsItsBitAndTheRestGoesOn)
{
    started();
    bench.set("%VD1204", 4711);
    read({3, 99, 8});
    EXPECT_TRUE(bench.bit("%M0.2"));
    EXPECT_EQ(bench.number("%MD8"), 2);
    EXPECT_EQ(bench.number("%VD1204"), 4711);
    EXPECT_NE(bench.number("%VD1208"), 0);
}

// KS-MC-15: 43 and 44 take one value only; ranges hold
TEST_F(KincoParametersTest, ValuesOutsideTheDrivesRangeFail)
{
    started();
    bench.set("%VD2000", 1);          // "save" is the only value
    bench.set("%VD2004", 40000);      // 0 … 32767
    bench.set("%VD2008", 100);
    write({43, 8, 8});
    EXPECT_EQ(bench.number("%MD18"), 3);
    bench.set("%VD2000", 0x65766173);
    write({43});
    EXPECT_EQ(bench.number("%MD18"), 0);
}

// KS-MC-13
TEST_F(KincoParametersTest, AWrongAxisOrCountExecutesNothing)
{
    started();
    bench.set("%MW12", 5);
    write({8});
    EXPECT_TRUE(bench.bit("%M1.2"));
    EXPECT_EQ(bench.number("%MD18"), kNothing);
    bench.set("%MW12", 1);
    for (const int count : {0, 33, -1}) {
        bench.set("%MW14", count);
        bench.setBit("%M1.0");
        bench.step(5ms);
        EXPECT_EQ(bench.number("%MD18"), kNothing) << count;
        bench.setBit("%M1.0", false);
        bench.step(5ms);
    }
}

// KS-MC-13, KS-MC-02: another instruction runs on the axis
TEST_F(KincoParametersTest, ASecondCallOnTheAxisExecutesNothing)
{
    started();
    list(200, {8, 8, 8, 8, 8, 8, 8, 8});
    bench.set("%MW14", 8);
    list(100, {3});
    bench.set("%MW4", 1);
    bench.setBit("%M1.0");
    bench.step(2ms);
    bench.setBit("%M0.0");
    bench.step(4ms);
    EXPECT_EQ(bench.number("%MD8"), kNothing);
}

// KS-MC-11: EXEC to 0 aborts a read, DONE = 1 and what was read stays
TEST_F(KincoParametersTest, AReadIsAbortedByExec)
{
    started();
    for (int i = 0; i < 32; ++i)
        bench.set("%VB" + std::to_string(100 + i), 8);
    bench.set("%MW4", 32);
    bench.setBit("%M0.0");
    bench.step(12ms);
    EXPECT_FALSE(bench.bit("%M0.1"));
    bench.setBit("%M0.0", false);
    bench.step(5ms);
    EXPECT_TRUE(bench.bit("%M0.1"));
    EXPECT_FALSE(bench.bit("%M0.2"));
    EXPECT_NE(bench.number("%VD1200"), 0);
    EXPECT_EQ(bench.number("%VD1324"), 0);
}

// KS-MC-12: a write is aborted by EN, not by EXEC
TEST_F(KincoParametersTest, AWriteIsAbortedByEnableOnly)
{
    started();
    for (int i = 0; i < 32; ++i) {
        bench.set("%VB" + std::to_string(200 + i), 8);
        bench.set("%VD" + std::to_string(2000 + 4 * i), 100 + i);
    }
    bench.set("%MW14", 32);
    bench.setBit("%M1.0");
    bench.step(5ms);
    bench.setBit("%M1.0", false);
    bench.step(5ms);
    EXPECT_FALSE(bench.bit("%M1.1"));
    bench.setBit("%M1.7", false);
    bench.step(5ms);
    EXPECT_TRUE(bench.bit("%M1.1"));
    EXPECT_FALSE(bench.bit("%M1.2"));
    bench.step(1s);
    read({8});
    EXPECT_LT(bench.number("%VD1200"), 131);
}

// KS-MC-21
TEST_F(KincoParametersTest, RestartBringsALostNodeBack)
{
    started();
    bench.set("%MW22", 1);
    bench.set("%MW24", 100);
    ASSERT_TRUE(bench.engine().apply(input::InjectFault{0, input::InjectedFault::NodeLoss}));
    ASSERT_TRUE(bench.stepUntil([&] { return bench.number("%MB36") == 1; }, 10s));
    ASSERT_TRUE(bench.engine().apply(input::InjectFault{0, input::InjectedFault::None}));
    bench.setBit("%M3.0");
    bench.step(2ms);
    EXPECT_FALSE(bench.bit("%M3.1"));
    ASSERT_TRUE(bench.stepUntil([&] { return bench.bit("%M3.1"); }, 5s));
    EXPECT_EQ(bench.number("%MB26"), 0);
    EXPECT_EQ(bench.number("%MB36"), 0);
}

// KS-MC-21: own error numbers
TEST_F(KincoParametersTest, RestartTellsItsOwnErrors)
{
    started();
    bench.set("%MW24", 50);
    bench.set("%MW22", 7);
    bench.setBit("%M3.0");
    bench.step(5ms);
    EXPECT_EQ(bench.number("%MB26"), 1);
    bench.setBit("%M3.0", false);
    bench.set("%MW22", 1);
    bench.step(5ms);
    bench.setBit("%M3.0");
    bench.step(3ms);
    bench.setBit("%M3.3");
    bench.step(3ms);
    EXPECT_EQ(bench.number("%MB27"), 2) << "already being restarted";
    bench.setBit("%M3.0", false);
    bench.step(3ms);
    EXPECT_EQ(bench.number("%MB26"), 6) << "stopped by EXEC";
    ASSERT_TRUE(bench.engine().apply(input::InjectFault{0, input::InjectedFault::NodeLoss}));
    bench.step(100ms);
    bench.setBit("%M3.0");
    bench.step(2ms);
    ASSERT_TRUE(bench.stepUntil([&] { return bench.bit("%M3.1"); }, 5s));
    EXPECT_EQ(bench.number("%MB26"), 4) << "no answer";
}

} // namespace
} // namespace camwright
