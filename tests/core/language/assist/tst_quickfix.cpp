#include "core/language/assist/quickfix.h"
#include "core/base/diagnostic.h"
#include "core/language/compile.h"
#include "tests/core/language/assist/assistproject.h"

#include <gtest/gtest.h>

#include <set>

using namespace camwright;
using namespace camwright::test;

namespace {

const ObjectKey Main{ObjectKind::Program, "Main"};

Diagnostics problemsOf(const Project& project)
{
    return checkProgramText(project, Main, project.content<Program>(Main)->source);
}

std::string codes(const Project& project)
{
    std::string out;
    for (const Diagnostic& problem : problemsOf(project))
        out += (out.empty() ? "" : " ") + std::string(codeInfo(problem.code).id);
    return out;
}

const Diagnostic* find(const Diagnostics& problems, Code code)
{
    for (const Diagnostic& problem : problems)
        if (problem.code == code)
            return &problem;
    return nullptr;
}

std::vector<QuickFix> fixesFor(const Project& project, Code code)
{
    const Diagnostics problems = problemsOf(project);
    const Diagnostic* problem = find(problems, code);
    return problem ? quickFixes(project, *problem) : std::vector<QuickFix>();
}

/// The program after the n-th fix of the first problem with the code; what is wrong then, in brackets.
std::string mended(const Project& project, Code code, std::size_t n = 0)
{
    const std::vector<QuickFix> fixes = fixesFor(project, code);
    if (n >= fixes.size())
        return "no fix among: " + codes(project);
    const Project after = applied(project, Main, fixes[n]);
    const std::string left = codes(after);
    return after.content<Program>(Main)->source + (left.empty() ? "" : "[" + left + "]");
}

std::string kinco(const std::string& text, Code code, std::size_t n = 0)
{
    return mended(assistProject("kinco", text, {row("Speed", DataType::Real, "%VR100")}, {{"Init", "LD %M0.0\nRET\n"}}), code, n);
}

std::string invt(const std::string& text, Code code, std::size_t n = 0)
{
    return mended(assistProject("invt", text), code, n);
}

const std::string Begin = "(* Network 0 *)\n";

struct Case {
    const char* name;
    Code code;
    const char* before;
    const char* after;
};

class KincoFix : public testing::TestWithParam<Case> {};

TEST_P(KincoFix, mendsTheProgram)
{
    EXPECT_EQ(kinco(Begin + GetParam().before, GetParam().code), Begin + GetParam().after);
}

INSTANTIATE_TEST_SUITE_P(QuickFixTest, KincoFix, testing::Values(
    Case{"mnemonic", Code::UnknownInstructionNear, "LD %M0.0\nMOEV %VW0, %VW2\n", "LD %M0.0\nMOVE %VW0, %VW2\n"},
    Case{"otherDialect", Code::UnknownInstructionNear, "LDI %M0.0\nST %M0.1\n", "LDN %M0.0\nST %M0.1\n"},
    Case{"variable", Code::UnknownNameNear, "LD %M0.0\nMOVE Sped, %VR4\n", "LD %M0.0\nMOVE Speed, %VR4\n"},
    Case{"subroutine", Code::UnknownSubroutineNear, "LD %M0.0\nCAL Inti\n", "LD %M0.0\nCAL Init\n"},
    Case{"lookalike", Code::LookalikeLetters, "LD %M0.0\nMOVE %VВ0, %VB2\n", "LD %M0.0\nMOVE %VB0, %VB2\n"},
    Case{"escape", Code::MarkdownEscape, "LD %M0.0\nR\\_TRIG\nST %M0.1\n", "LD %M0.0\nR_TRIG\nST %M0.1\n"},
    Case{"escapedComment", Code::MarkdownEscape, "(\\* go \\*)\nLD %M0.0\nST %M0.1\n", "(* go *)\nLD %M0.0\nST %M0.1\n"},
    Case{"fence", Code::MarkdownFence, "```\nLD %M0.0\nST %M0.1\n", "LD %M0.0\nST %M0.1\n"},
    Case{"blanks", Code::ConstantHasBlanks, "LD %M0.0\nMOVE DI # 100, %VD0\n", "LD %M0.0\nMOVE DI#100, %VD0\n"},
    Case{"percent", Code::AddressMissingPercent, "LD M0.0\nST %M0.1\n", "LD %M0.0\nST %M0.1\n"},
    Case{"comma", Code::MissingComma, "LD %M0.0\nMOVE %VW0 %VW2\n", "LD %M0.0\nMOVE %VW0, %VW2\n"},
    Case{"comment", Code::CommentOpenAtEnd, "LD %M0.0\nST %M0.1\n(* the end\n", "LD %M0.0\nST %M0.1\n(* the end *)\n"},
    Case{"unusedNetwork", Code::UnterminatedComment, "LD %M0.0 (* go\nST %M0.1\n(* Network 1 *)\nLD %M0.0\nST %M0.2\n", "LD %M0.0 (* go *)\nST %M0.1\n(* Network 1 *)\nLD %M0.0\nST %M0.2\n"},
    Case{"number", Code::NetworkNumber, "LD %M0.0\nST %M0.1\n(* Network 5 *)\nLD %M0.0\nST %M0.2\n(* Network 6 *)\nLD %M0.3\nST %M0.4\n",
        "LD %M0.0\nST %M0.1\n(* Network 1 *)\nLD %M0.0\nST %M0.2\n(* Network 2 *)\nLD %M0.3\nST %M0.4\n"},
    Case{"load", Code::RungNeedsLoad, "ANDN %M0.0\nST %M0.1\n", "LDN %M0.0\nST %M0.1\n"},
    Case{"always", Code::RungNeedsLoad, "MOVE %VW0, %VW2\n", "LD %SM0.0\nMOVE %VW0, %VW2\n"},
    Case{"secondLoad", Code::SecondLoad, "LD %M0.0\nLDN %M0.1\nST %M0.2\n", "LD %M0.0\nANDN %M0.1\nST %M0.2\n"},
    Case{"openGroup", Code::GroupNotClosed, "LD %M0.0\nAND( %M0.1\nOR %M0.2\nST %M0.3\n", "LD %M0.0\nAND( %M0.1\nOR %M0.2\n)\nST %M0.3\n"},
    Case{"strayGroupEnd", Code::GroupNotOpen, "LD %M0.0\n)\nST %M0.3\n", "LD %M0.0\nST %M0.3\n"},
    Case{"oddByte", Code::AddressOddByte, "LD %M0.0\nMOVE %VW1, %VW4\n", "LD %M0.0\nMOVE %VW0, %VW4\n"},
    Case{"real", Code::TypesDiffer, "LD %M0.0\nMOVE 12, Speed\n", "LD %M0.0\nMOVE 12.0, Speed\n"},
    Case{"afterEnd", Code::TextAfterEnd, "LD %M0.0\nST %M0.1\nEND\nLD %M0.1\n", "LD %M0.0\nST %M0.1\nLD %M0.1\n[CW3102]"}),
    [](const auto& info) { return std::string(info.param.name); });

TEST(QuickFixTest, missingOperandsBecomePlaceholders)
{
    EXPECT_EQ(kinco(Begin + "LD %M0.0\nMOVE %VW0\n", Code::TooFewOperands), Begin + "LD %M0.0\nMOVE %VW0, ???\n[CW3205]");
    EXPECT_EQ(kinco(Begin + "LD %M0.0\nMOVE %VW0,\n", Code::OperandLeftOut), Begin + "LD %M0.0\nMOVE %VW0, ???\n[CW3205]");
    EXPECT_EQ(kinco(Begin + "LD %M0.0\nMOVE , %VW0\n", Code::OperandLeftOut), Begin + "LD %M0.0\nMOVE ???, %VW0\n[CW3205]");
    EXPECT_EQ(kinco(Begin + "LD %M0.0\nMOVE _, %VW0\n", Code::OperandNotOptional), Begin + "LD %M0.0\nMOVE ???, %VW0\n[CW3205]");
}

TEST(QuickFixTest, superfluousOperandsGo)
{
    EXPECT_EQ(kinco(Begin + "LD %M0.0\nST %M0.1, %M0.2 (* both *)\n", Code::TooManyOperands), Begin + "LD %M0.0\nST %M0.1 (* both *)\n");
    EXPECT_EQ(kinco(Begin + "LD %M0.0\nCAL Init, 3\n", Code::TooManyOperands), Begin + "LD %M0.0\nCAL Init\n");
}

TEST(QuickFixTest, pinGetsItsName)
{
    EXPECT_EQ(kinco(Begin + "LD %M0.0\nMOVE INN:=%VW0, OUT:=%VW2\n", Code::UnknownPin), Begin + "LD %M0.0\nMOVE IN:=%VW0, OUT:=%VW2\n");
}

TEST(QuickFixTest, constantComesToItsLimit)
{
    EXPECT_EQ(kinco(Begin + "LD %M0.0\nTON T0, -5\nST %M0.1\n", Code::ConstantOutOfRange), Begin + "LD %M0.0\nTON T0, 0\nST %M0.1\n");
}

TEST(QuickFixTest, secondLoadMayBeginANetwork)
{
    EXPECT_EQ(kinco(Begin + "LD %M0.0\nST %M0.1\nLD %M0.2\nST %M0.3\n(* Network 1 *)\nLD %M0.4\nST %M0.5\n", Code::SecondLoad, 2),
        Begin + "LD %M0.0\nST %M0.1\n(* Network 1 *)\nLD %M0.2\nST %M0.3\n(* Network 2 *)\nLD %M0.4\nST %M0.5\n");
}

TEST(QuickFixTest, statementBeforeTheFirstNetworkGetsOne)
{
    EXPECT_EQ(kinco("LD %M0.0\nST %M0.1\n(* Network 0 *)\nLD %M0.2\nST %M0.3\n", Code::StatementBeforeNetwork),
        "(* Network 0 *)\nLD %M0.0\nST %M0.1\n(* Network 1 *)\nLD %M0.2\nST %M0.3\n");
}

TEST(QuickFixTest, branchesAreEndedAsTs600Wants)
{
    EXPECT_EQ(invt("LD X0\nMPS\nAND X1\nOUT Y0\nMRD\nAND X2\nOUT Y1\n", Code::BranchNotClosed), "LD X0\nMPS\nAND X1\nOUT Y0\nMPP\nAND X2\nOUT Y1\n");
    EXPECT_EQ(invt("LD X0\nMPS\nOUT Y0\n", Code::BranchNotClosed), "LD X0\nOUT Y0\n");
    EXPECT_EQ(invt("LD X0\nMPP\nOUT Y0\n", Code::BranchNotOpen), "LD X0\nOUT Y0\n");
    EXPECT_EQ(invt("LD X0\nLD X1\nOR X2\nOUT Y0\n", Code::FlowLeftOver), "LD X0\nLD X1\nOR X2\nANB\nOUT Y0\n");
    EXPECT_EQ(invt("LD X0\nLD X1\nOR X2\nOUT Y0\n", Code::FlowLeftOver, 1), "LD X0\nLD X1\nOR X2\nORB\nOUT Y0\n");
    EXPECT_EQ(invt("LD X0\nANB\nOUT Y0\n", Code::NothingToJoin), "LD X0\nOUT Y0\n");
    EXPECT_EQ(invt("LD X0\nMOV D0, D1\n", Code::UnexpectedComma), "LD X0\nMOV D0  D1\n");
}

TEST(QuickFixTest, undeclaredVariableIsDeclaredWhereNothingIs)
{
    const Project project = assistProject("kinco", Begin + "LD %M0.3\nST Ready\nMOVE %VW0, Height\nLD %M1.0\n", {row("Other", DataType::Int, "%VW2")});
    const Project one = applied(project, Main, fixesFor(project, Code::UnknownName).at(0));
    const auto* table = one.content<VariableTable>({ObjectKind::VariableTable, "Globals"});
    ASSERT_EQ(table->rowCount(), 2u);
    EXPECT_EQ(table->row(1), row("Ready", DataType::Bool, "%M2.0"));
    const Project two = applied(one, Main, fixesFor(one, Code::UnknownName).at(0));
    EXPECT_EQ(two.content<VariableTable>({ObjectKind::VariableTable, "Globals"})->row(2), row("Height", DataType::Int, "%VW4"));
    EXPECT_EQ(codes(two), "CW3102");
}

TEST(QuickFixTest, undeclaredVariableOfTs600NeedsNoAddress)
{
    const Project project = assistProject("invt", "LD Ready\nDMOV D0 Total\n");
    const Project one = applied(project, Main, fixesFor(project, Code::UnknownName).at(0));
    const Project two = applied(one, Main, fixesFor(one, Code::UnknownName).at(0));
    const auto* table = two.content<VariableTable>({ObjectKind::VariableTable, "Globals"});
    ASSERT_EQ(table->rowCount(), 2u);
    EXPECT_EQ(table->row(0), row("Ready", DataType::Bool, ""));
    EXPECT_EQ(table->row(1), row("Total", DataType::Dint, ""));
    EXPECT_EQ(codes(two), "");
}

TEST(QuickFixTest, unknownSubroutineIsAdded)
{
    const Project project = assistProject("kinco", Begin + "LD %M0.0\nCAL Homing\n");
    const Project after = applied(project, Main, fixesFor(project, Code::UnknownSubroutine).at(0));
    ASSERT_TRUE(after.content<Program>({ObjectKind::Program, "Homing"}));
    EXPECT_EQ(after.content<Program>({ObjectKind::Program, "Homing"})->role, ProgramRole::Subroutine);
    EXPECT_EQ(codes(after), "");
}

TEST(QuickFixTest, variableWithoutAddressGetsOne)
{
    const Project project = assistProject("kinco", Begin + "LD Ready\nST %M0.1\n", {row("Ready", DataType::Bool, "")});
    const Project after = applied(project, Main, fixesFor(project, Code::VariableWithoutAddress).at(0));
    EXPECT_EQ(after.content<VariableTable>({ObjectKind::VariableTable, "Globals"})->row(0).address, "%M1.0");
    EXPECT_EQ(codes(after), "");
}

TEST(QuickFixTest, strictKincoRefusesGroupsInPlace) // C32
{
    const std::string text = Begin + "LD %M0.0\nAND( %M0.1\nOR %M0.2\n)\nST %M0.3\n";
    EXPECT_EQ(codes(assistProject("kinco", text)), "");
    const Diagnostics problems = problemsOf(strictProject(text));
    ASSERT_EQ(problems.size(), 1u);
    EXPECT_EQ(problems[0].code, Code::GroupNotInFamily);
    EXPECT_EQ(problems[0].place.range, (TextRange{3, 1, 3, 5}));
}

TEST(QuickFixTest, groupsAreRewrittenWithFreeMarkers) // C32
{
    const Project project = strictProject(Begin + "LD %M0.0\nAND( %M0.1\nOR( %M0.2\nANDN %M0.5\n)\n)\nST %M0.3\n(* Network 1 *)\nLD %M1.0\nST %M2.0\n");
    EXPECT_EQ(mended(project, Code::GroupNotInFamily),
        "(* Network 0 *)\nLD      %M0.2\nANDN    %M0.5\nST      %M3.0\n"
        "(* Network 1 *)\nLD      %M0.1\nOR      %M3.0\nST      %M3.1\n"
        "(* Network 2 *)\nLD      %M0.0\nAND     %M3.1\nST      %M0.3\n"
        "(* Network 3 *)\nLD %M1.0\nST %M2.0\n");
    EXPECT_EQ(fixesFor(project, Code::GroupNotInFamily).at(0).arguments, (std::vector<std::string>{"%M3.0, %M3.1"}));
}

TEST(QuickFixTest, aTextThatWentOnIsLeftAlone)
{
    const Project project = assistProject("kinco", Begin + "LD %M0.0\nMOEV %VW0, %VW2\n");
    const Diagnostics problems = problemsOf(project);
    const Project later = assistProject("kinco", Begin + "LD %M0.0\nADD %VW0, %VW2\n");
    EXPECT_TRUE(quickFixes(later, problems.at(0)).empty());
    EXPECT_TRUE(quickFixes(assistProject("kinco", ""), problems.at(0)).empty());
}

/// Whatever the text has become since: no fix reads or writes outside it.
TEST(QuickFixTest, everyFixSurvivesAnyOtherText)
{
    const std::string texts[] = {Begin + "LD %M0.0\nMOEV %VW0 %VW2\nAND( %M0.1\nMC_POWER %M0.0, 3\n", "(* x", "\n\n\n", ")", "LD\r\nST",
        "CAL Nobody, 1\nLD Ready\nST %VW1\n```\nMOVE ,,\n", "LD %M0.0 (* a\n(* Network 3 *)\nOR %M\nEND\nLD"};
    std::set<Code> fixed;
    for (const char* family : {"kinco", "invt"})
        for (const std::string& from : texts)
            for (const Diagnostic& problem : problemsOf(assistProject(family, from)))
                for (const std::string& to : texts)
                    for (const QuickFix& fix : quickFixes(assistProject(family, to), problem)) {
                        fixed.insert(problem.code);
                        for (const TextEdit& edit : fix.edits)
                            EXPECT_LE(edit.offset + edit.length, to.size()) << fix.sentence;
                    }
    EXPECT_GT(fixed.size(), 8u);
}

TEST(QuickFixTest, sentencesUseTheirArguments)
{
    const Project project = assistProject("kinco", Begin + "LD %M0.0\nMOEV %VW0, %VW2\n");
    const QuickFix fix = fixesFor(project, Code::UnknownInstructionNear).at(0);
    EXPECT_EQ(fillTemplate(fix.sentence, fix.arguments), "Write MOVE in place of MOEV");
}

} // namespace
