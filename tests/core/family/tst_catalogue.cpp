#include "core/family/family.h"
#include "core/family/invt/invtareas.h"
#include "core/family/kinco/kincoareas.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

using namespace camwright;

namespace {

const Catalogue& kincoCatalogue() { return findFamily("kinco")->catalogue(); }
const Catalogue& invtCatalogue() { return findFamily("invt")->catalogue(); }

struct ListedInstruction {
    InstructionId id;
    const char* family;
    const char* mnemonic;
};
constexpr ListedInstruction Listed[] = {
#define CAMWRIGHT_INSTRUCTION(name, number, family, mnemonic) {InstructionId::name, family, mnemonic},
#include "core/family/instructionids.h"
#undef CAMWRIGHT_INSTRUCTION
};

TEST(CatalogueTest, numbersOfTheCodeAndOfTheDataAgree)
{
    std::size_t inData = 0;
    for (const Family* family : families())
        inData += family->catalogue().instructions().size();
    EXPECT_EQ(inData, std::size(Listed));
    for (const ListedInstruction& listed : Listed) {
        const Instruction* found = findFamily(listed.family)->catalogue().find(listed.mnemonic);
        ASSERT_NE(found, nullptr) << listed.mnemonic;
        EXPECT_EQ(found->id, listed.id) << listed.mnemonic;
        EXPECT_EQ(found->mnemonic, listed.mnemonic);
        EXPECT_EQ(findFamily(listed.family)->catalogue().find(listed.id), found);
    }
}

TEST(CatalogueTest, noNumberIsGivenTwice)
{
    std::set<InstructionId> seen;
    for (const ListedInstruction& listed : Listed)
        EXPECT_TRUE(seen.insert(listed.id).second) << listed.mnemonic;
}

TEST(CatalogueTest, everyInstructionAndPinIsExplainedInThreeLanguages)
{
    for (const Family* family : families()) {
        for (const Instruction& instruction : family->catalogue().instructions()) {
            const std::string name = family->id() + " " + instruction.mnemonic;
            EXPECT_TRUE(instruction.help.isComplete()) << name;
            EXPECT_TRUE(family->catalogue().groupName(instruction.group).isComplete()) << name;
            EXPECT_EQ(instruction.simulated, instruction.whyNotSimulated.en.empty()) << name;
            EXPECT_TRUE(instruction.basis != Basis::Manual || !instruction.sources.empty()) << name << " cites nothing";
            for (const Pin& pin : instruction.pins)
                EXPECT_TRUE(pin.help.isComplete()) << name << ' ' << pin.name;
        }
    }
}

TEST(CatalogueTest, everyPinCanBeGivenSomething)
{
    for (const Family* family : families()) {
        for (const Instruction& instruction : family->catalogue().instructions()) {
            for (const Pin& pin : instruction.pins) {
                const std::string name = family->id() + " " + instruction.mnemonic + " " + pin.name;
                if (pin.kind == PinKind::Program || pin.kind == PinKind::Axis || pin.kind == PinKind::Label || pin.kind == PinKind::Interrupt)
                    continue;
                EXPECT_FALSE(pin.types.isEmpty()) << name;
                EXPECT_TRUE(pin.types.contains(pin.mainType)) << name;
                EXPECT_TRUE(pin.constantAllowed || !pin.areas.empty()) << name;
                EXPECT_FALSE(pin.constantAllowed && pin.direction == PinDirection::Out) << name;
                const bool isWritten = pin.kind == PinKind::Value && pin.direction != PinDirection::In;
                for (AreaId area : pin.areas)
                    EXPECT_TRUE(!isWritten || family->area(area).writable) << name << " writes area " << family->area(area).name;
            }
        }
    }
}

TEST(CatalogueTest, countPinsAreIntegersOfTheSameInstruction)
{
    for (const Family* family : families()) {
        for (const Instruction& instruction : family->catalogue().instructions()) {
            for (const Pin& pin : instruction.pins) {
                if (pin.kind != PinKind::Block)
                    continue;
                EXPECT_NE(pin.countPin.empty(), pin.fixedCount == 0) << instruction.mnemonic << ' ' << pin.name;
                EXPECT_TRUE(pin.countPin.empty() || instruction.findPin(pin.countPin)) << instruction.mnemonic << ' ' << pin.name;
            }
        }
    }
}

TEST(CatalogueTest, countsTheOperandsThatMustBeWritten)
{
    const Instruction& move = *invtCatalogue().find("MC_MoveAbsolute");
    EXPECT_EQ(move.requiredPins(), 3u);
    EXPECT_EQ(kincoCatalogue().find("CTUD")->requiredPins(), 5u);
    EXPECT_EQ(kincoCatalogue().find("MC_STATE")->requiredPins(), 13u);
    EXPECT_EQ(invtCatalogue().find("CALL")->requiredPins(), 1u);
}

TEST(CatalogueTest, theHashIsThatOfThisDataAndOfNoOther)
{
    EXPECT_FALSE(kincoCatalogue().hash().isNull());
    EXPECT_EQ(kincoCatalogue().hash(), findFamily("kinco")->catalogue().hash());
    EXPECT_NE(kincoCatalogue().hash(), invtCatalogue().hash());
}

TEST(CatalogueTest, mnemonicsAreFoundWhateverTheirCase)
{
    EXPECT_EQ(kincoCatalogue().find("mc_mabs")->id, InstructionId::KincoMcMabs);
    EXPECT_EQ(invtCatalogue().find("MC_POWER")->id, InstructionId::InvtMcPower);
    EXPECT_EQ(kincoCatalogue().find("BN"), nullptr);
}

TEST(CatalogueTest, proposesTheNearestMnemonic)
{
    EXPECT_EQ(kincoCatalogue().nearest("MC_RESTRAT"), "MC_RESTART");
    EXPECT_EQ(kincoCatalogue().nearest("MOV"), "MOVE");
    EXPECT_EQ(invtCatalogue().nearest("MOVE"), "MOV");
    EXPECT_EQ(kincoCatalogue().nearest("QQQQQQ"), "");
}

// C9, first hard case.
TEST(CatalogueTest, writingParametersLinksAxisAndNumberAndCountsItsTwoTables)
{
    const Instruction& write = *kincoCatalogue().find("MC_WPARAS");
    std::string order;
    for (const Pin& pin : write.pins)
        order += pin.name + " ";
    EXPECT_EQ(order, "EXEC AXIS ID PARAS NUM DONE ERR ERRID ");
    EXPECT_EQ(write.findPin("AXIS")->linkGroup, write.findPin("NUM")->linkGroup);
    EXPECT_NE(write.findPin("AXIS")->linkGroup, '\0');
    const Pin& values = *write.findPin("PARAS");
    EXPECT_EQ(values.kind, PinKind::Block);
    EXPECT_EQ(values.direction, PinDirection::In);
    EXPECT_EQ(values.elementBytes, 4u);
    EXPECT_EQ(values.countPin, "NUM");
    EXPECT_FALSE(values.constantAllowed);
    EXPECT_EQ(write.findPin("ID")->elementBytes, 1u);
    EXPECT_EQ(write.findPin("NUM")->maximum, 32.0);
    EXPECT_EQ(write.findPin("ERRID")->mainType, DataType::Dword);
    EXPECT_EQ(write.findPin("EXEC")->areas, (std::vector<AreaId>{kinco::M, kinco::V, kinco::L, kinco::SM}));
}

// C9, second hard case.
TEST(CatalogueTest, anAxisBlockLeavesOptionalPinsEmptyAndSaysWhyItDoesNotRun)
{
    const Instruction& move = *invtCatalogue().find("MC_MoveAbsolute");
    EXPECT_EQ(move.findPin("Axis")->kind, PinKind::Axis);
    EXPECT_FALSE(move.findPin("Position")->optional);
    EXPECT_TRUE(move.findPin("Jerk")->optional);
    EXPECT_EQ(move.findPin("Direction")->defaultValue, "2");
    EXPECT_TRUE(move.findPin("Done")->optional);
    EXPECT_FALSE(move.simulated);
    EXPECT_TRUE(move.whyNotSimulated.isComplete());
}

TEST(CatalogueTest, pulseInstructionsNeedPulseOutputs)
{
    const Instruction& home = *kincoCatalogue().find("PHOME");
    EXPECT_FALSE(findFamily("kinco")->findModel("KS101M-04DX")->has(home.needs));
    EXPECT_TRUE(findFamily("kinco")->findModel("KS105-16DT")->has(home.needs));
    EXPECT_FALSE(home.simulated);
    const Instruction& power = *kincoCatalogue().find("MC_POWER");
    EXPECT_TRUE(findFamily("kinco")->findModel("KS101M-04DX")->has(power.needs));
    EXPECT_FALSE(findFamily("kinco")->findModel("KS105-16DT")->has(power.needs));
}

TEST(CatalogueTest, aTimerOperandIsAnElementAndItsValueAWord)
{
    EXPECT_EQ(kincoCatalogue().find("TON")->pins[0].areas, std::vector<AreaId>{kinco::TimerBit});
    const Pin& in = kincoCatalogue().find("GE")->pins[0];
    EXPECT_TRUE(std::ranges::find(in.areas, kinco::TimerValue) != in.areas.end());
    EXPECT_TRUE(std::ranges::find(in.areas, kinco::TimerBit) == in.areas.end());
    const Pin& bit = invtCatalogue().find("LD")->pins[0];
    EXPECT_TRUE(std::ranges::find(bit.areas, invt::TimerBit) != bit.areas.end());
    EXPECT_TRUE(std::ranges::find(bit.areas, invt::TimerValue) == bit.areas.end());
}

} // namespace
