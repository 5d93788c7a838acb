#include "core/family/embedded.h"
#include "core/family/family.h"
#include "core/family/familydata.h"
#include "core/family/invt/invtareas.h"
#include "core/family/kinco/kincoareas.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace camwright;

namespace {

const Family& kincoFamily() { return *findFamily("kinco"); }
const Family& invtFamily() { return *findFamily("invt"); }

TEST(FamilyTest, theEmbeddedTablesAreFlawless)
{
    for (std::string id : {"kinco", "invt", "koyo"}) {
        const auto data = readFamily([&id](std::string_view name) { return embeddedFamilyFile(id + "/" + std::string(name)); });
        if (data.ok())
            continue;
        for (const Diagnostic& diagnostic : data.error())
            ADD_FAILURE() << id << ' ' << englishLine(diagnostic);
    }
}

TEST(FamilyTest, familiesAreFoundByTheirId)
{
    ASSERT_EQ(families().size(), 3u);
    EXPECT_EQ(findFamily("kinco"), families()[0]);
    EXPECT_EQ(findFamily("invt")->displayName(), "INVT TS600");
    EXPECT_EQ(findFamily("koyo")->displayName(), "Koyo D2-MLINK");
    EXPECT_EQ(findFamily("Kinco"), nullptr);
    EXPECT_EQ(findFamily(""), nullptr);
}

TEST(FamilyTest, everyTextPeopleReadIsThereInThreeLanguages)
{
    for (const Family* family : families()) {
        for (const MemoryArea& area : family->areas())
            EXPECT_TRUE(area.meaning.isComplete()) << area.name;
        for (const AxisState& state : family->axisStates())
            EXPECT_TRUE(state.name.isComplete()) << state.id;
        for (const DriveParameter& parameter : family->driveParameters())
            EXPECT_TRUE(parameter.name.isComplete()) << parameter.number;
        for (const ErrorCategory& category : family->errorCategories())
            EXPECT_TRUE(category.module.isComplete()) << category.first;
        for (const ErrorText& error : family->errors())
            EXPECT_FALSE(error.text.en.empty()) << error.scope << ' ' << error.code;
    }
    for (const ErrorText& error : kincoFamily().errors())
        EXPECT_TRUE(error.text.isComplete()) << error.scope << ' ' << error.code;
}

TEST(KincoFactsTest, modelsHaveTheLimitsOfTheManual) // KS-CPU-01, KS-MC-01
{
    const ControllerModel& ks101 = *kincoFamily().findModel("KS101M-04DX");
    EXPECT_EQ(ks101.digitalInputs, 4u);
    EXPECT_EQ(ks101.digitalOutputs, 0u);
    EXPECT_EQ(ks101.pulseOutputs, 0u);
    EXPECT_EQ(ks101.axesMax, 32u);
    EXPECT_EQ(ks101.motionInstructionsMax, 1024u);
    EXPECT_EQ(ks101.restartInstructionsMax, 32u);
    EXPECT_EQ(ks101.programInstructionsMax, 8192u);
    EXPECT_EQ(ks101.area(kinco::M).bytes, 4096u);
    EXPECT_EQ(ks101.area(kinco::V).bytes, 16384u);
    const ControllerModel& ks105 = *kincoFamily().findModel("KS105-16DT");
    EXPECT_EQ(ks105.canPorts, 0u);
    EXPECT_EQ(ks105.axesMax, 0u);
    EXPECT_EQ(ks105.pulseOutputs, 4u);
    EXPECT_EQ(ks105.area(kinco::M).bytes, 1024u);
    const ControllerModel& ks105c1 = *kincoFamily().findModel("KS105C1-16DT");
    EXPECT_EQ(ks105c1.axesMax, 16u);
    EXPECT_EQ(ks105c1.motionInstructionsMax, 192u);
    EXPECT_EQ(ks105c1.expansionModulesMax, 0u);
    EXPECT_FALSE(kincoFamily().findModel("K209M")->selectable);
    EXPECT_EQ(&kincoFamily().defaultModel(), &ks101);
}

TEST(KincoFactsTest, timersHaveThreeResolutions) // KS-CPU-01: 4 of 1 ms, 16 of 10 ms, 236 of 100 ms
{
    EXPECT_EQ(kincoFamily().timerBase(0), 1ms);
    EXPECT_EQ(kincoFamily().timerBase(3), 1ms);
    EXPECT_EQ(kincoFamily().timerBase(4), 10ms);
    EXPECT_EQ(kincoFamily().timerBase(19), 10ms);
    EXPECT_EQ(kincoFamily().timerBase(20), 100ms);
    EXPECT_EQ(kincoFamily().timerBase(255), 100ms);
}

TEST(KincoFactsTest, thereAreFortyFiveDriveParameters) // KS-MC-15
{
    const auto parameters = kincoFamily().driveParameters();
    ASSERT_EQ(parameters.size(), 45u);
    EXPECT_EQ(parameters[0].index, 0x6083);
    EXPECT_EQ(parameters[0].objectBits, 32);
    EXPECT_TRUE(parameters[0].isReal);
    EXPECT_EQ(parameters[1].unitLinear, "mm/s^2");
    EXPECT_EQ(parameters[13].index, 0x6099);
    EXPECT_EQ(parameters[13].subindex, 0x05);
    EXPECT_EQ(parameters[13].objectBits, 8);
    EXPECT_EQ(parameters[3].minimum, -128);
    EXPECT_TRUE(parameters[3].isSigned);
    EXPECT_EQ(parameters[8].maximum, 32767);
    EXPECT_FALSE(parameters[8].isReal);
    EXPECT_EQ(parameters[32].subindex, 0x1D);
    EXPECT_EQ(parameters[41].index, 0x2508);
    EXPECT_TRUE(parameters[41].isSigned);
    EXPECT_EQ(parameters[43].onlyValue, 0x65766173u);
    EXPECT_EQ(parameters[44].onlyValue, 0x64616F6Cu);
    EXPECT_FALSE(parameters[42].onlyValue.has_value());
}

TEST(KincoFactsTest, errorNumbersHaveTheirSentence) // KS-MC-10, KS-MC-13, KS-MC-21
{
    const Family& family = kincoFamily();
    EXPECT_EQ(family.errorText("MC_MABS", 2, TextLanguage::English), "The axis is not locked.");
    EXPECT_EQ(family.errorText("MC_JOG", 3, TextLanguage::Chinese), "目标轴正在执行其他运动指令，未处于静止状态。");
    EXPECT_EQ(family.errorText("MC_RESTART", 2, TextLanguage::Russian), "Ось уже перезапускается.");
    EXPECT_EQ(family.errorText("MC_WPARAS", 0b101, TextLanguage::English), "List entry 0 failed. List entry 2 failed.");
    EXPECT_NE(family.errorText("MC_WPARAS", 0xFFFFFFFF, TextLanguage::English).find("Nothing could be executed"), std::string::npos);
    EXPECT_EQ(family.errorText("MC_MABS", 8, TextLanguage::English), "");
    EXPECT_EQ(family.errorText("MC_NONE", 1, TextLanguage::English), "");
    for (const char* mnemonic : {"MC_POWER", "MC_RESET", "MC_HOME", "MC_MABS", "MC_MREL", "MC_JOG"}) {
        for (std::uint32_t code = 0; code <= 7; ++code)
            EXPECT_NE(family.findError(mnemonic, code), nullptr) << mnemonic << ' ' << code;
    }
}

TEST(KincoFactsTest, anAxisHasSixStates) // KS-MC-26
{
    const auto states = kincoFamily().axisStates();
    ASSERT_EQ(states.size(), 6u);
    EXPECT_EQ(kincoFamily().findAxisState(3)->id, "Discrete_Motion");
    EXPECT_EQ(kincoFamily().findAxisState(0)->name.in(TextLanguage::Russian), "Питание снято");
    EXPECT_EQ(kincoFamily().findAxisState(6), nullptr);
}

TEST(KincoFactsTest, retainedMemoryFollowsTheModel)
{
    const AreaLayout& large = kincoFamily().findModel("KS101M-04DX")->area(kinco::V);
    EXPECT_EQ(large.retainedEnd - large.retainedFirst, 16384u);
    const AreaLayout& small = kincoFamily().findModel("KS105-16DT")->area(kinco::V);
    EXPECT_EQ(small.retainedEnd - small.retainedFirst, 1024u);
    const AreaLayout& markers = kincoFamily().defaultModel().area(kinco::M);
    EXPECT_EQ(markers.retainedFirst, markers.retainedEnd);
}

TEST(InvtFactsTest, elementsHaveTheCountsOfTheManual) // TS-MEM-01
{
    const ControllerModel& model = invtFamily().defaultModel();
    EXPECT_EQ(model.name, "TS635");
    EXPECT_EQ(model.programInstructionsMax, 204800u);
    EXPECT_EQ(model.area(invt::X).bytes, 1024u);
    EXPECT_EQ(model.area(invt::M).bytes, 32768u);
    EXPECT_EQ(model.area(invt::D).bytes, 2 * 32768u);
    EXPECT_EQ(model.area(invt::CounterValue).bytes, 4 * 256u);
    EXPECT_TRUE(invtFamily().area(invt::X).octal);
    EXPECT_TRUE(invtFamily().area(invt::X).isInput);
    EXPECT_FALSE(invtFamily().area(invt::X).writable);
}

TEST(InvtFactsTest, systemFlagsHaveTheirOwnMeaning) // TS-MEM-09
{
    const Family& family = invtFamily();
    const auto meaning = [&](const char* text) { return family.meaningOf(*family.parseAddress(text, family.defaultModel())).en; };
    EXPECT_EQ(meaning("SM1"), "On during the first scan after the start");
    EXPECT_EQ(meaning("SM5"), "System flags");
    EXPECT_EQ(meaning("D100"), "Data words");
}

TEST(InvtFactsTest, retainedRangesAreFixed) // TS-MEM-02
{
    const ControllerModel& model = invtFamily().defaultModel();
    EXPECT_EQ(model.area(invt::M).retainedFirst, 1000u);
    EXPECT_EQ(model.area(invt::S).retainedEnd, 4096u);
    EXPECT_EQ(model.area(invt::D).retainedFirst, 2 * 1000u);
    EXPECT_EQ(model.area(invt::R).retainedEnd, 2 * 32768u);
    EXPECT_EQ(model.area(invt::Z).retainedEnd, 0u);
}

TEST(InvtFactsTest, timersHaveThreeResolutions) // TS-MEM-03
{
    EXPECT_EQ(invtFamily().timerBase(0), 100ms);
    EXPECT_EQ(invtFamily().timerBase(199), 100ms);
    EXPECT_EQ(invtFamily().timerBase(200), 10ms);
    EXPECT_EQ(invtFamily().timerBase(300), 1ms);
    EXPECT_FALSE(invtFamily().counterIs32Bit(199));
    EXPECT_TRUE(invtFamily().counterIs32Bit(200));
}

TEST(InvtFactsTest, theErrorListIsComplete) // TS-DIAG-05
{
    const auto errors = invtFamily().errors();
    EXPECT_EQ(errors.size(), 814u);
    const auto ofLevel = [&](ErrorText::Level level) { return std::ranges::count(errors, level, &ErrorText::level); };
    EXPECT_EQ(ofLevel(ErrorText::Level::General), 169);
    EXPECT_EQ(ofLevel(ErrorText::Level::Serious), 115);
    EXPECT_EQ(ofLevel(ErrorText::Level::Warning), 530);
    EXPECT_EQ(invtFamily().errorCategories().size(), 59u);
    const ErrorText* supply = invtFamily().findError("0x0001", 2);
    ASSERT_NE(supply, nullptr);
    EXPECT_EQ(supply->text.en, "Supply voltage of the unit is too low.");
    EXPECT_EQ(supply->cause.en, "Supply below 19 V.");
    EXPECT_EQ(supply->remedy.en, "Check the power supply.");
    EXPECT_EQ(invtFamily().findError("0x0011", 0x1B)->instruction, "MC_Power");
    EXPECT_EQ(invtFamily().findError("0x0011", 0x7FFF), nullptr);
}

TEST(InvtFactsTest, everyErrorsMainCodeIsClassified)
{
    for (const ErrorText& error : invtFamily().errors()) {
        const unsigned long main = std::stoul(error.scope, nullptr, 16);
        const bool known = std::ranges::any_of(invtFamily().errorCategories(),
            [main](const ErrorCategory& category) { return main >= category.first && main <= category.last; });
        EXPECT_TRUE(known) << error.scope;
    }
}

} // namespace
