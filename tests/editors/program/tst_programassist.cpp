#include "editors/program/programassist.h"

#include <QtTest>

using namespace camwright;

namespace {

Project project()
{
    ControllerSettings controller;
    controller.family = "kinco";
    controller.model = "KS101M-04DX";
    Project out = Project().withContent(controllerKey(), controller);
    out = out.withContent({ObjectKind::Axis, "Feed"}, Axis());
    out = out.withContent({ObjectKind::Program, "Main"}, Program{});
    out = out.withContent({ObjectKind::Program, "Homing"}, Program{ProgramRole::Subroutine, ProgramLanguage::InstructionList, ""});
    return out.withContent({ObjectKind::VariableTable, "Globals"},
        VariableTable::of({{"Start", DataType::Bool, "%M0.0", "", false, ""}, {"Speed", DataType::Real, "%VR100", "", false, ""}}));
}

} // namespace

class ProgramAssistTest : public QObject {
    Q_OBJECT
private slots:
    void completesFromTheSecondLetterOn()
    {
        QVERIFY(assist::complete(project(), "M", 1, false).entries.isEmpty());
        const assist::Completions found = assist::complete(project(), "LD %M0.0\nMC_HO", 14, false);
        QCOMPARE(found.begin, 9);
        QCOMPARE(found.end, 14);
        QCOMPARE(found.entries.size(), 1);
        QVERIFY(found.entries.front().startsWith("MC_HOME "));
    }

    void completesAtOnceWhenAsked()
    {
        QVERIFY(assist::complete(project(), "M", 1, true).entries.size() > 5);
    }

    void proposesVariablesOfThePin()
    {
        const assist::Completions found = assist::complete(project(), "LD St", 5, false);
        QCOMPARE(found.entries.size(), 1);
        QVERIFY(found.entries.front().contains("BOOL %M0.0"));
        QVERIFY(assist::complete(project(), "LD Sp", 5, false).entries.isEmpty()); // Speed is no BOOL
    }

    void aWordThatIsWholeIsNotProposed()
    {
        QVERIFY(assist::complete(project(), "LD Start", 8, false).entries.isEmpty());
    }

    void nothingIsProposedInComments()
    {
        QVERIFY(assist::complete(project(), "(* MO *)", 5, true).entries.isEmpty());
    }

    void theTextOfAnEntryIsInserted()
    {
        QCOMPARE(assist::insertionOf("MC_HOME            homes an axis"), QByteArray("MC_HOME"));
        QCOMPARE(assist::insertionOf("Start"), QByteArray("Start"));
    }

    void hoverTellsInstructionVariableAndAddress()
    {
        QVERIFY(assist::hover(project(), "MOVE %VW0, %VW2", 1).contains("MOVE IN, OUT"));
        const QString variable = assist::hover(project(), "LD Start", 4);
        QVERIFY(variable.contains("Start") && variable.contains("%M0.0"));
        QVERIFY(assist::hover(project(), "LD %M0.0", 4).contains("Start")); // the name of the address
        QVERIFY(assist::hover(project(), "LD %M0.0\n\n", 9).isEmpty());
    }

    void hoverEscapesWhatIsTyped()
    {
        QVERIFY(!assist::hover(project(), "MOVE <b>, %VW2", 6).contains("<b></b>"));
    }

    void linesBecomeCommentsAndText()
    {
        const QByteArray text = "LD %M0.0\nST %M0.1\n\nLD %M0.2\n";
        const auto on = assist::toggleComment(text, 1, 3);
        QCOMPARE(on.offset, std::size_t(0));
        QByteArray commented = text;
        commented.replace(0, static_cast<qsizetype>(on.removed), on.inserted);
        QCOMPARE(commented, QByteArray("(* LD %M0.0 *)\n(* ST %M0.1 *)\n\nLD %M0.2\n"));
        const auto off = assist::toggleComment(commented, 1, 3);
        commented.replace(0, static_cast<qsizetype>(off.removed), off.inserted);
        QCOMPARE(commented, text);
    }

    void aCommentAmongLinesStaysOne()
    {
        const auto change = assist::toggleComment("(* why *)\nLD %M0.0\n", 1, 2);
        QCOMPARE(change.inserted, QByteArray("(* why *)\n(* LD %M0.0 *)"));
    }

    void commentsInTheMiddleLeaveTheRestAlone()
    {
        const QByteArray text = "LD %M0.0\nST %M0.1\nLD %M0.2\n";
        const auto change = assist::toggleComment(text, 2, 2);
        QCOMPARE(change.offset, std::size_t(9));
        QCOMPARE(change.removed, std::size_t(8));
        QCOMPARE(change.inserted, QByteArray("(* ST %M0.1 *)"));
    }

    void definitionsAreFound()
    {
        QCOMPARE(assist::definitionOf(project(), "Speed")->field, std::string("rows[1]"));
        QCOMPARE(assist::definitionOf(project(), "%M0.0")->field, std::string("rows[0]"));
        QCOMPARE(assist::definitionOf(project(), "Homing")->object, (ObjectKey{ObjectKind::Program, "Homing"}));
        QCOMPARE(assist::definitionOf(project(), "Feed")->object, (ObjectKey{ObjectKind::Axis, "Feed"}));
        QVERIFY(!assist::definitionOf(project(), "%M7.7"));
        QVERIFY(!assist::definitionOf(project(), ""));
    }
};

QTEST_MAIN(ProgramAssistTest)
#include "tst_programassist.moc"
