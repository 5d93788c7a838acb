#include "tests/core/language/lowering/programbench.h"

#include <fstream>
#include <iterator>

using namespace camwright;
using namespace camwright::test;

namespace {

// The wider core of the TS600: forms common in this vendor's families (docs/families.md), values computed by hand or printed.
// TS-MEM-04, TS-MEM-05, TS-MEM-09, TS-MB-05 (check codes), TS-INS-01.
const ProgramRow Rows[] = {
    {"BMOV overlapping", "LD X0\nBMOV D0 D1 3", "X0=1 D0=1 D1=2 D2=3", 1, "D0=1 D1=1 D2=2 D3=3"},
    {"BMOV beyond the area sets SM24", "LD X0\nBMOV D32766 D0 D100", "X0=1 D32766=7 D100=3", 1, "D0=0 SM24=1"},
    {"BMOV of a negative count sets SM24", "LD X0\nBMOV D0 D10 D100", "X0=1 D0=7 D100=-1", 1, "D10=0 SM24=1"},
    {"FMOV DFMOV", "LD X0\nFMOV 7 D0 2\nDFMOV 65537 D10 2", "X0=1", 1, "D0=7 D1=7 D2=0 D10=1 D11=1 D12=1 D13=1 D14=0"},
    {"SWAP XCH DXCH", "LD X0\nSWAP D0\nXCH D1 D2\nDXCH D4 D6", "X0=1 D0:WORD=16#1234 D1=1 D2=2 D4:DINT=70000 D6:DINT=-1", 1,
     "D0:WORD=16#3412 D1=2 D2=1 D4:DINT=-1 D6:DINT=70000"},
    {"SMOV decimal", "LD X0\nSMOV D0 4 2 D1 3", "X0=1 D0=1234 D1=9876", 1, "D1=9126"},
    {"SMOV hexadecimal", "LD X0\nSMOV D0 4 2 D1 3", "X0=1 SM34=1 D0:WORD=16#ABCD D1:WORD=16#1234", 1, "D1:WORD=16#1AB4"},
    {"SMOV of a number without four digits", "LD X0\nSMOV D0 4 2 D1 3", "X0=1 D0=-1 D1=9876", 1, "D1=9876 SM24=1"},
    {"NEG VABS", "LD X0\nNEG D0 D1\nVABS D0 D2\nDNEG D4 D6\nDVABS D4 D8", "X0=1 D0=-32768 D4:DINT=-5", 1, "D1=-32768 D2=-32768 D6:DINT=5 D8:DINT=5"},
    {"RNEG RABS RSQT", "LD X0\nRNEG D0 D2\nRABS D2 D4\nRSQT D0 D6", "X0=1 D0:REAL=6.25", 1, "D2:REAL=-6.25 D4:REAL=6.25 D6:REAL=2.5"},
    {"RSQT of a negative number sets SM22", "LD X0\nRSQT D0 D6", "X0=1 D0:REAL=-1", 1, "D6:DWORD=16#7FC00000 SM22=1"},
    {"MOD DMOD", "LD X0\nMOD D0 3 D1\nDMOD D4 7 D6", "X0=1 D0=-7 D4:DINT=100000", 1, "D1=-1 D6:DINT=5"},
    {"MOD by 0 leaves D and sets SM22", "LD X0\nMOD D0 D1 D2", "X0=1 D0=7 D2=9", 1, "D2=9 SM22=1"},
    {"LDR> ANDR<= ORR=", "LDR> D0 1.5\nANDR<= D2 -2.5\nORR= D4 1.0\nOUT Y0", "D0:REAL=1.75 D2:REAL=-2.5", 1, "Y0=1"},
    {"LDR<> with NaN is on, LDR= is not", "LDR<> D0 D0\nOUT Y0\nLDR= D0 D0\nOUT Y1\nLDR< D0 1.0\nOUT Y2", "D0:DWORD=16#7FC00000", 1, "Y0=1 Y1=0 Y2=0"},
    {"WAND WOR WXOR WINV", "LD X0\nWAND D0 D1 D2\nWOR D0 D1 D3\nWXOR D0 D1 D4\nWINV D0 D5", "X0=1 D0:WORD=16#F0F0 D1:WORD=16#FF00", 1,
     "D2:WORD=16#F000 D3:WORD=16#FFF0 D4:WORD=16#0FF0 D5:WORD=16#0F0F"},
    {"DWAND DWOR DWXOR DWINV", "LD X0\nDWAND D0 D2 D4\nDWOR D0 D2 D6\nDWXOR D0 D2 D8\nDWINV D0 D10", "X0=1 D0:DWORD=16#F0F0F0F0 D2:DWORD=16#FFFF0000", 1,
     "D4:DWORD=16#F0F00000 D6:DWORD=16#FFFFF0F0 D8:DWORD=16#0F0FF0F0 D10:DWORD=16#0F0F0F0F"},
    {"SHL SHR", "LD X0\nSHL D0 D1 4\nSHR D0 D2 4", "X0=1 D0:WORD=16#F00F", 1, "D1:WORD=16#00F0 D2:WORD=16#0F00"},
    {"shifts by the width and more give 0", "LD X0\nSHL D0 D1 16\nSHR D0 D2 255\nDSHL D4 D6 32", "X0=1 D0=-1 D1=9 D2=9 D4:DINT=-1 D6:DINT=9", 1, "D1=0 D2=0 D6:DINT=0"},
    {"ROL ROR count modulo the width", "LD X0\nROL D0 D1 17\nROR D0 D2 1\nDROL D4 D6 1\nDROR D4 D8 33", "X0=1 D0:WORD=16#8001 D4:DWORD=16#80000001", 1,
     "D1:WORD=3 D2:WORD=16#C000 D6:DWORD=3 D8:DWORD=16#C0000000"},
    {"ITD keeps the sign, DTI the low word", "LD X0\nITD D0 D2\nDTI D4 D6", "X0=1 D0=-5 D4:DINT=70000", 1, "D2:DINT=-5 D6=4464"},
    {"FLT DFLT", "LD X0\nFLT D0 D2\nDFLT D4 D6", "X0=1 D0=-5 D4:DINT=16777217", 1, "D2:REAL=-5 D6:REAL=16777216"},
    {"INT DINT cut and saturate", "LD X0\nINT D0 D2\nDINT D0 D4\nINT D6 D8\nINT D10 D12", "X0=1 D0:REAL=-2.75 D6:REAL=1e6 D10:DWORD=16#7FC00000 D12=9", 1, "D2=-2 D4:DINT=-2 D8=32767 D12=0"},
    {"BCD BIN", "LD X0\nBCD D0 D1\nBIN D1 D2\nDBCD D4 D6\nDBIN D6 D8", "X0=1 D0=1234 D4:DINT=12345678", 1, "D1:WORD=16#1234 D2=1234 D6:DWORD=16#12345678 D8:DINT=12345678"},
    {"BCD of 10000 sets SM24", "LD X0\nBCD D0 D1", "X0=1 D0=10000 D1=9", 1, "D1=9 SM24=1"},
    {"BIN of no digit sets SM24", "LD X0\nBIN D0 D1", "X0=1 D0=15 D1=9", 1, "D1=9 SM24=1"},
    {"SEG", "LD X0\nSEG D0 D1", "X0=1 D0=16#19", 1, "D1=16#6F"},
    {"SIN COS TAN", "LD X0\nSIN 1.0 D0\nCOS 1.0 D2\nTAN 1.0 D4", "X0=1", 1, "D0:REAL=0.84147096 D2:REAL=0.5403023 D4:REAL=1.5574077"},
    {"LN LOG EXP", "LD X0\nLN 10.0 D0\nLOG 0.01 D2\nEXP -1.0 D4", "X0=1", 1, "D0:REAL=2.3025851 D2:REAL=-2 D4:REAL=0.36787945"},
    {"ZSET ZRST", "LD X0\nZSET M0 3\nZRST M1 1", "X0=1", 1, "M0=1 M1=0 M2=1 M3=0"},
    {"ZRST over the end sets SM24", "LD X0\nZRST S4094 D0", "X0=1 D0=3 S4094=1", 1, "S4094=1 SM24=1"},
    {"BINDA", "LD X0\nBINDA D0 D10", "X0=1 D0=-42 D13=9", 1, "D10:WORD=16#302D D11:WORD=16#3030 D12:WORD=16#3234 D13=0"},
    {"BINDA keeps the end with SM31", "LD X0\nBINDA D0 D10", "X0=1 SM31=1 D0=32767 D13=9", 1, "D10:WORD=16#3320 D11:WORD=16#3732 D12:WORD=16#3736 D13=9"},
    {"BINDA of the smallest", "LD X0\nBINDA D0 D10", "X0=1 D0=-32768", 1, "D10:WORD=16#332D D12:WORD=16#3836"},
    {"ITA two characters a word", "LD X0\nITA D0 D10 4", "X0=1 D0:WORD=16#0ABC", 1, "D10:WORD=16#4130 D11:WORD=16#4342"},
    {"ITA one character a word", "LD X0\nITA D0 D10 2", "X0=1 SM32=1 D0:WORD=16#0ABC", 1, "D10=66 D11=67 D12=0"},
    {"ATI", "LD X0\nATI D10 D0 4", "X0=1 D10:WORD=16#4130 D11:WORD=16#6342", 1, "D0:WORD=16#0ABC"},
    {"ATI of no digit sets SM24", "LD X0\nATI D10 D0 2", "X0=1 D10:WORD=16#4747 D0=9", 1, "D0=9 SM24=1"},
    {"CRC16 of the manual's frame", "LD X0\nCRC16 D0 6 D10", "X0=1 D0:WORD=16#0301 D1:WORD=16#0100 D2:WORD=16#0100", 1, "D10:WORD=16#CAD5"},
    {"CRC16 a byte a word", "LD X0\nCRC16 D0 6 D10", "X0=1 SM32=1 D0=1 D1=3 D2=0 D3=1 D4=0 D5=1", 1, "D10:WORD=16#CAD5"},
    {"LRC of the manual's frame", "LD X0\nLRC D0 6 D10", "X0=1 D0:WORD=16#0301 D1:WORD=16#0100 D2:WORD=16#0100", 1, "D10=250"},
    {"CCITT of 123456789 (XMODEM)", "LD X0\nCCITT D0 9 D10", "X0=1 D0:WORD=16#3231 D1:WORD=16#3433 D2:WORD=16#3635 D3:WORD=16#3837 D4:WORD=16#0039", 1, "D10:WORD=16#31C3"},
    {"CD: sum and parity", "LD X0\nCD D0 3 D10", "X0=1 D0:WORD=16#FF01 D1:WORD=16#0010", 1, "D10=272 D11=238"},
    {"SORTR by the second column", "LD X0\nSORTR D0 3 2 D10 2", "X0=1 D0=1 D1=30 D2=2 D3=-10 D4=3 D5=20", 1, "D10=2 D11=-10 D12=3 D13=20 D14=1 D15=30"},
    {"SORTR downwards", "LD X0\nSORTR D0 3 2 D10 2", "X0=1 SM33=1 D0=1 D1=30 D2=2 D3=-10 D4=3 D5=20", 1, "D10=1 D12=3 D14=2"},
    {"SORTC by the first row", "LD X0\nSORTC D0 2 3 D10 1", "X0=1 D0=3 D1=30 D2=1 D3=10 D4=2 D5=20", 1, "D10=1 D11=10 D12=2 D13=20 D14=3 D15=30"},
    {"SORTR by a column that is not there", "LD X0\nSORTR D0 3 2 D10 3", "X0=1 D0=1", 1, "D10=0 SM24=1"},
    {"BKCOMP", "LD X0\nBKCOMP D0 D10 M0 3", "X0=1 D0=1 D1=2 D2=3 D10=1 D11=9 D12=3 SM35=1", 1, "M0=1 M1=0 M2=1 SM35=0"},
    {"BKCOMP all equal", "LD X0\nBKCOMP D0 D10 M0 2", "X0=1", 1, "M0=1 M1=1 SM35=1"},
    {"TRD begins at 1 January 2000, a Saturday", "LD X0\nTRD D0", "X0=1", 1, "D0=2000 D1=1 D2=1 D3=0 D6=6"},
    {"TWR TRD", "LD X0\nTWR D10\nTRD D0", "X0=1 D10=2026 D11=11 D12=22 D13=10 D14=5 D15=7", 1, "D0=2026 D1=11 D2=22 D3=10 D4=5 D5=7 D6=0"},
    {"TWR of no date sets SM24", "LD X0\nTWR D10\nTRD D0", "X0=1 D10=2026 D11=2 D12=29", 1, "D0=2000 SM24=1"},
    {"CJ over", "LD X0\nCJ 1\nLD X1\nINC D0\nLBL 1\nLD X1\nINC D1", "X0=1 X1=1", 1, "D0=0 D1=1"},
    {"CJ not taken", "LD X0\nCJ 1\nLD X1\nINC D0\nLBL 1\nLD X1\nINC D1", "X1=1", 1, "D0=1 D1=1"},
    {"FOR NEXT", "LD X0\nFOR 5\nLD X0\nINC D0\nNEXT", "X0=1", 2, "D0=10"},
    {"FOR 0", "LD X0\nFOR D1\nLD X0\nINC D0\nNEXT", "X0=1 D1=-1", 1, "D0=0"},
    {"FOR in FOR", "LD X0\nFOR 3\nLD X0\nFOR 4\nLD X0\nINC D0\nNEXT\nNEXT", "X0=1", 1, "D0=12"},
    {"FOR without flow", "LD X1\nFOR 5\nLD X0\nINC D0\nNEXT\nLD X0\nINC D1", "X0=1", 1, "D0=0 D1=1"},
};

TEST(WiderTs600Test, eachInstructionDoesWhatItsHelpSays)
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

// TS-MEM-04: cyclic counters.
TEST(WiderTs600Test, aCyclicCounterBeginsAgain)
{
    ProgramBench bench("invt", "TS635", "LD X0\nCTR C0 3\n");
    ASSERT_EQ(bench.build(), "");
    std::string values;
    for (int pulse = 0; pulse < 7; ++pulse) {
        bench.set("X0=1");
        bench.scan();
        bench.scan(); // a held input counts once
        const Address value = bench.addressOf("C0:INT");
        values += std::to_string(bench.executor().memory().read(value).asInteger());
        values += bench.executor().memory().read(bench.addressOf("C0")).asBool() ? "* " : " ";
        bench.set("X0=0");
        bench.scan();
    }
    EXPECT_EQ(values, "1 2 3* 1 2 3* 1 ");
}

// TS-SBR-03, TS-SBR-04, TS-IL-03: IN at the call, OUT at the return, IN_OUT both; the form of the printed ADD #IN1 #IN2 #OUT1.
TEST(WiderTs600Test, argumentsGoInAndOut)
{
    const ProgramBench::Programs others{{"Mix", {ProgramRole::Subroutine,
        "VAR_INPUT\n  IN1 : INT; (* first *)\n  IN2 : INT;\n  ON : BOOL;\nEND_VAR\nVAR_OUTPUT\n  OUT1 : INT;\nEND_VAR\nVAR_IN_OUT\n  SUM : DINT;\nEND_VAR\n"
        "VAR_TEMP\n  T1 : INT;\nEND_VAR\n// the body\nLD ON\nADD #IN1 #IN2 #OUT1\nDINC SUM\nADD T1 1 T1\n"}}};
    ProgramBench bench("invt", "TS635", "LD X0\nCALL Mix D0 5 X1 D10 D20\nLD X0\nCALL Mix 100 D0 ON:=X1 D11 D20\n", others);
    EXPECT_NE(bench.build().find("CW3207"), std::string::npos) << "arguments have places, not names";
    ProgramBench good("invt", "TS635", "LD X0\nCALL Mix D0 5 X1 D10 D20\nLD X0\nCALL Mix 100 D0 X1 D11 D20\n", others);
    ASSERT_EQ(good.build(), "");
    good.set("X0=1 X1=1 D0=37 D20:DINT=70000");
    good.scan();
    EXPECT_EQ(good.differences("D10=42 D11=137 D20:DINT=70002"), "");
    good.set("X1=0 D0=1");
    good.scan();
    EXPECT_EQ(good.differences("D10=137 D11=137 D20:DINT=70002"), "") << "an output that is not written keeps the last call's value";
}

TEST(WiderTs600Test, aCallMustMatchTheTable)
{
    const ProgramBench::Programs others{{"Mix", {ProgramRole::Subroutine, "VAR_INPUT\n  IN1 : INT;\nEND_VAR\nVAR_OUTPUT\n  OUT1 : REAL;\nEND_VAR\nLD SM0\nFLT IN1 OUT1\n"}}};
    const auto codes = [&](const std::string& call) { return ProgramBench("invt", "TS635", "LD X0\n" + call + "\n", others).build().substr(0, 120); };
    EXPECT_EQ(ProgramBench("invt", "TS635", "LD X0\nCALL Mix D0 D2\n", others).build(), "");
    EXPECT_NE(codes("CALL Mix D0").find("CW3315"), std::string::npos);
    EXPECT_NE(codes("CALL Mix D0 D2 D4").find("CW3315"), std::string::npos);
    EXPECT_NE(codes("CALL Mix X0 D2").find("CW32"), std::string::npos) << "a bit for an INT";
    EXPECT_NE(codes("CALL Mix 1.5 D2").find("CW3216"), std::string::npos) << codes("CALL Mix 1.5 D2");
    EXPECT_NE(codes("CALL Mix 5 2.5").find("CW3213"), std::string::npos) << "a constant cannot take a result";
    EXPECT_NE(codes("CALL Mix ??? D2").find("CW3205"), std::string::npos);
}

Variable variable(const std::string& name, const std::string& type, const std::string& address)
{
    Variable out;
    out.name = name;
    const auto known = dataTypeByName(type);
    out.type = known ? Field<DataType>(*known) : Field<DataType>::typed(type);
    out.address = address;
    return out;
}

VariableTable arrays()
{
    return VariableTable::of({variable("Heights", "INT[4]", "D100"), variable("Flags", "BOOL[3]", "M10"), variable("Long", "DINT [2]", ""),
        variable("Speed", "REAL[2]", "R10"), variable("I", "INT", "D0"), variable("J", "DINT", ""), variable("Order", "INT[2]", "D10")});
}

// TS-IDX-01 … 05, TS-VAR-05, TS-VAR-10
TEST(WiderTs600Test, aVariableChoosesTheElement)
{
    ProgramBench bench("invt", "TS635",
        "LD X0\nMOV Heights[I] D50\nMOV 7 Heights[Order[1]]\nINC Heights[0]\nDMOV 70000 Long[I]\nDMOV Long[1] D52\nRMOV 1.5 Speed[I]\n"
        "LD Flags[I]\nOUT Y0\nLD X0\nOUT Flags[2]\nLD X0\nAND> Heights[I] 40\nOUT Y1\n");
    bench.add({ObjectKind::VariableTable, "Globals"}, arrays());
    ASSERT_EQ(bench.build(), "");
    bench.set("X0=1 D0=1 D11=3 D100=10 D101=41 D102=42 M11=1");
    bench.scan();
    EXPECT_EQ(bench.differences("D50=41 D103=7 D100=11 D52:DINT=70000 R12:REAL=1.5 Y0=1 M12=1 Y1=1 SM23=0"), "");
}

// TS-IDX-09: what is read is 0, what is written goes nowhere (ours).
TEST(WiderTs600Test, aSubscriptOutsideSetsSm23)
{
    ProgramBench bench("invt", "TS635", "LD X0\nMOV Heights[I] D50\nMOV 9 Heights[I]\nLD Flags[I]\nOUT Y0\nLD X1\nMOV Heights[I] D51\n");
    bench.add({ObjectKind::VariableTable, "Globals"}, arrays());
    ASSERT_EQ(bench.build(), "");
    for (const char* index : {"D0=4", "D0=-1", "D0=32767"}) {
        bench.set(std::string("X0=1 D50=5 D51=5 M13=1 D104=3 SM23=0 Y0=1 ") + index);
        const ScanReport report = bench.scan();
        EXPECT_EQ(report.faults, 0u) << index;
        EXPECT_EQ(bench.differences("D50=0 D51=5 D104=3 D99=0 Y0=0 SM23=1"), "") << index;
    }
}

TEST(WiderTs600Test, subscriptsThatAreNoneAreRefused)
{
    const auto codes = [](const std::string& line) {
        ProgramBench bench("invt", "TS635", "LD X0\n" + line + "\n");
        bench.add({ObjectKind::VariableTable, "Globals"}, arrays());
        return bench.build().substr(0, 60);
    };
    EXPECT_EQ(codes("MOV Heights[3] D0"), "");
    for (const auto& [line, code] : std::map<std::string, std::string>{
             {"MOV Heights D0", "CW3320"}, {"MOV Heights[4] D0", "CW3321"}, {"MOV Heights[D0] D0", "CW3322"}, {"MOV Heights[Order[I]] D0", "CW3322"},
             {"MOV Heights[Speed[0]] D0", "CW3322"}, {"MOV Heights[] D0", "CW3322"}, {"MOV Heights[-1] D0", "CW3013"}, {"MOV Heights[I][J] D0", "CW3322"},
             {"MOV I[0] D0", "CW3301"}, {"ZSET Flags[I] 2", "CW3323"}, {"BMOV Heights[I] D0 2", "CW3323"}, {"MOV Heights[Order[2]] D0", "CW3322"},
             {"MOV Flags[0] D0", "CW3210"}, {"SIN Speed[I] D0", "CW3323"}})
        EXPECT_NE(codes(line).find(code), std::string::npos) << line << ": " << codes(line);
    EXPECT_EQ(codes("BMOV Heights[1] D0 2"), "");
}

std::string sample(const std::string& name)
{
    std::ifstream in(CAMWRIGHT_SOURCE_DIR "/tests/data/language/ts600/" + name);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// TS-SBR-04: the printed sample gives 3 + 2 = 5.
TEST(WiderTs600Test, theManualsSubroutineAdds)
{
    ProgramBench bench("invt", "TS635", sample("call.il"), {{"SBR_1", {ProgramRole::Subroutine, sample("sbr_1.il")}}});
    ASSERT_EQ(bench.build(), "");
    bench.set("M0=1 SM0=1");
    bench.scan();
    EXPECT_EQ(bench.differences("D0=5"), "");
}

} // namespace
