#include "tests/core/language/check/checking.h"

#include <gtest/gtest.h>

#include <filesystem>

using namespace camwright;
using namespace camwright::test;

namespace {

std::string source(const std::string& path)
{
    const std::string text = readFile(std::string(CAMWRIGHT_SOURCE_DIR) + "/tests/data/language/" + path);
    EXPECT_FALSE(text.empty()) << path;
    return text;
}

std::string statementsOf(const CheckedSources& checked, const LanguageContext& context)
{
    std::string out;
    if (!checked.programs)
        return "no program";
    for (const CheckedNetwork& network : checked.programs->front().networks)
        for (const CheckedRung& rung : network.rungs) {
            EXPECT_TRUE(rung.drawable);
            for (const CheckedStatement& statement : rung.statements)
                out += show(statement, *context.family) + "\n";
        }
    return out;
}

TEST(ExamplesTest, compilesEx1AsListed) // KS-IL-09, Appendix A
{
    const CheckedSources checked = check(ks101m(), source("kinco/ex1.il"));
    EXPECT_EQ(codesOf(checked.diagnostics), "");
    EXPECT_EQ(statementsOf(checked, ks101m()),
        "LD %SM0.0:BOOL\nMOVE 0:BYTE %VB100:BYTE\nMOVE 3:BYTE %VB101:BYTE\nMOVE 8:BYTE %VB102:BYTE\n"
        "LD %M0.0:BOOL\nMC_RPARAS %M0.1:BOOL 1:INT %VB100[3]:BYTE 3:INT %M0.2:BOOL %M0.3:BOOL %MD8:DWORD %VD1200[3]:DWORD\n"
        "LD %SM0.0:BOOL\nMOVE %VR1200:REAL %VR300:REAL\n"
        "LD %SM0.0:BOOL\nDI_TO_I %VD1204:DINT %VW304:INT\n"
        "LD %SM0.0:BOOL\nDI_TO_I %VD1208:DINT %VW308:INT\nGE %VW308:INT 0:INT\nST %M3.0:BOOL\n");
    EXPECT_EQ(checked.size.instructions, 14u); // KS-CPU-02
    EXPECT_EQ(checked.size.motionInstructions, 1u);
}

TEST(ExamplesTest, compilesEx2AndWarnsOfTheListThatIsTooShort) // NUM is printed as 8, three values are prepared
{
    const CheckedSources checked = check(ks101m(), source("kinco/ex2.il"));
    EXPECT_EQ(codesOf(checked.diagnostics), "CW3504@13:21");
    EXPECT_TRUE(statementsOf(checked, ks101m()).ends_with(
        "MC_WPARAS %M1.1:BOOL 1:INT %VB200[8]:BYTE %VD2000[8]:DWORD 8:INT %M1.2:BOOL %M1.3:BOOL %MD14:DWORD\n"));
}

TEST(ExamplesTest, compilesEx3AndEx4ForAModelWithPulseOutputs)
{
    for (const char* example : {"kinco/ex3.il", "kinco/ex4.il"}) {
        const CheckedSources checked = check(ks105(), source(example));
        EXPECT_EQ(codesOf(checked.diagnostics), "") << example;
        EXPECT_NE(statementsOf(checked, ks105()).find("PHOME 0:INT %M0.0:BOOL %M0.1:BOOL %M0.2:BOOL %VW0:INT %VW2:INT %VW4:WORD %VD6:DWORD "
            "%VW10:WORD %M0.4:BOOL %M0.5:BOOL %MB1:BYTE\n"), std::string::npos);
        EXPECT_EQ(codesOf(check(ks101m(), source(example)).diagnostics), "CW3401@3:1") << example;
    }
}

TEST(ExamplesTest, compilesTheTs600Marquee)
{
    const CheckedSources checked = check(ts635(), source("ts600/marquee.il"));
    EXPECT_EQ(codesOf(checked.diagnostics), "");
    EXPECT_TRUE(checked.programs);
}

TEST(ExamplesTest, numbersHiddenMemoryDensely)
{
    const CheckedSources checked = check(ks105(), source("kinco/ex3.il"));
    ASSERT_TRUE(checked.programs);
    const CheckedProgram& program = checked.programs->front();
    EXPECT_EQ(program.instances, 2u);
    EXPECT_EQ(program.networks[0].rungs[0].statements[1].instance, 0u); // PHOME
    EXPECT_EQ(program.networks[1].rungs[0].statements[1].instance, 1u); // R_TRIG
    EXPECT_EQ(program.networks[1].rungs[0].statements[2].instance, NoInstance);
}

/// Every file of tests/data/language/damaged names its codes in a line "(* expect: CW3005@4:6 *)" or "// expect: ..." at
/// its end, so that the folder can be tried with the command line too.
TEST(ExamplesTest, locatesEveryDamagedForm) // KS-IL-09
{
    int files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(CAMWRIGHT_SOURCE_DIR "/tests/data/language/damaged")) {
        if (entry.path().extension() != ".il")
            continue;
        ++files;
        const std::string text = readFile(entry.path().string());
        const std::size_t at = text.rfind("expect: ");
        ASSERT_NE(at, std::string::npos) << entry.path();
        std::string expected = text.substr(at + 8, text.find('\n', at) - at - 8);
        if (expected.ends_with(" *)"))
            expected.resize(expected.size() - 3);
        const bool ts600 = entry.path().stem().string().starts_with("ts600");
        const bool pulse = text.find("PHOME") != std::string::npos;
        const CheckedSources checked = check(ts600 ? ts635() : pulse ? ks105() : ks101m(), text);
        EXPECT_EQ(codesOf(checked.diagnostics), expected) << entry.path();
        EXPECT_FALSE(checked.programs) << entry.path();
    }
    EXPECT_GE(files, 10);
}

TEST(ExamplesTest, survivesTheRawPagesOfTheManuals)
{
    for (const char* path : {"raw/000_L302-351.txt", "raw/000_L393-422.txt", "raw/001_L1075-1091.txt", "raw/001_L1105-1123.txt"}) {
        const std::string text = source(path);
        const CheckedSources checked = check(ks105(), text);
        EXPECT_FALSE(checked.programs) << path;
        EXPECT_LE(checked.diagnostics.size(), 25u) << path << codesOf(checked.diagnostics);
        EXPECT_EQ(writeIl(parseIl(kincoIl(), text)), text);
    }
}

} // namespace
