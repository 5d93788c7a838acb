#include "editors/document/editcommands.h"
#include "editors/shell/widgets.h"
#include "editors/watch/register.h"
#include "editors/watch/watcheditor.h"
#include "editors/watch/watchmodel.h"
#include "editors/watch/watchpanel.h"
#include "editors/watch/watchview.h"
#include "tests/editors/editorbench.h"

#include <QAction>
#include <QClipboard>
#include <QComboBox>
#include <QCompleter>
#include <QLineEdit>
#include <QSignalSpy>
#include <QTableView>
#include <QtTest>

using namespace camwright;

namespace {

const ObjectKey List{ObjectKind::WatchTable, "List"};

Project watching()
{
    return Project().withContent(List, WatchTable{{{"Run", "", {}}, {"Level", "", {}}, {"Nowhere", "", {}}}})
        .withContent({ObjectKind::WatchTable, "Other"}, WatchTable{{{"Delay", "", {}}}})
        .withContent({ObjectKind::Axis, "Feed"}, Axis{});
}

struct Bench : EditorBench {
    Bench() : EditorBench(watching())
    {
        registerWatch(registry, actions);
        link.types = {{"Run", DataType::Bool}, {"Level", DataType::Byte}, {"Delay", DataType::Time}};
    }
};

QString cell(const WatchView& view, int row, int column)
{
    return view.model().index(row, column).data().toString();
}

void select(const WatchView& view, int row)
{
    view.table()->setCurrentIndex(view.model().index(row, WatchModel::Name));
}

void type(const WatchView& view, int row, const QString& text)
{
    view.model().setData(view.model().index(row, WatchModel::NewValue), text, Qt::EditRole);
}

std::vector<std::string> onlySubscription(const ValueLink& link)
{
    return link.subscriptions.size() == 1 ? link.subscriptions.begin()->second.names : std::vector<std::string>{"not one subscription"};
}

} // namespace

class WatchViewTest : public QObject {
    Q_OBJECT

private slots:
    void subscribesToWhatTheProgramKnows()
    {
        Bench bench;
        WatchView view(bench.context, List);
        bench.goOnline();
        QCOMPARE(onlySubscription(bench.link), (std::vector<std::string>{"Level", "Run"}));
        bench.link.publish("Level", Value::ofInteger(DataType::Byte, 5));
        QCOMPARE(cell(view, 1, WatchModel::CurrentValue), QString("5"));
        QCOMPARE(cell(view, 2, WatchModel::CurrentValue), QString("not known"));
    }

    void aNewRowIsAskedForAndTheOldSubscriptionEnds()
    {
        Bench bench;
        WatchView view(bench.context, List);
        bench.goOnline();
        view.model().add(0, {{"Delay", "", {}}});
        bench.link.deliver();
        QCOMPARE(onlySubscription(bench.link), (std::vector<std::string>{"Delay", "Level", "Run"}));
        bench.document.undo();
        bench.link.deliver();
        QCOMPARE(onlySubscription(bench.link), (std::vector<std::string>{"Level", "Run"}));
    }

    void aSecondRowOfTheSameNameIsAskedForOnce()
    {
        Bench bench;
        WatchView view(bench.context, List);
        view.model().add(0, {{"Run", "", {}}});
        bench.goOnline();
        QCOMPARE(onlySubscription(bench.link), (std::vector<std::string>{"Level", "Run"}));
        bench.link.publish("Run", Value::ofBool(true));
        QCOMPARE(cell(view, 0, WatchModel::CurrentValue), QString("TRUE"));
        QCOMPARE(cell(view, 1, WatchModel::CurrentValue), QString("TRUE"));
    }

    void answersThatComeAfterAnotherQuestionAreDropped()
    {
        Bench bench;
        WatchView view(bench.context, List);
        bench.context.setLink(&bench.link);
        bench.context.setProgramMatches(true);
        view.setKey({ObjectKind::WatchTable, "Other"}); // before the first answers are there
        bench.link.deliver();
        QCOMPARE(onlySubscription(bench.link), (std::vector<std::string>{"Delay"}));
    }

    void aClosedViewHearsNothingMore()
    {
        Bench bench;
        auto view = std::make_unique<WatchView>(bench.context, List);
        bench.goOnline();
        QCOMPARE(bench.link.subscriptions.size(), std::size_t(1));
        view.reset();
        QCOMPARE(bench.link.subscriptions.size(), std::size_t(0));
        bench.link.publish("Run", Value::ofBool(true));
    }

    void closesWhileANameIsTyped()
    {
        Bench bench;
        auto editor = std::make_unique<WatchEditor>(bench.context, List);
        editor->show();
        editor->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(editor.get()));
        auto* table = part<QTableView>(*editor, "watchTable");
        table->setFocus();
        table->setCurrentIndex(table->model()->index(3, WatchModel::Name));
        QTest::keyClicks(table, "x");
        QVERIFY(table->findChild<QLineEdit*>());
        editor.reset();
    }

    void aLostLinkLeavesTheLastValuesDimmedAndComesBack()
    {
        Bench bench;
        WatchView view(bench.context, List);
        bench.goOnline();
        bench.link.publish("Run", Value::ofBool(true));
        bench.link.setState(LinkState::Lost);
        const QModelIndex value = view.model().index(0, WatchModel::CurrentValue);
        QCOMPARE(value.data().toString(), QString("TRUE"));
        QCOMPARE(value.data(Qt::ForegroundRole).value<QColor>(), theme().color(Role::Faint));
        QCOMPARE(bench.link.subscriptions.size(), std::size_t(0));
        bench.link.setState(LinkState::Online);
        bench.link.deliver();
        QCOMPARE(onlySubscription(bench.link), (std::vector<std::string>{"Level", "Run"}));
    }

    void offlineShowsNoValues()
    {
        Bench bench;
        WatchView view(bench.context, List);
        bench.goOnline();
        bench.link.publish("Run", Value::ofBool(true));
        bench.context.setLink(nullptr);
        QCOMPARE(cell(view, 0, WatchModel::CurrentValue), QString());
        QCOMPARE(bench.link.subscriptions.size(), std::size_t(0));
    }

    void anotherProgramInTheControllerShowsNoValuesAndSaysWhy()
    {
        Bench bench;
        WatchView view(bench.context, List);
        view.show();
        bench.goOnline();
        auto* banner = view.findChild<Banner*>();
        QVERIFY(!banner->isVisible());
        bench.link.publish("Run", Value::ofBool(true));
        bench.context.setProgramMatches(false);
        bench.link.deliver();
        QVERIFY(banner->isVisible());
        QCOMPARE(cell(view, 0, WatchModel::CurrentValue), QString());
        QCOMPARE(bench.link.subscriptions.size(), std::size_t(0));
        bench.context.setProgramMatches(true);
        bench.link.deliver();
        QVERIFY(!banner->isVisible());
        QCOMPARE(bench.link.subscriptions.size(), std::size_t(1));
    }

    void aTypedValueIsWrittenUnderControl()
    {
        Bench bench;
        WatchView view(bench.context, List);
        bench.goOnline();
        type(view, 1, "16#FF");
        QCOMPARE(bench.link.take(), Said({"takeControl", "write Level 255"}));
        type(view, 1, "256");
        QCOMPARE(bench.link.take(), Said());
        QCOMPARE(cell(view, 1, WatchModel::NewValue), QString("256"));
    }

    void aRefusedWriteIsTold()
    {
        Bench bench;
        WatchView view(bench.context, List);
        bench.goOnline();
        bench.link.autoAnswer = false;
        type(view, 0, "1");
        bench.link.answer(diagnostic(Code::NameUnknown, {"control"}));
        QCOMPARE(bench.orders(), Said()); // without control nothing is written
        QCOMPARE(bench.notices.size(), 1);
        type(view, 0, "1");
        bench.link.answer();
        bench.link.answer(diagnostic(Code::NameUnknown, {"Run"}));
        QCOMPARE(bench.notices.size(), 2);
        QCOMPARE(cell(view, 0, WatchModel::NewValue), QString("1"));
    }

    void forcesWhatIsTypedElseWhatStands()
    {
        Bench bench;
        WatchView view(bench.context, List);
        bench.goOnline();
        bench.link.publish("Level", Value::ofInteger(DataType::Byte, 7));
        select(view, 1);
        view.forceSelected();
        QCOMPARE(bench.orders(), Said({"force Level 7"}));
        type(view, 1, "2#11");
        bench.orders();
        view.forceSelected();
        QCOMPARE(bench.orders(), Said({"force Level 3"}));
        view.releaseSelected();
        QCOMPARE(bench.orders(), Said({"release Level"}));
    }

    void aWrongEntryIsNotForced()
    {
        Bench bench;
        WatchView view(bench.context, List);
        bench.goOnline();
        bench.link.publish("Level", Value::ofInteger(DataType::Byte, 7));
        type(view, 1, "999");
        select(view, 1);
        view.forceSelected();
        QCOMPARE(bench.orders(), Said());
        QCOMPARE(bench.notices.size(), 1);
    }

    void durationsAreForcedAsTyped()
    {
        Bench bench;
        WatchView view(bench.context, {ObjectKind::WatchTable, "Other"});
        bench.goOnline();
        type(view, 0, "T#5s");
        select(view, 0);
        view.forceSelected();
        QCOMPARE(bench.orders(), Said({"write Delay T#5s", "force Delay T#5s"}));
    }

    void unknownNamesAreNotForced()
    {
        Bench bench;
        WatchView view(bench.context, List);
        bench.goOnline();
        select(view, 2);
        view.forceSelected();
        QCOMPARE(bench.orders(), Said());
    }

    void nothingIsOrderedOffline()
    {
        Bench bench;
        WatchView view(bench.context, List);
        select(view, 0);
        type(view, 0, "1");
        view.forceSelected();
        view.releaseSelected();
        QCOMPARE(bench.link.take(), Said());
        QCOMPARE(cell(view, 0, WatchModel::NewValue), QString("1"));
    }

    void cutAndPasteMoveRows()
    {
        Bench bench;
        WatchView view(bench.context, List);
        const Project before = bench.document.project();
        select(view, 0);
        view.perform("edit.cut");
        QCOMPARE(QApplication::clipboard()->text(), QString("Run"));
        select(view, 1);
        QApplication::clipboard()->setText("Run\tBOOL\n\n  %M0.1\r\n");
        view.perform("edit.paste");
        QStringList names;
        for (const WatchRow& row : view.model().rows())
            names << QString::fromStdString(row.expression);
        QCOMPARE(names, QStringList({"Level", "Nowhere", "Run", "%M0.1"}));
        bench.document.undo();
        bench.document.undo();
        QVERIFY(bench.document.project() == before);
    }

    void theNameFieldCompletesAnywhereInANameInAnyCase()
    {
        Bench bench;
        WatchView view(bench.context, List);
        view.show();
        const QModelIndex empty = view.model().index(3, WatchModel::Name);
        view.table()->edit(empty);
        auto* edit = view.table()->findChild<QLineEdit*>();
        QVERIFY(edit);
        edit->completer()->setCompletionPrefix("FOLLOW");
        QCOMPARE(edit->completer()->completionCount(), 1);
        QCOMPARE(edit->completer()->currentCompletion(), QString("axis.Feed.followingError"));
    }

    void typingANewRowByKeysKeepsTheCursorInIt()
    {
        Bench bench;
        WatchView view(bench.context, List);
        view.show();
        view.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&view));
        view.table()->setFocus();
        view.table()->setCurrentIndex(view.model().index(3, WatchModel::Name));
        QTest::keyClicks(view.table(), "D");
        auto* edit = view.table()->findChild<QLineEdit*>();
        QVERIFY(edit);
        QTest::keyClicks(edit, "elay");
        QTest::keyClick(edit, Qt::Key_Return);
        QTRY_COMPARE(view.model().rows().back().expression, std::string("Delay"));
        QCOMPARE(view.table()->currentIndex(), view.model().index(3, WatchModel::Name));
    }

    void everyRowIsPaintedWithItsHistory()
    {
        Bench bench;
        WatchView view(bench.context, List);
        view.resize(900, 200);
        bench.goOnline();
        const QImage plain = view.grab().toImage();
        for (int i = 0; i < 20; ++i)
            bench.link.publish("Level", Value::ofInteger(DataType::Byte, i * i % 50));
        const QRect curve = view.table()->visualRect(view.model().index(1, WatchModel::History));
        QVERIFY(view.table()->viewport()->grab(curve).toImage() != view.table()->viewport()->grab(view.table()->visualRect(view.model().index(2, WatchModel::History))).toImage());
        QVERIFY(view.grab().toImage() != plain);
    }

    // The panel and the tab

    void f7ForcesInTheListWithTheFocus()
    {
        Bench bench;
        WatchPanel panel(bench.context);
        WatchEditor editor(bench.context, {ObjectKind::WatchTable, "Other"});
        panel.show();
        editor.show();
        bench.goOnline();
        bench.link.publish("Run", Value::ofBool(true));
        bench.link.publish("Delay", Value::ofInteger(DataType::Time, 20));
        auto* table = part<QTableView>(editor, "watchTable");
        table->setCurrentIndex(table->model()->index(0, 0));
        select(panel.view(), 0);
        editor.activateWindow();
        table->setFocus();
        QTRY_COMPARE(QApplication::focusWidget(), table);
        bench.actions.action("watch.force")->setEnabled(true);
        bench.actions.action("watch.force")->trigger();
        QCOMPARE(bench.orders(), Said({"force Delay T#20ms"}));
        panel.activateWindow();
        panel.view().table()->setFocus();
        QTRY_COMPARE(QApplication::focusWidget(), panel.view().table());
        bench.actions.action("watch.force")->trigger();
        QCOMPARE(bench.orders(), Said({"force Run TRUE"}));
    }

    void thePanelStaysWithItsListWhenThatIsRenamed()
    {
        Bench bench;
        WatchPanel panel(bench.context);
        auto* lists = panel.tabRowWidget()->findChild<QComboBox*>("watchLists");
        QCOMPARE(lists->count(), 2);
        lists->setCurrentIndex(1);
        emit lists->activated(1);
        QCOMPARE(panel.view().model().key().name, std::string("Other"));
        QVERIFY(renameObject(bench.document, {ObjectKind::WatchTable, "Other"}, "Pauses").ok());
        QCOMPARE(panel.view().model().key().name, std::string("Pauses"));
        QCOMPARE(panel.view().model().rows().size(), std::size_t(1));
        bench.document.undo();
        QCOMPARE(panel.view().model().key().name, std::string("Other"));
    }

    void thePanelMakesAListAndShowsAnotherWhenItIsGone()
    {
        Bench bench;
        WatchPanel panel(bench.context);
        auto* lists = panel.tabRowWidget()->findChild<QComboBox*>("watchLists");
        QTest::mouseClick(panel.tabRowWidget()->findChild<QWidget*>("addWatchList"), Qt::LeftButton);
        QCOMPARE(lists->count(), 3);
        QCOMPARE(lists->currentText(), QString("Watch1"));
        bench.document.undo();
        QCOMPARE(lists->count(), 2);
        QCOMPARE(lists->currentText(), QString("Other"));
        QCOMPARE(panel.view().model().key().name, std::string("Other"));
    }

    void anEmptyProjectOffersAList()
    {
        EditorBench bench{Project().withContent({ObjectKind::Axis, "Feed"}, Axis{})};
        registerWatch(bench.registry, bench.actions);
        WatchPanel panel(bench.context);
        panel.show();
        auto* empty = panel.findChild<EmptyState*>();
        QVERIFY(empty && empty->isVisible());
        QTest::mouseClick(empty->findChild<QPushButton*>(), Qt::LeftButton);
        QVERIFY(bench.document.object({ObjectKind::WatchTable, "Watch1"}));
        QVERIFY(!empty->isVisible());
    }
};

QTEST_MAIN(WatchViewTest)
#include "tst_watchview.moc"
