#include "tests/core/language/lowering/programbench.h"

using namespace camwright;
using namespace camwright::test;

namespace {

// Semantics: KS-IL-06, KS-IL-07, KS-IL-11, KS-MEM-02; the others take the common form (docs/families.md).
const ProgramRow Rows[] = {
    {"LD ST", "LD %M0.0\nST %M1.0", "%M0.0=1", 1, "%M1.0=1"},
    {"ST stores 0 too", "LD %M0.0\nST %M1.0", "%M1.0=1", 1, "%M1.0=0"},
    {"LDN", "LDN %M0.0\nST %M1.0", "", 1, "%M1.0=1"},
    {"AND", "LD %M0.0\nAND %M0.1\nST %M1.0", "%M0.0=1 %M0.1=1", 1, "%M1.0=1"},
    {"AND with 0", "LD %M0.0\nAND %M0.1\nST %M1.0", "%M0.0=1", 1, "%M1.0=0"},
    {"ANDN", "LD %M0.0\nANDN %M0.1\nST %M1.0", "%M0.0=1", 1, "%M1.0=1"},
    {"OR", "LD %M0.0\nOR %M0.1\nST %M1.0", "%M0.1=1", 1, "%M1.0=1"},
    {"ORN", "LD %M0.0\nORN %M0.1\nST %M1.0", "", 1, "%M1.0=1"},
    {"AND( )", "LD %M0.0\nAND( %M0.1\nOR %M0.2\n)\nST %M1.0", "%M0.0=1 %M0.2=1", 1, "%M1.0=1"},
    {"OR( ) nested", "LD %M0.0\nOR( %M0.1\nAND( %M0.2\nORN %M0.3\n)\n)\nST %M1.0", "%M0.1=1", 1, "%M1.0=1"},
    {"NOT", "LD %M0.0\nNOT\nST %M1.0", "", 1, "%M1.0=1"},
    {"STN", "LD %M0.0\nSTN %M1.0", "", 1, "%M1.0=1"},
    {"S holds", "LD %M0.0\nS %M1.0", "%M1.0=1", 1, "%M1.0=1"},
    {"S sets", "LD %M0.0\nS %M1.0", "%M0.0=1", 1, "%M1.0=1"},
    {"R resets", "LD %M0.0\nR %M1.0", "%M0.0=1 %M1.0=1", 1, "%M1.0=0"},
    {"R leaves", "LD %M0.0\nR %M1.0", "%M1.0=1", 1, "%M1.0=1"},
    {"R_TRIG one scan", "LD %M0.0\nR_TRIG\nS %M1.0\nST %M1.1", "%M0.0=1", 2, "%M1.0=1 %M1.1=0"},
    {"F_TRIG sees no edge at the start", "LD %M0.0\nF_TRIG\nS %M1.0", "", 2, "%M1.0=0"},
    {"MOVE with flow", "LD %M0.0\nMOVE %VW0,%VW2", "%M0.0=1 %VW0=17", 1, "%VW2=17"},
    {"MOVE without flow", "LD %M0.0\nMOVE %VW0,%VW2", "%VW0=17 %VW2=3", 1, "%VW2=3"},
    {"MOVE leaves CR", "LD %SM0.0\nMOVE 5,%VW2\nST %M1.0", "%SM0.0=1", 1, "%VW2=5 %M1.0=1"},
    {"MOVE of a DINT overlaps its words", "LD %SM0.0\nMOVE DI#65537,%VD4", "%SM0.0=1", 1, "%VW4=1 %VW6=1 %VB4=1 %VB5=0"},
    {"MOVE REAL", "LD %SM0.0\nMOVE 1200.5,%VR8\nMOVE %VR8,%VR300", "%SM0.0=1", 1, "%VR300=1200.5"},
    {"unaligned double word", "LD %SM0.0\nMOVE %VD6,%MD14", "%SM0.0=1 %VD6=123456789", 1, "%MD14=123456789"},
    {"GT", "LD %SM0.0\nGT %VW0,5\nST %M1.0", "%SM0.0=1 %VW0=6", 1, "%M1.0=1"},
    {"GE equal", "LD %SM0.0\nGE %VW0,6\nST %M1.0", "%SM0.0=1 %VW0=6", 1, "%M1.0=1"},
    {"LT", "LD %SM0.0\nLT %VW0,5\nST %M1.0", "%SM0.0=1 %VW0=6", 1, "%M1.0=0"},
    {"LE", "LD %SM0.0\nLE %VD0,DI#-7\nST %M1.0", "%SM0.0=1 %VD0=-7", 1, "%M1.0=1"},
    {"EQ of REAL", "LD %SM0.0\nEQ %VR0,1.5\nST %M1.0", "%SM0.0=1 %VR0=1.5", 1, "%M1.0=1"},
    {"NE", "LD %SM0.0\nNE %VB0,B#3\nST %M1.0", "%SM0.0=1 %VB0=3", 1, "%M1.0=0"},
    {"a comparison is ANDed with CR", "LD %M0.0\nGT %VW0,5\nST %M1.0", "%VW0=6", 1, "%M1.0=0"},
    {"ADD wraps", "LD %SM0.0\nADD %VW0,1,%VW2", "%SM0.0=1 %VW0=32767", 1, "%VW2:INT=-32768"},
    {"SUB DINT", "LD %SM0.0\nSUB %VD0,DI#1,%VD4", "%SM0.0=1 %VD0=0", 1, "%VD4:DINT=-1"},
    {"MUL REAL", "LD %SM0.0\nMUL %VR0,2.5,%VR4", "%SM0.0=1 %VR0=3.0", 1, "%VR4=7.5"},
    {"DIV truncates", "LD %SM0.0\nDIV %VW0,2,%VW2", "%SM0.0=1 %VW0:INT=-7", 1, "%VW2:INT=-3"},
    {"DIV by 0 leaves the result", "LD %SM0.0\nDIV %VW0,%VW4,%VW2", "%SM0.0=1 %VW0=8 %VW2=99", 1, "%VW2=99"},
    {"MOD", "LD %SM0.0\nMOD %VW0,5,%VW2", "%SM0.0=1 %VW0:INT=-7", 1, "%VW2:INT=-2"},
    {"INC counts scans", "LD %SM0.0\nINC %VW0", "%SM0.0=1 %VW0=4", 3, "%VW0=7"},
    {"DEC BYTE wraps", "LD %SM0.0\nDEC %VB0", "%SM0.0=1", 1, "%VB0=255"},
    {"ABS", "LD %SM0.0\nABS %VD0,%VD4", "%SM0.0=1 %VD0:DINT=-12", 1, "%VD4=12"},
    {"ANDW", "LD %SM0.0\nANDW %VW0,16#F0F0,%VW2", "%SM0.0=1 %VW0=16#3C3C", 1, "%VW2=16#3030"},
    {"ORB", "LD %SM0.0\nORB %VB0,B#16#0F,%VB2", "%SM0.0=1 %VB0=16#30", 1, "%VB2=16#3F"},
    {"XORDW", "LD %SM0.0\nXORDW %VD0,%VD0,%VD4", "%SM0.0=1 %VD0=77 %VD4=5", 1, "%VD4=0"},
    {"INVB", "LD %SM0.0\nINVB %VB0,%VB1", "%SM0.0=1 %VB0=16#0F", 1, "%VB1=16#F0"},
    {"SHL", "LD %SM0.0\nSHL %VW0,B#4,%VW2", "%SM0.0=1 %VW0=16#1234", 1, "%VW2=16#2340"},
    {"SHR by memory", "LD %SM0.0\nSHR %VD0,%VB10,%VD4", "%SM0.0=1 %VD0:DWORD=16#80000000 %VB10=31", 1, "%VD4=1"},
    {"ROL", "LD %SM0.0\nROL %VB0,B#1,%VB1", "%SM0.0=1 %VB0=16#81", 1, "%VB1=3"},
    {"ROR", "LD %SM0.0\nROR %VW0,B#1,%VW2", "%SM0.0=1 %VW0=1", 1, "%VW2:WORD=16#8000"},
    {"DI_TO_I keeps the low word", "LD %SM0.0\nDI_TO_I %VD0,%VW4", "%SM0.0=1 %VD0=65541", 1, "%VW4=5"},
    {"I_TO_DI keeps the sign", "LD %SM0.0\nI_TO_DI %VW0,%VD4", "%SM0.0=1 %VW0:INT=-2", 1, "%VD4:DINT=-2"},
    {"DI_TO_R", "LD %SM0.0\nDI_TO_R %VD0,%VR4", "%SM0.0=1 %VD0:DINT=-3", 1, "%VR4=-3.0"},
    {"R_TO_DI rounds to even and saturates", "LD %SM0.0\nR_TO_DI %VR0,%VD4\nR_TO_DI %VR8,%VD12", "%SM0.0=1 %VR0=2.5 %VR8=1e20", 1, "%VD4=2 %VD12=2147483647"},
    {"B_TO_I", "LD %SM0.0\nB_TO_I %VB0,%VW4", "%SM0.0=1 %VB0=200", 1, "%VW4=200"},
    {"I_TO_B keeps the low byte", "LD %SM0.0\nI_TO_B %VW0,%VB4", "%SM0.0=1 %VW0=16#1FF", 1, "%VB4=255"},
    {"two networks", "(* Network 0 *)\nLD %M0.0\nST %M1.0\n(* Network 1 *)\nLD %M1.0\nST %M1.1", "%M0.0=1", 1, "%M1.1=1"},
    {"END ends the program", "(* Network 0 *)\nLD %SM0.0\nST %M1.0\nEND", "%SM0.0=1", 1, "%M1.0=1"},
    {"flow goes on behind an edge", "LD %M0.4\nR_TRIG\nMOVE DI#100,%VD208\nST %M1.4", "%M0.4=1", 1, "%VD208=100 %M1.4=1"},
};

TEST(KincoProgramTest, eachInstructionDoesWhatItsHelpSays)
{
    for (const ProgramRow& row : Rows) {
        ProgramBench bench("kinco", "KS101M-04DX", std::string("(* Network 0 *)\n") + (std::string_view(row.text).starts_with("(*") ? row.text + 16 : row.text) + "\n");
        const std::string wrong = bench.build();
        ASSERT_EQ(wrong.find("error"), std::string::npos) << row.what << "\n" << wrong;
        bench.set(row.before);
        for (int scan = 0; scan < row.scans; ++scan)
            bench.scan();
        EXPECT_EQ(bench.differences(row.after), "") << row.what;
    }
}

TEST(KincoProgramTest, timersCountInTheirBases)
{
    // T0: 1 ms, T4: 10 ms, T20: 100 ms.
    ProgramBench bench("kinco", "KS101M-04DX",
                       "(* Network 0 *)\nLD %M0.0\nTON T0,3\nST %M1.0\n"
                       "(* Network 1 *)\nLD %M0.0\nTON T4,3\nST %M1.1\n"
                       "(* Network 2 *)\nLD %M0.0\nTON T20,3\nST %M1.2\n"
                       "(* Network 3 *)\nLD %M0.0\nTOF T5,2\nST %M1.3\n"
                       "(* Network 4 *)\nLD %M0.0\nTP T6,2\nST %M1.4\n"
                       "(* Network 5 *)\nLD T4\nMOVE T4,%VW0\n");
    ASSERT_EQ(bench.build(), "");
    bench.set("%M0.0=1");
    bench.scan();
    for (int i = 0; i < 3; ++i)
        bench.scan();
    EXPECT_EQ(bench.differences("%M1.0=1 %M1.1=0 %M1.2=0 %M1.3=1 %M1.4=1"), "");
    for (int i = 0; i < 27; ++i)
        bench.scan();
    EXPECT_EQ(bench.differences("%M1.1=1 %M1.2=0 %M1.4=0 %VW0=3"), "");
    bench.set("%M0.0=0");
    bench.scan();
    bench.scan(19ms);
    EXPECT_EQ(bench.differences("%M1.0=0 %M1.1=0 %M1.3=1"), "");
    bench.scan();
    EXPECT_EQ(bench.differences("%M1.3=0"), "");
}

TEST(KincoProgramTest, countersCountResultsAndTheirPins)
{
    ProgramBench bench("kinco", "KS101M-04DX",
                       "(* Network 0 *)\nLD %M0.0\nCTU C0,%M0.1,2\nST %M1.0\n"
                       "(* Network 1 *)\nLD %M0.0\nCTD C1,%M0.1,1\nST %M1.1\n"
                       "(* Network 2 *)\nLD %M0.0\nCTUD C2,%M0.2,%M0.3,%M0.1,3,%M1.3\nST %M1.2\n");
    ASSERT_EQ(bench.build(), "");
    bench.set("%M0.1=1");
    bench.scan();
    EXPECT_EQ(bench.differences("%M1.0=0 %M1.1=0 %M1.2=1 %M1.3=0 C2:INT=3"), "") << "LD loads, R of CTU resets";
    bench.set("%M0.1=0 %M0.0=1");
    bench.scan();
    EXPECT_EQ(bench.differences("C0:INT=1 C1:INT=0 %M1.1=1 C2:INT=4"), "");
    bench.set("%M0.0=0 %M0.2=1");
    bench.scan();
    EXPECT_EQ(bench.differences("C2:INT=3 %M1.2=1"), "");
    bench.set("%M0.3=1");
    bench.scan();
    EXPECT_EQ(bench.differences("C2:INT=0 %M1.2=0 %M1.3=1"), "");
}

TEST(KincoProgramTest, subroutinesHaveTheirOwnLocalsAndReturn)
{
    ProgramBench bench("kinco", "KS101M-04DX",
                       "(* Network 0 *)\nLD %SM0.0\nMOVE 7,%LW0\nCAL Sub\nMOVE %LW0,%VW0\n",
                       {{"Sub", {ProgramRole::Subroutine, "(* Network 0 *)\nLD %SM0.0\nMOVE 9,%LW0\nMOVE %LW0,%VW2\nRET\nMOVE 1,%VW4\n"}}});
    ASSERT_EQ(bench.build(), "");
    bench.set("%SM0.0=1");
    bench.scan();
    EXPECT_EQ(bench.differences("%VW0=7 %VW2=9 %VW4=0"), "");
}

/// Takes down what it is asked, as the engine would see it.
struct Recorder : BlockHost {
    std::vector<std::string> calls;

    void call(InstructionId instruction, const BlockInstance& instance, PinValues& pins) override
    {
        std::string text = std::to_string(static_cast<int>(instruction)) + "#" + std::to_string(instance.number) + (instance.enabled ? "+" : "-");
        for (std::size_t p = 0; p < pins.count(); ++p)
            text += pins.isConstant(p) ? " =" + formatValue(pins.read(p)) : " " + std::string(name(pins.read(p).type));
        calls.push_back(text);
    }
};

// KS-MC-12, -18, -19, -22: EN = 0 means something to them.
TEST(KincoProgramTest, motionBlocksAreCalledWithEnOnAndOff)
{
    ProgramBench bench("kinco", "KS101M-04DX",
                       "(* Network 0 *)\nLD %M0.0\nMC_RPARAS %M0.1, 1, %VB100, 3, %M0.2, %M0.3, %MD8, %VD1200\n"
                       "(* Network 1 *)\nLD %M0.0\nMC_POWER %M0.4, 1, %M0.5, %M0.6, %MB20\nST %M1.0\n");
    ASSERT_EQ(bench.build(), "");
    Recorder recorder;
    bench.setHost(&recorder);
    bench.scan();
    bench.set("%M0.0=1");
    bench.scan();
    ASSERT_EQ(recorder.calls.size(), 4u);
    EXPECT_EQ(recorder.calls[0], "1207#0- BOOL =1 BYTE =3 BOOL BOOL DWORD DWORD");
    EXPECT_EQ(recorder.calls[3], "1200#1+ BOOL =1 BOOL BOOL BYTE");
    EXPECT_EQ(bench.differences("%M1.0=1"), "") << "CR unchanged";
}

// KS-IL-09: Appendix A, EX1 (with GE) and EX2.
TEST(KincoProgramTest, theManualsExamplesRun)
{
    ProgramBench bench("kinco", "KS101M-04DX",
                       "(* Network 0 *)\nLD %SM0.0\nMOVE B#0,%VB100\nMOVE B#3,%VB101\nMOVE B#8,%VB102\n"
                       "(* Network 1 *)\nLD %M0.0\nMC_RPARAS %M0.1, 1, %VB100, 3, %M0.2, %M0.3, %MD8, %VD1200\n"
                       "(* Network 2 *)\nLD %SM0.0\nMOVE %VR1200,%VR300\n"
                       "(* Network 3 *)\nLD %SM0.0\nDI_TO_I %VD1204,%VW304\n"
                       "(* Network 4 *)\nLD %SM0.0\nDI_TO_I %VD1208,%VW308\nGE %VW308, 0\nST %M3.0\n");
    ASSERT_EQ(bench.build(), "");
    bench.set("%SM0.0=1 %VR1200=1200.0 %VD1204=8 %VD1208:DINT=-1");
    bench.scan();
    EXPECT_EQ(bench.differences("%VB101=3 %VR300=1200.0 %VW304=8 %M3.0=0"), "");
}

// KS-IL-09: EX3 and EX4 compile for a KS105; the block is called and does nothing here.
TEST(KincoProgramTest, pulseExamplesCompileForAKs105)
{
    ProgramBench bench("kinco", "KS105-16DT",
                       "(* Network 0 *)\nLD %SM0.0\nPHOME 0, %M0.0, %M0.1, %M0.2, %VW0, %VW2, %VW4, %VD6, %VW10, %M0.4, %M0.5, %MB1\n"
                       "(* Network 1 *)\nLD %M0.4\nR_TRIG\nMOVE DI#100, %SMD208\nST %SM201.4\n");
    const std::string wrong = bench.build();
    ASSERT_EQ(wrong.find("error"), std::string::npos) << wrong;
    bench.set("%M0.4=1");
    bench.scan();
    EXPECT_EQ(bench.differences("%SMD208=100 %SM201.4=1"), "");
    bench.scan();
    EXPECT_EQ(bench.differences("%SM201.4=0"), "");
}

TEST(KincoProgramTest, instructionsKnowTheirLine)
{
    ProgramBench bench("kinco", "KS101M-04DX", "(* Network 0 *)\nLD %SM0.0\nDIV %VW0,%VW2,%VW4\n");
    ASSERT_EQ(bench.build(), "");
    bench.set("%SM0.0=1");
    const ScanReport report = bench.scan();
    EXPECT_EQ(report.faults, 1u);
    const Place place = sourceOf(bench.image(), report.routine, report.instruction);
    EXPECT_EQ(place.object.name, "Main");
    EXPECT_EQ(place.range.line, 3u);
}

} // namespace
