#include "editors/document/editcommands.h"
#include "editors/shell/quantityfield.h"
#include "editors/shell/widgets.h"
#include "editors/trace/channellist.h"
#include "editors/trace/scopeplot.h"
#include "editors/trace/tracepanel.h"
#include "editors/words/words.h"
#include "tests/editors/editorbench.h"
#include "tests/editors/fits.h"
#include "traceblocks.h"

#include <QComboBox>
#include <QFile>
#include <QLineEdit>
#include <QTableView>
#include <QTemporaryDir>
#include <QtTest>

using namespace camwright;

namespace {

const std::vector<ChannelInfo> Two{{"A", DataType::Lreal, "mm"}, {"B", DataType::Dint, ""}};

struct Bench : EditorBench {
    explicit Bench(Project project = Project()) : EditorBench(std::move(project))
    {
        panel = std::make_unique<TracePanel>(context);
        panel->resize(1100, 400);
        panel->show();
    }
    std::unique_ptr<TracePanel> panel;

    QPushButton* record() const { return part<QPushButton>(*panel, "recordTrace"); }
    QTableView* list() const { return part<QTableView>(*panel, "traceChannels"); }
    QString statistics() const { return part<QLabel>(*panel, "traceStatistics")->text(); }
    QStringList channels() const
    {
        QStringList out;
        for (int row = 0; row < list()->model()->rowCount(); ++row)
            out << list()->model()->index(row, 0).data().toString();
        return out;
    }
    QString emptySentence() const
    {
        auto* empty = panel->findChild<EmptyState*>();
        QString out;
        for (const QLabel* label : empty->findChildren<QLabel*>())
            out += label->text();
        return empty->isVisible() ? out : QString();
    }
    int visibleCursorLines() const
    {
        int out = 0;
        for (int i = 0; i < panel->plot().itemCount(); ++i)
            out += panel->plot().item(i)->visible() && qobject_cast<QCPItemStraightLine*>(panel->plot().item(i)) ? 1 : 0;
        return out;
    }
    void recordTwo()
    {
        panel->addChannels({"A", "B"});
        goOnline();
        QTest::mouseClick(record(), Qt::LeftButton);
    }
    void finish(std::vector<std::vector<double>> columns, std::uint32_t set = 1, std::vector<ChannelInfo> infos = Two)
    {
        SampleBlock block = sampleBlock(0, 1000, std::move(columns), std::move(infos));
        block.channelSet = set;
        block.last = true;
        link.onBlock(block);
    }
};

Project machine()
{
    return Project().withContent({ObjectKind::Axis, "Axis 1 name"}, Axis{});
}

} // namespace

class TracePanelTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { theme().applyToApplication(); }

    void anEmptyPanelSaysHowToRecord()
    {
        Bench bench;
        QVERIFY(bench.emptySentence().contains("Add a channel"));
        bench.panel->addChannels({"A"});
        QVERIFY(bench.emptySentence().contains("Go online"));
        bench.goOnline();
        QVERIFY(bench.emptySentence().startsWith("Press Record"));
        QCOMPARE(bench.visibleCursorLines(), 0);
        QTest::mouseClick(bench.record(), Qt::LeftButton);
        QVERIFY(bench.emptySentence().contains("as soon as"));
        bench.finish({{1, 2, 3}}, 1, {{"A", DataType::Lreal, "mm"}});
        QVERIFY(bench.emptySentence().isEmpty());
        QVERIFY(bench.panel->plot().isVisible());
        QCOMPARE(bench.visibleCursorLines(), 2);
    }

    void theWayToRecordFitsInEveryLanguage_data()
    {
        QTest::addColumn<QString>("language");
        QTest::addColumn<bool>("dark");
        for (const QString& language : words::languages()) {
            QTest::newRow(qPrintable(language + "-light")) << language << false;
            QTest::newRow(qPrintable(language + "-dark")) << language << true;
        }
    }

    void theWayToRecordFitsInEveryLanguage()
    {
        QFETCH(QString, language);
        QFETCH(bool, dark);
        QVERIFY(words::setLanguage(*qApp, language));
        theme().setKind(dark ? Theme::Kind::Dark : Theme::Kind::Light);
        Bench bench;
        bench.panel->resize(1204, 215); // as it stands at the bottom of the window
        QTest::qWait(1);
        QVERIFY(savePicture(*bench.panel, QStringLiteral("trace-empty-") + QLatin1String(QTest::currentDataTag())));
        const QStringList cut = cutTexts(*bench.panel);
        theme().setKind(Theme::Kind::Light);
        QVERIFY(words::setLanguage(*qApp, QStringLiteral("en")));
        QVERIFY2(cut.isEmpty(), qPrintable(cut.join(", ")));
    }

    void recordsTheChannelsOfTheList()
    {
        Bench bench;
        QVERIFY(!bench.record()->isEnabled());
        bench.recordTwo();
        QCOMPARE(bench.link.take(), Said({"startTrace"}));
        QCOMPARE(bench.link.trace->channels, (std::vector<std::string>{"A", "B"}));
        QCOMPARE(bench.link.trace->trigger, TriggerKind::Immediate);
        QTest::mouseClick(bench.record(), Qt::LeftButton);
        QCOMPARE(bench.link.take(), Said({"stopTrace"}));
    }

    void aRefusedStartIsTold()
    {
        Bench bench;
        bench.link.autoAnswer = false;
        bench.recordTwo();
        bench.link.answer(diagnostic(Code::NameUnknown, {"A"}));
        QCOMPARE(bench.notices.size(), 1);
        QVERIFY(bench.notices[0].contains("A"));
        QVERIFY(bench.record()->isEnabled());
        QVERIFY(bench.emptySentence().startsWith("Press Record"));
    }

    void aLostLinkEndsTheRecordingAndKeepsIt()
    {
        Bench bench;
        bench.recordTwo();
        bench.link.onBlock(sampleBlock(0, 1000, {{1, 2}, {3, 4}}, Two));
        bench.link.setState(LinkState::Lost);
        QVERIFY(!bench.record()->isEnabled());
        QCOMPARE(bench.panel->buffer().rows(), std::uint64_t(2));
        bench.link.take();
        bench.link.setState(LinkState::Online);
        QCOMPARE(bench.link.take(), Said()); // never starts by itself
        QVERIFY(bench.record()->isEnabled());
    }

    void statisticsFollowTheCursors()
    {
        Bench bench;
        bench.recordTwo();
        bench.finish({{0, 10, 20, 30, 40}, {1, 1, 1, 1, 1}});
        // The recording fills the view from 1.000 to 1.004 s: the cursors stand at 1.001 and 1.003.
        QCOMPARE(bench.panel->plot().cursorCycle(0), std::uint64_t(1001));
        QCOMPARE(bench.panel->plot().cursorCycle(1), std::uint64_t(1003));
        QVERIFY2(bench.statistics().startsWith("A   A 10.000   B 30.000   Δt 0.002 s   Δy 20.000 mm   min 10.000   max 30.000   mean 20.000"),
            qPrintable(bench.statistics()));
        QVERIFY2(bench.statistics().endsWith("slope 10000.000 mm/s"), qPrintable(bench.statistics()));
        QCOMPARE(bench.list()->model()->index(1, ChannelListModel::AtB).data().toString(), QString("1"));
        bench.list()->selectRow(1);
        QVERIFY2(bench.statistics().startsWith("B   A 1.000"), qPrintable(bench.statistics()));
    }

    void theNextRecordingStartsWithACleanSheet()
    {
        Bench bench;
        bench.recordTwo();
        bench.finish({{1, 2}, {3, 4}});
        QCOMPARE(bench.panel->plot().plottableCount(), 2);
        bench.panel->start();
        QCOMPARE(bench.panel->plot().plottableCount(), 0);
        QCOMPARE(bench.panel->buffer().rows(), std::uint64_t(0));
        bench.finish({{1, 2}, {0, 1}}, 2, {{"A", DataType::Lreal, "mm"}, {"Run", DataType::Bool, ""}});
        QCOMPARE(bench.panel->plot().plottableCount(), 2);
    }

    void aHiddenChannelStaysHiddenInTheNextRecording()
    {
        Bench bench;
        bench.recordTwo();
        bench.finish({{1, 2}, {3, 4}});
        bench.list()->model()->setData(bench.list()->model()->index(0, 0), Qt::Unchecked, Qt::CheckStateRole);
        QCOMPARE(bench.panel->plot().plottableCount(), 1);
        bench.panel->start();
        bench.finish({{1, 2}, {3, 4}}, 2);
        QCOMPARE(bench.panel->plot().plottableCount(), 1);
    }

    void thePresetQuotesTheAxis() // CONTRACTS 18
    {
        Bench bench(machine());
        QCOMPARE(bench.channels().first(), QString("axis.\"Axis 1 name\".setPosition"));
        QCOMPARE(bench.channels().size(), 6);
    }

    void namesAreTypedInAList()
    {
        Bench bench;
        auto* edit = part<QLineEdit>(*bench.panel, "newChannel");
        edit->setText(" Run, axis.\"left, upper\".position,,Run ");
        QTest::keyClick(edit, Qt::Key_Return);
        QCOMPARE(bench.channels(), QStringList({"Run", "axis.\"left, upper\".position"}));
        QVERIFY(edit->text().isEmpty());
    }

    void deleteTakesTheSelectedChannelsAway()
    {
        Bench bench;
        bench.panel->addChannels({"A", "B", "C"});
        bench.panel->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(bench.panel.get()));
        bench.list()->setFocus();
        bench.list()->selectRow(1);
        QTest::keyClick(bench.list(), Qt::Key_Delete);
        QCOMPARE(bench.channels(), QStringList({"A", "C"}));
    }

    void anotherProjectBringsItsOwnChannels()
    {
        Bench bench(machine());
        bench.document.adopt(Project().withContent({ObjectKind::Axis, "Feed"}, Axis{}));
        QCOMPARE(bench.channels().first(), QString("axis.Feed.setPosition"));
        QCOMPARE(bench.channels().size(), 6);
    }

    void aWrongTriggerEntryIsToldInsteadOfReplaced()
    {
        Bench bench;
        bench.panel->addChannels({"A"});
        bench.goOnline();
        auto* kinds = part<QComboBox>(*bench.panel, "triggerKind");
        kinds->setCurrentIndex(kinds->findData(int(TriggerKind::Above)));
        QLineEdit* length = part<QuantityField>(*bench.panel, "traceLength")->lineEdit();
        length->setFocus();
        length->selectAll();
        QTest::keyClicks(length, "two");
        QTest::keyClick(length, Qt::Key_Return);
        bench.panel->start();
        QCOMPARE(bench.link.take(), Said());
        QCOMPARE(bench.notices.size(), 1);
        QCOMPARE(length->text(), QString("two"));
    }

    void exportWritesTheFileAndSaysSo()
    {
        Bench bench;
        bench.recordTwo();
        bench.finish({{1.5, 2}, {3, 4}});
        QTemporaryDir dir;
        const QString file = dir.filePath("out.csv");
        QVERIFY(bench.panel->exportTo(file));
        QFile written(file);
        QVERIFY(written.open(QIODevice::ReadOnly));
        QCOMPARE(written.readAll(), QByteArray("time_s,A,B\n1,1.5,3\n1.001,2,4\n"));
        QVERIFY(bench.notices.last().contains(file));
    }

    void aPathThatCannotBeWrittenIsTold()
    {
        Bench bench;
        bench.recordTwo();
        bench.finish({{1}, {2}});
        QTemporaryDir dir;
        const QString file = dir.filePath("no/such/folder/out.csv");
        QVERIFY(!bench.panel->exportTo(file));
        QVERIFY(bench.notices.last().contains(file));
        QVERIFY(bench.notices.last().contains("cannot be written"));
        QVERIFY(!bench.panel->exportTo(dir.path())); // a folder
        QCOMPARE(bench.notices.size(), 2);
    }

    void aClosedPanelIgnoresWhatStillArrives()
    {
        Bench bench;
        bench.recordTwo();
        bench.panel.reset();
        bench.finish({{1}, {2}});
    }
};

QTEST_MAIN(TracePanelTest)
#include "tst_tracepanel.moc"
