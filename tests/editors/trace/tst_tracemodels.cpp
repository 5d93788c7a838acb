#include "editors/shell/quantityfield.h"
#include "editors/shell/theme.h"
#include "editors/trace/channellist.h"
#include "editors/trace/scopeplot.h"
#include "editors/trace/triggerbar.h"
#include "traceblocks.h"

#include <QAbstractItemModelTester>
#include <QComboBox>
#include <QLineEdit>
#include <QSignalSpy>
#include <QtTest>

using namespace camwright;

namespace {

const std::vector<ChannelInfo> Recorded{{"axis.Feed.position", DataType::Lreal, "mm"}, {"Run", DataType::Bool, ""}, {"Count", DataType::Dint, ""}};

struct Bench {
    TraceBuffer buffer;
    ChannelListModel model{buffer};
    QAbstractItemModelTester tester{&model, QAbstractItemModelTester::FailureReportingMode::QtTest};
    void record() { buffer.append(sampleBlock(0, 100, {{1.25, 2.5, Nan}, {0, 1, 1}, {7, -8, 9}}, Recorded)); }
    QString cell(int row, int column) const { return model.index(row, column).data().toString(); }
    QStringList row(int row) const { return {cell(row, 0), cell(row, 1), cell(row, 2)}; }
};

template <class W>
W* part(const QWidget& parent, const char* name)
{
    W* found = parent.findChild<W*>(QString::fromLatin1(name));
    if (!found)
        qFatal("no widget %s", name);
    return found;
}

void type(const TriggerBar& bar, const char* field, const QString& text)
{
    QLineEdit* edit = part<QuantityField>(bar, field)->lineEdit();
    edit->setFocus();
    edit->selectAll();
    QTest::keyClicks(edit, text);
    QTest::keyClick(edit, Qt::Key_Return);
}

void choose(const TriggerBar& bar, TriggerKind kind)
{
    auto* kinds = part<QComboBox>(bar, "triggerKind");
    kinds->setCurrentIndex(kinds->findData(int(kind)));
}

} // namespace

class TraceModelsTest : public QObject {
    Q_OBJECT

private slots:
    void valuesAtTheCursorsAreShownAsTheirType()
    {
        Bench bench;
        bench.model.setChannels({"axis.Feed.position", "Run", "Count", "Later"});
        QCOMPARE(bench.row(0), QStringList({"axis.Feed.position", "–", "–"}));
        bench.record();
        QSignalSpy changes(&bench.model, &QAbstractItemModel::dataChanged);
        bench.model.setCursors(100, 101);
        QCOMPARE(bench.row(0), QStringList({"axis.Feed.position  [mm]", "1.250", "2.500"}));
        QCOMPARE(bench.row(1), QStringList({"Run", "FALSE", "TRUE"}));
        QCOMPARE(bench.row(2), QStringList({"Count", "7", "-8"}));
        QCOMPARE(bench.row(3), QStringList({"Later", "–", "–"}));
        QCOMPARE(changes.size(), 1);
        QCOMPARE(changes[0][0].toModelIndex().column(), int(ChannelListModel::Name)); // the unit has come
        bench.model.setCursors(50, 500);
        QCOMPARE(bench.row(2), QStringList({"Count", "–", "–"}));
    }

    void onlyWhatIsRecordedHasAColour()
    {
        Bench bench;
        bench.model.setChannels({"Later", "Run"});
        bench.record();
        QVERIFY(!bench.model.index(0, 0).data(Qt::ForegroundRole).isValid());
        QVERIFY(!bench.model.index(0, 0).data(Qt::ToolTipRole).toString().isEmpty());
        QCOMPARE(bench.model.recorded(0), -1);
        QCOMPARE(bench.model.recorded(1), 1);
        QCOMPARE(bench.model.index(1, 0).data(Qt::ForegroundRole).value<QColor>(), theme().color(ScopePlot::channelRole(1)));
    }

    void theMarkHidesAndShows()
    {
        Bench bench;
        bench.model.setChannels({"Run", "Count"});
        QSignalSpy shown(&bench.model, &ChannelListModel::shownChanged);
        QVERIFY(bench.model.setData(bench.model.index(1, 0), Qt::Unchecked, Qt::CheckStateRole));
        QCOMPARE(shown.size(), 1);
        QCOMPARE(shown[0], QVariantList({1, false}));
        QVERIFY(!bench.model.isShown(1));
        QVERIFY(bench.model.isShown(0));
        QVERIFY(!bench.model.setData(bench.model.index(1, 1), Qt::Unchecked, Qt::CheckStateRole));
        QVERIFY(!bench.model.setData({}, Qt::Unchecked, Qt::CheckStateRole));
        QVERIFY(!bench.model.setData(bench.model.index(1, 0), "other", Qt::EditRole));
    }

    void aHiddenChannelStaysHiddenWhenOthersComeAndGo()
    {
        Bench bench;
        bench.model.setChannels({"Run", "Count"});
        bench.model.setData(bench.model.index(1, 0), Qt::Unchecked, Qt::CheckStateRole);
        bench.model.setChannels({"Speed", "Count", "Run"});
        QVERIFY(bench.model.isShown(0));
        QVERIFY(!bench.model.isShown(1));
        QVERIFY(bench.model.isShown(2));
        bench.model.setChannels({"Run"});
        bench.model.setChannels({"Run", "Count"}); // taken away and added again: a new wish
        QVERIFY(bench.model.isShown(1));
    }

    // The trigger

    void atOnceRecordsWithoutEnd()
    {
        TriggerBar bar;
        bar.show();
        TraceSetup setup;
        bar.apply(setup);
        QCOMPARE(setup.trigger, TriggerKind::Immediate);
        QCOMPARE(setup.samples, 0u);
        QVERIFY(!part<QComboBox>(bar, "triggerChannel")->isVisible());
    }

    void aTriggerHasChannelLevelAndLength()
    {
        TriggerBar bar;
        bar.show();
        bar.setChannels({"Run", "axis.Feed.position"});
        choose(bar, TriggerKind::Above);
        part<QComboBox>(bar, "triggerChannel")->setCurrentText(" axis.Feed.position ");
        type(bar, "triggerLevel", "12,5");
        type(bar, "preTrigger", "40");
        type(bar, "traceLength", "0.5");
        TraceSetup setup;
        setup.stride = 2;
        bar.apply(setup);
        QCOMPARE(setup.trigger, TriggerKind::Above);
        QCOMPARE(setup.triggerChannel, std::string("axis.Feed.position"));
        QCOMPARE(setup.triggerLevel, 12.5);
        QCOMPARE(setup.preTrigger, 0.4);
        QCOMPARE(setup.samples, 250u); // half a second of every second millisecond
    }

    void theTriggerChannelStaysWhenTheListChanges()
    {
        TriggerBar bar;
        bar.setChannels({"A", "B"});
        part<QComboBox>(bar, "triggerChannel")->setCurrentText("Mine");
        bar.setChannels({"C"});
        QCOMPARE(part<QComboBox>(bar, "triggerChannel")->currentText(), QString("Mine"));
    }

    void aWrongEntryIsKeptAndToldOnlyWhereItCounts()
    {
        TriggerBar bar;
        bar.show();
        choose(bar, TriggerKind::RisingEdge);
        QVERIFY(!bar.wrongField());
        type(bar, "traceLength", "2x");
        QCOMPARE(bar.wrongField(), part<QuantityField>(bar, "traceLength"));
        QCOMPARE(part<QuantityField>(bar, "traceLength")->lineEdit()->text(), QString("2x"));
        type(bar, "preTrigger", "101");
        QCOMPARE(bar.wrongField(), part<QuantityField>(bar, "preTrigger"));
        choose(bar, TriggerKind::Immediate);
        QVERIFY(!bar.wrongField());
    }
};

QTEST_MAIN(TraceModelsTest)
#include "tst_tracemodels.moc"
