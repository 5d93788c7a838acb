#include "core/checks/checkproject.h"
#include "core/base/diagnostic.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace camwright;

namespace {

const ObjectKey TableKey{ObjectKind::VariableTable, "Globals"};
const ObjectKey NetworkKey{ObjectKind::Network, "CANopen"};

ObjectKey axisKey(int number) { return {ObjectKind::Axis, "Axis" + std::to_string(number)}; }

Axis axisNumber(std::int64_t number)
{
    Axis out;
    out.number = number;
    return out;
}

Project kinco(const char* model = "KS101M-04DX", int axes = 2)
{
    Project out = Project().withName("Test").withContent(controllerKey(), ControllerSettings{"kinco", model, 0, 500, ""});
    out = out.withContent({ObjectKind::Program, "Main"}, Program{ProgramRole::Main, ProgramLanguage::InstructionList, "LD %SM0.0\n"});
    for (int n = 1; n <= axes; ++n)
        out = out.withContent(axisKey(n), axisNumber(n));
    return axes == 0 ? out : out.withContent(NetworkKey, Network{});
}

Project ts600()
{
    return kinco("", 0).withContent(controllerKey(), ControllerSettings{"invt", "TS635", 0, 500, ""});
}

Project withVariables(const Project& project, std::vector<Variable> rows)
{
    return project.withContent(TableKey, VariableTable::of(rows));
}

Variable variable(const char* name, DataType type, const char* address = "", const char* initial = "")
{
    return {name, type, address, initial, false, ""};
}

/// "CW1107 number" for each diagnostic: its code and the field it stands at.
std::vector<std::string> found(const Project& project)
{
    std::vector<std::string> out;
    for (const Diagnostic& d : checkProject(project))
        out.push_back(std::string(codeInfo(d.code).id) + ' ' + d.place.field);
    return out;
}

using List = std::vector<std::string>;

TEST(CheckProjectTest, aSoundProjectBecomesAValidOne)
{
    Project project = withVariables(kinco(), {variable("Start", DataType::Bool, "%M0.0"), variable("Speed", DataType::Real, "%VR100", "6000.0")});
    Axis turn = axisNumber(2);
    turn.type = AxisType::Rotary;
    turn.mechanicalEquivalent = 45.0;
    project = project.withContent(axisKey(2), turn);
    const Validation result = validate(project);
    ASSERT_TRUE(result.project.has_value()) << englishLine(result.diagnostics.front());
    EXPECT_TRUE(result.diagnostics.empty());
    EXPECT_EQ(result.project->model().name, "KS101M-04DX");
    ASSERT_EQ(result.project->axes().size(), 2u);
    EXPECT_EQ(result.project->axes()[1].type, AxisType::Rotary);
    EXPECT_DOUBLE_EQ(result.project->axes()[1].pulsesPerUnit(), 10000 / 45.0);
    EXPECT_EQ(result.project->network()->baudrate, 1000000u);
    EXPECT_EQ(result.project->network()->sdoTimeout, 100ms);
    EXPECT_EQ(result.project->mainProgram().source, "LD %SM0.0\n");
    ASSERT_EQ(result.project->variables().size(), 2u);
    EXPECT_EQ(result.project->variables()[1].initial, Value::ofReal(6000.0f));
    EXPECT_EQ(result.project->variables()[1].address->type, DataType::Real);
    EXPECT_EQ(result.project->watchdog(), 500ms);
}

TEST(CheckProjectTest, axesAreSortedByNumberWhateverTheirOrder)
{
    const Project project = kinco("KS101M-04DX", 3).withContent(axisKey(1), axisNumber(3)).withContent(axisKey(3), axisNumber(1));
    const Validation result = validate(project);
    ASSERT_TRUE(result.project.has_value());
    EXPECT_EQ(result.project->axes()[0].name, "Axis3");
    EXPECT_EQ(result.project->axes()[2].name, "Axis1");
}

TEST(CheckProjectTest, theMainProgramStandsFirst)
{
    Project project = Project().withName("x").withContent({ObjectKind::Program, "Grip"}, Program{ProgramRole::Subroutine, {}, ""});
    project = project.withContent(controllerKey(), ControllerSettings{"kinco", "KS101M-04DX", 0, 500, ""});
    project = project.withContent({ObjectKind::Program, "Main"}, Program{});
    const Validation result = validate(project);
    ASSERT_TRUE(result.project.has_value());
    EXPECT_EQ(result.project->mainProgram().name(), "Main");
    EXPECT_EQ(result.project->programs()[1].name(), "Grip");
}

TEST(CheckProjectTest, axisNumbersAreContiguousFromOne) // KS-MCN-06
{
    EXPECT_EQ(found(kinco().withContent(axisKey(2), axisNumber(1))), (List{"CW1107 number"}));
    EXPECT_EQ(found(kinco().withContent(axisKey(2), axisNumber(3))), (List{"CW1108 number"}));
    EXPECT_EQ(found(kinco().withContent(axisKey(1), axisNumber(3))), (List{"CW1108 number"}));
    EXPECT_EQ(found(kinco().with(axisKey(1), nullptr)), (List{"CW1108 number"}));
    EXPECT_EQ(found(kinco().withContent(axisKey(1), axisNumber(0))), (List{"CW1102 number", "CW1108 number"}));
}

TEST(CheckProjectTest, twoAxesWithOneNumberAreBothNamed)
{
    const Diagnostics out = checkProject(kinco().withContent(axisKey(2), axisNumber(1)));
    ASSERT_EQ(out.size(), 1u);
    EXPECT_EQ(out[0].place.object, axisKey(2));
    ASSERT_TRUE(out[0].related.has_value());
    EXPECT_EQ(out[0].related->object, axisKey(1));
    EXPECT_EQ(englishText(out[0]), "Axis number 1 is used by \"Axis1\" and by \"Axis2\". Give one of them another number.");
}

TEST(CheckProjectTest, modelsLimitTheNumberOfAxes) // KS-MCN-10, KS-CPU-01
{
    EXPECT_EQ(found(kinco("KS105C1-16DT", 16)), List{});
    EXPECT_EQ(found(kinco("KS105C1-16DT", 17)), (List{"CW1106 model"}));
    EXPECT_EQ(found(kinco("KS101M-04DX", 32)), List{"CW6008 baudrate"}); // taken, but see the load of the bus
    EXPECT_EQ(found(kinco("KS101M-04DX", 33)), (List{"CW1106 model", "CW6008 baudrate"}));
    EXPECT_EQ(found(kinco("KS105-16DT", 1)), (List{"CW1105 model"}));
    EXPECT_EQ(found(kinco("KS105-16DT", 0).withContent(NetworkKey, Network{})), (List{"CW1105 model"}));
}

TEST(CheckProjectTest, moreProcessDataThanTheWireCarriesIsAWarning) // KS-CAN-04
{
    const Project full = kinco("KS101M-04DX", 32);
    ASSERT_EQ(checkProject(full).size(), 1u);
    EXPECT_EQ(englishText(checkProject(full).front()),
              "The process data of 32 axes would load the bus with 106.56 % at 1000000 bit/s. Raise the PDO inhibit times or the baud rate.");
    EXPECT_TRUE(validate(full).project.has_value());
    Axis slower = axisNumber(32);
    slower.inhibitTimeMs = 1000;
    Axis second = axisNumber(31);
    second.inhibitTimeMs = 1000;
    EXPECT_EQ(found(full.withContent(axisKey(32), slower).withContent(axisKey(31), second)), List{});
}

TEST(CheckProjectTest, familyAndModelMustBeKnown)
{
    EXPECT_EQ(found(kinco("KS999", 0)), (List{"CW1104 model"}));
    EXPECT_EQ(found(kinco("K209M", 0)), (List{"CW1104 model"})) << "named in the manual for its limits only";
    EXPECT_EQ(found(kinco("", 0).withContent(controllerKey(), ControllerSettings{"kinko", "x", 0, 500, ""})), (List{"CW1103 family"}));
    EXPECT_EQ(found(kinco("", 0).with(controllerKey(), nullptr)), (List{"CW1120 "}));
}

TEST(CheckProjectTest, oneNetworkForAxes)
{
    EXPECT_EQ(found(kinco().with(NetworkKey, nullptr)), (List{"CW1118 "}));
    EXPECT_EQ(found(kinco().withContent({ObjectKind::Network, "Other"}, Network{})), (List{"CW1119 "}));
    EXPECT_EQ(found(kinco().withContent(NetworkKey, Network{123456, 100})), (List{"CW1109 baudrate"}));
    for (const std::int64_t rate : offeredBaudrates())
        EXPECT_TRUE(validate(kinco().withContent(NetworkKey, Network{rate, proposedSdoTimeoutMs(rate)})).project.has_value()) << rate;
}

TEST(CheckProjectTest, textsThatAreNoValuesAreNamedWithTheirField)
{
    Axis axis = axisNumber(1);
    axis.type = Field<AxisType>::typed("diagonal");
    axis.encoderResolution = Field<std::int64_t>::typed("ten");
    axis.mechanicalEquivalent = Field<double>::typed("1 inch");
    axis.simulation.homeSwitch = Field<double>::typed("");
    EXPECT_EQ(found(kinco().withContent(axisKey(1), axis)),
              (List{"CW1101 encoder_resolution", "CW1121 mechanical_equivalent", "CW1121 simulation.home_switch", "CW1122 type"}));
}

struct RangeCase {
    const char* field;
    void (*set)(Axis&);
};

class OutOfRange : public testing::TestWithParam<RangeCase> {};

TEST_P(OutOfRange, isRefused)
{
    Axis axis = axisNumber(1);
    GetParam().set(axis);
    EXPECT_EQ(found(kinco().withContent(axisKey(1), axis)), (List{std::string("CW1102 ") + GetParam().field}));
}

INSTANTIATE_TEST_SUITE_P(CheckProjectTest, OutOfRange, testing::Values(
    RangeCase{"encoder_resolution", [](Axis& a) { a.encoderResolution = 0; }},
    RangeCase{"encoder_resolution", [](Axis& a) { a.encoderResolution = 2147483648; }},
    RangeCase{"mechanical_equivalent", [](Axis& a) { a.mechanicalEquivalent = 0.0; }},
    RangeCase{"mechanical_equivalent", [](Axis& a) { a.mechanicalEquivalent = -1.0; }},
    RangeCase{"guard_time_ms", [](Axis& a) { a.guardTimeMs = 65536; }},
    RangeCase{"life_factor", [](Axis& a) { a.lifeFactor = -1; }},
    RangeCase{"inhibit_time_ms", [](Axis& a) { a.inhibitTimeMs = 6554; }},
    RangeCase{"event_timer_ms", [](Axis& a) { a.eventTimerMs = INT64_MAX; }},
    RangeCase{"simulation.start_position", [](Axis& a) { a.simulation.startPosition = 1e300; }},
    RangeCase{"simulation.inertia_ratio", [](Axis& a) { a.simulation.inertiaRatio = -0.5; }}));

TEST(CheckProjectTest, theLimitSwitchesAreInOrder)
{
    Axis axis = axisNumber(1);
    axis.simulation.lowerLimitSwitch = 10.0;
    axis.simulation.upperLimitSwitch = 10.0;
    EXPECT_EQ(found(kinco().withContent(axisKey(1), axis)), (List{"CW1126 simulation.lower_limit_switch"}));
}

TEST(CheckProjectTest, theWatchdogIsLongerThanTheScan) // TS-TIM-04
{
    const auto with = [](std::int64_t us, std::int64_t ms) {
        return found(kinco().withContent(controllerKey(), ControllerSettings{"kinco", "KS101M-04DX", us, ms, ""}));
    };
    EXPECT_EQ(with(100'000, 50), (List{"CW1110 watchdog_ms"}));
    EXPECT_EQ(with(50'000, 50), (List{"CW1110 watchdog_ms"}));
    EXPECT_EQ(with(49'999, 50), List{});
    EXPECT_EQ(with(0, 1), List{});
    EXPECT_EQ(with(-1, 0), (List{"CW1102 scan_period_us", "CW1102 watchdog_ms"}));
}

TEST(CheckProjectTest, strictKincoIsTrueOrFalse) // C32
{
    ControllerSettings settings{"kinco", "KS101M-04DX", 0, 500, ""};
    settings.strictKinco = true;
    EXPECT_EQ(found(kinco().withContent(controllerKey(), settings)), List{});
    settings.strictKinco = Field<bool>::typed("perhaps");
    EXPECT_EQ(found(kinco().withContent(controllerKey(), settings)), (List{"CW1122 strict_kinco"}));
}

TEST(CheckProjectTest, exactlyOneMainProgram)
{
    EXPECT_EQ(found(kinco().with({ObjectKind::Program, "Main"}, nullptr)), (List{"CW1116 "}));
    EXPECT_EQ(found(kinco().withContent({ObjectKind::Program, "Second"}, Program{})), (List{"CW1117 role"}));
    EXPECT_EQ(found(kinco().withContent({ObjectKind::Program, "no good"}, Program{ProgramRole::Subroutine, {}, ""})), (List{"CW1111 "}));
}

TEST(CheckProjectTest, namesOfObjectsDifferInMoreThanCase)
{
    EXPECT_EQ(found(kinco("KS101M-04DX", 1).withContent({ObjectKind::Axis, "AXIS1"}, axisNumber(2))), (List{"CW1112 "}));
    EXPECT_EQ(found(kinco("KS101M-04DX", 1).withContent({ObjectKind::Axis, ""}, axisNumber(2))), (List{"CW1125 "}));
}

TEST(CheckProjectTest, namesOfVariablesAreNoAddressesTypesOrInstructions) // TS-VAR-03
{
    for (const char* name : {"2nd", "start motor", "LD", "ld", "INT", "TRUE", "VW100", "_x", "a-b", "a.b", "\xE2\x80\xAEx", "a\xC2\xA0" "b", "MC_POWER"})
        EXPECT_EQ(found(withVariables(kinco(), {variable(name, DataType::Bool, "%M0.0")})), (List{"CW1111 rows[0].name"})) << name;
    for (const char* name : {"Start", "x_1", "Пуск", "进给"})
        EXPECT_EQ(found(withVariables(kinco(), {variable(name, DataType::Bool, "%M0.0")})), List{}) << name;
    for (const char* name : {"D100", "X17", "T5", "LDI"})
        EXPECT_EQ(found(withVariables(ts600(), {variable(name, DataType::Bool)})), (List{"CW1111 rows[0].name"})) << name;
}

TEST(CheckProjectTest, aNameOfTwoAlphabetsThatLookAlikeIsAWarning)
{
    EXPECT_EQ(found(withVariables(kinco(), {variable("St\xD0\xB0rt", DataType::Bool, "%M0.0")})), (List{"CW1127 rows[0].name"}));
    EXPECT_EQ(found(kinco("KS101M-04DX", 1).withContent({ObjectKind::Axis, "Ach\xD1\x81\xD0\xB5"}, axisNumber(2))), (List{"CW1127 "}));
}

TEST(CheckProjectTest, namesOfVariablesAreUniqueInAllTables)
{
    Project project = withVariables(kinco(), {variable("Start", DataType::Bool, "%M0.0")});
    project = project.withContent({ObjectKind::VariableTable, "More"}, VariableTable::of({variable("START", DataType::Bool, "%M0.1")}));
    const Diagnostics out = checkProject(project);
    ASSERT_EQ(out.size(), 1u);
    EXPECT_EQ(out[0].code, Code::NameTwice);
    EXPECT_EQ(out[0].related->object, TableKey);
    EXPECT_EQ(found(withVariables(kinco(), {variable("", DataType::Bool, "%M0.0")})), (List{"CW1125 rows[0].name"}));
}

TEST(CheckProjectTest, addressesAreTheFamilysOwn)
{
    EXPECT_EQ(found(withVariables(kinco(), {variable("a", DataType::Bool)})), (List{"CW1113 rows[0].address"}));
    EXPECT_EQ(found(withVariables(ts600(), {variable("a", DataType::Bool)})), List{});
    for (const char* address : {"M0.0", "%M9999.0", "%M0.8", "%ZZ1", "%VW", "D100"})
        EXPECT_EQ(found(withVariables(kinco(), {variable("a", DataType::Bool, address)})).size(), 1u) << address;
    EXPECT_EQ(found(withVariables(kinco(), {variable("a", DataType::Real, "%VW0")})).size(), 1u);
    EXPECT_EQ(found(withVariables(ts600(), {variable("a", DataType::Bool, "X8")})).size(), 1u) << "X is octal";
    EXPECT_EQ(found(withVariables(ts600(), {variable("a", DataType::Real, "D100"), variable("b", DataType::Bool, "Y17")})), List{});
}

TEST(CheckProjectTest, typesAreTheFamilysOwn) // KS-MEM-05, TS-VAR-01
{
    EXPECT_EQ(found(withVariables(kinco(), {variable("a", DataType::Lreal, "%VD0")})), (List{"CW1123 rows[0].type"}));
    EXPECT_EQ(found(withVariables(ts600(), {variable("a", DataType::Byte)})), (List{"CW1123 rows[0].type"}));
    Variable typed = variable("a", DataType::Bool, "%M0.0");
    typed.type = Field<DataType>::typed("STRING");
    EXPECT_EQ(found(withVariables(kinco(), {typed})), (List{"CW1122 rows[0].type"}));
}

TEST(CheckProjectTest, initialValuesFitTheType)
{
    EXPECT_EQ(found(withVariables(kinco(), {variable("a", DataType::Byte, "%VB0", "256")})), (List{"CW0004 rows[0].initial"}));
    EXPECT_EQ(found(withVariables(kinco(), {variable("a", DataType::Int, "%VW0", "x")})), (List{"CW0003 rows[0].initial"}));
}

TEST(CheckProjectTest, sharedMemoryIsAWarningThatNamesBoth)
{
    const auto overlaps = [](const Variable& a, const Variable& b) { return found(withVariables(kinco(), {a, b})); };
    EXPECT_EQ(overlaps(variable("a", DataType::Dint, "%VD0"), variable("b", DataType::Byte, "%VB3")), (List{"CW1114 rows[1].address"}));
    EXPECT_EQ(overlaps(variable("a", DataType::Byte, "%VB4"), variable("b", DataType::Dint, "%VD0")), List{});
    EXPECT_EQ(overlaps(variable("a", DataType::Bool, "%M0.0"), variable("b", DataType::Bool, "%M0.1")), List{});
    EXPECT_EQ(overlaps(variable("a", DataType::Bool, "%M1.7"), variable("b", DataType::Word, "%MW0")), (List{"CW1114 rows[0].address"}));
    const Validation result = validate(withVariables(kinco(), {variable("a", DataType::Dint, "%VD0"), variable("b", DataType::Real, "%VR0")}));
    EXPECT_TRUE(result.project.has_value());
    ASSERT_EQ(result.diagnostics.size(), 1u);
    EXPECT_EQ(result.diagnostics[0].severity(), Severity::Warning);
}

TEST(CheckProjectTest, retainIsDecidedByTheAddress) // TS-VAR-09
{
    Variable row = variable("a", DataType::Int, "D0");
    row.retain = true;
    EXPECT_EQ(found(withVariables(ts600(), {row})), (List{"CW1124 rows[0].address"}));
    row.address.clear();
    EXPECT_EQ(found(withVariables(ts600(), {row})), List{});
}

TEST(CheckProjectTest, everyProblemIsNamedSortedByPlace)
{
    Project project = kinco().withContent(axisKey(1), axisNumber(500)).with(NetworkKey, nullptr).with({ObjectKind::Program, "Main"}, nullptr);
    const Diagnostics out = checkProject(project);
    ASSERT_GE(out.size(), 4u);
    EXPECT_TRUE(std::is_sorted(out.begin(), out.end(), [](const Diagnostic& a, const Diagnostic& b) { return a.place < b.place; }));
    EXPECT_FALSE(validate(project).project.has_value());
    const Diagnostics rows = checkProject(withVariables(kinco(), std::vector<Variable>(12, variable("", DataType::Bool, "%M0.0"))));
    EXPECT_EQ(rows.back().place.field, "rows[11].name");
}

} // namespace
