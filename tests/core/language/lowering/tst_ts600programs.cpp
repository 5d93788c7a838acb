#include "tests/core/language/lowering/programbench.h"

using namespace camwright;
using namespace camwright::test;

namespace {

// Semantics: TS-IL-01, TS-IL-02, TS-MEM-05, TS-MEM-06; the others take the common form (docs/families.md).
const ProgramRow Rows[] = {
    {"LD OUT", "LD X0\nOUT Y0", "X0=1", 1, "Y0=1"},
    {"LDI", "LDI X0\nOUT Y0", "", 1, "Y0=1"},
    {"X and Y are octal", "LD X10\nOUT Y17", "X10=1", 1, "Y17=1"},
    {"AND ANI OR ORI", "LD X0\nAND X1\nANI X2\nOR X3\nORI X4\nOUT Y0", "X0=1 X1=1 X2=1 X4=1", 1, "Y0=0"},
    {"ANB", "LD X0\nOR X1\nLD X2\nOR X3\nANB\nOUT Y0", "X1=1 X3=1", 1, "Y0=1"},
    {"ANB needs both", "LD X0\nOR X1\nLD X2\nOR X3\nANB\nOUT Y0", "X1=1", 1, "Y0=0"},
    {"ORB", "LD X0\nAND X1\nLD X2\nAND X3\nORB\nOUT Y0", "X2=1 X3=1", 1, "Y0=1"},
    {"MPS MRD MPP", "LD X0\nMPS\nAND X1\nOUT Y0\nMRD\nAND X2\nOUT Y1\nMPP\nANI X3\nOUT Y2", "X0=1 X2=1", 1, "Y0=0 Y1=1 Y2=1"},
    {"nested MPS", "LD X0\nMPS\nAND X1\nMPS\nAND X2\nOUT Y0\nMPP\nOUT Y1\nMPP\nOUT Y2", "X0=1 X1=1", 1, "Y0=0 Y1=1 Y2=1"},
    {"two outputs", "LD X0\nOUT Y0\nOUT Y1", "X0=1", 1, "Y0=1 Y1=1"},
    {"INV", "LD X0\nINV\nOUT Y0", "", 1, "Y0=1"},
    {"SET and RST", "LD X0\nSET M0\nLD X1\nRST M1", "X0=1 X1=1 M1=1", 1, "M0=1 M1=0"},
    {"bit of a word", "LD D0.3\nOUT D1.15", "D0=8", 1, "D1:WORD=16#8000"},
    {"LDP for one scan", "LDP X0\nSET M0\nLDP X0\nOUT M1", "X0=1", 2, "M0=1 M1=0"},
    {"LDF not at the start", "LDF X0\nSET M0", "", 2, "M0=0"},
    {"ANDP in series", "LD X1\nANDP X0\nINC D0", "X0=1 X1=1", 3, "D0=1"},
    {"ORF", "LD X1\nORF X0\nSET M0", "X1=1", 1, "M0=1"},
    {"MOV", "LD X0\nMOV D0 D1", "X0=1 D0=-5", 1, "D1=-5"},
    {"MOV without flow", "LD X0\nMOV 5 D1", "D1=3", 1, "D1=3"},
    {"DMOV takes two words, low first", "LD X0\nDMOV 65538 D10", "X0=1", 1, "D10=2 D11=1"},
    {"RMOV", "LD X0\nRMOV 1.5 D10", "X0=1", 1, "D10:REAL=1.5 D10=0 D11=16320"},
    {"ADD wraps", "LD X0\nADD D0 1 D1", "X0=1 D0=32767", 1, "D1=-32768"},
    {"SUB", "LD X0\nSUB D0 D1 D2", "X0=1 D0=3 D1=5", 1, "D2=-2"},
    {"MUL keeps the low word", "LD X0\nMUL D0 D1 D2", "X0=1 D0=300 D1=300", 1, "D2=24464 D3=0"},
    {"DIV", "LD X0\nDIV D0 2 D2", "X0=1 D0=-7", 1, "D2=-3"},
    {"DIV by 0 leaves D and sets SM22", "LD X0\nDIV D0 D1 D2", "X0=1 D0=7 D2=9", 1, "D2=9 SM22=1"},
    {"INC DEC", "LD X0\nINC D0\nDEC D1", "X0=1", 2, "D0=2 D1=-2"},
    {"DADD", "LD X0\nDADD D0 D2 D4", "X0=1 D0:DINT=70000 D2:DINT=-1", 1, "D4:DINT=69999"},
    {"DINC carries into the high word", "LD X0\nDINC D0", "X0=1 D0=-1", 1, "D0=0 D1=1"},
    {"DDIV", "LD X0\nDDIV D0 D2 D4", "X0=1 D0:DINT=-100000 D2:DINT=3", 1, "D4:DINT=-33333"},
    {"RADD RMUL", "LD X0\nRADD D0 0.5 D2\nRMUL D2 2.0 D4", "X0=1 D0:REAL=1.25", 1, "D2:REAL=1.75 D4:REAL=3.5"},
    {"LD=", "LD= D0 5\nOUT Y0", "D0=5", 1, "Y0=1"},
    {"comparisons are signed", "LD< D0 0\nOUT Y0", "D0=-1", 1, "Y0=1"},
    {"AND> OR<>", "LD X0\nAND> D0 3\nOR<> D1 0\nOUT Y0", "X0=1 D0=3 D1=1", 1, "Y0=1"},
    {"LDD>= in 32 bits", "LDD>= D0 65536\nOUT Y0", "D1=1", 1, "Y0=1"},
    {"a timer as a contact and as a value", "LD X0\nTON T0 5\nLDI T0\nMOV T0 D0", "X0=1", 1, "D0=0"},
};

TEST(Ts600ProgramTest, eachInstructionDoesWhatItsHelpSays)
{
    for (const ProgramRow& row : Rows) {
        ProgramBench bench("invt", "TS635", std::string(row.text) + "\n");
        const std::string wrong = bench.build();
        ASSERT_EQ(wrong.find("error"), std::string::npos) << row.what << "\n" << wrong;
        bench.set(row.before);
        for (int scan = 0; scan < row.scans; ++scan)
            bench.scan();
        EXPECT_EQ(bench.differences(row.after), "") << row.what;
    }
}

// TS-TMR-01 … 04, TS-MEM-03
TEST(Ts600ProgramTest, timersCountInTheirResolution)
{
    ProgramBench bench("invt", "TS635",
                       "LD X0\nTON T0 2\nLD X0\nTON T200 2\nLD X0\nTON T300 2\n"
                       "LD X1\nTONR T201 3\nLD X2\nTOF T202 2\nLD X3\nTMON T203 2\nLD X4\nRST T201\n");
    ASSERT_EQ(bench.build(), "");
    bench.scan();
    bench.set("X0=1 X1=1 X2=1 X3=1");
    bench.scan();
    bench.scan();
    bench.scan();
    EXPECT_EQ(bench.differences("T300=1 T200=0 T0=0 T202=1 T203=1"), "");
    bench.scan(17ms);
    EXPECT_EQ(bench.differences("T200=0 T203=1 T200:INT=1"), "") << "19 ms";
    bench.scan(1ms);
    EXPECT_EQ(bench.differences("T200=1 T0=0 T203=0"), "");
    bench.set("X1=0 X2=0");
    bench.scan(1ms);
    bench.scan(19ms);
    EXPECT_EQ(bench.differences("T202=1 T201:INT=2"), "");
    bench.scan(1ms);
    EXPECT_EQ(bench.differences("T202=0"), "");
    bench.set("X4=1");
    bench.scan(1ms);
    EXPECT_EQ(bench.differences("T201:INT=0 T201=0"), "");
    bench.scan(200ms);
    EXPECT_EQ(bench.differences("T0=1"), "");
}

TEST(Ts600ProgramTest, countersAndTheirReset)
{
    ProgramBench bench("invt", "TS635", "LD X0\nCTU C0 2\nLD X0\nCTUD C200 X1 70000\nLD X2\nRST C0\nLD X3\nDMOV 69999 C200\n");
    ASSERT_EQ(bench.build(), "");
    bench.set("X3=1");
    bench.scan();
    bench.set("X3=0 X0=1");
    bench.scan();
    EXPECT_EQ(bench.differences("C0:INT=1 C0=0 C200:DINT=70000 C200=1"), "");
    bench.set("X0=0");
    bench.scan();
    bench.set("X0=1 X1=1");
    bench.scan();
    EXPECT_EQ(bench.differences("C0=1 C200:DINT=69999 C200=0"), "");
    bench.set("X2=1");
    bench.scan();
    EXPECT_EQ(bench.differences("C0:INT=0 C0=0"), "");
}

/// The lamp program of the INVT manual: X0 starts; Y0, Y1, Y2 alternate for 2 s each with 100 ms timers.
TEST(Ts600ProgramTest, marqueeAlternatesEveryTwoSeconds)
{
    ProgramBench bench("invt", "TS635",
                       "LD X0\nANI T2\nTON T0 20\nLD T0\nTON T1 20\nLD T1\nTON T2 20\n"
                       "LD X0\nANI T0\nOUT Y0\nLD T0\nANI T1\nOUT Y1\nLD T1\nANI T2\nOUT Y2\n");
    ASSERT_EQ(bench.build(), "");
    bench.set("X0=1");
    std::string lamps;
    for (int ms = 0; ms < 12500; ++ms) {
        bench.scan();
        if (ms % 1000 == 999)
            lamps += bench.differences("Y0=1 Y1=0 Y2=0").empty() ? '0' : bench.differences("Y0=0 Y1=1 Y2=0").empty() ? '1' : bench.differences("Y0=0 Y1=0 Y2=1").empty() ? '2' : '?';
    }
    EXPECT_EQ(lamps, "001122001122");
}

TEST(Ts600ProgramTest, subroutinesAreCalledWithFlow)
{
    ProgramBench bench("invt", "TS635", "LD X0\nCALL Sub\nLD X1\nCALL Sub\n",
                       {{"Sub", {ProgramRole::Subroutine, "LD SM0\nINC D0\nLD X2\nCRET\nLD SM0\nINC D1\n"}}});
    ASSERT_EQ(bench.build(), "");
    bench.set("SM0=1 X0=1");
    bench.scan();
    EXPECT_EQ(bench.differences("D0=1 D1=1"), "");
    bench.set("X1=1 X2=1");
    bench.scan();
    EXPECT_EQ(bench.differences("D0=3 D1=1"), "");
}

} // namespace
