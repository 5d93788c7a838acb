#include "tests/core/language/lowering/programbench.h"

#include <fstream>
#include <iterator>
#include <random>

using namespace camwright;
using namespace camwright::test;

namespace {

#define ON "STR SP1\n"

// What stands in the D2-MLINK manual: LDS, OUTW, RST, B10003.1 (D2-PRG-02); the others take the form published for DL205
// (docs/families.md). SP1 is on because the bench sets it.
const ProgramRow Rows[] = {
    {"STR OUT", "STR X0\nOUT Y0", "X0=1", 1, "Y0=1"},
    {"the manual's names for the same bits", "STR I0\nOUT Q0\nOUT M1002", "X0=1", 1, "Y0=1 C1002=1"},
    {"STRN", "STRN X0\nOUT Y0", "", 1, "Y0=1"},
    {"numbers are octal", "STR X10\nOUT Y17", "X10=1", 1, "Y17=1"},
    {"AND ANDN OR ORN", "STR X0\nAND X1\nANDN X2\nOR X3\nORN X4\nOUT Y0", "X0=1 X1=1 X2=1 X4=1", 1, "Y0=0"},
    {"ANDSTR", "STR X0\nOR X1\nSTR X2\nOR X3\nANDSTR\nOUT Y0", "X1=1 X3=1", 1, "Y0=1"},
    {"ANDSTR needs both", "STR X0\nOR X1\nSTR X2\nOR X3\nANDSTR\nOUT Y0", "X1=1", 1, "Y0=0"},
    {"ORSTR", "STR X0\nAND X1\nSTR X2\nAND X3\nORSTR\nOUT Y0", "X2=1 X3=1", 1, "Y0=1"},
    {"NOT", "STR X0\nNOT\nOUT Y0", "", 1, "Y0=1"},
    {"SET and RST", "STR X0\nSET C0\nSTR X1\nRST C1", "X0=1 X1=1 C1=1", 1, "C0=1 C1=0"},
    {"PD for one scan", "STR X0\nPD C0\nSTR C0\nINC V1400", "X0=1", 3, "C0=0 V1400=16#1"},
    {"STRPD", "STRPD X0\nINC V1400", "X0=1", 3, "V1400=16#1"},
    {"ANDND", "STR X1\nANDND X0\nINC V1400", "X1=1", 3, "V1400=16#0"},
    {"bit of a word", "STR B1400.3\nOUT B1401.15", "V1400=8", 1, "V1401=16#8000"},
    {"bits and words are one memory", "STR X0\nOUT C17\nSTR B40600.15\nOUT Y0", "X0=1", 1, "Y0=1 V40600=16#8000"},
    {"a word of inputs", ON "LD V40400\nOUT V1400", "X3=1 X17=1", 1, "V1400=16#8008"},
    {"LDS and OUTW as the manual prints them", "LDS K10\nOUTW R10000\nLDS K2000\nOUTW R10001", "", 1, "V10000=16#10 V10001=16#2000"},
    {"OUT with a word is OUTW", ON "LD K12AB\nOUT V1400", "", 1, "V1400=16#12AB"},
    {"LD without flow keeps the accumulator", "STR X0\nLD K5\nSTR SP1\nOUT V1400", "V1400=7 ACC0=9", 1, "V1400=9 ACC0=9"},
    {"the accumulator lives from rung to rung", ON "LD K5\nSTR X0\nOUT V1400", "X0=1", 1, "V1400=5"},
    {"the accumulator lives from scan to scan", ON "OUT V1400\nSTR SP1\nLD K7", "", 2, "V1400=7"},
    {"LDD and OUTD take two words, low first", ON "LDD K12345678\nOUTD V1400", "", 1, "V1400=16#5678 V1401=16#1234"},
    {"LD clears the upper half", ON "LDD K12345678\nLD V1400\nOUTD V1402", "V1400=16#9", 1, "V1402=9 V1403=0"},
    {"LDA makes a binary number of an octal address", ON "LDA O10000\nOUT R7662", "", 1, "V7662=16#1000"},
    {"LDF and OUTF", ON "LDF X2 K4\nOUTF C10 K12", "X2=1 X5=1", 1, "ACC0=9 C10=1 C11=0 C13=1 C14=0"},
    {"POP takes the load before", ON "LD K1\nLD K2\nLD K3\nPOP\nOUT V1400\nPOP\nOUT V1401", "", 1, "V1400=2 V1401=1"},
    {"OUT ends the waiting of a load", ON "LD K1\nOUT V1400\nLD K2\nLD K3\nPOP\nPOP\nOUT V1401", "", 1, "V1401=0"},
    {"ADD in BCD", ON "LD V1400\nADD K1\nOUTD V1402", "V1400=16#1999", 1, "V1402=16#2000 V1403=0"},
    {"ADD carries into the 5th digit", ON "LD K9999\nADD K1\nOUTD V1402", "", 1, "V1402=0 V1403=1 SP67=0"},
    {"ADDD carries out", ON "LDD K99999999\nADDD K2\nOUTD V1402", "", 1, "V1402=1 V1403=0 SP67=1"},
    {"SUB in BCD", ON "LD K2000\nSUB K1\nOUT V1400", "", 1, "V1400=16#1999 SP65=0"},
    {"SUBD borrows", ON "LDD K1\nSUBD K3\nOUTD V1400", "", 1, "V1400=16#9998 V1401=16#9999 SP65=1"},
    {"MUL in BCD has 8 digits", ON "LD K1234\nMUL K5678\nOUTD V1400", "", 1, "V1400=16#6652 V1401=16#0700"},
    {"MULD puts the upper digits onto the stack", ON "LDD K12345678\nMULD K87654321\nOUTD V1400\nPOP\nOUTD V1402", "", 1, "V1400:DWORD=16#22374638 V1402:DWORD=16#10821520"},
    {"DIV in BCD, the rest on the stack", ON "LD K100\nDIV K7\nOUT V1400\nPOP\nOUT V1401", "", 1, "V1400=16#14 V1401=2"},
    {"DIV by 0 leaves the accumulator", ON "LD K100\nDIV V1405\nOUT V1400", "", 1, "V1400=16#100"},
    {"DIVD", ON "LDD K87654321\nDIVD K1000\nOUTD V1400", "", 1, "V1400:DWORD=16#87654"},
    {"ADDB is binary", ON "LD KFF\nADDB K1\nOUT V1400", "", 1, "V1400=16#100"},
    {"ADDBD carries out", ON "LDD KFFFFFFFF\nADDBD K1\nOUTD V1400", "", 1, "V1400:DWORD=0 SP67=1 SP63=1"},
    {"SUBB", ON "LD K3\nSUBB K5\nOUT V1400", "", 1, "V1400=16#FFFE SP65=1 SP70=1"},
    {"SUBBD", ON "LDD K10000\nSUBBD V1402\nOUTD V1400", "V1402=1", 1, "V1400:DWORD=16#FFFF"},
    {"MULB", ON "LD KFFFF\nMULB KFFFF\nOUTD V1400", "", 1, "V1400:DWORD=16#FFFE0001"},
    {"DIVB", ON "LD K64\nDIVB K7\nOUT V1400\nPOP\nOUT V1401", "", 1, "V1400=14 V1401=2"},
    {"INC and DEC in BCD", ON "INC V1400\nDEC V1401", "V1400=16#9999 V1401=16#0", 1, "V1400=0 V1401=16#9999"},
    {"INCB and DECB", ON "INCB V1400\nDECB V1401", "V1400=16#FFFF", 1, "V1400=0 V1401=16#FFFF"},
    {"CMP", ON "LD K5\nCMP K6", "", 1, "SP60=1 SP61=0 SP62=0"},
    {"CMPD", ON "LDD K70000\nCMPD K6FFFF", "", 1, "SP60=0 SP61=0 SP62=1"},
    {"BIN", ON "LD K1234\nBIN\nOUT V1400", "", 1, "V1400=1234 SP75=0"},
    {"BIN of what is no BCD sets SP75", ON "LD K12AB\nBIN", "", 1, "SP75=1"},
    {"BCD", ON "LD V1400\nBCD\nOUTD V1402", "V1400=65535", 1, "V1402=16#5535 V1403=6"},
    {"AND OR with a word, XOR", ON "LD KF0F0\nAND KFF00\nOR K5\nXOR K1\nOUT V1400", "", 1, "V1400=16#F004"},
    {"ANDD ORD XORD", ON "LDD KFFFF0000\nANDD KFF00FF00\nORD KFF\nXORD K1\nOUTD V1400", "", 1, "V1400:DWORD=16#FF0000FE"},
    {"INV", ON "LD K0\nINV\nOUTD V1400", "", 1, "V1400:DWORD=16#FFFFFFFF"},
    {"SHFL counts in BCD", ON "LD K1\nSHFL K10\nOUT V1400", "", 1, "V1400=1024"},
    {"SHFR ROTL ROTR", ON "LDD K80000000\nSHFR K31\nROTR K1\nROTL K2\nOUT V1400", "", 1, "V1400=2"},
    {"STRE compares words", "STRE V1400 K5\nOUT Y0", "V1400=5", 1, "Y0=1"},
    {"ANDNE ORE", "STR X0\nANDNE V1400 K3\nORE V1401 K7\nOUT Y0", "X0=1 V1400=3 V1401=7", 1, "Y0=1"},
    {"STR with two operands is greater or equal", "STR V1400 K100\nOUT Y0", "V1400=16#100", 1, "Y0=1"},
    {"STRN with two operands is less, without sign", "STRN V1400 K100\nOUT Y0", "V1400=16#8000", 1, "Y0=0"},
    {"ANDN with two operands", "STR SP1\nANDN V1400 V1401\nOUT Y0", "V1401=1", 1, "Y0=1"},
    {"OR>= is the same as OR", "STR X0\nOR>= V1400 K1\nOUT Y0", "V1400=1", 1, "Y0=1"},
    {"FOR repeats", ON "FOR K10\nSTR SP1\nINCB V1400\nNEXT\nSTR SP1\nOUT Y0", "", 1, "V1400=10 Y0=1"},
    {"FOR within FOR", ON "FOR K3\nSTR SP1\nFOR V1401\nSTR SP1\nINCB V1400\nNEXT\nNEXT", "V1401=4", 1, "V1400=12"},
    {"FOR without flow is skipped", "STR X0\nFOR K10\nSTR SP1\nINCB V1400\nNEXT", "", 1, "V1400=0"},
    {"ENDC ends the scan", "STR X0\nENDC\nSTR SP1\nOUT Y0", "X0=1", 1, "Y0=0"},
    {"END ends the program", ON "OUT Y0\nEND", "", 1, "Y0=1"},
    {"a comparison with a timer's value", "STR X0\nTMR T0 K30\nSTR TA0 K0\nOUT Y0", "", 1, "Y0=1"},
};

/// The special relays are the engine's; the bench has none.
void run(ProgramBench& bench, int scans, Time step = 1ms)
{
    for (int scan = 0; scan < scans; ++scan) {
        bench.set("SP1=1");
        bench.scan(step);
    }
}

TEST(KoyoProgramTest, eachInstructionDoesWhatItsHelpSays) // D2-PRG-02, D2-AMB-21
{
    for (const ProgramRow& row : Rows) {
        ProgramBench bench("koyo", "DL-260", std::string(row.text) + "\n");
        const std::string wrong = bench.build();
        ASSERT_EQ(wrong.find("error"), std::string::npos) << row.what << "\n" << wrong;
        bench.set(row.before);
        run(bench, row.scans);
        EXPECT_EQ(bench.differences(row.after), "") << row.what;
    }
}

TEST(KoyoProgramTest, aTimerCountsTenthsInBcdBeyondItsPreset)
{
    ProgramBench bench("koyo", "DL-260", "STR X0\nTMR T5 K30\nSTR T5\nOUT Y0\n");
    ASSERT_EQ(bench.build(), "");
    bench.set("X0=1");
    run(bench, 1);
    run(bench, 29, 100ms);
    EXPECT_EQ(bench.differences("V5=16#29 Y0=0"), "");
    run(bench, 1, 100ms);
    EXPECT_EQ(bench.differences("V5=16#30 Y0=1"), "");
    run(bench, 1, 300s);
    EXPECT_EQ(bench.differences("V5=16#3030 Y0=1"), "");
    run(bench, 1, 3000s);
    EXPECT_EQ(bench.differences("V5=16#9999"), "");
    bench.set("X0=0");
    run(bench, 1);
    EXPECT_EQ(bench.differences("V5=0 Y0=0"), "");
}

TEST(KoyoProgramTest, aFastTimerCountsHundredthsAndTakesItsPresetFromAWord)
{
    ProgramBench bench("koyo", "DL-260", "STR X0\nTMRF T0 V1400\n");
    ASSERT_EQ(bench.build(), "");
    bench.set("X0=1 V1400=16#15");
    run(bench, 1);
    run(bench, 14, 10ms);
    EXPECT_EQ(bench.differences("T0=0 V0=16#14"), "");
    run(bench, 1, 10ms);
    EXPECT_EQ(bench.differences("T0=1"), "");
}

TEST(KoyoProgramTest, anAccumulatingTimerKeepsItsEightDigitsUntilReset)
{
    ProgramBench bench("koyo", "DL-260", "STR X0\nSTR X1\nTMRA T0 K10005\nSTR T0\nOUT Y0\n");
    ASSERT_EQ(bench.build(), "");
    bench.set("X0=1");
    run(bench, 1);
    run(bench, 1, 1000s);
    bench.set("X0=0");
    run(bench, 1, 500s);
    EXPECT_EQ(bench.differences("V0:DWORD=16#10000 Y0=0"), "");
    bench.set("X0=1");
    run(bench, 1, 10s);
    run(bench, 1, 500ms);
    EXPECT_EQ(bench.differences("V0=5 V1=1 Y0=1"), "");
    bench.set("X1=1");
    run(bench, 1);
    EXPECT_EQ(bench.differences("V0:DWORD=0 T0=0"), "");
}

TEST(KoyoProgramTest, aCounterCountsEdgesInBcdAndIsReset)
{
    ProgramBench bench("koyo", "DL-260", "STR X0\nSTR X1\nCNT CT2 K3\nSTR CT2\nOUT Y0\n");
    ASSERT_EQ(bench.build(), "");
    for (int i = 0; i < 12; ++i) {
        EXPECT_EQ(bench.differences(i >= 3 ? "Y0=1" : "Y0=0"), "") << i;
        bench.set("X0=1");
        run(bench, 2);
        bench.set("X0=0");
        run(bench, 1);
    }
    EXPECT_EQ(bench.differences("V1002=16#12 CT2=1"), "");
    bench.set("X1=1 X0=1");
    run(bench, 1);
    EXPECT_EQ(bench.differences("V1002=0 CT2=0 Y0=0"), "");
}

TEST(KoyoProgramTest, anUpDownCounterHasEightDigitsAndStopsAtZero)
{
    ProgramBench bench("koyo", "DL-260", "STR X0\nSTR X1\nSTR X2\nUDC CT0 K10000\n");
    ASSERT_EQ(bench.build(), "");
    bench.set("V1000=16#9999 X0=1");
    run(bench, 1);
    EXPECT_EQ(bench.differences("V1000=0 V1001=1 CT0=1"), "");
    bench.set("X0=0 X1=1");
    run(bench, 1);
    EXPECT_EQ(bench.differences("V1000=16#9999 V1001=0 CT0=0"), "");
    bench.set("X1=0 X2=1");
    run(bench, 1);
    bench.set("X2=0 X1=1");
    run(bench, 1);
    EXPECT_EQ(bench.differences("V1000:DWORD=0"), "");
}

TEST(KoyoProgramTest, aStageCounterIsSetBackByRst)
{
    ProgramBench bench("koyo", "DL-260", "STR X0\nSGCNT CT1 K1\nSTR X1\nRST CT1\n");
    ASSERT_EQ(bench.build(), "");
    bench.set("X0=1");
    run(bench, 1);
    EXPECT_EQ(bench.differences("V1001=1 CT1=1"), "");
    bench.set("X1=1");
    run(bench, 1);
    EXPECT_EQ(bench.differences("V1001=0 CT1=0"), "");
}

TEST(KoyoProgramTest, subroutinesAreCalledByNumberAndByName)
{
    ProgramBench bench("koyo", "DL-260", "STR X0\nGTS K3\nSTR X1\nGTS Lamps\n",
        {{"Count", {ProgramRole::Subroutine, "// the third\nSBR K3\nSTR SP1\nINC V1400\nSTR X2\nRTC\nSTR SP1\nINC V1401\nRT\n"}},
         {"Lamps", {ProgramRole::Subroutine, "STR SP1\nSET Y5\n"}}});
    ASSERT_EQ(bench.build(), "");
    bench.set("X0=1 X2=1");
    run(bench, 2);
    EXPECT_EQ(bench.differences("V1400=2 V1401=0 Y5=0"), "");
    bench.set("X1=1 X2=0");
    run(bench, 1);
    EXPECT_EQ(bench.differences("V1400=3 V1401=1 Y5=1"), "");
}

std::string program(const std::string& name)
{
    std::ifstream in(std::string(CAMWRIGHT_SOURCE_DIR) + "/tests/data/language/koyo/" + name, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

TEST(KoyoProgramTest, theSetUpOfTheManualFillsTheRegistersOfTheModule) // D2-PRG-01, D2-PRG-02, D2-REG-01 … 03, D2-REG-14
{
    ProgramBench bench("koyo", "DL-260", program("initialisation.il"));
    ASSERT_EQ(bench.build(), "");
    bench.set("SP0=1");
    bench.scan();
    EXPECT_EQ(bench.differences("V7662=16#1000 V10000=16#2 V10001=16#2000 V10020=16#41 V10060=16#42"), "");
}

TEST(KoyoProgramTest, theJogPatternSendsFeedAtTheRisingAndHoldAtTheFallingEdge) // D2-PRG-03
{
    ProgramBench bench("koyo", "DL-260", program("jog.il"));
    ASSERT_EQ(bench.build(), "");
    bench.set("SP0=1 V1400=16#86A0 V1401=1");
    bench.scan();
    bench.set("SP0=0 I0=1");
    bench.scan();
    EXPECT_EQ(bench.differences("V10021=16#31 B10003.1=1"), "");
    bench.set("B10003.1=0 I1=1"); // the module has answered
    bench.scan();
    EXPECT_EQ(bench.differences("V10021=16#36 V10025=16#86A0 V10026=1 V10027=16#20 B10003.1=1"), "");
    bench.set("B10003.1=0");
    bench.scan();
    EXPECT_EQ(bench.differences("B10003.1=0"), "") << "the command is sent once";
    bench.set("I1=0");
    bench.scan();
    EXPECT_EQ(bench.differences("V10021=16#25 V10023=0 B10003.1=1"), "");
}

TEST(KoyoProgramTest, everyBcdNumberComesBackFromBinary)
{
    ProgramBench bench("koyo", "DL-260", ON "LDD V1400\nBCD\nOUTD V1402\nBIN\nOUTD V1404\n");
    ASSERT_EQ(bench.build(), "");
    std::mt19937 random(7);
    for (int i = 0; i < 2000; ++i) {
        const std::uint32_t number = i < 200 ? static_cast<std::uint32_t>(i * 505'037) % 100'000'000 : static_cast<std::uint32_t>(random() % 100'000'000);
        std::string digits = std::to_string(number);
        bench.set("V1400:DWORD=" + digits);
        bench.set("SP1=1");
        bench.scan();
        ASSERT_EQ(bench.differences("V1402:DWORD=16#" + digits + " V1404:DWORD=" + digits + " SP75=0"), "") << digits;
    }
}

} // namespace
