#include "core/checks/checkproject.h"
#include "core/language/compile.h"
#include "core/language/image/container.h"
#include "core/runtime/executor/executor.h"
#include "core/language/stprograms.h"
#include "core/storage/objecttext.h"
#include "core/storage/projectstore.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace camwright;

namespace {

constexpr const char* Source = "(* Network 0 *)\nLD %M0.0\nADD %VW0,1,%VW2\nST %M1.0\n";

class CompileTest : public testing::Test {
protected:
    CompileTest() { use("KS101M-04DX"); program("Main", ProgramRole::Main, Source); }

    void use(const char* model)
    {
        ControllerSettings settings;
        settings.family = "kinco";
        settings.model = model;
        put(controllerKey(), settings);
    }
    void put(const ObjectKey& key, ObjectContent content)
    {
        m_project = m_project.with(key, std::make_shared<const Object>(Object{key, m_order++, std::move(content), {}}));
    }
    void program(const std::string& name, ProgramRole role, const std::string& source)
    {
        put({ObjectKind::Program, name}, Program{role, ProgramLanguage::InstructionList, source});
    }
    void axis(const std::string& name, std::int64_t number)
    {
        Axis out;
        out.number = number;
        out.mechanicalEquivalent = 100.0;
        put({ObjectKind::Axis, name}, out);
        put({ObjectKind::Network, "CANopen"}, Network{});
    }
    CompileResult compiled(const BuildOptions& options = {})
    {
        const Validation validation = validate(m_project);
        for (const Diagnostic& d : validation.diagnostics)
            EXPECT_NE(d.severity(), Severity::Error) << englishLine(d);
        if (!validation.project)
            return {};
        return compile(*validation.project, options, m_job);
    }
    static std::string text(const Diagnostics& diagnostics)
    {
        std::string out;
        for (const Diagnostic& d : diagnostics)
            out += englishLine(d) + "\n";
        return out;
    }

    Project m_project = Project().withName("feeder");
    std::int64_t m_order = 0;
    Job m_job;
};

TEST_F(CompileTest, strictKincoGivesNoImageOfNestedBranches) // C32
{
    program("Main", ProgramRole::Main, "(* Network 0 *)\nLD %M0.0\nAND( %M0.1\nOR %M0.2\n)\nST %M1.0\n");
    ASSERT_TRUE(compiled().image);
    ControllerSettings settings = m_project.controller();
    settings.strictKinco = true;
    put(controllerKey(), settings);
    const CompileResult result = compiled();
    EXPECT_FALSE(result.image);
    ASSERT_EQ(result.diagnostics.size(), 1u);
    EXPECT_EQ(result.diagnostics[0].code, Code::GroupNotInFamily);
    EXPECT_EQ(result.diagnostics[0].place.range.line, 3u);
}

TEST_F(CompileTest, makesAnImageThatReadsBackAndRuns)
{
    const CompileResult result = compiled();
    ASSERT_TRUE(result.image) << text(result.diagnostics);
    const Result<ControllerImage> read = readImage(write(*result.image));
    ASSERT_TRUE(read.ok()) << englishText(read.error());
    EXPECT_EQ(*read, *result.image);
    EXPECT_EQ(read->target.family, "kinco");
    EXPECT_EQ(read->debug.projectName, "feeder");
    ScanExecutor executor = ScanExecutor::load(std::make_shared<const ControllerImage>(*read)).value();
    executor.memory().write(bitAddress(2, 0), Value::ofBool(true));
    executor.scan({});
    EXPECT_EQ(executor.memory().read(valueAddress(3, 2, DataType::Int)).asInteger(), 1);
}

TEST_F(CompileTest, aKoyoProjectIsBuiltAndSaysThatItsBoxesAreNotSimulated) // D2-IB-21
{
    ControllerSettings settings;
    settings.family = "koyo";
    settings.model = "DL-265";
    put(controllerKey(), settings);
    program("Main", ProgramRole::Main, "STR X0\nTMR T0 K5\nSTR X0\nGTS K1\nSTRN B10003.1\nAND M1002\nIB-2021 R5000 R5001 R5040 M100 M101 R5002 R5003\n");
    program("Count", ProgramRole::Subroutine, "SBR K1\nLD K1999\nADD K1\nOUT V1400\nRT\n");
    BuildOptions options;
    options.forVirtualController = true;
    const CompileResult result = compiled(options);
    ASSERT_TRUE(result.image) << text(result.diagnostics);
    ASSERT_EQ(result.diagnostics.size(), 1u) << text(result.diagnostics);
    EXPECT_EQ(result.diagnostics.front().code, Code::BlockNotSimulated);
    EXPECT_EQ(result.diagnostics.front().place.range.line, 7u);
    const Result<ControllerImage> read = readImage(write(*result.image));
    ASSERT_TRUE(read.ok()) << englishText(read.error());
    EXPECT_EQ(*read, *result.image);
    ScanExecutor executor = ScanExecutor::load(std::make_shared<const ControllerImage>(*read)).value();
    executor.memory().write(bitAddress(0, 0), Value::ofBool(true)); // X0
    executor.scan({});
    EXPECT_EQ(executor.memory().read(valueAddress(9, 01400 * 2, DataType::Word)).asInteger(), 0x2000); // V1400
}

TEST_F(CompileTest, theSameProjectGivesTheSameBytes)
{
    axis("Feed", 1);
    const CompileResult first = compiled();
    const CompileResult second = compiled();
    ASSERT_TRUE(first.image && second.image) << text(first.diagnostics);
    EXPECT_EQ(write(*first.image), write(*second.image));
}

TEST_F(CompileTest, aCommentChangesTheImageButNotTheProgram)
{
    const ControllerImage before = *compiled().image;
    program("Main", ProgramRole::Main, std::string("(* Network 0 *)\n(* what it is for *)\n") + (Source + 16));
    const ControllerImage after = *compiled().image;
    EXPECT_NE(write(before), write(after));
    EXPECT_EQ(programHash(before), programHash(after));
    program("Main", ProgramRole::Main, "(* Network 0 *)\nLD %M0.0\nADD %VW0,2,%VW2\nST %M1.0\n");
    EXPECT_NE(programHash(before), programHash(*compiled().image));
}

TEST_F(CompileTest, carriesAxesNetworkVariablesAndSource)
{
    axis("Feed", 1);
    axis("Turn", 2);
    VariableTable table;
    table.chunks.push_back(std::make_shared<const std::vector<Variable>>(std::vector<Variable>{
        {"Speed", DataType::Real, "%VR100", "12.5", false, ""}, {"Lamp", DataType::Bool, "%M5.3", "", false, ""}}));
    put({ObjectKind::VariableTable, "Globals"}, table);
    const CompileResult result = compiled();
    ASSERT_TRUE(result.image) << text(result.diagnostics);
    ASSERT_EQ(result.image->configuration.axes.size(), 2u);
    EXPECT_EQ(result.image->configuration.axes[1].name, "Turn");
    EXPECT_EQ(result.image->configuration.axes[1].mechanicalEquivalent, 100.0);
    EXPECT_TRUE(result.image->configuration.network.present);
    ASSERT_NE(findSymbol(*result.image, "Speed"), nullptr);
    EXPECT_EQ(findSymbol(*result.image, "Speed")->address, valueAddress(3, 100, DataType::Real));
    ASSERT_EQ(result.image->layout.initialValues.size(), 1u);
    EXPECT_EQ(result.image->layout.initialValues[0].value, Value::ofReal(12.5f));
    EXPECT_GE(result.image->source.size(), 5u);
    const auto parts = readPartTable(write(*result.image));
    EXPECT_TRUE(std::ranges::any_of(*parts, [](const ImagePartInfo& part) { return part.name == "axis Feed"; }));
}

TEST_F(CompileTest, errorsGiveNoImageAndTheirPlace)
{
    program("Main", ProgramRole::Main, "(* Network 0 *)\nLD %M0.0\nBN %VW308, 0\nST %M3.0\n");
    const CompileResult result = compiled();
    EXPECT_FALSE(result.image);
    ASSERT_FALSE(result.diagnostics.empty());
    EXPECT_EQ(result.diagnostics[0].place.range.line, 3u) << text(result.diagnostics);
    EXPECT_EQ(result.diagnostics[0].place.object.name, "Main");
}

// KS-PLS-01, KS-POS-02
TEST_F(CompileTest, pulseOutputsCompileForAKs105WithAWarning)
{
    program("Main", ProgramRole::Main,
            "(* Network 0 *)\nLD %SM0.0\nPHOME 0, %M0.0, %M0.1, %M0.2, %VW0, %VW2, %VW4, %VD6, %VW10, %M0.4, %M0.5, %MB1\n");
    EXPECT_FALSE(compiled().image) << "not on a KS101M";
    use("KS105-16DT");
    CompileResult result = compiled();
    ASSERT_TRUE(result.image) << text(result.diagnostics);
    const auto warning = std::ranges::find(result.diagnostics, Code::PulseNotSimulated, &Diagnostic::code);
    ASSERT_NE(warning, result.diagnostics.end());
    EXPECT_EQ(warning->place.range.line, 3u);
    EXPECT_EQ(englishText(*warning), "PHOME has no effect on the virtual controller: pulse outputs are not simulated yet. On the real controller it runs.");
    result = compiled({.forVirtualController = false, .archive = {}});
    EXPECT_EQ(std::ranges::count(result.diagnostics, Code::PulseNotSimulated, &Diagnostic::code), 0);
}

TEST_F(CompileTest, callsThatNestTooDeepAreNamed)
{
    program("Main", ProgramRole::Main, "(* Network 0 *)\nLD %SM0.0\nCAL R01\n");
    for (int level = 1; level <= 17; ++level) {
        const auto routine = [](int n) { return (n < 10 ? "R0" : "R") + std::to_string(n); };
        const std::string body = level < 17 ? "LD %SM0.0\nCAL " + routine(level + 1) + "\n" : "LD %SM0.0\nST %M0.0\n";
        program(routine(level), ProgramRole::Subroutine, "(* Network 0 *)\n" + body);
    }
    const CompileResult result = compiled();
    EXPECT_FALSE(result.image);
    ASSERT_FALSE(result.diagnostics.empty());
    EXPECT_EQ(result.diagnostics.back().code, Code::CallsTooDeep) << text(result.diagnostics);
    EXPECT_EQ(result.diagnostics.back().arguments, (std::vector<std::string>{"16", "R17"}));
}

TEST_F(CompileTest, theExamplesBuildWithoutAWord)
{
    PosixFileSystem files;
    for (const char* example : {"kinco-feeder", "ts600-marquee"}) {
        const auto loaded = openProject(files, std::string(CAMWRIGHT_SOURCE_DIR "/examples/") + example);
        ASSERT_TRUE(loaded.ok()) << example;
        m_project = loaded->project;
        const CompileResult result = compiled();
        ASSERT_TRUE(result.image) << text(result.diagnostics);
        EXPECT_EQ(text(result.diagnostics), "") << example;
        EXPECT_TRUE(readImage(write(*result.image)).ok());
    }
}

TEST_F(CompileTest, aCancelledJobGivesNoImage)
{
    m_job.cancel();
    const CompileResult result = compiled();
    EXPECT_FALSE(result.image);
    EXPECT_EQ(result.diagnostics.back().code, Code::Cancelled);
}

TEST_F(CompileTest, typedTextIsCheckedAgainstTheRestOfTheProject)
{
    const ObjectKey key{ObjectKind::Program, "Main"};
    EXPECT_EQ(text(checkProgramText(m_project, key, Source)), "");
    const Diagnostics wrong = checkProgramText(m_project, key, "(* Network 0 *)\nLD %M9999.0\n");
    ASSERT_FALSE(wrong.empty());
    EXPECT_EQ(wrong[0].place.range.line, 2u);
    EXPECT_TRUE(checkProgramText(Project(), key, Source).empty()) << "no family: nothing to check against";
}

class CompileStTest : public CompileTest {
protected:
    void st(const std::string& name, ProgramRole role, const std::string& source)
    {
        put({ObjectKind::Program, name}, Program{role, ProgramLanguage::StructuredText, source});
    }
    void variables()
    {
        put({ObjectKind::VariableTable, "Globals"}, VariableTable::of({Variable{"Speed", DataType::Int, "%VW20", "", false, ""}, Variable{"Lamp", DataType::Bool, "%Q0.1", "", false, ""}}));
    }
    ScanExecutor run()
    {
        const CompileResult result = compiled();
        EXPECT_TRUE(result.image) << text(result.diagnostics);
        auto executor = ScanExecutor::load(std::make_shared<const ControllerImage>(readImage(write(result.image.value())).value()));
        return std::move(executor.value());
    }
    static std::int64_t symbol(const ScanExecutor& executor, std::string_view name)
    {
        const Symbol* found = findSymbol(executor.image(), name);
        return found ? executor.memory().read(found->address).asInteger() : -1;
    }
};

TEST_F(CompileStTest, structuredTextAndInstructionListWorkOnTheSameVariables)
{
    variables();
    st("Main", ProgramRole::Main, "PROGRAM Main\nVAR count : INT := 5; wide AT %VW20 : INT; bit AT %IX0.0 : BOOL; END_VAR\ncount := count + 1; Speed := count * 2; Increment(); Lamp := bit OR wide > 10; END_PROGRAM\n");
    program("Increment", ProgramRole::Subroutine, "(* Network 0 *)\nLDN %M9.0\nADD %VW20,1,%VW20\n");
    ScanExecutor executor = run();
    executor.scan({});
    EXPECT_EQ(symbol(executor, "Main.count"), 6);
    EXPECT_EQ(symbol(executor, "Speed"), 13) << "Increment ran behind the assignment";
    EXPECT_EQ(symbol(executor, "Lamp"), 1);
}

TEST_F(CompileStTest, instructionListCallsAProgramInStructuredText)
{
    program("Main", ProgramRole::Main, "(* Network 0 *)\nLD %SM0.0\nCAL Blocks\n");
    st("Blocks", ProgramRole::Subroutine, "FUNCTION_BLOCK Counter VAR_OUTPUT n : DINT; END_VAR n := n + 1; END_FUNCTION_BLOCK\nPROGRAM Anything VAR c : Counter; n : DINT; END_VAR c(n => n); END_PROGRAM\n");
    ScanExecutor executor = run();
    executor.memory().write(bitAddress(5, 0), Value::ofBool(true));
    const Symbol* found = findSymbol(executor.image(), "Anything.n");
    ASSERT_NE(found, nullptr);
    EXPECT_EQ(executor.image().program.routines[0].name, "Main");
    EXPECT_EQ(executor.image().program.routines[1].name, "Blocks");
}

TEST_F(CompileStTest, textsShareTheirDeclarations)
{
    st("Main", ProgramRole::Main, "PROGRAM Main VAR m : Motor; r : DINT; END_VAR m(speed := Fast); r := m.steps; END_PROGRAM");
    st("Library", ProgramRole::Subroutine, "TYPE Speed : (Slow := 1, Fast := 10); END_TYPE FUNCTION_BLOCK Motor VAR_INPUT speed : Speed; END_VAR VAR_OUTPUT steps : DINT; END_VAR\nIF speed = Speed#Fast THEN steps := steps + 10; END_IF; END_FUNCTION_BLOCK");
    ScanExecutor executor = run();
    executor.scan({});
    executor.scan({});
    EXPECT_EQ(symbol(executor, "Main.r"), 20);
}

TEST_F(CompileStTest, theRealFamilyIsSaidToHaveNone)
{
    st("Main", ProgramRole::Main, "PROGRAM Main END_PROGRAM");
    const CompileResult result = compiled();
    ASSERT_TRUE(result.image) << text(result.diagnostics);
    ASSERT_EQ(result.diagnostics.size(), 1u) << text(result.diagnostics);
    EXPECT_EQ(result.diagnostics[0].code, Code::StOnlyVirtual);
}

TEST_F(CompileStTest, anErrorIsAtItsPlaceInItsTextWhileSomebodyTypes)
{
    st("Main", ProgramRole::Main, "PROGRAM Main END_PROGRAM");
    st("Other", ProgramRole::Subroutine, "PROGRAM Broken x := 1; END_PROGRAM");
    const Diagnostics found = checkProgramText(m_project, {ObjectKind::Program, "Main"}, "PROGRAM Main\nVAR x : INT; END_VAR\nx := 1\nEND_PROGRAM");
    ASSERT_EQ(found.size(), 2u) << text(found);
    EXPECT_EQ(found[0].code, Code::StMissing);
    EXPECT_EQ(found[0].place.range.line, 3u);
    EXPECT_EQ(found[0].place.object.name, "Main");
    EXPECT_FALSE(compiled().image);
}

TEST_F(CompileStTest, aProjectKeepsItInAFileOfItsOwnEnding)
{
    st("Main", ProgramRole::Main, "PROGRAM Main END_PROGRAM\n");
    const ObjectKey key{ObjectKind::Program, "Main"};
    EXPECT_EQ(fileOf(key, m_project), "programs/Main.st");
    const std::string written = toText(*m_project.find(key));
    EXPECT_TRUE(written.starts_with("(* camwright: role=main, language=st, order=")) << written;
    const auto read = fromText(key, written);
    ASSERT_TRUE(read.ok());
    EXPECT_EQ(*read, *m_project.find(key));
    const auto byEnding = fromText(key, "(* camwright: role=main, order=1 *)\nPROGRAM Main END_PROGRAM\n", "programs/Main.st");
    ASSERT_TRUE(byEnding.ok());
    EXPECT_EQ(std::get<Program>(byEnding->content).language, ProgramLanguage::StructuredText);
}

TEST(LooseStTest, aFileOutsideAProjectIsCheckedWithAnyAddress)
{
    EXPECT_TRUE(checkLooseSt("VAR_GLOBAL a AT %QX7.7 : BOOL; END_VAR\nFUNCTION f : INT f := 1; END_FUNCTION", "f.st").empty());
    const Diagnostics found = checkLooseSt("FUNCTION f : INT\nf := TRUE;\nEND_FUNCTION", "dir/f.st");
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(englishLine(found[0]).substr(0, 26), "dir/f.st:2:6: error CW8302");
}

} // namespace
