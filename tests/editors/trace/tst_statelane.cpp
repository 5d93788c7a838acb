// States and booleans in the oscilloscope: bands with their names, readouts in words, CSV in numbers.
#include "core/family/family.h"
#include "editors/shell/actions.h"
#include "editors/shell/context.h"
#include "editors/shell/registry.h"
#include "editors/trace/channellist.h"
#include "editors/trace/scopeplot.h"
#include "editors/trace/statelane.h"
#include "editors/trace/tracecsv.h"
#include "editors/trace/tracepanel.h"
#include "editors/words/words.h"
#include "tests/gui/fakelink.h"

#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTableView>
#include <QThreadPool>
#include <QtTest>

using namespace camwright;

namespace {

TraceColumn column(double value)
{
    return {false, false, value, value, value, value};
}

TraceColumn changing(double first, double last)
{
    return {false, false, std::min(first, last), std::max(first, last), first, last};
}

/// A position, a state that goes 2, 3, 2 and a switch; a gap of 100 cycles before the last stretch.
SampleBlock recording()
{
    SampleBlock out;
    out.channels = {{"axis.Feed.position", DataType::Lreal, "mm"}, {"axis.Feed.state", DataType::Usint, ""}, {"%I0.0", DataType::Bool, ""}};
    out.columns.resize(3);
    for (int i = 0; i < 300; ++i) {
        out.columns[0].push_back(i * 0.1);
        out.columns[1].push_back(i < 100 ? 2 : i < 200 ? 3 : 2);
        out.columns[2].push_back(i < 150 ? 0 : 1);
    }
    return out;
}

} // namespace

class StateLaneTest : public QObject {
    Q_OBJECT

private slots:
    void cleanup() { QVERIFY(words::setLanguage(*qApp, "en")); }

    void bandsJoinEqualColumns()
    {
        const auto bands = bandsOf({column(2), column(2), column(3), column(3)}, 10, 0.5);
        QCOMPARE(bands, (std::vector<StateBand>{{10, 11, 2.0}, {11, 12, 3.0}}));
    }

    void columnWithTheChangeBelongsToWhatFollows()
    {
        const auto bands = bandsOf({column(2), changing(2, 3), column(3)}, 0, 1);
        QCOMPARE(bands, (std::vector<StateBand>{{0, 1, 2.0}, {1, 3, 3.0}}));
    }

    void changesTooFastToTellApartHaveNoName()
    {
        const auto bands = bandsOf({column(2), changing(2, 3), changing(3, 2), column(2)}, 0, 1);
        QCOMPARE(bands, (std::vector<StateBand>{{0, 1, 2.0}, {1, 3, std::nullopt}, {3, 4, 2.0}}));
    }

    void gapIsNeverPartOfABand()
    {
        TraceColumn after = column(2);
        after.gap = true;
        const auto bands = bandsOf({column(2), TraceColumn(), after}, 0, 1);
        QCOMPARE(bands, (std::vector<StateBand>{{0, 1, 2.0}, {2, 3, 2.0}}));
    }

    void timeBetweenTwoSamplesBelongsToTheEarlier()
    {
        const auto bands = bandsOf({column(2), TraceColumn(), column(3)}, 0, 1);
        QCOMPARE(bands, (std::vector<StateBand>{{0, 2, 2.0}, {2, 3, 3.0}}));
    }

    void narrowBandsShortenTheirTextThenHideIt()
    {
        const QFontMetrics metrics{QFont()};
        const QString name = "Discrete motion";
        const int full = metrics.horizontalAdvance(name) + 10;
        QCOMPARE(bandText(name, metrics, full), name);
        const QString shortened = bandText(name, metrics, full * 0.6);
        QVERIFY(shortened.endsWith(QChar(0x2026)));
        QVERIFY(metrics.horizontalAdvance(shortened) <= full * 0.6);
        QCOMPARE(bandText(name, metrics, 12), QString());
    }

    void statesAreNamedByTheFamilyInTheUsersLanguage()
    {
        const StateNames names = StateNames::of({"axis.Feed.state", DataType::Usint, ""}, "kinco");
        QVERIFY(names.hasNames());
        const Text& standstill = findFamily("kinco")->findAxisState(2)->name;
        QCOMPARE(names.name(2), QString::fromStdString(standstill.en));
        QVERIFY(words::setLanguage(*qApp, "zh"));
        QCOMPARE(names.name(2), QString::fromStdString(standstill.zh));
        QVERIFY(words::setLanguage(*qApp, "ru"));
        QCOMPARE(names.name(2), QString::fromStdString(standstill.ru));
        QCOMPARE(names.name(77), QString("77"));
    }

    void quantitiesAndVariablesNamedStateHaveNoNames()
    {
        QVERIFY(!StateNames::of({"axis.Feed.position", DataType::Lreal, "mm"}, "kinco").hasNames());
        QVERIFY(!StateNames::of({"Machine.state", DataType::Usint, ""}, "kinco").hasNames());
        QVERIFY(!StateNames::of({"axis.Feed.state", DataType::Usint, ""}, "moon").hasNames());
        QVERIFY(StateNames::of({"axis.\"Axis 1\".state", DataType::Usint, ""}, "kinco").hasNames());
    }

    void plotShowsStatesAndBooleansAsBands()
    {
        TraceBuffer buffer;
        QVERIFY(buffer.append(recording()));
        ScopePlot plot(buffer);
        plot.setFamily("kinco");
        plot.resize(800, 300);
        plot.rebuild();
        plot.fit();
        QVERIFY(!plot.stateLane(0));
        QVERIFY(plot.stateLane(1) && plot.stateLane(2));
        QCOMPARE(plot.graphCount(), 1);
        const auto& bands = plot.stateLane(1)->bands();
        QCOMPARE(bands.size(), 3u);
        QCOMPARE(*bands[1].value, 3.0);
        QVERIFY(std::abs(bands[1].from - 0.1) < 0.002 && std::abs(bands[1].to - 0.2) < 0.002);
        QCOMPARE(plot.stateLane(2)->bands().size(), 2u);
    }

    void overlaidStatesKeepTheirOwnLanes()
    {
        TraceBuffer buffer;
        QVERIFY(buffer.append(recording()));
        ScopePlot plot(buffer);
        plot.setFamily("kinco");
        plot.rebuild();
        plot.setOverlaid(true);
        QCOMPARE(plot.axisRectCount(), 3);
        QVERIFY(plot.stateLane(1));
        plot.setLaneVisible(1, false);
        QCOMPARE(plot.axisRectCount(), 2);
        QVERIFY(!plot.stateLane(1));
    }

    void cursorReadoutSaysTheName()
    {
        TraceBuffer buffer;
        QVERIFY(buffer.append(recording()));
        ChannelListModel model(buffer);
        model.setFamily("kinco");
        model.setChannels({"axis.Feed.position", "axis.Feed.state", "%I0.0"});
        model.setCursors(50, 160);
        const Family* kinco = findFamily("kinco");
        QCOMPARE(model.index(1, ChannelListModel::AtA).data().toString(), QString::fromStdString(kinco->findAxisState(2)->name.en));
        QCOMPARE(model.index(1, ChannelListModel::AtB).data().toString(), QString::fromStdString(kinco->findAxisState(3)->name.en));
        QCOMPARE(model.index(2, ChannelListModel::AtA).data().toString(), QString("FALSE"));
        QCOMPARE(model.index(0, ChannelListModel::AtA).data().toString(), QString("5.000"));
    }

    void csvKeepsTheNumbers()
    {
        TraceBuffer buffer;
        QVERIFY(buffer.append(recording()));
        const QList<QByteArray> lines = traceCsv(buffer).split('\n');
        QCOMPARE(lines[0], QByteArray("time_s,axis.Feed.position,axis.Feed.state,%I0.0"));
        QCOMPARE(lines[1], QByteArray("0,0,2,0"));
        QCOMPARE(lines[161], QByteArray("0.16,16,3,1"));
    }

    void panelNamesTheStateUnderTheCursors()
    {
        ProjectDocument document;
        ActionCatalogue actions;
        Registry registry;
        QThreadPool pool;
        Context context(document, actions, registry, pool);
        FakeLink link;
        context.setLink(&link);
        TracePanel panel(context);
        panel.resize(1000, 400);
        panel.addChannels({"axis.Feed.position", "axis.Feed.state"});
        panel.show();
        QTest::mouseClick(panel.findChild<QPushButton*>("recordTrace"), Qt::LeftButton);
        QTRY_VERIFY(panel.plot().stateLane(1) && !panel.plot().stateLane(1)->bands().empty());
        panel.findChild<QTableView*>("traceChannels")->selectRow(1);
        panel.plot().placeCursorsInView();
        const QString words = panel.findChild<QLabel*>("traceStatistics")->text();
        QVERIFY2(words.contains("axis.Feed.state") && words.contains("Δt") && !words.contains("mean"), qPrintable(words));
        const double cycle = double(panel.plot().cursorCycle(0));
        const auto value = panel.buffer().valueAt(1, std::uint64_t(cycle));
        if (value)
            QVERIFY2(words.contains(QString::fromStdString(findFamily("kinco")->findAxisState(int(*value))->name.en)), qPrintable(words));
        context.setLink(nullptr);
    }
};

QTEST_MAIN(StateLaneTest)
#include "tst_statelane.moc"
