#include "tests/core/language/check/checking.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace camwright;
using namespace camwright::test;

namespace {

LanguageContext withPrograms(const std::string& model, std::vector<KnownProgram> programs)
{
    LanguageContext out = contextFor("kinco", model);
    out.programs = std::move(programs);
    return out;
}

CheckedSources checkAll(const LanguageContext& context, const std::vector<std::pair<std::string, std::string>>& texts)
{
    std::vector<ProgramSource> sources;
    for (const auto& [name, text] : texts)
        sources.push_back({{ObjectKind::Program, name}, context.findProgram(name)->role, text});
    return checkSources(sources, context);
}

const std::string Head = "(* Network 0 *)\nLD %SM0.0\n";

TEST(ProjectRulesTest, refusesRecursion)
{
    const LanguageContext context = withPrograms("KS101M-04DX",
        {{"Main", ProgramRole::Main}, {"A", ProgramRole::Subroutine}, {"B", ProgramRole::Subroutine}, {"C", ProgramRole::Subroutine}});
    const CheckedSources checked = checkAll(context,
        {{"Main", Head + "CAL A\n"}, {"A", Head + "CAL B\nCAL C\n"}, {"B", Head + "CAL A\nCAL B\n"}, {"C", Head + "MOVE 1, %VW0\n"}});
    EXPECT_EQ(codesOf(checked.diagnostics), "CW3306@3:5 CW3306@4:5");
    EXPECT_EQ(checked.diagnostics[0].place.object.name, "B");
    EXPECT_EQ(englishText(checked.diagnostics[0]), "This call leads back to A: A > B > A. A controller of this family cannot do that.");
}

TEST(ProjectRulesTest, countsInstructionsAgainstTheModel) // KS-CPU-02
{
    const auto program = [](unsigned networks) {
        std::string out;
        for (unsigned i = 0; i < networks; ++i)
            out += "(* Network " + std::to_string(i) + " *)\nLD %M0.0\nAND %M0.1\nS %M0.2\nR %M0.3\n";
        return out;
    };
    const LanguageContext small = contextFor("kinco", "KS105-16DT");
    const CheckedSources fits = check(small, program(1024));
    EXPECT_EQ(codesOf(fits.diagnostics), "");
    EXPECT_EQ(fits.size.instructions, 4096u);
    const CheckedSources tooLarge = check(small, program(1024) + "(* Network 1024 *)\nLD %M0.0\nS %M0.1\n");
    EXPECT_EQ(codesOf(tooLarge.diagnostics), "CW3402@5122:1");
    EXPECT_EQ(englishText(tooLarge.diagnostics[0]), "The programs have 4098 instructions, a KS105-16DT holds 4096.");
    EXPECT_EQ(codesOf(check(ks101m(), program(1025)).diagnostics), "");
}

TEST(ProjectRulesTest, countsMotionInstructions) // KS-MC-01
{
    const auto program = [](unsigned calls) {
        std::string out = Head;
        for (unsigned i = 0; i < calls; ++i)
            out += "MC_RESET %M0.0, 1, %M0.1, %M0.2, %MB4\n";
        return out;
    };
    EXPECT_EQ(codesOf(check(ks105(), program(192)).diagnostics), "");
    EXPECT_EQ(codesOf(check(ks105(), program(193)).diagnostics), "CW3403@195:1");
    EXPECT_EQ(codesOf(check(ks101m(), program(1024)).diagnostics), "");
    EXPECT_EQ(codesOf(check(ks101m(), program(1025)).diagnostics), "CW3403@1027:1");
}

TEST(ProjectRulesTest, countsRestartsAndStatusBlocks) // KS-MC-01
{
    std::string restarts = Head;
    for (int i = 0; i < 33; ++i)
        restarts += "MC_RESTART %M0.0, 1, 100, %M0.1, %M0.2, %MB4\n";
    EXPECT_EQ(codesOf(check(ks101m(), restarts).diagnostics), "CW3404@35:1");
    const std::string status = "MC_MIOT 1, %M0.0, %M0.1, %VW0, %VB2, %VB100, %VB3, %VB140, %VB4, %VB180, %VB200\n";
    EXPECT_EQ(codesOf(check(ks101m(), Head + status).diagnostics), "");
    EXPECT_EQ(codesOf(check(ks101m(), Head + status + status).diagnostics), "CW3405@4:1");
}

TEST(ProjectRulesTest, warnsOfATimerUsedTwiceInAnyProgram)
{
    const LanguageContext context = withPrograms("KS101M-04DX", {{"Main", ProgramRole::Main}, {"A", ProgramRole::Subroutine}});
    const CheckedSources checked = checkAll(context, {{"Main", Head + "CAL A\nTON T0, 5\n"}, {"A", Head + "TOF T0, 5\nTON T1, 5\n"}});
    EXPECT_EQ(codesOf(checked.diagnostics), "CW3502@3:5");
    EXPECT_EQ(checked.diagnostics[0].place.object.name, "A");
    EXPECT_EQ(checked.diagnostics[0].related->object.name, "Main");
    EXPECT_TRUE(checked.programs);
}

TEST(ProjectRulesTest, warnsOfACoilInTwoRungs)
{
    const std::string text = "(* Network 0 *)\nLD %M0.0\nST %Q0.0\nST %Q0.0\n(* Network 1 *)\nLD %M0.1\nST %Q0.0\nS %Q0.1\n(* Network 2 *)\nLD %M0.2\nR %Q0.1\n";
    EXPECT_EQ(codesOf(check(ks101m(), text).diagnostics), "CW3505@7:4");
}

TEST(ProjectRulesTest, buildsAProgramOfManyWarnings)
{
    std::string text;
    for (int i = 0; i < 500; ++i)
        text += "(* Network 7 *)\nLD %M0.0\nST %M0.1\n";
    const CheckedSources checked = check(ks101m(), text);
    EXPECT_TRUE(checked.programs);
    EXPECT_FALSE(hasErrors(checked.diagnostics));
    EXPECT_EQ(std::count_if(checked.diagnostics.begin(), checked.diagnostics.end(), [](const Diagnostic& d) { return d.code == Code::TooManyWarnings; }), 1);
    const CheckedSources broken = check(ks101m(), text + "(* Network 7 *)\nLD %M0.0\nMOVE 5\n");
    EXPECT_TRUE(hasErrors(broken.diagnostics)) << "an error is listed among the warnings";
    EXPECT_FALSE(broken.programs);
}

TEST(ProjectRulesTest, checksOneProgramAloneWhileTyping)
{
    const ProgramSource source{{ObjectKind::Program, "Main"}, ProgramRole::Main, "(* Network 0 *)\nLD %SM0.0\nCAL Missing\n\nMOVE 5\n"};
    EXPECT_EQ(codesOf(checkSource(source, ks101m())), "CW3304@3:5 CW3203@5:1");
}

TEST(ProjectRulesTest, checksTenThousandRungsQuickly)
{
    std::string text;
    for (int i = 0; i < 2000; ++i)
        text += "(* Network " + std::to_string(i) + " *)\nLD %M0.0\nANDN %M0.1\nMOVE 1, %VW" + std::to_string(i * 2) + "\nS %M0.2\n";
    EXPECT_EQ(codesOf(check(ks101m(), text).diagnostics), "");
    EXPECT_EQ(check(ks101m(), text).size.instructions, 8000u);
}

} // namespace
