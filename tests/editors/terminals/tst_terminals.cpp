#include "editors/document/editcommands.h"
#include "editors/shell/widgets.h"
#include "editors/terminals/terminallamp.h"
#include "editors/terminals/terminalspanel.h"
#include "tests/editors/editorbench.h"

#include <QSignalSpy>
#include <QtTest>

using namespace camwright;

namespace {

const ObjectKey Globals{ObjectKind::VariableTable, "Globals"};

struct Bench : EditorBench {
    Bench() : EditorBench(Project().withContent(Globals, VariableTable::of({{"Start", DataType::Bool, "%I0.0", "", false, ""}})))
    {
        link.terminalList = {{"%I0.0", true}, {"%I0.1", true}, {"%Q0.0", false}};
        panel = std::make_unique<TerminalsPanel>(context);
        panel->resize(800, 200);
        panel->show();
    }
    TerminalLamp* lamp(const char* address) const { return panel->findChild<TerminalLamp*>(QStringLiteral("terminal_") + QLatin1String(address)); }
    QString sentence() const
    {
        auto* empty = panel->findChild<EmptyState*>();
        QString out;
        for (const QLabel* label : empty->findChildren<QLabel*>())
            out += label->text();
        return empty->isVisible() ? out : QString();
    }
    std::unique_ptr<TerminalsPanel> panel;
};

} // namespace

class TerminalsTest : public QObject {
    Q_OBJECT

private slots:
    void showsWhatTheControllerHasWithTheNamesOfTheProject()
    {
        Bench bench;
        QVERIFY(!bench.lamp("%I0.0"));
        QVERIFY(bench.sentence().contains("Go online"));
        bench.goOnline();
        QCOMPARE(bench.panel->findChildren<TerminalLamp*>().size(), 3);
        QCOMPARE(bench.lamp("%I0.0")->accessibleName(), QString("%I0.0 Start, off"));
        QCOMPARE(bench.lamp("%I0.1")->accessibleName(), QString("%I0.1, off"));
        QCOMPARE(bench.link.subscriptions.begin()->second.names, (std::vector<std::string>{"%I0.0", "%I0.1", "%Q0.0"}));
    }

    void namesFollowTheVariables()
    {
        Bench bench;
        bench.goOnline();
        editObject<VariableTable>(bench.document, Globals, "edit", "rows", [](VariableTable& table) {
            table = table.replaced(0, 1, {{"Lamp", DataType::Bool, "%Q0.0", "", false, ""}});
        });
        QCOMPARE(bench.lamp("%I0.0")->accessibleName(), QString("%I0.0, off"));
        QCOMPARE(bench.lamp("%Q0.0")->accessibleName(), QString("%Q0.0 Lamp, off"));
        bench.document.undo();
        QCOMPARE(bench.lamp("%I0.0")->accessibleName(), QString("%I0.0 Start, off"));
    }

    void aClickSwitchesAndTheControllerHasTheLastWord()
    {
        Bench bench;
        bench.goOnline();
        QTest::mouseClick(bench.lamp("%I0.0"), Qt::LeftButton);
        QCOMPARE(bench.link.take(), Said({"takeControl", "write %I0.0 TRUE"}));
        QVERIFY(!bench.lamp("%I0.0")->isOn()); // asked for, not yet so
        bench.link.publish("%I0.0", Value::ofBool(true));
        QVERIFY(bench.lamp("%I0.0")->isOn());
        QCOMPARE(bench.lamp("%I0.0")->accessibleName(), QString("%I0.0 Start, on"));
        QTest::mouseClick(bench.lamp("%I0.0"), Qt::LeftButton);
        QCOMPARE(bench.orders(), Said({"write %I0.0 FALSE"}));
    }

    void theSpaceBarSwitchesToo()
    {
        Bench bench;
        bench.goOnline();
        bench.lamp("%I0.1")->setFocus();
        QTest::keyClick(bench.lamp("%I0.1"), Qt::Key_Space);
        QCOMPARE(bench.orders(), Said({"write %I0.1 TRUE"}));
    }

    void outputsOnlyShow()
    {
        Bench bench;
        bench.goOnline();
        QTest::mouseClick(bench.lamp("%Q0.0"), Qt::LeftButton);
        QCOMPARE(bench.link.take(), Said());
        QCOMPARE(bench.lamp("%Q0.0")->focusPolicy(), Qt::NoFocus);
        bench.link.publish("%Q0.0", Value::ofBool(true), true);
        QVERIFY(bench.lamp("%Q0.0")->isOn());
    }

    void aRefusalIsTold()
    {
        Bench bench;
        bench.goOnline();
        bench.link.autoAnswer = false;
        QTest::mouseClick(bench.lamp("%I0.0"), Qt::LeftButton);
        bench.link.answer();
        bench.link.answer(diagnostic(Code::NameUnknown, {"%I0.0"}));
        QCOMPARE(bench.notices.size(), 1);
        QVERIFY(!bench.lamp("%I0.0")->isOn());
    }

    void aLostLinkTakesTheLampsAwayAndBringsThemBack()
    {
        Bench bench;
        bench.goOnline();
        bench.link.setState(LinkState::Lost);
        QVERIFY(!bench.lamp("%I0.0"));
        QVERIFY(!bench.sentence().isEmpty());
        QCOMPARE(bench.link.subscriptions.size(), std::size_t(0));
        bench.link.setState(LinkState::Online);
        bench.link.deliver();
        QVERIFY(bench.lamp("%I0.0"));
    }

    void aRealControllerSaysWhyThereIsNothing()
    {
        Bench bench;
        bench.link.m_can.terminals = false;
        bench.goOnline();
        QVERIFY(bench.sentence().contains("wired"));
        bench.context.setLink(nullptr);
        QVERIFY(bench.sentence().contains("Go online")); // not the last controller's reason
    }

    void aControllerWithoutAProgramSaysSo()
    {
        Bench bench;
        bench.link.terminalList.clear();
        bench.goOnline(false);
        QVERIFY(bench.sentence().contains("no program"));
        bench.link.terminalList = {{"%I0.0", true}};
        bench.context.setProgramMatches(true); // downloaded
        bench.link.deliver();
        QVERIFY(bench.lamp("%I0.0"));
    }

    void anAnswerOfTheProgramBeforeIsDropped()
    {
        Bench bench;
        bench.link.terminalList = {{"%I7.7", true}};
        bench.context.setLink(&bench.link); // asks
        bench.link.terminalList = {{"%I0.0", true}};
        bench.context.setProgramMatches(true); // another program by now; asks again
        bench.link.deliver();
        QVERIFY(bench.lamp("%I0.0"));
        QVERIFY(!bench.lamp("%I7.7"));
        QCOMPARE(bench.link.subscriptions.size(), std::size_t(1));
    }

    void aClosedPanelHearsNothingMore()
    {
        Bench bench;
        bench.goOnline();
        QCOMPARE(bench.link.subscriptions.size(), std::size_t(1));
        bench.panel.reset();
        QCOMPARE(bench.link.subscriptions.size(), std::size_t(0));
    }

    void onAndOffDifferInMoreThanColour()
    {
        TerminalLamp lamp("%I0.0", true);
        const QImage off = lamp.grab().toImage().convertToFormat(QImage::Format_Mono);
        lamp.setOn(true, false);
        QVERIFY(lamp.grab().toImage().convertToFormat(QImage::Format_Mono) != off);
    }
};

QTEST_MAIN(TerminalsTest)
#include "tst_terminals.moc"
