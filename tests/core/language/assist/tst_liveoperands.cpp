#include "core/language/assist/liveoperands.h"
#include "tests/core/language/assist/assistproject.h"

#include <gtest/gtest.h>

using namespace camwright;
using namespace camwright::test;

namespace {

std::string show(const Project& project, const std::string& text, LineState before = LineState::Code, std::uint32_t firstLine = 1)
{
    std::string out;
    for (const LiveOperand& operand : liveOperands(*contextOf(project), text, before, firstLine)) {
        out += std::to_string(operand.line) + ":" + std::to_string(operand.column) + " " + operand.pin + " ";
        for (const std::string& name : operand.names)
            out += name + (&name == &operand.names.back() ? "" : "+");
        out += " " + std::string(name(operand.type)) + "\n";
    }
    return out;
}

const Project& ks()
{
    static const Project out = assistProject("kinco", "", {row("Start", DataType::Bool, "%M0.0"), row("Speed", DataType::Real, "%VR100")});
    return out;
}

TEST(LiveOperandsTest, areVariablesAndAddresses)
{
    EXPECT_EQ(show(ks(), "(* Network 0 *)\nLD Start\nMOVE %VD0, %VD4 (* %VD8 *)\nMOVE 12, %VW2\n"),
        "2:3 BIT Start BOOL\n3:5 IN %VD0 DINT\n3:11 OUT %VD4 DINT\n4:9 OUT %VW2 INT\n");
    EXPECT_EQ(show(ks(), "MC_POWER Start, 1, %M0.1, %M0.2, %MW4\n").substr(0, 26), "1:9 EXEC Start BOOL\n1:19 D"); // not the axis, a constant
}

TEST(LiveOperandsTest, listsAndLocalMemoryHaveNone)
{
    EXPECT_EQ(show(ks(), "MC_RPARAS %L0.1, 1, %VB100, 3, %M0.2, %M0.3, %MD8, %VD1200\n"), "1:31 DONE %M0.2 BOOL\n1:38 ERR %M0.3 BOOL\n1:45 ERRID %MD8 DWORD\n");
}

TEST(LiveOperandsTest, countLinesFromTheFirstAndKnowOpenComments)
{
    EXPECT_EQ(show(ks(), "LD Start\n*)\nLD Start\n", LineState::Comment, 40), "42:3 BIT Start BOOL\n");
}

TEST(LiveOperandsTest, longValuesOfWordsAskForBoth)
{
    const Project ts = assistProject("invt", "", {row("Total", DataType::Dint, "")});
    EXPECT_EQ(show(ts, "DMOV D10 Total\nRMOV D20 D22\nMOV D30 D31\n"),
        "1:5 S D10+D11 DINT\n1:9 D Total DINT\n2:5 S D20+D21 REAL\n2:9 D D22+D23 REAL\n3:4 S D30 INT\n3:8 D D31 INT\n");
}

TEST(LiveOperandsTest, twoWordsMakeOneValue)
{
    const LiveOperand operand{1, 0, 3, {"D20", "D21"}, DataType::Real, "S"};
    const std::uint32_t bits = static_cast<std::uint32_t>(Value::ofReal(-12.5F).bits);
    const Value words[] = {Value::ofInteger(DataType::Int, bits & 0xFFFF), Value::ofInteger(DataType::Int, bits >> 16)};
    EXPECT_EQ(liveValue(operand, words), Value::ofReal(-12.5F));
}

} // namespace
