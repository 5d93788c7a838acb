#include "tests/core/language/check/checking.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace camwright;
using namespace camwright::test;

namespace {

// Every instruction of the catalogue, written rightly once and then wrongly in each way its operands allow. The place and
// the code of the one error are known from the kind of damage (KS-IL-08, KS-IL-09, KS-MEM-08, TS-IL-03).

/// A statement with the texts of its operands.
struct Written {
    const Instruction* instruction = nullptr;
    std::vector<std::string> operands;
};

/// One damaged text: what was done, and the error it must give.
struct Damaged {
    std::string what;
    std::string text;
    std::string error; ///< "CW3203@3:1"
};

std::string addressFor(const LanguageContext& context, DataType type, unsigned number = 0)
{
    const bool kinco = context.family->id() == "kinco";
    const std::string n = std::to_string(number);
    if (type == DataType::Bool)
        return kinco ? "%M" + n + ".0" : "M" + n;
    if (!kinco)
        return "D" + n;
    if (type == DataType::Real)
        return "%VR" + n;
    const unsigned width = byteWidth(type);
    return (width == 1 ? "%VB" : width == 2 ? "%VW" : "%VD") + n;
}

std::string constantFor(const Pin& pin)
{
    if (pin.mainType == DataType::Bool)
        return "TRUE";
    if (pin.mainType == DataType::Real)
        return "1.5";
    return std::to_string(static_cast<int>(std::max(1.0, pin.minimum.value_or(1))));
}

std::string operandFor(const LanguageContext& context, const Pin& pin)
{
    switch (pin.kind) {
    case PinKind::Timer: return "T0";
    case PinKind::Counter: return "C0";
    case PinKind::Program: return "Init";
    case PinKind::Interrupt: return "Tick";
    case PinKind::Axis: return "1";
    case PinKind::Block: return addressFor(context, pin.mainType, 100);
    default: break;
    }
    return pin.constantAllowed ? constantFor(pin) : addressFor(context, pin.mainType);
}

bool isStructural(const LanguageContext& context, const Instruction& instruction)
{
    const StatementRole role = context.dialect->shapeOf(instruction.mnemonic).role;
    return role >= StatementRole::AndBlock && role <= StatementRole::CloseGroup;
}

bool usesLabel(const Instruction& instruction)
{
    return std::ranges::any_of(instruction.pins, [](const Pin& pin) { return pin.kind == PinKind::Label; });
}

class Damager {
public:
    explicit Damager(const LanguageContext& context) : m_context(context), m_kinco(context.dialect->networkHeaders) {}

    std::vector<Damaged> all()
    {
        for (const Instruction& instruction : m_context.family->catalogue().instructions()) {
            const bool isLoop = instruction.mnemonic == "FOR" || instruction.mnemonic == "NEXT" || instruction.mnemonic == "END";
            if (isStructural(m_context, instruction) || usesLabel(instruction) || isLoop)
                continue;
            damage(rightly(instruction));
        }
        return std::move(m_out);
    }

    Written rightly(const Instruction& instruction) const
    {
        Written out{&instruction, {}};
        for (const Pin& pin : instruction.pins)
            if (pin.kind != PinKind::Arguments)
                out.operands.push_back(operandFor(m_context, pin));
        return out;
    }

    /// The program around a statement; the statement is line 3 on Kinco, else line 2, or the line before for an LD.
    std::string textOf(const std::string& line, const Instruction& instruction) const
    {
        const std::string head = m_kinco ? "(* Network 0 *)\n" : "";
        if (isLoad(instruction))
            return head + line + (m_kinco ? "\nST %M9.0\n" : "\nOUT Y0\n");
        return head + (m_kinco ? "LD %SM0.0\n" : "LD SM0\n") + line + "\n";
    }

    std::string lineOf(const Written& statement) const
    {
        std::string out = statement.instruction->mnemonic;
        for (std::size_t i = 0; i < statement.operands.size(); ++i)
            out += (i > 0 && m_kinco ? ", " : " ") + statement.operands[i];
        return out;
    }

private:
    bool isLoad(const Instruction& instruction) const { return m_context.dialect->shapeOf(instruction.mnemonic).role == StatementRole::Load; }

    std::size_t columnOf(const Written& statement, std::size_t operand) const
    {
        std::size_t column = statement.instruction->mnemonic.size() + 2;
        for (std::size_t i = 0; i < operand; ++i)
            column += statement.operands[i].size() + (m_kinco ? 2 : 1);
        return column;
    }

    void add(const std::string& what, const Written& statement, const char* code, std::size_t column)
    {
        const unsigned line = (m_kinco ? 3u : 2u) - (isLoad(*statement.instruction) ? 1u : 0u);
        m_out.push_back({statement.instruction->mnemonic + ": " + what, textOf(lineOf(statement), *statement.instruction),
                         std::string(code) + "@" + std::to_string(line) + ":" + std::to_string(column)});
    }

    void replace(const std::string& what, Written statement, std::size_t operand, const std::string& text, const char* code)
    {
        statement.operands[operand] = text;
        add(what, statement, code, columnOf(statement, operand));
    }

    void damage(const Written& right)
    {
        const std::vector<Pin>& pins = right.instruction->pins;
        const bool isCall = !pins.empty() && pins.back().kind == PinKind::Arguments;
        if (const unsigned required = right.instruction->requiredPins(); required > 0 && required == right.operands.size()) {
            Written shorter = right;
            shorter.operands.pop_back();
            add("the last operand left out", shorter, "CW3203", 1);
        }
        Written longer = right;
        longer.operands.push_back(addressFor(m_context, DataType::Int));
        if (right.operands.size() > 0)
            add("an operand too many", longer, isCall ? "CW3307" : "CW3204", columnOf(longer, right.operands.size()));
        for (std::size_t i = 0; i < right.operands.size(); ++i)
            damageOperand(right, i, pins[i]);
    }

    void damageOperand(const Written& right, std::size_t i, const Pin& pin)
    {
        replace("still to be filled in", right, i, "???", "CW3205");
        if (!pin.optional)
            replace("left empty", right, i, "_", "CW3206");
        if (pin.kind == PinKind::Program || pin.kind == PinKind::Interrupt || pin.kind == PinKind::Axis)
            return;
        replace("a name nobody knows", right, i, "Zzqqxyw", "CW3301");
        Written named = right;
        named.operands[i] = "ZZQ:=" + right.operands[i];
        add("a pin that does not exist", named, "CW3207", columnOf(right, i) + 5);
        if (pin.kind == PinKind::Timer)
            replace("no timer", right, i, "1", "CW3220");
        else if (pin.kind == PinKind::Counter)
            replace("no counter", right, i, "1", "CW3221");
        else if (pin.direction != PinDirection::In)
            replace("a constant for a result", right, i, constantFor(pin), "CW3213");
        else if (!pin.constantAllowed)
            replace("a constant", right, i, constantFor(pin), "CW3212");
        if (!pin.areas.empty() && (pin.kind == PinKind::Value || pin.kind == PinKind::Block))
            replace("an address outside its area", right, i, addressFor(m_context, pin.mainType, 70000), "CW2005");
        if (pin.kind == PinKind::Value && pin.mainType == DataType::Bool && pin.direction != PinDirection::In)
            replace("an input for a result", right, i, m_kinco ? "%I0.0" : "X0", "CW3210");
    }

    const LanguageContext& m_context;
    bool m_kinco;
    std::vector<Damaged> m_out;
};

std::string errorsOf(const Diagnostics& diagnostics)
{
    Diagnostics errors;
    std::ranges::copy_if(diagnostics, std::back_inserter(errors), [](const Diagnostic& d) { return d.severity() == Severity::Error; });
    return codesOf(errors);
}

class DamagedStatements : public testing::TestWithParam<const LanguageContext& (*)()> {};

TEST_P(DamagedStatements, rightOnesHaveNoError)
{
    const LanguageContext& context = GetParam()();
    const Damager damager(context);
    for (const Instruction& instruction : context.family->catalogue().instructions()) {
        if (isStructural(context, instruction) || usesLabel(instruction) || instruction.mnemonic == "FOR" || instruction.mnemonic == "NEXT")
            continue;
        const std::string text = damager.textOf(damager.lineOf(damager.rightly(instruction)), instruction);
        EXPECT_EQ(errorsOf(check(context, text).diagnostics), "") << text;
    }
}

TEST_P(DamagedStatements, giveOneErrorAtItsPlaceAndKeepTheirText)
{
    const LanguageContext& context = GetParam()();
    const std::vector<Damaged> cases = Damager(context).all();
    EXPECT_GE(cases.size(), 300u);
    for (const Damaged& damaged : cases) {
        const CheckedSources checked = check(context, damaged.text);
        EXPECT_EQ(errorsOf(checked.diagnostics), damaged.error) << damaged.what << "\n" << damaged.text;
        EXPECT_FALSE(checked.programs) << damaged.text;
        EXPECT_EQ(writeIl(parseIl(*context.dialect, damaged.text)), damaged.text);
    }
}

INSTANTIATE_TEST_SUITE_P(Families, DamagedStatements, testing::Values(ks105, ts635),
                         [](const auto& info) { return std::string(info.index == 0 ? "Kinco" : "Ts600"); });

/// Labels, loops, declarations and events: whole programs and all their messages.
struct Program {
    const char* name;
    const LanguageContext& (*context)();
    ProgramRole role;
    const char* text;
    const char* codes;
};

class DamagedPrograms : public testing::TestWithParam<Program> {};

TEST_P(DamagedPrograms, areLocated)
{
    const LanguageContext& context = GetParam().context();
    const ProgramSource source{{ObjectKind::Program, "Main"}, GetParam().role, GetParam().text};
    const CheckedSources checked = checkSources({&source, 1}, context);
    EXPECT_EQ(codesOf(checked.diagnostics), GetParam().codes);
    EXPECT_EQ(writeIl(parseIl(*context.dialect, GetParam().text)), GetParam().text);
}

constexpr auto Main = ProgramRole::Main;
constexpr auto Sub = ProgramRole::Subroutine;
constexpr auto Int = ProgramRole::Interrupt;
#define NET "(* Network 0 *)\n"
#define VARS(a) "VAR_INPUT\n" a "END_VAR\nLD X0\nOUT Y0\n"
const Program Programs[] = {
    // Labels.
    {"jumpNowhere", ks101m, Main, NET "LD %M0.0\nJMPC a\n", "CW3324@3:6"},
    {"jumpNowhereTs600", ts635, Main, "LD X0\nCJ 5\n", "CW3324@2:4"},
    {"labelTwice", ks101m, Main, NET "LBL a\nLBL A\n", "CW3325@3:5"},
    {"labelTwiceTs600", ts635, Main, "LBL 5\nLD X0\nINC D0\nLBL 5\n", "CW3325@4:5"},
    {"labelIsAnAddress", ks101m, Main, NET "LBL %M0.0\n", "CW3324@2:5"},
    {"labelIsNegative", ts635, Main, "LBL -5\n", "CW3324@1:5"},
    {"labelLeftOut", ks101m, Main, NET "LBL\n", "CW3203@2:1"},
    {"jumpToFillIn", ks101m, Main, NET "LD %M0.0\nJMP ???\n", "CW3205@3:5"},
    {"labelStandsAlone", ks101m, Main, NET "LBL a\n", ""},
    {"jumpFromOtherCase", ks101m, Main, NET "LD %M0.0\nJMPC Ab\n(* Network 1 *)\nLBL aB\n", ""},
    // Loops.
    {"loopOpen", ks101m, Main, NET "LD %M0.0\nFOR %VW0, 1, 5\n", "CW3407@3:1"},
    {"loopOpenTs600", ts635, Main, "LD X0\nFOR 5\nLD X0\nINC D0\n", "CW3407@2:1"},
    {"loopsOpenTwice", ts635, Main, "LD X0\nFOR 5\nFOR 6\nNEXT\n", "CW3407@2:1"},
    {"nextAlone", ts635, Main, "NEXT\n", "CW3408@1:1"},
    {"nextTwice", ks101m, Main, NET "LD %M0.0\nFOR %VW0, 1, 5\nNEXT\nNEXT\n", "CW3408@5:1"},
    {"loopWithAConstantIndex", ks101m, Main, NET "LD %M0.0\nFOR 1, 1, 5\nNEXT\n", "CW3213@3:5"},
    {"loopOverReals", ks101m, Main, NET "LD %M0.0\nFOR %VW0, 1.5, 5\nNEXT\n", "CW3216@3:11"},
    {"nextWithOperand", ts635, Main, "LD X0\nFOR 5\nNEXT 5\n", "CW3204@3:6"},
    // Declarations.
    {"noType", ts635, Sub, VARS("  IN1 INT\n"), "CW3316@2:3"},
    {"noName", ts635, Sub, VARS("  : INT;\n"), "CW3316@2:3"},
    {"unknownType", ts635, Sub, VARS("  IN1 : LREAL;\n"), "CW3316@2:3"},
    {"nameBeginsWithADigit", ts635, Sub, VARS("  1IN : INT;\n"), "CW3316@2:3"},
    {"nameTwice", ts635, Sub, VARS("  A : INT;\n  A : BOOL;\n"), "CW3316@3:3"},
    {"textBehindTheSection", ts635, Sub, "VAR_INPUT A : INT;\nEND_VAR\nLD X0\nOUT Y0\n", "CW3316@1:1"},
    {"sectionNotClosed", ts635, Sub, "VAR_INPUT\n  A : INT;\nLD X0\nOUT Y0\n", "CW3316@3:1"},
    {"declaredAndUsed", ts635, Sub, VARS("  A : INT;\n") "LD X1\nINC #A\nINC A\n", ""},
    {"localUnknown", ts635, Sub, VARS("  A : INT;\n") "LD X1\nINC #B\n", "CW3301@7:5"},
    {"localOfAnotherType", ts635, Sub, VARS("  A : BOOL;\n") "LD X1\nINC A\n", "CW3210@7:5"},
    {"localConstantIntoIt", ts635, Sub, VARS("  A : REAL;\n") "LD X1\nMOV 5 A\n", "CW3214@7:7"},
    {"tooManyBits", ts635, Sub,
     VARS("A1:BOOL\nA2:BOOL\nA3:BOOL\nA4:BOOL\nA5:BOOL\nA6:BOOL\nA7:BOOL\nA8:BOOL\nA9:BOOL\nA10:BOOL\nA11:BOOL\nA12:BOOL\nA13:BOOL\nA14:BOOL\nA15:BOOL\nA16:BOOL\nA17:BOOL\n"), "CW3317@18:1"},
    {"tooManyWords", ts635, Sub,
     VARS("A1:INT\nA2:INT\nA3:INT\nA4:INT\nA5:INT\nA6:INT\nA7:INT\nA8:REAL\nA9:INT\nA10:INT\nA11:INT\nA12:INT\nA13:INT\nA14:INT\nA15:INT\nA16:INT\nA17:INT\nB:BOOL\n"), "CW3317@18:1"},
    {"declarationOnKinco", ks101m, Sub, "VAR_INPUT\n", "CW3015@1:1 CW3101@1:1 CW3201@1:1"},
    // Events.
    {"eventNotOne", ts635, Int, "EVENT X0 UP\nLD X0\nOUT Y0\n", "CW3318@1:1"},
    {"eventOfAnOutput", ts635, Int, "EVENT Y0 RISING\nLD X0\nOUT Y0\n", "CW3318@1:1"},
    {"eventEmpty", ts635, Int, "EVENT\nLD X0\nOUT Y0\n", "CW3318@1:1"},
    {"eventZero", ts635, Int, "EVENT 0 ms\nLD X0\nOUT Y0\n", "CW3318@1:1"},
    {"eventTooLong", ts635, Int, "EVENT 1001 ms\nLD X0\nOUT Y0\n", "CW3318@1:1"},
    {"eventOfX8", ts635, Int, "EVENT X8 RISING\nLD X0\nOUT Y0\n", "CW3318@1:1"},
    {"eventInMain", ts635, Main, "EVENT 10 ms\nLD X0\nOUT Y0\n", "CW3313@1:1"},
    {"eventLongest", ts635, Int, "event 1000 MS\nLD X0\nOUT Y0\n", ""},
    {"noEvent", ts635, Int, "LD X0\nOUT Y0\n", "CW3319@1:1"},
    {"noAttach", ks101m, Int, NET "LD %M0.0\nST %M0.1\n", "CW3319@1:1"},
    {"attachMain", ks101m, Main, NET "LD %M0.0\nATCH Main, 3\n", "CW3313@3:6"},
    {"attachNobody", ks101m, Main, NET "LD %M0.0\nATCH Nobody, 3\n", "CW3313@3:6"},
    {"attachToNoEvent", ks101m, Main, NET "LD %M0.0\nATCH Tick, 256\n", "CW3217@3:12"},
    {"callInInterrupt", ts635, Int, "EVENT 10 ms\nLD X0\nCALL Init\n", "CW3314@3:6"},
    {"callInKincoInterruptIsFine", ks101m, Int, NET "LD %M0.0\nCAL Init\n", "CW3319@1:1"},
};
INSTANTIATE_TEST_SUITE_P(Text, DamagedPrograms, testing::ValuesIn(Programs), [](const auto& info) { return info.param.name; });

/// TS-SBR-01.
TEST(DamagedCallsTest, nestSixDeepAndAreSixtyFourAtMost)
{
    std::vector<std::string> texts;
    for (int level = 1; level <= 7; ++level)
        texts.push_back(level < 7 ? "LD X0\nCALL Level" + std::to_string(level + 1) + "\n" : "LD X0\nOUT Y0\n");
    Project project;
    const auto add = [&](const ObjectKey& key, ObjectContent content) {
        project = project.with(key, std::make_shared<const Object>(Object{key, 0, std::move(content), {}}));
    };
    ControllerSettings controller;
    controller.family = "invt";
    controller.model = "TS635";
    add(controllerKey(), controller);
    std::vector<ProgramSource> sources{{{ObjectKind::Program, "Main"}, ProgramRole::Main, "LD X0\nCALL Level1\n"}};
    for (std::size_t i = 0; i < texts.size(); ++i) {
        const ObjectKey key{ObjectKind::Program, "Level" + std::to_string(i + 1)};
        add(key, ::camwright::Program{ProgramRole::Subroutine, {}, texts[i]});
        sources.push_back({key, ProgramRole::Subroutine, texts[i]});
    }
    const CheckedSources deep = checkSources(sources, *contextOf(project));
    EXPECT_EQ(codesOf(deep.diagnostics), "CW3415@2:6");
    EXPECT_EQ(deep.diagnostics.at(0).place.object.name, "Level6");
    sources.pop_back();
    sources.back().text = "LD X0\nOUT Y0\n";
    EXPECT_EQ(codesOf(checkSources(sources, *contextOf(project)).diagnostics), "");
    std::vector<std::string> names;
    for (int i = 0; i < 60; ++i)
        names.push_back("Part" + std::to_string(i));
    for (const std::string& name : names)
        sources.push_back({{ObjectKind::Program, name}, ProgramRole::Subroutine, "LD X0\nOUT M0\n"});
    EXPECT_EQ(codesOf(checkSources(sources, *contextOf(project)).diagnostics), "CW3416@1:1");
}

} // namespace
