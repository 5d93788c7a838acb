#include "tests/core/language/lowering/programbench.h"

using namespace camwright;
using namespace camwright::test;

namespace {

// The wider core of Kinco: forms common in this tool family (docs/families.md), values computed by hand. KS-IL-06, KS-IL-07,
// KS-CPU-20 for the clock.
const ProgramRow Rows[] = {
    {"BLKMOVE", "LD %SM0.0\nBLKMOVE %VB0, %VB10, 3", "%SM0.0=1 %VB0=1 %VB1=2 %VB2=3 %VB3=4", 1, "%VB10=1 %VB11=2 %VB12=3 %VB13=0"},
    {"BLKMOVE overlapping", "LD %SM0.0\nBLKMOVE %VB0, %VB1, 3", "%SM0.0=1 %VB0=1 %VB1=2 %VB2=3", 1, "%VB0=1 %VB1=1 %VB2=2 %VB3=3"},
    {"BLKMOVE of a negative count", "LD %SM0.0\nBLKMOVE %VB0, %VB10, %VW20", "%SM0.0=1 %VB0=1 %VW20=-1", 1, "%VB10=0"},
    {"BLKMOVE beyond the area", "LD %SM0.0\nBLKMOVE %VB16380, %VB0, %VW20", "%SM0.0=1 %VB16380=7 %VW20=5", 1, "%VB0=0"},
    {"BLKMOVE without flow", "LD %M0.0\nBLKMOVE %VB0, %VB10, 3", "%VB0=1", 1, "%VB10=0"},
    {"FILL", "LD %SM0.0\nFILL B#16#AA, %VB10, 2", "%SM0.0=1", 1, "%VB10=16#AA %VB11=16#AA %VB12=0"},
    {"FILL of nothing", "LD %SM0.0\nFILL B#16#AA, %VB10, 0", "%SM0.0=1", 1, "%VB10=0"},
    {"SWAP of a word", "LD %SM0.0\nSWAP %MW0", "%SM0.0=1 %MW0=16#1234", 1, "%MW0=16#3412"},
    {"SWAP of a double word", "LD %SM0.0\nSWAP %MD0", "%SM0.0=1 %MD0:DWORD=16#12345678", 1, "%MD0:DWORD=16#56781234"},
    {"NEG", "LD %SM0.0\nNEG %VW0, %VW2", "%SM0.0=1 %VW0=5", 1, "%VW2=-5"},
    {"NEG of the smallest", "LD %SM0.0\nNEG %VW0, %VW2", "%SM0.0=1 %VW0=-32768", 1, "%VW2=-32768"},
    {"SQRT", "LD %SM0.0\nSQRT %VR0, %VR4", "%SM0.0=1 %VR0=6.25", 1, "%VR4=2.5"},
    {"SQRT of a negative number is the one NaN", "LD %SM0.0\nSQRT %VR0, %VR4", "%SM0.0=1 %VR0=-1", 1, "%VD4:DWORD=16#7FC00000"},
    {"SIN", "LD %SM0.0\nSIN 1.0, %VR4", "%SM0.0=1", 1, "%VR4=0.84147096"},
    {"COS", "LD %SM0.0\nCOS 1.0, %VR4", "%SM0.0=1", 1, "%VR4=0.5403023"},
    {"TAN", "LD %SM0.0\nTAN 1.0, %VR4", "%SM0.0=1", 1, "%VR4=1.5574077"},
    {"ASIN ACOS ATAN", "LD %SM0.0\nASIN 0.5, %VR4\nACOS 0.5, %VR8\nATAN 1.0, %VR12", "%SM0.0=1", 1, "%VR4=0.5235988 %VR8=1.0471976 %VR12=0.7853982"},
    {"ASIN of 2 is no number", "LD %SM0.0\nASIN 2.0, %VR4", "%SM0.0=1", 1, "%VD4:DWORD=16#7FC00000"},
    {"LN LOG EXP", "LD %SM0.0\nLN 10.0, %VR4\nLOG 1000.0, %VR8\nEXP 1.0, %VR12", "%SM0.0=1", 1, "%VR4=2.3025851 %VR8=3 %VR12=2.7182817"},
    {"EXP too large is infinite", "LD %SM0.0\nEXP 1000.0, %VR4", "%SM0.0=1", 1, "%VD4:DWORD=16#7F800000"},
    {"LN of 0 is minus infinity", "LD %SM0.0\nLN 0.0, %VR4", "%SM0.0=1", 1, "%VD4:DWORD=16#FF800000"},
    {"ENCO DECO", "LD %SM0.0\nENCO %VW0, %VB4\nDECO B#9, %VW6", "%SM0.0=1 %VW0=16#50", 1, "%VB4=4 %VW6=512"},
    {"ENCO of 0", "LD %SM0.0\nENCO %VW0, %VB4", "%SM0.0=1 %VB4=9", 1, "%VB4=0"},
    {"DECO of 15 is the sign bit", "LD %SM0.0\nDECO B#31, %VW6", "%SM0.0=1", 1, "%VW6:WORD=16#8000"},
    {"SEG", "LD %SM0.0\nSEG B#10, %VB4\nSEG B#0, %VB5", "%SM0.0=1", 1, "%VB4=16#77 %VB5=16#3F"},
    {"TRUNC cuts, R_TO_DI rounds", "LD %SM0.0\nTRUNC %VR0, %VD4\nR_TO_DI %VR0, %VD8", "%SM0.0=1 %VR0=-2.75", 1, "%VD4=-2 %VD8=-3"},
    {"TRUNC saturates", "LD %SM0.0\nTRUNC %VR0, %VD4", "%SM0.0=1 %VR0=1e20", 1, "%VD4=2147483647"},
    {"I_TO_BCD", "LD %SM0.0\nI_TO_BCD %VW0, %VW4", "%SM0.0=1 %VW0=9876", 1, "%VW4:WORD=16#9876"},
    {"I_TO_BCD of 10000 leaves OUT", "LD %SM0.0\nI_TO_BCD %VW0, %VW4", "%SM0.0=1 %VW0=10000 %VW4=7", 1, "%VW4=7"},
    {"I_TO_BCD of -1 leaves OUT", "LD %SM0.0\nI_TO_BCD %VW0, %VW4", "%SM0.0=1 %VW0=-1 %VW4=7", 1, "%VW4=7"},
    {"BCD_TO_I", "LD %SM0.0\nBCD_TO_I %VW0, %VW4", "%SM0.0=1 %VW0:WORD=16#9876", 1, "%VW4=9876"},
    {"BCD_TO_I of no digit leaves OUT", "LD %SM0.0\nBCD_TO_I %VW0, %VW4", "%SM0.0=1 %VW0:WORD=16#00A0 %VW4=7", 1, "%VW4=7"},
    {"SHL by the width gives 0", "LD %SM0.0\nSHL %VB0, B#8, %VB1\nSHL %VB0, B#255, %VB2", "%SM0.0=1 %VB0=255 %VB1=9 %VB2=9", 1, "%VB1=0 %VB2=0"},
    {"ROL counts modulo the width", "LD %SM0.0\nROL %VB0, B#9, %VB1", "%SM0.0=1 %VB0=16#81", 1, "%VB1=3"},
    {"DIV of the smallest by -1 wraps", "LD %SM0.0\nDIV %VW0, -1, %VW2", "%SM0.0=1 %VW0=-32768", 1, "%VW2=-32768"},
    {"MOD by 0 leaves OUT", "LD %SM0.0\nMOD %VW0, 0, %VW2", "%SM0.0=1 %VW0=5 %VW2=3", 1, "%VW2=3"},
    {"JMPC over", "LD %M0.0\nJMPC end\nINC %VW0\n(* Network 1 *)\nLBL end\n(* Network 2 *)\nLD %M0.0\nST %M1.0", "%M0.0=1", 1, "%VW0=0 %M1.0=1"},
    {"JMPC not taken keeps the flow", "LD %M0.0\nJMPC 7\n(* Network 1 *)\nLD %SM0.0\nINC %VW0\n(* Network 2 *)\nLBL 7", "%SM0.0=1", 1, "%VW0=1"},
    {"JMPCN", "LD %M0.0\nJMPCN skip\nINC %VW0\n(* Network 1 *)\nLBL SKIP", "", 1, "%VW0=0"},
    {"JMP whatever the flow", "LD %M0.0\nJMP skip\n(* Network 1 *)\nLD %SM0.0\nINC %VW0\n(* Network 2 *)\nLBL skip", "%SM0.0=1", 1, "%VW0=0"},
    {"a jump back is a loop", "LD %SM0.0\nLBL again\n(* Network 1 *)\nLD %SM0.0\nINC %VW0\nLT %VW0, 5\nJMPC again", "%SM0.0=1", 1, "%VW0=5"},
    {"FOR NEXT", "LD %SM0.0\nFOR %VW0, 1, 4\n(* Network 1 *)\nLD %SM0.0\nADD %VW2, %VW0, %VW2\n(* Network 2 *)\nNEXT", "%SM0.0=1", 1, "%VW2=10 %VW0=4"},
    {"FOR not at all", "LD %SM0.0\nFOR %VW0, 5, 4\n(* Network 1 *)\nLD %SM0.0\nINC %VW2\n(* Network 2 *)\nNEXT", "%SM0.0=1", 1, "%VW2=0 %VW0=5"},
    {"FOR without flow", "LD %M0.0\nFOR %VW0, 1, 4\n(* Network 1 *)\nLD %SM0.0\nINC %VW2\n(* Network 2 *)\nNEXT", "%SM0.0=1", 1, "%VW2=0 %VW0=0"},
    {"FOR up to the last INT", "LD %SM0.0\nFOR %VW0, 32766, 32767\n(* Network 1 *)\nLD %SM0.0\nINC %VW2\n(* Network 2 *)\nNEXT", "%SM0.0=1", 1, "%VW2=2 %VW0=32767"},
    {"FOR in FOR", "LD %SM0.0\nFOR %VW0, 1, 3\n(* Network 1 *)\nLD %SM0.0\nFOR %VW4, 1, %VW0\n(* Network 2 *)\nLD %SM0.0\nINC %VW2\n(* Network 3 *)\nNEXT\n(* Network 4 *)\nNEXT",
     "%SM0.0=1", 1, "%VW2=6"},
    {"READ_RTC begins at 1 January 2000, a Saturday", "LD %SM0.0\nREAD_RTC %VB0", "%SM0.0=1", 1, "%VB0=0 %VB1=1 %VB2=1 %VB3=0 %VB5=0 %VB7=6"},
    {"SET_RTC and RTC_R over the leap day", "LD %M0.0\nSET_RTC %VB0\n(* Network 1 *)\nLD %SM0.0\nRTC_R %VW20, %VW22, %VW24, %VW26, %VW28, %VW30, %VW32",
     "%SM0.0=1 %M0.0=1 %VB0=16#24 %VB1=2 %VB2=16#29 %VB3=16#23 %VB4=16#59 %VB5=16#58", 1, "%VW20=2024 %VW22=2 %VW24=29 %VW26=23 %VW28=59 %VW30=58 %VW32=4"},
    {"SET_RTC to no date changes nothing", "LD %M0.0\nSET_RTC %VB0\n(* Network 1 *)\nLD %SM0.0\nRTC_R %VW20, %VW22, %VW24, %VW26, %VW28, %VW30, %VW32",
     "%SM0.0=1 %M0.0=1 %VB0=16#23 %VB1=2 %VB2=16#29", 1, "%VW20=2000 %VW24=1"},
    {"RTC_W", "LD %SM0.0\nRTC_W 2026, 11, 22, 10, 30, 0, %V0.0\nRTC_R %VW20, %VW22, %VW24, %VW26, %VW28, %VW30, %VW32", "%SM0.0=1", 1, "%VW20=2026 %VW22=11 %VW28=30 %VW32=7 %VB0=0"},
    {"RTC_W of 25 hours", "LD %SM0.0\nRTC_W 2026, 11, 22, 25, 30, 0, %V0.0", "%SM0.0=1", 1, "%VB0=1"},
};

TEST(WiderKincoTest, eachInstructionDoesWhatItsHelpSays)
{
    for (const ProgramRow& row : Rows) {
        ProgramBench bench("kinco", "KS101M-04DX", "(* Network 0 *)\n" + std::string(row.text) + "\n");
        const std::string wrong = bench.build();
        ASSERT_EQ(wrong.find("error"), std::string::npos) << row.what << "\n" << wrong;
        bench.set(row.before);
        for (int scan = 0; scan < row.scans; ++scan)
            bench.scan();
        EXPECT_EQ(bench.differences(row.after), "") << row.what;
    }
}

TEST(WiderKincoTest, anEndlessLoopEndsInTheWatchdog)
{
    ProgramBench bench("kinco", "KS101M-04DX", "(* Network 0 *)\nLBL a\n(* Network 1 *)\nLD %SM0.0\nINC %VW0\nJMP a\n");
    ASSERT_EQ(bench.build().find("error"), std::string::npos);
    EXPECT_EQ(bench.scan().end, ScanEnd::OutOfOperations);
}

TEST(WiderKincoTest, theClockGoesOnOverMidnight)
{
    ProgramBench bench("kinco", "KS101M-04DX", "(* Network 0 *)\nLD %M0.0\nRTC_W 2099, 12, 31, 23, 59, 59, %V0.0\n(* Network 1 *)\nLD %SM0.0\n"
                       "RTC_R %VW20, %VW22, %VW24, %VW26, %VW28, %VW30, %VW32\n");
    ASSERT_EQ(bench.build().find("error"), std::string::npos);
    bench.set("%SM0.0=1 %M0.0=1");
    bench.scan();
    bench.set("%M0.0=0");
    bench.scan(1s);
    EXPECT_EQ(bench.differences("%VW20=2000 %VW22=1 %VW24=1 %VW26=0 %VW30=0"), "") << "a century has 36525 days";
}

} // namespace
