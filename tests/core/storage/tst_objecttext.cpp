#include "core/base/diagnostic.h"
#include "core/storage/filenames.h"
#include "core/storage/objecttext.h"
#include "tests/core/storage/sampleproject.h"

#include <gtest/gtest.h>

#include <random>
#include <sstream>

using namespace camwright;

namespace {

const ObjectKey FeedKey{ObjectKind::Axis, "Feed"};
const ObjectKey MainKey{ObjectKind::Program, "Main"};
const ObjectKey TableKey{ObjectKind::VariableTable, "Globals"};

std::string firstError(const ObjectKey& key, std::string_view text)
{
    const auto object = fromText(key, text, "f");
    return object ? "none" : englishLine(object.error().front());
}

/// How many lines differ between two texts of equally many lines; -1 when the numbers of lines differ.
int linesDiffering(const std::string& a, const std::string& b)
{
    std::istringstream one(a), two(b);
    std::string left, right;
    int out = 0;
    for (;;) {
        const bool more = static_cast<bool>(std::getline(one, left));
        if (more != static_cast<bool>(std::getline(two, right)))
            return -1;
        if (!more)
            return out;
        out += left != right;
    }
}

TEST(ObjectTextTest, everyFieldOfEveryKindSurvivesTheRoundTrip)
{
    const Project project = sampleProject();
    for (const auto& [key, object] : project.all()) {
        const std::string text = toText(*object);
        const auto back = fromText(key, text, fileOf(key));
        ASSERT_TRUE(back.ok()) << englishLine(back.error().front()) << '\n' << text;
        EXPECT_EQ(*back, *object) << text;
        EXPECT_EQ(toText(*back), text);
        EXPECT_EQ(toTextKeeping(*back, text), text);
    }
}

TEST(ObjectTextTest, oneChangedFieldChangesOneLine)
{
    Axis axis;
    const Object before{FeedKey, 1, axis, {}};
    axis.simulation.startPosition = 12.5;
    EXPECT_EQ(linesDiffering(toText(before), toText({FeedKey, 1, axis, {}})), 1);
    Variable row{"Start", DataType::Bool, "%M0.0", "", false, ""};
    const VariableTable table = VariableTable::of({row, row, row});
    row.comment = "new";
    EXPECT_EQ(linesDiffering(toText({TableKey, 1, table, {}}), toText({TableKey, 1, table.replaced(1, 1, {row}), {}})), 1);
    const WatchTable watch{{{"a", "", {}}, {"b", "", {}}}}, other{{{"a", "hex", {}}, {"b", "", {}}}};
    const ObjectKey watchKey{ObjectKind::WatchTable, "W"};
    EXPECT_EQ(linesDiffering(toText({watchKey, 1, watch, {}}), toText({watchKey, 1, other, {}})), 1);
}

TEST(ObjectTextTest, strictKincoStandsInTheFileOnlyWhereItIsOn) // C32
{
    ControllerSettings settings;
    settings.family = "kinco";
    EXPECT_EQ(toText({controllerKey(), 0, settings, {}}).find("strict_kinco"), std::string::npos);
    settings.strictKinco = true;
    const std::string text = toText({controllerKey(), 0, settings, {}});
    EXPECT_NE(text.find("strict_kinco = true\n"), std::string::npos);
    const auto back = fromText(controllerKey(), text);
    ASSERT_TRUE(back.ok());
    EXPECT_EQ(std::get<ControllerSettings>(back->content), settings);
    settings.strictKinco = false;
    EXPECT_EQ(toTextKeeping({controllerKey(), 0, settings, {}}, "# mine\nfamily = \"kinco\"\nstrict_kinco = true\nwatchdog_ms = 500\n").find("strict_kinco"), std::string::npos);
    const auto typed = fromText(controllerKey(), "strict_kinco = \"perhaps\"\n");
    ASSERT_TRUE(typed.ok());
    EXPECT_EQ(std::get<ControllerSettings>(typed->content).strictKinco.text(), "perhaps");
}

constexpr const char* HandWritten = "\xEF\xBB\xBF# my axis\r\n\r\nnumber=2 # was 3\r\n\r\n[ simulation ]\r\n\r\n# left end\r\n"
                                    "home_switch = -1_0.0   # mm\r\n[camera]\r\nfps = 0x1E\r\n[[camera.shots]]\r\nat = 2026-01-01\r\n";

TEST(ObjectTextTest, anEditKeepsCommentsOrderUnknownKeysAndLineEndsOfAFileWrittenByHand)
{
    const auto read = fromText(FeedKey, HandWritten);
    ASSERT_TRUE(read.ok()) << englishLine(read.error().front());
    Object object = *read;
    EXPECT_EQ(object.unknown.at("camera.fps"), "0x1E");
    EXPECT_EQ(toTextKeeping(object, HandWritten), HandWritten);

    std::get<Axis>(object.content).simulation.homeSwitch = 4.0;
    std::string expected = HandWritten;
    expected.replace(expected.find("-1_0.0"), 6, "4.0");
    EXPECT_EQ(toTextKeeping(object, HandWritten), expected);
}

TEST(ObjectTextTest, aKeyTheFileLeftOutIsAddedBesideItsNeighbours)
{
    const std::string before = "# head\nnumber = 2\n\n[simulation]\nhome_switch = 1.0\n# tail\n";
    Object object = *fromText(FeedKey, before);
    std::get<Axis>(object.content).type = AxisType::Rotary;
    std::get<Axis>(object.content).simulation.inertiaRatio = 2.0;
    EXPECT_EQ(toTextKeeping(object, before),
              "# head\nnumber = 2\ntype = \"rotary\"\n\n[simulation]\nhome_switch = 1.0\ninertia_ratio = 2.0\n# tail\n");
}

TEST(ObjectTextTest, unknownKeysSurviveWithoutTheFileTheyCameFrom)
{
    const Object object = *fromText(FeedKey, HandWritten);
    const auto back = fromText(FeedKey, toText(object));
    ASSERT_TRUE(back.ok()) << englishLine(back.error().front()) << '\n' << toText(object);
    EXPECT_EQ(back->content, object.content);
    EXPECT_EQ(back->unknown, object.unknown);
}

TEST(ObjectTextTest, editedRowsOfATableKeepTheCommentsBetweenThem)
{
    const std::string before = "(* camwright: order=1 *)\n// inputs\nVAR_GLOBAL\n  (* start *)\n  A AT %M0.0 : BOOL; (* first *)\n\n"
                               "  // between\n  B : INT;\n  C:INT;\nEND_VAR\n// end\n";
    Object object = *fromText(TableKey, before);
    auto& table = std::get<VariableTable>(object.content);
    ASSERT_EQ(table.rowCount(), 3u);
    EXPECT_EQ(table.row(0).comment, "first");
    Variable a = table.row(0), b = table.row(1);
    a.address = "%M0.1";
    b.initial = "5";
    table = table.replaced(0, 2, {a, b});
    EXPECT_EQ(toTextKeeping(object, before),
              "(* camwright: order=1 *)\n// inputs\nVAR_GLOBAL\n  (* start *)\n    A AT %M0.1 : BOOL;  // first\n\n"
              "  // between\n    B : INT := 5;\n  C:INT;\nEND_VAR\n// end\n");
}

struct Wrong {
    ObjectKey key;
    const char* text;
    const char* message;
};

class WrongText : public testing::TestWithParam<Wrong> {};

TEST_P(WrongText, isRefusedWithFileLineAndRule)
{
    const std::string found = firstError(GetParam().key, GetParam().text);
    EXPECT_EQ(found.substr(0, std::string_view(GetParam().message).size()), GetParam().message) << found;
}

INSTANTIATE_TEST_SUITE_P(ObjectTextTest, WrongText, testing::Values(
    Wrong{FeedKey, "number = ", "f:1:10: error CW1008"},
    Wrong{FeedKey, "number = 1\nnumber = 2\n", "f:2:"},
    Wrong{FeedKey, "number = [1]\n", "f:1:10: error CW1024: \"number\" is to be a single value, not a list or a table."},
    Wrong{FeedKey, "comment = 3\n", "f:1:11: error CW1009: \"comment\" is to be a text in quotation marks."},
    Wrong{FeedKey, "order = \"1\"\n", "f:1:9: error CW1023"},
    Wrong{FeedKey, "simulation = 3\n", "f:1:14: error CW1025: \"simulation\" is to be a table of keys and values."},
    Wrong{FeedKey, "number.x = 3\n", "f:1:12: error CW1024: \"number\" is to be a single value, not a list or a table."},
    Wrong{FeedKey, "# \xC3\x28\n", "f:1:3: error CW1010"},
    Wrong{FeedKey, "\xFF\xFEn\0u\0", "f:1:1: error CW1010"},
    Wrong{projectKey(), "name = \"x\"\n", "f:1:1: error CW1007"},
    Wrong{projectKey(), "format = 99\nname = 3\n", "f:1:10: error CW1006: This project has format 99"},
    Wrong{projectKey(), "format = \"1\"\n", "f:1:10: error CW1023"},
    Wrong{MainKey, "", "f:1:1: error CW1011: The file is to begin with a line that tells its settings: (* camwright: role=main, order=1 *)"},
    Wrong{MainKey, "LD %SM0.0\n", "f:1:1: error CW1011"},
    Wrong{MainKey, "(* camwright: role=main, order=1\n", "f:1:1: error CW1011"},
    Wrong{MainKey, "(* camwright: role=main, role=main *)\n", "f:1:1: error CW1011"},
    Wrong{MainKey, "(* camwright: role=boss, order=1 *)\n", "f:1:1: error CW1012: \"boss\" is no role of a program. The roles are main, subroutine, interrupt."},
    Wrong{MainKey, "(* camwright: role=main, order=x *)\n", "f:1:1: error CW1023"},
    Wrong{MainKey, "(* camwright: role=main, order=1 *)\nLD %M0.0\n\x80", "f:3:1: error CW1010"},
    Wrong{TableKey, "(* camwright: order=1 *)\nVAR_GLOBAL\n  A BOOL;\nEND_VAR\n", "f:3:5: error CW1013: Expected :, found \"BOOL\"."},
    Wrong{TableKey, "(* camwright: order=1 *)\nVAR_GLOBAL\n  A : BOOL\nEND_VAR\n", "f:4:1: error CW1013: Expected ;, found \"END_VAR\"."},
    Wrong{TableKey, "(* camwright: order=1 *)\nVAR_GLOBAL\n  A : BOOL;\n", "f:4:1: error CW1027: The file ends where END_VAR is expected."},
    Wrong{TableKey, "(* camwright: order=1 *)\nVAR_GLOBAL\n  \"A : BOOL;\nEND_VAR\n", "f:3:3: error CW1013"},
    Wrong{TableKey, "(* camwright: order=1 *)\nVAR_GLOBAL (* \nEND_VAR\n", "f:2:12: error CW1013: Expected *), found \"(\"."},
    Wrong{TableKey, "(* camwright: order=1 *)\nVAR x\n", "f:2:1: error CW1013: Expected VAR_GLOBAL, found \"VAR\"."}));

TEST(ObjectTextTest, everyWrongRowIsNamedNotOnlyTheFirst)
{
    const auto table = fromText(TableKey, "(* camwright: order=1 *)\nVAR_GLOBAL\n A BOOL;\n B : INT;\n C INT;\nEND_VAR\n");
    ASSERT_FALSE(table.ok());
    ASSERT_EQ(table.error().size(), 2u);
    EXPECT_EQ(table.error()[1].place.range.line, 5u);
}

TEST(ObjectTextTest, illegalValuesAreKeptAsTyped)
{
    const Object object = *fromText(FeedKey, "number = \"one\"\ntype = 3\nmechanical_equivalent = nan\nguard_time_ms = 1.5\n");
    const auto& axis = std::get<Axis>(object.content);
    EXPECT_EQ(axis.number.text(), "one");
    EXPECT_EQ(axis.type.text(), "3");
    EXPECT_EQ(axis.mechanicalEquivalent.text(), "nan");
    EXPECT_EQ(axis.guardTimeMs.text(), "1.5");
}

TEST(ObjectTextTest, deepNestingIsAnErrorNotACrash)
{
    EXPECT_NE(firstError(FeedKey, "x = " + std::string(100000, '[')).find("CW1008"), std::string::npos);
}

TEST(ObjectTextTest, mutatedFilesAreReadOrRefusedWithALine)
{
    std::mt19937 random(7);
    const Project project = sampleProject();
    for (const auto& [key, object] : project.all()) {
        const std::string text = toText(*object);
        for (int turn = 0; turn < 300; ++turn) {
            std::string broken = text;
            for (unsigned n = 0; n < 1 + random() % 3; ++n)
                broken[random() % broken.size()] = static_cast<char>(random() % 4 ? "\"=[]{};:(*)\n.#"[random() % 14] : random() % 256);
            const auto read = fromText(key, broken, "f");
            if (read)
                ASSERT_EQ(fromText(key, toText(*read)).ok(), true) << broken;
            else
                ASSERT_TRUE(read.error().front().place.range.isValid()) << englishLine(read.error().front()) << '\n' << broken;
        }
    }
}

TEST(FilePlaceTest, aProgramsLineIsOneFurtherDownInItsFile)
{
    Place place{MainKey, {}, {2, 4, 2, 10}, {}};
    const Place out = filePlace(place, sampleProject());
    EXPECT_EQ(out.file, "programs/Main.il");
    EXPECT_EQ(out.range, (TextRange{3, 4, 3, 10}));
}

TEST(FilePlaceTest, aFieldIsFoundInTheFileAsItWasWritten)
{
    const std::string text = "# c\n\n  guard_time_ms   = 9\n";
    const auto object = std::make_shared<const Object>(*fromText(FeedKey, text));
    const Project project = Project().with(FeedKey, object);
    const KnownFiles files{{"axes/Feed.toml", {object, {}, {}, text}}};
    EXPECT_EQ(filePlace({FeedKey, "guard_time_ms", {}, {}}, project, files).range.line, 3u);
    EXPECT_EQ(filePlace({FeedKey, "guard_time_ms", {}, {}}, project).range.line, 6u);
    EXPECT_FALSE(filePlace({FeedKey, "no_such_field", {}, {}}, project).range.isValid());
}

TEST(FilePlaceTest, aRowIsFoundByItsNumber)
{
    const Project project = sampleProject();
    EXPECT_EQ(filePlace({TableKey, "rows[1].address", {}, {}}, project).range.line, 6u); // behind END_VAR and VAR_GLOBAL RETAIN
    const Place watch = filePlace({{ObjectKind::WatchTable, "Watch"}, "rows[1].expression", {}, {}}, project);
    EXPECT_EQ(watch.range.line, 4u);
}

} // namespace
