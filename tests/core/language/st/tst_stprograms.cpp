#include "tests/core/language/st/stbench.h"

#include <fstream>
#include <sstream>

using namespace camwright;
using namespace camwright::test;

namespace {

std::string fileText(const std::string& name)
{
    std::ifstream file(std::string(CAMWRIGHT_SOURCE_DIR) + "/tests/data/language/st/" + name, std::ios::binary);
    std::stringstream out;
    out << file.rdbuf();
    return out.str();
}

// The numbers are those of the same program in C, compiled by gcc.
TEST(StProgramTest, aGeneratedProgramHasTheChecksumsOfItsTwinInC)
{
    StBench bench(fileText("generated.st"));
    ASSERT_TRUE(bench.runs()) << bench.messages();
    bench.scan();
    EXPECT_EQ(bench.integer("checksum"), 3678);
    bench.scan(99);
    EXPECT_EQ(bench.integer("checksum"), 8845);
    bench.scan(900);
    EXPECT_EQ(bench.integer("checksum"), 4442);
}

TEST(StProgramTest, thePublishedScanTimeTestsGiveTheirResults)
{
    std::string multiply = fileText("plc_bench.st");
    StBench first(multiply);
    ASSERT_TRUE(first.runs()) << first.messages();
    EXPECT_EQ(first.scan().end, ScanEnd::Completed);
    EXPECT_EQ(first.integer("checksum"), 24) << "3.25 * 7.5 = 24.375";
    multiply.replace(multiply.find("which : DINT := 0"), 17, "which : DINT := 1");
    StBench second(multiply);
    ASSERT_TRUE(second.runs()) << second.messages();
    EXPECT_EQ(second.scan().end, ScanEnd::Completed);
    EXPECT_EQ(second.integer("checksum"), 999);
}

TEST(StProgramTest, arithmeticFollowsPrecedenceAndWidens)
{
    const StBench bench = runOnce("a : DINT; b : REAL; c : LREAL; i : INT := 7; s : SINT := -3; w : WORD; q : BOOL;",
                                  "a := 2 + 3 * 4 - 10 / 3 MOD 2;\nb := i * 0.5;\nc := b + i;\nw := 16#F0F0 AND NOT WORD#16#00F0;\nq := i > s AND (a = 13 OR FALSE) XOR FALSE;");
    EXPECT_EQ(bench.integer("a"), 2 + 3 * 4 - 10 / 3 % 2);
    EXPECT_EQ(bench.real("b"), 3.5);
    EXPECT_EQ(bench.real("c"), 10.5);
    EXPECT_EQ(bench.value("w").bits, 0xF000u);
    EXPECT_TRUE(bench.value("q").asBool());
}

TEST(StProgramTest, loopsRunAsOftenAsTheySay)
{
    const StBench bench = runOnce("i : INT; n : DINT; m : DINT; k : DINT; u : USINT; c : DINT; d : DINT; e : DINT; step : INT := -2;",
                                  "FOR i := 1 TO 10 DO n := n + i; END_FOR;\n"
                                  "FOR i := 10 TO 1 BY -3 DO m := m + 1; END_FOR;\n"
                                  "FOR u := 250 TO 255 DO c := c + 1; END_FOR;\n"
                                  "FOR i := 9 TO 0 BY step DO e := e + 1; END_FOR;\n"
                                  "WHILE k < 100 DO k := k + 7; IF k > 50 THEN EXIT; END_IF; END_WHILE;\n"
                                  "REPEAT d := d + 1; IF d = 2 THEN CONTINUE; END_IF; UNTIL d >= 5 END_REPEAT;");
    EXPECT_EQ(bench.integer("n"), 55);
    EXPECT_EQ(bench.integer("m"), 4);
    EXPECT_EQ(bench.integer("c"), 6) << "the last value is the largest of its type";
    EXPECT_EQ(bench.integer("e"), 5);
    EXPECT_EQ(bench.integer("k"), 56);
    EXPECT_EQ(bench.integer("d"), 5);
}

TEST(StProgramTest, caseTakesValuesRangesAndEnumerations)
{
    const std::string text = "TYPE Colour : (Red, Green := 5, Blue); END_TYPE\nPROGRAM Main\nVAR i : INT; n : LINT; c : Colour := Blue; r : INT; END_VAR\n"
                             "FOR i := 0 TO 9 DO\nCASE i OF\n1: n := n * 10 + 1;\n2, 4..6: n := n * 10 + 2;\nELSE n := n * 10 + 3;\nEND_CASE;\nEND_FOR;\n"
                             "CASE c OF Red: r := 1; Colour#Green: r := 2; Blue: r := 3; END_CASE;\nEND_PROGRAM\n";
    StBench bench(text);
    ASSERT_TRUE(bench.runs()) << bench.messages();
    bench.scan();
    EXPECT_EQ(bench.integer("r"), 3);
    EXPECT_EQ(bench.integer("n"), 3123222333);
}

TEST(StProgramTest, arraysAndStructuresNest)
{
    const StBench bench = runOnce("a : ARRAY [0..2, 1..3] OF DINT := [1, 2, 3, 3(7), 2(8)];\nb : ARRAY [0..2, 1..3] OF DINT;\n"
                                  "p : ARRAY [1..4] OF STRUCT x : INT := 5; y : ARRAY [0..1] OF REAL; END_STRUCT;\ni : INT := 2; j : INT := 3; r, s, u, v : DINT; t : REAL;",
                                  "b[i, j] := 42; r := b[2, 3]; v := a[0, 3] * 100 + a[2, 2];\np[i].y[1] := 2.5; p[i + 1] := p[i]; t := p[3].y[i - 1]; s := p[4].x;\nu := b[i][j];");
    EXPECT_EQ(bench.integer("r"), 42);
    EXPECT_EQ(bench.integer("s"), 5);
    EXPECT_EQ(bench.real("t"), 2.5);
    EXPECT_EQ(bench.integer("u"), 42);
    EXPECT_EQ(bench.integer("v"), 308);
}

TEST(StProgramTest, aSubscriptOutsideLeavesTheStatementOutAndIsAFault)
{
    StBench bench("PROGRAM Main VAR a : ARRAY [1..3] OF INT; i : INT := 4; n : INT; END_VAR\na[i] := 9; n := n + 1; IF a[i] = 0 THEN n := 100; END_IF; a[3] := n; END_PROGRAM");
    ASSERT_TRUE(bench.runs()) << bench.messages();
    EXPECT_EQ(bench.scan().faults, 2u);
    EXPECT_EQ(bench.integer("n"), 1) << "an IF whose condition has no value is left out whole";
}

TEST(StProgramTest, functionsHaveParametersDefaultsAndOutputs)
{
    StBench bench("FUNCTION Scale : REAL\nVAR_INPUT x : REAL; k : REAL := 2.0; END_VAR\nVAR_OUTPUT doubled : BOOL; END_VAR\nVAR t : REAL := 1.0; END_VAR\n"
                  "t := t + x * k; doubled := k = 2.0; Scale := t; END_FUNCTION\n"
                  "PROGRAM Main VAR a, b, c : REAL; d, e : BOOL; END_VAR\n"
                  "a := Scale(3.0); b := Scale(x := 3.0, k := 4.0, doubled => d); c := Scale(Scale(1.0, 1.0), Scale(2.0), NOT doubled => e); END_PROGRAM");
    ASSERT_TRUE(bench.runs()) << bench.messages();
    bench.scan(2);
    EXPECT_EQ(bench.real("a"), 7.0);
    EXPECT_EQ(bench.real("b"), 13.0);
    EXPECT_FALSE(bench.value("d").asBool());
    EXPECT_EQ(bench.real("c"), 11.0);
    EXPECT_TRUE(bench.value("e").asBool());
}

TEST(StProgramTest, functionBlocksKeepTheirStateInEachInstance)
{
    StBench bench("FUNCTION_BLOCK Adder VAR_INPUT x : DINT; END_VAR VAR_OUTPUT sum : DINT; END_VAR VAR edge : R_TRIG; calls : INT; END_VAR\n"
                  "edge(CLK := x > 2); sum := sum + x; IF edge.Q THEN sum := sum + 1000; END_IF; END_FUNCTION_BLOCK\n"
                  "PROGRAM Main VAR a : Adder; list : ARRAY [0..2] OF Adder; i : INT; s : DINT; o : DINT; END_VAR\n"
                  "a(x := 1); a(x := 2, sum => o); FOR i := 0 TO 2 DO list[i](x := i + 2); END_FOR; s := list[0].sum * 1 + list[1].sum * 10 + list[2].sum; END_PROGRAM");
    ASSERT_TRUE(bench.runs()) << bench.messages();
    bench.scan();
    EXPECT_EQ(bench.integer("o"), 3);
    EXPECT_EQ(bench.integer("s"), 2 + 10030 + 1004);
}

TEST(StProgramTest, inOutAndReferencesReachTheVariableItself)
{
    StBench bench("FUNCTION_BLOCK Doubler VAR_IN_OUT v : DINT; END_VAR v := v * 2; END_FUNCTION_BLOCK\n"
                  "FUNCTION Swap : BOOL VAR_IN_OUT a, b : DINT; END_VAR VAR t : DINT; END_VAR t := a; a := b; b := t; Swap := TRUE; END_FUNCTION\n"
                  "PROGRAM Main VAR d : Doubler; x : DINT := 5; y : DINT := 7; arr : ARRAY [0..3] OF DINT := [1, 2, 3, 4]; i : INT := 2; ok : BOOL; r : REF_TO DINT; z : DINT; n : REF_TO DINT; q : BOOL; END_VAR\n"
                  "d(v := x); d(v := arr[i]); ok := Swap(x, y); r := REF(arr[1]); r^ := r^ + 40; z := arr[1] + arr[2]; q := n = NULL; n^ := 3; END_PROGRAM");
    ASSERT_TRUE(bench.runs()) << bench.messages();
    EXPECT_EQ(bench.scan().faults, 1u) << "writing through NULL";
    EXPECT_EQ(bench.integer("x"), 7);
    EXPECT_EQ(bench.integer("y"), 10);
    EXPECT_EQ(bench.integer("z"), 42 + 6);
    EXPECT_TRUE(bench.value("q").asBool());
}

TEST(StProgramTest, methodsWorkOnTheirInstanceAndAreInherited)
{
    StBench bench("INTERFACE Counter METHOD Count : DINT VAR_INPUT n2 : DINT; END_VAR END_METHOD END_INTERFACE\n"
                  "FUNCTION_BLOCK Base IMPLEMENTS Counter VAR n : DINT; END_VAR METHOD Count : DINT VAR_INPUT n2 : DINT := 1; END_VAR n := n + n2; Count := n; END_METHOD END_FUNCTION_BLOCK\n"
                  "FUNCTION_BLOCK Derived EXTENDS Base VAR_OUTPUT total : DINT; END_VAR METHOD Twice : DINT Twice := Count(2) + THIS.Count(); END_METHOD total := total + SUPER.Count(n2 := 5); END_FUNCTION_BLOCK\n"
                  "PROGRAM Main VAR a : Base; b : Derived; x, y, z : DINT; END_VAR x := a.Count(n2 := 3); y := b.Twice(); b(); z := b.total; END_PROGRAM");
    ASSERT_TRUE(bench.runs()) << bench.messages();
    bench.scan();
    EXPECT_EQ(bench.integer("x"), 3);
    EXPECT_EQ(bench.integer("y"), 2 + 3);
    EXPECT_EQ(bench.integer("z"), 8);
}

TEST(StProgramTest, timersFollowTheClock)
{
    StBench bench("PROGRAM Main VAR in : BOOL := TRUE; late : TON; off : TOF; pulse : TP; a, b, c : BOOL; n : INT; et : TIME; END_VAR\n"
                  "n := n + 1; IF n > 10 THEN in := FALSE; END_IF;\n"
                  "late(IN := in, PT := T#5ms, Q => a); off(IN := in, PT := T#3ms); b := off.Q; pulse(IN := in, PT := T#4ms, Q => c, ET => et); END_PROGRAM");
    ASSERT_TRUE(bench.runs()) << bench.messages();
    std::string on;
    std::string off;
    std::string pulse;
    for (int i = 0; i < 16; ++i) {
        bench.scan();
        on += bench.value("a").asBool() ? '1' : '0';
        off += bench.value("b").asBool() ? '1' : '0';
        pulse += bench.value("c").asBool() ? '1' : '0';
    }
    EXPECT_EQ(on, "0000011111000000");
    EXPECT_EQ(off, "1111111111111000");
    EXPECT_EQ(pulse, "1111000000000000");
}

TEST(StProgramTest, countersLatchesAndEdges)
{
    StBench bench("PROGRAM Main VAR clock : BOOL; u : CTU; d : CTD_DINT; ud : CTUD; s : SR; r : RS; f : F_TRIG; falls : INT; END_VAR\n"
                  "clock := NOT clock; u(CU := clock, PV := 3); d(CD := clock, LD := u.CV = 0, PV := 10); ud(CU := clock, CD := FALSE, R := FALSE, PV := 2);\n"
                  "s(S1 := TRUE, R := TRUE); r(S := TRUE, R1 := TRUE); f(CLK := clock); IF f.Q THEN falls := falls + 1; END_IF; END_PROGRAM");
    ASSERT_TRUE(bench.runs()) << bench.messages();
    bench.scan(8);
    EXPECT_EQ(bench.integer("falls"), 4);
}

TEST(StProgramTest, standardFunctions)
{
    const StBench bench = runOnce("a, b, c, d, e, f : DINT; r : REAL; l : LREAL; t : TIME; w : BYTE; q : BOOL; i : INT; x : WORD := 16#8001; g : LREAL;",
                                  "a := MAX(3, 9, 5); b := LIMIT(0, -5, 10); c := SEL(TRUE, 1, 2); d := MUX(1, 10, 20, 30); e := ABS(-7); f := REAL_TO_DINT(2.5);\n"
                                  "r := SQRT(REAL#2.25); l := INT_TO_LREAL(i); t := T#1s + T#500ms * 2; w := SHL(BYTE#16#0F, 6); q := x.15 AND NOT x.1; i := TRUNC_INT(-3.9); x := ROL(x, 1); g := ADD(1.5, 2.5, 3.0);");
    EXPECT_EQ(bench.integer("a"), 9);
    EXPECT_EQ(bench.integer("b"), 0);
    EXPECT_EQ(bench.integer("c"), 2);
    EXPECT_EQ(bench.integer("d"), 20);
    EXPECT_EQ(bench.integer("e"), 7);
    EXPECT_EQ(bench.integer("f"), 2) << "to even";
    EXPECT_EQ(bench.real("r"), 1.5);
    EXPECT_EQ(bench.integer("t"), 2000);
    EXPECT_EQ(bench.value("w").bits, 0xC0u);
    EXPECT_TRUE(bench.value("q").asBool());
    EXPECT_EQ(bench.integer("i"), -3);
    EXPECT_EQ(bench.value("x").bits, 3u);
    EXPECT_EQ(bench.real("g"), 7.0);
}

TEST(StProgramTest, transcendentalFunctionsAndPowers)
{
    const StBench bench = runOnce("r : REAL := 0.5; l : LREAL := 0.5; a, b, c, d, e, f : LREAL; s : REAL; x : INT := 3;",
                                  "s := SIN(r); a := COS(l) + TAN(l); b := ASIN(l) - ACOS(l) + ATAN(l); c := EXP(LN(l)) + LOG(1000.0); d := 2.0 ** 10 + EXPT(l, -2); e := ATAN2(1.0, -1.0); f := x ** 2;");
    EXPECT_EQ(bench.real("s"), static_cast<double>(static_cast<float>(0.47942553860420300)));
    EXPECT_NEAR(bench.real("a"), 0.87758256189037276 + 0.54630248984379051, 1e-15);
    EXPECT_NEAR(bench.real("b"), 0.52359877559829882 - 1.04719755119659774 + 0.46364760900080609, 1e-15);
    EXPECT_NEAR(bench.real("c"), 3.5, 1e-15);
    EXPECT_EQ(bench.real("d"), 1028.0);
    EXPECT_NEAR(bench.real("e"), 2.35619449019234484, 1e-15);
    EXPECT_EQ(bench.real("f"), 9.0);
}

TEST(StProgramTest, tasksRunAtTheirIntervalsAndPriorities)
{
    StBench bench("VAR_GLOBAL order : DINT; END_VAR\nPROGRAM Slow VAR_EXTERNAL order : DINT; END_VAR VAR n : DINT; END_VAR n := n + 1; order := order * 10 + 2; END_PROGRAM\n"
                  "PROGRAM Fast VAR m : DINT; END_VAR m := m + 1; order := 1; END_PROGRAM\n"
                  "CONFIGURATION C RESOURCE R ON PLC TASK S(INTERVAL := T#5ms, PRIORITY := 2); TASK F(INTERVAL := T#1ms, PRIORITY := 1);\n"
                  "PROGRAM A WITH S : Slow; PROGRAM B WITH F : Fast; END_RESOURCE END_CONFIGURATION");
    ASSERT_TRUE(bench.runs()) << bench.messages();
    bench.scan(20);
    EXPECT_EQ(bench.executor().image().program.routines.back().kind, RoutineKind::Main);
    EXPECT_EQ(bench.integer("order"), 1);
}

TEST(StProgramTest, anEndlessLoopEndsByTheBudgetOfOperations)
{
    StBench bench("PROGRAM Main VAR x : INT; END_VAR WHILE TRUE DO x := x + 1; END_WHILE; END_PROGRAM");
    ASSERT_TRUE(bench.runs()) << bench.messages();
    EXPECT_EQ(bench.scan().end, ScanEnd::OutOfOperations);
}

TEST(StProgramTest, twoCompilationsGiveTheSameBytes)
{
    const std::string text = fileText("generated.st");
    const StBench first(text);
    const StBench second(text);
    EXPECT_EQ(write(first.executor().image()), write(second.executor().image()));
}

} // namespace
