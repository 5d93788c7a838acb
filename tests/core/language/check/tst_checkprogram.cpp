#include "core/language/check/operandtypes.h"
#include "tests/core/language/check/checking.h"

#include <gtest/gtest.h>

using namespace camwright;
using namespace camwright::test;

namespace {

/// One line after an LD, and the codes it must give: on Kinco line 3, on TS600 line 2.
struct Case {
    const char* name;
    const LanguageContext& (*context)();
    const char* line;
    const char* codes;
};

class LineCases : public testing::TestWithParam<Case> {};

TEST_P(LineCases, areLocated)
{
    const LanguageContext& context = GetParam().context();
    const bool kinco = context.dialect->networkHeaders;
    const std::string text = (kinco ? "(* Network 0 *)\nLD %SM0.0\n" : "LD SM0\n") + std::string(GetParam().line) + "\n";
    const CheckedSources checked = check(context, text);
    EXPECT_EQ(codesOf(checked.diagnostics), GetParam().codes);
    EXPECT_EQ(checked.programs.has_value(), !hasErrors(checked.diagnostics));
    for (const Diagnostic& d : checked.diagnostics)
        EXPECT_EQ(d.place.object.name, "Main");
}

const Case Cases[] = {
    // Words.
    {"bn", ks101m, "BN %VW308, 0", "CW3202@3:1"}, // KS-IL-10
    {"nearMnemonic", ks101m, "MC_POWR %M0.0, 1, %M0.1, %M0.2, %MB4", "CW3202@3:1"},
    {"farMnemonic", ks101m, "FROBNICATE %M0.0", "CW3201@3:1"},
    {"garbledMnemonic", ks101m, "MC_RESTRAT %M0.0, 1, 10, %M0.1, %M0.2, %MB4", "CW3202@3:1"},
    {"cyrillicMnemonic", ks101m, "МOVE 1, %VW0", "CW3005@3:1"},
    {"hugeMnemonic", ks101m, "AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA", "CW3201@3:1"},
    {"lowerCase", ks101m, "move 1, %VW0", ""},
    {"ts600WordOnKinco", ks101m, "OUT %M0.0", "CW3202@3:1"},
    {"kincoWordOnTs600", ts635, "ST M0", "CW3202@2:1"},
    // Operand count (KS-IL-08).
    {"none", ks101m, "MOVE", "CW3203@3:1"},
    {"one", ks101m, "MOVE 1", "CW3203@3:1"},
    {"three", ks101m, "MOVE 1, %VW0, %VW2", "CW3204@3:15"},
    {"noOperandWanted", ks101m, "R_TRIG %M0.0", "CW3501@2:1 CW3204@3:8"},
    {"toFillIn", ks101m, "MOVE ???, %VW0", "CW3205@3:6"},
    {"notOptional", ks101m, "MOVE _, %VW0", "CW3206@3:6"},
    {"optionalLeftEmpty", ks101m, "CTUD C0, %M0.0, %M0.1, %M0.2, 5, _", ""},
    {"optionalLeftOut", ks101m, "CTUD C0, %M0.0, %M0.1, %M0.2, 5", ""},
    {"ts600TooMany", ts635, "MOV 5 D0 D1", "CW3204@2:10"},
    // Pins by name (C6).
    {"byName", ks101m, "MOVE OUT:=%VW0, IN:=5", ""},
    {"byNameAfterPlace", ks101m, "MOVE 5, OUT:=%VW0", ""},
    {"unknownPin", ks101m, "MOVE 5, OTU:=%VW0", "CW3207@3:14"},
    {"pinTwice", ks101m, "MOVE 5, IN:=6, OUT:=%VW0", "CW3208@3:13"},
    {"ts600ByName", ts635, "MOV S:=5 D:=D0", ""},
    // Addresses.
    {"missingPercent", ks101m, "ST M0.1", "CW2002@3:4"},
    {"outOfRange", ks101m, "ST %M5000.0", "CW2005@3:4"},
    {"bitOutOfRange", ks101m, "ST %M0.8", "CW2007@3:8"},
    {"unknownArea", ks101m, "ST %X0.0", "CW2001@3:5"},
    {"oddWord", ks101m, "MOVE 1, %VW1", "CW2008@3:9"},
    {"smallModel", ks105, "MOVE 1, %VW4096", "CW2005@3:9"},
    {"notOctal", ts635, "OUT Y8", "CW2006@2:6"},
    {"wordTooHigh", ts635, "MOV 1 D32768", "CW2005@2:7"},
    {"bitOfWord", ts635, "OUT D0.15", ""},
    {"bitOfWordTooHigh", ts635, "OUT D0.16", "CW2007@2:8"},
    // Areas.
    {"writesInput", ks101m, "ST %I0.0", "CW3210@3:4"},
    {"writesX", ts635, "OUT X0", "CW3210@2:5"},
    {"motionNotFromInput", ks101m, "MC_POWER %I0.0, 1, %M0.1, %M0.2, %MB4", "CW3210@3:10"},
    {"motionNotToOutput", ks101m, "MC_POWER %M0.0, 1, %Q0.1, %M0.2, %MB4", "CW3210@3:20"},
    {"constantOnly", ks105, "PLS %VW0", "CW3211@3:5"},
    {"constantBit", ks101m, "ST TRUE", "CW3213@3:4"},
    {"constantOut", ks101m, "MOVE %VW0, 5", "CW3213@3:12"},
    {"constantList", ks101m, "MC_RPARAS %M0.1, 1, 5, 3, %M0.2, %M0.3, %MD8, %VD1200", "CW3212@3:21"},
    {"timerWanted", ks101m, "TON %VW0, 5", "CW3220@3:5"},
    {"timerNotCounter", ks101m, "TON C0, 5", "CW3220@3:5"},
    {"timerNotConstant", ts635, "TON 3 5", "CW3220@2:5"},
    {"counterWanted", ks101m, "CTU T0, %M0.0, 5", "CW3221@3:5"},
    {"counterRange", ts635, "CTU C200 5", "CW3217@2:5"},
    {"timerValueAsWord", ks101m, "MOVE T0, %VW0", ""},
    {"timerValueInTs600", ts635, "MOV T0 D0", ""},
    // Types.
    {"bitFromWord", ks101m, "ST %VW0", "CW3214@3:4"},
    {"wordFromBit", ks101m, "MOVE %M0.0, %VW0", "CW3214@3:6"},
    {"realFromInteger", ks101m, "MOVE %VW0, %VR4", "CW3215@3:12"},
    {"byteToWord", ks101m, "MOVE B#1, %VW0", "CW3215@3:11"},
    {"realConstantToDint", ks101m, "MOVE 1.5, %VD0", "CW3215@3:11"},
    {"integerToRealConstant", ks101m, "MOVE 5, %VR0", "CW3215@3:9"},
    {"integerForReal", ks101m, "MC_JOG %M0.0, 1, 250, 0, %M0.1, %M0.2, %MB4, %M0.3", "CW3216@3:18"},
    {"realForInt", ks101m, "TON T0, 1.5", "CW3216@3:9"},
    {"typedConstantOfOtherType", ks101m, "TON T0, DI#5", "CW3214@3:9"},
    {"malformedConstant", ks101m, "MOVE 16#G, %VW0", "CW3216@3:6"},
    {"unknownPrefix", ks101m, "MOVE QQ#1, %VW0", "CW3216@3:6"},
    {"sizes", ks101m, "MOVE 300, %VB0", "CW0004@3:6"},
    {"negativeByte", ks101m, "MOVE -1, %VB0", "CW0004@3:6"},
    {"wordHoldsUnsigned", ks101m, "MOVE 40000, %VW0", ""},
    {"ts600Unsigned", ts635, "MOV 40000 D0", ""},
    {"ts600TooBig", ts635, "MOV 70000 D0", "CW0004@2:5"},
    {"ts600DoubleWord", ts635, "DMOV 70000 D0", ""},
    {"ts600Real", ts635, "RMOV 123.1230 D10", ""},
    {"ts600RealNeedsPoint", ts635, "RMOV 123 D10", "CW3216@2:6"},
    {"doubleWordAtTheEnd", ts635, "DMOV 1 D32767", "CW3214@2:8"},
    {"compareTypes", ks101m, "GE %VW0, %VD4", "CW3501@2:1 CW3215@3:10"},
    {"compareConstant", ks101m, "GE %VR0, 0.5", "CW3501@2:1"},
    // Ranges, groups, blocks.
    {"numZero", ks101m, "MC_RPARAS %M0.1, 1, %VB100, 0, %M0.2, %M0.3, %MD8, %VD1200", "CW3217@3:29"},
    {"num33", ks101m, "MC_RPARAS %M0.1, 1, %VB100, 33, %M0.2, %M0.3, %MD8, %VD1200", "CW3217@3:29"},
    {"axisZero", ks101m, "MC_POWER %M0.0, 0, %M0.1, %M0.2, %MB4", "CW3217@3:17"},
    {"mixedGroup", ks101m, "MC_RPARAS %M0.1, %VW0, %VB100, 3, %M0.2, %M0.3, %MD8, %VD1200", "CW3218@3:32"}, // KS-MEM-08
    {"allMemory", ks101m, "MC_RPARAS %M0.1, %VW0, %VB100, %VW2, %M0.2, %M0.3, %MD8, %VD1200", ""},
    {"mixedRestart", ks101m, "MC_RESTART %M0.1, 1, %VW2, %M0.2, %M0.3, %MB8", "CW3218@3:22"},
    {"listOverTheEnd", ks101m, "MC_RPARAS %M0.1, 1, %VB16382, 3, %M0.2, %M0.3, %MD8, %VD1200", "CW3219@3:21"}, // KS-MEM-07
    {"valuesOverTheEnd", ks101m, "MC_RPARAS %M0.1, 1, %VB100, 3, %M0.2, %M0.3, %MD8, %VD16376", "CW3219@3:52"},
    {"listJustFits", ks101m, "MC_RPARAS %M0.1, 1, %VB100, 3, %M0.2, %M0.3, %MD8, %VD16372", ""},
    {"listOfUnknownLength", ks101m, "MC_RPARAS %M0.1, %VW0, %VB16383, %VW2, %M0.2, %M0.3, %MD8, %VD16380", ""},
    {"listInTheWrongWidth", ks101m, "MC_RPARAS %M0.1, 1, %VW100, 3, %M0.2, %M0.3, %MD8, %VD1200", "CW3214@3:21"},
    // Names (KS-MEM-06).
    {"symbol", ks101m, "ST Start", ""},
    {"unknownSymbol", ks101m, "ST Nothing", "CW3301@3:4"},
    {"nearSymbol", ks101m, "ST Strat", "CW3302@3:4"},
    {"caseOfSymbol", ks101m, "ST START", "CW3302@3:4"},
    {"symbolOfOtherType", ks101m, "MOVE 5, Speed", "CW3215@3:9"},
    {"forcedType", ks101m, "MOVE I#5, %VW200", "CW3215@3:11"},
    {"forcedTypeOfPin", ks101m, "TON T0, %VW200", "CW3303@3:9"},
    {"forcedTypeKept", ks101m, "MOVE W#5, %VW200", ""},
    {"listMayHoldAnyType", ks101m, "MC_RPARAS %M0.1, 1, %VB0, 3, %M0.2, %M0.3, %MD8, %VD100", ""},
    {"unboundVariable", ts635, "OUT Lamp", ""},
    {"boundVariable", ts635, "OUT 电机", ""},
    {"unboundWrongType", ts635, "MOV 1 Total", "CW3214@2:7"},
    {"unboundDint", ts635, "DMOV 1 Total", ""},
    {"element", ts635, "OUT Lamp[3]", "CW3301@2:5"},
    {"cyrillicOperand", ts635, "OUT У0", "CW3005@2:5"},
    // Calls.
    {"call", ks101m, "CAL Init", ""},
    {"callInTs600", ts635, "CALL Init", ""},
    {"unknownSubroutine", ks101m, "CAL Missing", "CW3304@3:5"},
    {"nearSubroutine", ks101m, "CAL Intt", "CW3309@3:5"},
    {"callsMain", ks101m, "CAL Main", "CW3305@3:5"},
    {"callsInterrupt", ks101m, "CAL Tick", "CW3305@3:5"},
    {"callsAddress", ks101m, "CAL %M0.0", "CW3304@3:5"},
    {"arguments", ts635, "CALL Init 3 2 D0", "CW3307@2:11"},
    // Models.
    {"pulseOnKs101m", ks101m, "PLS 0", "CW3401@3:1"},
    {"pulseOnKs105", ks105, "PLS 0", ""},
    {"pulseChannel", ks105, "PLS 4", "CW3217@3:5"},
    {"axisNotThere", ks101m, "MC_POWER %M0.0, 3, %M0.1, %M0.2, %MB4", "CW3503@3:17"},
};
INSTANTIATE_TEST_SUITE_P(Lines, LineCases, testing::ValuesIn(Cases), [](const auto& info) { return info.param.name; });

TEST(CheckProgramTest, givesTheWayOutInWords)
{
    const auto text = [](const std::string& line) {
        const CheckedSources checked = check(ks101m(), "(* Network 0 *)\nLD %SM0.0\n" + line + "\n");
        return checked.diagnostics.empty() ? "" : englishText(checked.diagnostics.front());
    };
    EXPECT_EQ(text("BN %VW308, 0"), "\"BN\" is not an instruction of Kinco KS. Did you mean GE?");
    EXPECT_EQ(text("MOVE 5"), "MOVE lacks the operand OUT. It is written MOVE IN, OUT.");
    EXPECT_EQ(text("MC_JOG %M0.0, 1, 250, 0, %M0.1, %M0.2, %MB4, %M0.3"), "\"250\" is not a constant of type REAL. Write it like 250.0.");
    EXPECT_EQ(text("MC_RPARAS %M0.1, %VW0, %VB100, 3, %M0.2, %M0.3, %MD8, %VD1200"),
        "The operands AXIS, NUM of MC_RPARAS are all constants or all memory. Here they are mixed.");
    EXPECT_EQ(text("MC_RPARAS %M0.1, 1, %VB16382, 3, %M0.2, %M0.3, %MD8, %VD1200"),
        "The 3 elements that begin at %VB16382 do not fit into the memory area. They need 3 bytes, and 2 are left.");
    EXPECT_EQ(text("ST %I0.0"), "%I0.0 cannot be the operand BIT of ST. The memory areas allowed are Q, M, V, L, SM.");
    EXPECT_EQ(text("TON T0, %VW200"), "The variable table makes %VW200 the WORD variable Count; here it is used as INT. Use it as WORD, or change the variable.");
}

TEST(CheckProgramTest, pointsFromAForcedTypeToItsVariable)
{
    const CheckedSources checked = check(ks101m(), "(* Network 0 *)\nLD %SM0.0\nTON T0, %VW200\n");
    ASSERT_TRUE(checked.diagnostics.at(0).related);
    EXPECT_EQ(checked.diagnostics[0].related->object, (ObjectKey{ObjectKind::VariableTable, "Globals"}));
    EXPECT_EQ(checked.diagnostics[0].related->field, "rows[2]");
}

TEST(CheckProgramTest, laysUnboundVariablesOneAfterAnother) // C8
{
    const CheckedSources checked = check(ts635(), "LD Lamp\nDMOV Total D0\n");
    ASSERT_TRUE(checked.programs);
    const auto& statements = checked.programs->front().networks[0].rungs[0].statements;
    EXPECT_EQ(show(statements[0], *ts635().family), "LD Lamp@0:BOOL");
    EXPECT_EQ(show(statements[1], *ts635().family), "DMOV Total@2:DINT D0:DINT");
    EXPECT_EQ(ts635().variableBytes, 6u);
}

TEST(CheckProgramTest, keepsTheFlowOfATextRungInOrder)
{
    const CheckedSources checked = check(ks101m(), "(* Network 0 *)\nLD %M0.0\nST %M0.1\nOR %M0.2\nST %M0.3\n");
    ASSERT_TRUE(checked.programs);
    const CheckedRung& rung = checked.programs->front().networks[0].rungs[0];
    EXPECT_FALSE(rung.drawable);
    EXPECT_EQ(rung.statements.size(), 4u);
    EXPECT_EQ(rung.statements[2].role, StatementRole::Or);
}

TEST(CheckProgramTest, refusesGroupsWhenStrict) // C32
{
    LanguageContext strict = ks101m();
    strict.strictKinco = true;
    const std::string text = "(* Network 0 *)\nLD %M0.0\nAND( %M0.1\nOR %M0.2\n)\nST %M0.3\n";
    EXPECT_EQ(codesOf(check(ks101m(), text).diagnostics), "");
    EXPECT_EQ(codesOf(check(strict, text).diagnostics), "CW3110@3:1");
}

TEST(CheckProgramTest, knowsTheTypesOfEveryFormAsTheFamilyDoes)
{
    for (const LanguageContext* context : {&ks101m(), &ks105(), &ts635()})
        for (const char* text : {"%M0.1", "%VB0", "%VW304", "%VD6", "%VR8", "%AIW0", "%VD16380", "%VD4092", "%SMD208", "T5", "C5", "X17", "Y0", "D0", "D0.3",
                 "D32767", "Z0", "R5", "SM1", "C200", "S9"}) {
            const auto address = context->family->parseAddress(text, *context->model);
            if (!address)
                continue;
            const MemoryTypes types = typesOf({*address, nullptr}, *context);
            if (types.forcing)
                continue;
            for (unsigned i = 1; i <= 16; ++i) {
                const auto type = static_cast<DataType>(i);
                EXPECT_EQ(types.possible.contains(type), context->family->withType(*address, type, *context->model).ok()) << text << ' ' << name(type);
            }
        }
}

TEST(CheckProgramTest, everyStructuralMnemonicIsInTheCatalogue)
{
    for (const char* id : {"kinco", "invt"}) {
        const Family& family = *findFamily(id);
        const Dialect& dialect = *dialectOfFamily(id);
        for (const Instruction& instruction : family.catalogue().instructions()) {
            const CrEffect effect = instruction.crEffect;
            const bool structural = effect == CrEffect::Loads || effect == CrEffect::Stacks || effect == CrEffect::Combines;
            EXPECT_EQ(dialect.shapeOf(instruction.mnemonic).role == StatementRole::Block && structural, false) << instruction.mnemonic;
        }
        for (int role = 0; role < static_cast<int>(StatementRole::Block); ++role) {
            const std::string_view word = dialect.structureMnemonic(static_cast<StatementRole>(role));
            EXPECT_TRUE(word.empty() || family.catalogue().find(word)) << word;
        }
    }
}

} // namespace
