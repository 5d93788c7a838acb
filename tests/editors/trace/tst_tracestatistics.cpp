#include "editors/trace/tracecsv.h"
#include "editors/trace/tracestatistics.h"
#include "traceblocks.h"

#include <QtTest>

using namespace camwright;

namespace {

/// Cycles 10, 12, 14, 16 hold 1, NaN, 3, 5; then a gap; cycles 30, 32 hold -4, 2.
TraceBuffer torn()
{
    TraceBuffer out;
    out.append(sampleBlock(0, 10, {{1, Nan, 3, 5}}, {{"Level", DataType::Real, ""}}, 2));
    out.append(sampleBlock(2, 30, {{-4, 2}}, {}, 2));
    return out;
}

} // namespace

class TraceStatisticsTest : public QObject {
    Q_OBJECT

private slots:
    void numbersOverAGapAndANan()
    {
        const TraceStatistics s = statisticsBetween(torn(), 0, 10, 32); // 1, 3, 5, -4, 2
        QCOMPARE(s.samples, std::uint64_t(5));
        QCOMPARE(s.minimum, -4.0);
        QCOMPARE(s.maximum, 5.0);
        QCOMPARE(s.mean, 1.4);
        QCOMPARE(s.rms, std::sqrt(11.0));
        QCOMPARE(s.deltaTime, 0.022);
        QCOMPARE(s.atA, std::optional(1.0));
        QCOMPARE(s.atB, std::optional(2.0));
        QCOMPARE(s.slope, 1 / 0.022);
    }

    void bothCursorsAreIncluded()
    {
        const TraceStatistics s = statisticsBetween(torn(), 0, 14, 16);
        QCOMPARE(s.samples, std::uint64_t(2));
        QCOMPARE(s.mean, 4.0);
        QCOMPARE(s.rms, std::sqrt(17.0));
        QCOMPARE(s.deltaValue(), std::optional(2.0));
    }

    void cursorsBetweenSamplesTakeTheOneBefore()
    {
        const TraceStatistics s = statisticsBetween(torn(), 0, 15, 31);
        QCOMPARE(s.atA, std::optional(3.0));
        QCOMPARE(s.atB, std::optional(-4.0));
        QCOMPARE(s.samples, std::uint64_t(2)); // cycles 16 and 30
        QCOMPARE(s.minimum, -4.0);
        QCOMPARE(s.maximum, 5.0);
    }

    void aCursorInAGapHasNoValue()
    {
        const TraceStatistics s = statisticsBetween(torn(), 0, 10, 25);
        QCOMPARE(s.atA, std::optional(1.0));
        QVERIFY(!s.atB);
        QVERIFY(!s.deltaValue());
        QCOMPARE(s.slope, 0.0);
        QCOMPARE(s.samples, std::uint64_t(3));
        QCOMPARE(s.mean, 3.0);
    }

    void aCursorOnANanHasNoSlope()
    {
        const TraceStatistics s = statisticsBetween(torn(), 0, 12, 16);
        QCOMPARE(s.slope, 0.0);
        QCOMPARE(s.samples, std::uint64_t(2));
        QCOMPARE(s.mean, 4.0);
    }

    void swappedCursorsKeepSignAndSlope()
    {
        const TraceStatistics s = statisticsBetween(torn(), 0, 32, 10);
        QCOMPARE(s.deltaTime, -0.022);
        QCOMPARE(s.deltaValue(), std::optional(-1.0));
        QCOMPARE(s.slope, 1 / 0.022);
        QCOMPARE(s.samples, std::uint64_t(5));
    }

    void bothCursorsOnOneSample()
    {
        const TraceStatistics s = statisticsBetween(torn(), 0, 14, 14);
        QCOMPARE(s.samples, std::uint64_t(1));
        QCOMPARE(s.minimum, 3.0);
        QCOMPARE(s.maximum, 3.0);
        QCOMPARE(s.rms, 3.0);
        QCOMPARE(s.deltaTime, 0.0);
        QCOMPARE(s.slope, 0.0);
    }

    void nothingBetweenTheCursors_data()
    {
        QTest::addColumn<quint64>("a");
        QTest::addColumn<quint64>("b");
        QTest::newRow("before the recording") << quint64(0) << quint64(9);
        QTest::newRow("behind it") << quint64(33) << quint64(1000);
        QTest::newRow("inside the gap") << quint64(17) << quint64(29);
        QTest::newRow("only a NaN") << quint64(11) << quint64(13);
    }

    void nothingBetweenTheCursors()
    {
        QFETCH(quint64, a);
        QFETCH(quint64, b);
        const TraceStatistics s = statisticsBetween(torn(), 0, a, b);
        QCOMPARE(s.samples, std::uint64_t(0));
        QCOMPARE(s.mean, 0.0);
        QCOMPARE(s.slope, 0.0);
    }

    void anEmptyRecordingHasNothing()
    {
        const TraceStatistics s = statisticsBetween(TraceBuffer(), 0, 0, 100);
        QCOMPARE(s.samples, std::uint64_t(0));
        QVERIFY(!s.atA && !s.atB);
    }

    // CSV

    void csvIsExactToTheByte()
    {
        TraceBuffer buffer;
        buffer.append(sampleBlock(0, 10, {{0.1, Nan}, {1, 0}, {double(0.1f), 2.5}, {-7, 4294967295.0}},
            {{"axis.\"Feed, left\".position", DataType::Lreal, "mm"}, {"Run", DataType::Bool, ""}, {"Speed", DataType::Real, ""}, {"Count", DataType::Lint, ""}}, 2));
        buffer.append(sampleBlock(3, 2000, {{1e300}, {1}, {1e20}, {0}}, {}, 2));
        QCOMPARE(traceCsv(buffer), QByteArray("time_s,\"axis.\"\"Feed, left\"\".position\",Run,Speed,Count\n"
                                              "0.01,0.1,1,0.1,-7\n"
                                              "0.012,nan,0,2.5,4294967295\n"
                                              "\n"
                                              "2,1e+300,1,1e+20,0\n"));
    }

    void csvOfNothingIsItsHeader()
    {
        QCOMPARE(traceCsv(TraceBuffer()), QByteArray("time_s\n"));
        TraceBuffer named;
        named.append(sampleBlock(0, 0, {{}}, {{"Run", DataType::Bool, ""}}));
        QCOMPARE(traceCsv(named), QByteArray("time_s,Run\n"));
    }

    void everyGapIsOneEmptyLine()
    {
        TraceBuffer buffer;
        buffer.append(sampleBlock(0, 0, {{1, 2}}, {{"A", DataType::Int, ""}}));
        buffer.append(sampleBlock(1, 2, {{3}}));     // follows
        buffer.append(sampleBlock(2, 10, {{4}}));    // cycles are missing
        SampleBlock lossy = sampleBlock(3, 11, {{5}});
        lossy.lostRows = 7;                          // the controller says so
        buffer.append(lossy);
        QCOMPARE(traceCsv(buffer), QByteArray("time_s,A\n0,1\n0.001,2\n0.002,3\n\n0.01,4\n\n0.011,5\n"));
    }
};

QTEST_GUILESS_MAIN(TraceStatisticsTest)
#include "tst_tracestatistics.moc"
