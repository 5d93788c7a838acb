#include "editors/log/logmodel.h"
#include "editors/log/logpanel.h"
#include "editors/shell/widgets.h"
#include "tests/editors/editorbench.h"

#include <QAbstractItemModelTester>
#include <QClipboard>
#include <QGuiApplication>
#include <QTableView>
#include <QtTest>

using namespace camwright;

namespace {

LogEntry entry(std::uint64_t sequence, const char* name = "Feed")
{
    return {sequence, sequence * 10, Time(std::int64_t(sequence) * 1'500'000'000), diagnostic(Code::NameUnknown, {name})};
}

std::vector<std::uint64_t> sequences(const LogModel& model)
{
    std::vector<std::uint64_t> out;
    for (int row = 0; row < model.rowCount(); ++row)
        out.push_back(model.entry(row).sequence);
    return out;
}

using Sequences = std::vector<std::uint64_t>;

QStringList cycles(const QTableView& table)
{
    QStringList out;
    for (int row = 0; row < table.model()->rowCount(); ++row)
        out << table.model()->index(row, LogModel::Cycle).data().toString();
    return out;
}

} // namespace

class LogTest : public QObject {
    Q_OBJECT

private slots:
    void newestIsFirst()
    {
        LogModel model;
        QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
        model.add({entry(0), entry(1)});
        model.add({entry(2)});
        QCOMPARE(sequences(model), Sequences({2, 1, 0}));
        QCOMPARE(model.nextSequence(), std::uint64_t(3));
    }

    void whatIsKnownIsLeftOut()
    {
        LogModel model;
        model.add({entry(4), entry(5)});
        model.add({entry(3), entry(4), entry(5), entry(6)});
        QCOMPARE(sequences(model), Sequences({6, 5, 4, 3}));
    }

    void historyThatComesLateGoesBehindWhatIsThere()
    {
        LogModel model;
        QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
        model.add({entry(7)}); // live, before the answer with the history
        model.add({entry(5), entry(6), entry(7)});
        QCOMPARE(sequences(model), Sequences({7, 6, 5}));
    }

    void theOldestFallOutAtTheLimit()
    {
        LogModel model;
        std::vector<LogEntry> many;
        for (std::uint64_t i = 0; i < LogModel::Limit + 25; ++i)
            many.push_back(entry(i));
        model.add(many);
        QCOMPARE(model.rowCount(), int(LogModel::Limit));
        QCOMPARE(model.entry(0).sequence, std::uint64_t(LogModel::Limit + 24));
        QCOMPARE(model.entry(model.rowCount() - 1).sequence, std::uint64_t(25));
    }

    void cellsTellTimeCycleCodeAndSentence()
    {
        LogModel model;
        model.add({entry(1, "Lamp")});
        QCOMPARE(model.index(0, LogModel::When).data().toString(), QString("1.500 s"));
        QCOMPARE(model.index(0, LogModel::Cycle).data().toString(), QString("10"));
        QVERIFY(model.index(0, LogModel::CodeId).data().toString().startsWith("CW"));
        QVERIFY(model.index(0, LogModel::Text).data().toString().contains("Lamp"));
        QVERIFY(!model.index(0, LogModel::CodeId).data(Qt::DecorationRole).isNull());
        model.clear();
        QCOMPARE(model.rowCount(), 0);
        QCOMPARE(model.nextSequence(), std::uint64_t(0));
    }

    void thePanelShowsHistoryAndWhatFollows()
    {
        EditorBench bench{Project()};
        bench.link.entries = {entry(0), entry(1)};
        LogPanel panel(bench.context);
        panel.show();
        auto* table = part<QTableView>(panel, "controllerLog");
        QVERIFY(panel.findChild<EmptyState*>()->isVisible());
        bench.context.setLink(&bench.link);
        bench.link.logs(entry(2)); // between question and answer
        bench.link.deliver();
        bench.link.logs(entry(3));
        QVERIFY(table->isVisible());
        QCOMPARE(cycles(*table), QStringList({"30", "20", "10", "0"}));
    }

    void aLostLinkKeepsTheLogAndFillsItUpAfterwards()
    {
        EditorBench bench{Project()};
        LogPanel panel(bench.context);
        bench.link.entries = {entry(0)};
        bench.goOnline();
        auto* table = part<QTableView>(panel, "controllerLog");
        bench.link.setState(LinkState::Lost);
        QCOMPARE(cycles(*table), QStringList({"0"}));
        bench.link.entries.push_back(entry(1)); // while nobody listened
        bench.link.setState(LinkState::Online);
        bench.link.deliver();
        QCOMPARE(cycles(*table), QStringList({"10", "0"}));
        QCOMPARE(bench.link.logListeners(), std::size_t(1));
    }

    void offlineForgetsTheLog()
    {
        EditorBench bench{Project()};
        LogPanel panel(bench.context);
        bench.link.entries = {entry(0)};
        bench.goOnline();
        bench.context.setLink(nullptr);
        QCOMPARE(cycles(*part<QTableView>(panel, "controllerLog")), QStringList());
        QCOMPARE(bench.link.logListeners(), std::size_t(0));
    }

    void aClosedPanelHearsNothingMore()
    {
        EditorBench bench{Project()};
        auto panel = std::make_unique<LogPanel>(bench.context);
        bench.goOnline();
        QCOMPARE(bench.link.logListeners(), std::size_t(1));
        panel.reset();
        QCOMPARE(bench.link.logListeners(), std::size_t(0));
    }

    void copyTakesTheRowsInTheirOrder()
    {
        EditorBench bench{Project()};
        LogPanel panel(bench.context);
        bench.link.entries = {entry(0), entry(1), entry(2)};
        bench.goOnline();
        auto* table = part<QTableView>(panel, "controllerLog");
        QVERIFY(!panel.can("edit.copy"));
        for (const int row : {2, 0})
            table->selectionModel()->select(table->model()->index(row, 0), QItemSelectionModel::Select | QItemSelectionModel::Rows);
        QVERIFY(panel.can("edit.copy"));
        panel.perform("edit.copy");
        const QStringList lines = QGuiApplication::clipboard()->text().split('\n');
        QCOMPARE(lines.size(), 2);
        QVERIFY(lines[0].startsWith("3.000 s\t20\tCW"));
        QVERIFY(lines[1].startsWith("0.000 s\t0\tCW"));
    }
};

QTEST_MAIN(LogTest)
#include "tst_log.moc"
