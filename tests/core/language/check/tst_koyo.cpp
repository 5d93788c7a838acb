#include "core/language/source/ilwriter.h"
#include "core/language/source/koyodialect.h"
#include "tests/core/language/check/checking.h"

#include <gtest/gtest.h>

#include <ctime>

using namespace camwright;
using namespace camwright::test;

namespace {

const LanguageContext& dl260()
{
    static const LanguageContext out = contextFor("koyo", "DL-260",
        {variable("Lamp", DataType::Bool, "Y0"), variable("Target", DataType::Dword, "V1410"), variable("电机", DataType::Bool, "C5")});
    return out;
}

std::string dataFile(const std::string& path)
{
    const std::string text = readFile(std::string(CAMWRIGHT_SOURCE_DIR) + "/tests/data/language/koyo/" + path);
    EXPECT_FALSE(text.empty()) << path;
    return text;
}

std::vector<std::string> parts(const std::string& text, char separator)
{
    std::vector<std::string> out;
    std::size_t at = 0;
    for (std::size_t end; (end = text.find(separator, at)) != std::string::npos; at = end + 1)
        out.push_back(text.substr(at, end - at));
    out.push_back(text.substr(at));
    return out;
}

std::string unescaped(const std::string& text)
{
    std::string out;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool escapes = text[i] == '\\' && i + 1 < text.size();
        out += !escapes ? text[i] : text[++i] == 'n' ? '\n' : text[i];
    }
    return out;
}

TEST(KoyoCheckTest, malformedSourcesAreLocatedAndCoded) // D2-IBC-01 … 05, D2-IBC-07, D2-IBC-12, D2-REG-02 … 04, D2-PRG-06, C9
{
    std::size_t count = 0;
    for (const std::string& line : parts(dataFile("malformed.tsv"), '\n')) {
        if (line.empty() || line.starts_with('#'))
            continue;
        const std::vector<std::string> fields = parts(line, '\t');
        ASSERT_EQ(fields.size(), 3u) << line;
        const std::string text = unescaped(fields[2]) + "\n";
        const CheckedSources checked = check(dl260(), text);
        EXPECT_EQ(codesOf(checked.diagnostics), fields[1]) << fields[0] << "\n" << text;
        EXPECT_EQ(checked.programs.has_value(), !hasErrors(checked.diagnostics)) << fields[0];
        EXPECT_EQ(writeIl(parseIl(koyoIl(), text)), text) << fields[0];
        ++count;
    }
    EXPECT_GE(count, 300u);
}

TEST(KoyoCheckTest, theProgramsOfTheManualCompile) // D2-REG-02, D2-REG-03, D2-PRG-01 … 05
{
    for (const char* name : {"registers.il", "initialisation.il", "jog.il", "interpolation.il"}) {
        const CheckedSources checked = check(dl260(), dataFile(name));
        EXPECT_EQ(codesOf(checked.diagnostics), "") << name;
        EXPECT_TRUE(checked.programs.has_value()) << name;
    }
}

/// The box, its operands as the sheet's example has them, moved apart where the manual prints them over each other.
struct Box {
    const char* feature;
    const char* line;
};
const Box Boxes[] = {
    {"D2-IB-00", "IB-2000 R5000 R5001 R5040 M100 M101"},
    {"D2-IB-01", "IB-2001 R5000 R5001 R5040 M100 M101 R5002 R5003"},
    {"D2-IB-02", "IB-2002 R5000 R5001 R5040 M100 M101 R5002 R5003 R5004"},
    {"D2-IB-04", "IB-2004 R5000 R5001 R5040 M100 M101"},
    {"D2-IB-05", "IB-2005 R5000 R5001 R5040 M100 M101"},
    {"D2-IB-06", "IB-2006 R5000 R5001 R5040 M100 M101"},
    {"D2-IB-11", "IB-2011 R5000 R5001 R5040 M100 M101 R5002 R5003 R5004"},
    {"D2-IB-12", "IB-2012 R5000 R5001 R5040 M100 M101 R5002 R5003"},
    {"D2-IB-13", "IB-2013 R5000 R5001 R5040 M100 M101 R5002"},
    {"D2-IB-14", "IB-2014 R5000 R5001 R5040 M100 M101 R5002"},
    {"D2-IB-15", "IB-2015 R5000 R5001 R5040 M100 M101 R5002"},
    {"D2-IB-16", "IB-2016 R5000 R5001 R5040 M100 M101 R5002"},
    {"D2-IB-17", "IB-2017 R5000 R5001 R5040 M100 M101 R5002 R5003 R5004"},
    {"D2-IB-20", "IB-2020 R5000 R5001 R5040 M100 M101 R5002"},
    {"D2-IB-21", "IB-2021 R5000 R5001 R5040 M100 M101 R5002 R5003"},
    {"D2-IB-22", "IB-2022 R5000 R5001 R5040 M100 M101 R5002"},
    {"D2-IB-23", "IB-2023 R5000 R5001 R5040 M100 M101 R5003 R5004 R5006 R5010 R5011"},
    {"D2-IB-24", "IB-2024 R5000 R5001 R5040 M100 M101 R5003 R5004 R5006 R5010"},
    {"D2-IB-25", "IB-2025 R5000 R5001 R5040 M100 M101 R5002 R5003 R5005 R5007 R5010 R5011"},
    {"D2-IB-26", "IB-2026 R5000 R5001 R5040 M100 M101 R5002 R5003 R5005 R5006 R5007"},
    {"D2-IB-27", "IB-2027 R5000 R5001 R5040 M100 M101 R5002 R5003 R5004 R5005 R5007"},
    {"D2-IB-28", "IB-2028 R5000 R5001 R5040 M100 M101 R5002 R5003 R5005 R5007"},
    {"D2-IB-40", "IB-2040 R1400 R1440 R2000 R2002 R2003 R2004 R2005 R2006 R2007 R2010 R2012 R2014 R2016 R2020 M0 M10 M20 M30 R2022 R2030 R2023 R2024 M100 M101"},
    {"D2-IB-41", "IB-2041 R1400 R1440 R2000 R2002 R2003 R2004 R2005 R2006 R2007 R2010 R2012 R2014 R2016 R2020 R2022 R2030 R2024 R2025 M100 M101"},
    {"D2-IB-42", "IB-2042 M10 M20 M30 M40 R2000 R2030 R2004 R2005 M100 M101"},
    {"D2-IB-43", "IB-2043 R1400 R1440 R2000 R2002 R2003 R2004 R2005 R2006 R2007 R2030 R2010 R2011 M100 M101"},
    {"D2-IB-44", "IB-2044 R2000 R2002 R2004 R2006 R2010 R2012 M10 M20 M30 M40 R2014 R2030 R2015 R2016 M100 M101"},
    {"D2-IB-45", "IB-2045 R2000 R2001 R2002 R2004 R2005 R2006 R2007 R2010 R2011 R2030 R2012 R2013 M100 M101"},
    {"D2-IB-46", "IB-2046 R2000 R2002 R2004 R2006 R2010 R2012 R2014 R2030 R2015 R2016 M100 M101"},
    {"D2-IB-47", "IB-2047 M10 M20 M30 M40 R2000 R2030 R2004 R2005 M100 M101"},
};

TEST(KoyoCheckTest, everyBoxTakesTheOperandsOfTheSheet) // D2-IB-00 … 47, D2-IBC-01, D2-IBC-04, D2-IBC-06, D2-IBC-09, D2-IBC-10
{
    for (const Box& box : Boxes) {
        const std::string text = "STRN B10003.1\nAND M1002\n" + std::string(box.line) + "\n";
        const CheckedSources checked = check(dl260(), text);
        ASSERT_EQ(codesOf(checked.diagnostics), "") << box.feature;
        const Instruction& instruction = *checked.programs->front().networks.front().rungs.front().statements.back().instruction;
        EXPECT_NE(instruction.sources.find(box.feature), std::string::npos) << box.feature << ' ' << instruction.mnemonic;
        EXPECT_FALSE(instruction.simulated) << box.feature;
        EXPECT_EQ(instruction.whyNotSimulated.en, "I-box motion is not simulated yet.");
        const std::string byName = "STRN B10003.1\nAND M1002\n" + instruction.mnemonic + std::string(box.line).substr(7) + "\n";
        EXPECT_EQ(codesOf(check(dl260(), byName).diagnostics), "") << byName;
    }
}

TEST(KoyoCheckTest, aBoxHasAWorkAreaOfTwentyOrTwentyFiveWords) // D2-IBC-02
{
    for (const Instruction& instruction : dl260().family->catalogue().instructions()) {
        if (instruction.group != "mlink")
            continue;
        const Pin& work = *instruction.findPin("Work");
        const bool interpolates = instruction.mnemonic.starts_with("ML_IP");
        EXPECT_EQ(work.fixedCount, interpolates ? 25u : 20u) << instruction.mnemonic;
        EXPECT_EQ(work.elementBytes, 2u);
        EXPECT_TRUE(work.isPrivate);
        EXPECT_EQ(instruction.findPin("Header") != nullptr, !interpolates) << instruction.mnemonic;
    }
}

TEST(KoyoCheckTest, theLastWorkAreaThatFitsIsTaken) // D2-IBC-02, D2-IBC-07
{
    EXPECT_EQ(codesOf(check(dl260(), "STR M1\nIB-2000 R5000 R5001 R37754 M100 M101\n").diagnostics), "");
    EXPECT_EQ(codesOf(check(dl260(), "STR M1\nIB-2000 R5000 R5001 R37755 M100 M101\n").diagnostics), "CW3219@2:21");
    EXPECT_EQ(codesOf(check(dl260(), "STR M1\nIB-2000 R5000 R5001 R5040 M100 M101\nSTR M2\nIB-2000 R5000 R5001 R5064 M102 M103\n").diagnostics), "");
}

TEST(KoyoCheckTest, namesOfVariablesStandForAddresses)
{
    EXPECT_EQ(codesOf(check(dl260(), "STR 电机\nOUT Lamp\nSTR SP1\nLDD Target\nOUTD V1420\n").diagnostics), "");
    EXPECT_EQ(codesOf(check(dl260(), "STR SP1\nLD Target\n").diagnostics), "CW3214@2:4");
}

TEST(KoyoCheckTest, whatIsDrawnIsWrittenAgainAsTheSameProgram) // lossless IL -> rung -> IL
{
    const std::string text = "// first\nSTR X0\nOR X1\nSTR X2\nOR X3\nAND V1400 K5\nANDSTR\nORE V1401 K7\nOUT Y0\n"
                             "STRN V1400 V1401 // less\nLD K5\nOUT V1400\nTMR T0 K30\nSTR X0\nSTR X1\nCNT CT0 K5\nSTRPD X5\nPD C0\n";
    const ParsedProgram parsed = parseIl(koyoIl(), text);
    EXPECT_EQ(codesOf(parsed.diagnostics), "");
    EXPECT_EQ(writeIl(parsed), text);
    ParsedProgram edited = parsed;
    for (ParsedNetwork& network : edited.networks)
        for (ParsedRung& rung : network.rungs) {
            const auto lines = linearize(koyoIl(), rung.rung);
            ASSERT_TRUE(lines.has_value());
            rung.rung = *lines;
            rung.edited = true;
        }
    const std::string written = writeIl(edited);
    const ParsedProgram again = parseIl(koyoIl(), written);
    ASSERT_EQ(again.networks.size(), parsed.networks.size()) << written;
    for (std::size_t i = 0; i < again.networks.size(); ++i)
        EXPECT_EQ(again.networks[i].rungs[0].rung.drawable, parsed.networks[i].rungs[0].rung.drawable) << i;
    EXPECT_EQ(codesOf(check(dl260(), written).diagnostics), codesOf(check(dl260(), text).diagnostics));
    EXPECT_NE(written.find("AND     V1400 K5"), std::string::npos) << written;
    EXPECT_FALSE(parsed.networks[2].rungs[0].rung.drawable) << "CNT takes two flows: a text rung";
}

TEST(KoyoCheckTest, aSubroutineIsKnownByTheNumberAtItsBeginning)
{
    EXPECT_EQ(subroutineNumber("// third\n\n(* Network 1 *)\r\n sbr k3 // here\r\nSTR X0\n"), "K3");
    EXPECT_EQ(subroutineNumber("STR X0\nSBR K3\n"), "");
    EXPECT_EQ(subroutineNumber("SBR\n"), "");
    EXPECT_EQ(subroutineNumber(""), "");
}

TEST(KoyoCheckTest, twoSubroutinesWithOneNumberAreReported)
{
    const ProgramSource sources[] = {{{ObjectKind::Program, "A"}, ProgramRole::Subroutine, "SBR K1\nRT\n"},
        {{ObjectKind::Program, "B"}, ProgramRole::Subroutine, "SBR K1\nRT\n"}};
    const CheckedSources checked = checkSources(sources, dl260());
    EXPECT_EQ(codesOf(checked.diagnostics), "CW3312@1:5");
    EXPECT_EQ(checked.diagnostics.front().place.object.name, "B");
}

TEST(KoyoCheckTest, hugeAndEndlessTextsTakeLinearTime)
{
    std::string work;
    for (int i = 0; i < 20'000; ++i)
        work += "STR M1\nIB-2000 R5000 R5001 R5040 M100 M101\n";
    const std::clock_t begin = std::clock();
    EXPECT_FALSE(check(dl260(), work).programs.has_value());
    EXPECT_FALSE(check(dl260(), "STR " + std::string(1'000'000, 'K') + "\n").programs.has_value());
    EXPECT_FALSE(check(dl260(), std::string(200'000, '\\') + "\nLD K" + std::string(100'000, '9') + "\n").programs.has_value());
    std::string deep;
    for (int i = 0; i < 50'000; ++i)
        deep += "STR X0\n";
    EXPECT_FALSE(check(dl260(), deep + "OUT Y0\n").programs.has_value());
    EXPECT_LT((std::clock() - begin) / CLOCKS_PER_SEC, 60) << "seconds of processor time";
}

} // namespace
