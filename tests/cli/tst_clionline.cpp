#include "tests/cli/clirun.h"
#include "tests/support/runtimeprocess.h"

#include <QElapsedTimer>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

#include <csignal>

using namespace camwright::test;

namespace {

QJsonObject json(const CliRun& run)
{
    return QJsonDocument::fromJson(run.out.toUtf8()).object();
}

QElapsedTimer startedTimer()
{
    QElapsedTimer out;
    out.start();
    return out;
}

/// To a process that runs, never to 0, which would be this test's own group.
void signalTo(QProcess& process, int signal)
{
    QVERIFY2(process.processId() > 0, qPrintable(QString::fromUtf8(process.readAllStandardError())));
    ::kill(static_cast<pid_t>(process.processId()), signal);
}

/// The second column of a CSV.
QList<double> samples(const QString& file)
{
    QFile csv(file);
    QList<double> out;
    if (csv.open(QIODevice::ReadOnly)) {
        csv.readLine();
        while (!csv.atEnd())
            out << csv.readLine().split(',').value(1).toDouble();
    }
    return out;
}

} // namespace

/// A runtime in one process, the command line in others.
class CliOnlineTest : public QObject {
    Q_OBJECT

    QTemporaryDir m_dir;
    Cli m_cli{m_dir.path()};

    QStringList at(const RuntimeProcess& runtime, QStringList arguments) const { return arguments << "--at" << runtime.address(); }
    CliRun ask(const RuntimeProcess& runtime, const QStringList& arguments) const { return m_cli.run(at(runtime, arguments)); }

    void prepare(const RuntimeProcess& runtime)
    {
        QVERIFY(runtime.isRunning());
        const CliRun loaded = ask(runtime, {"download", Cli::example("kinco-feeder")});
        QVERIFY2(loaded.status == 0, qPrintable(loaded.out + loaded.err));
    }

    double number(const RuntimeProcess& runtime, const QString& name) const
    {
        return json(ask(runtime, {"read", name, "--json"}))["values"].toArray().first().toObject()["value"].toString().toDouble();
    }

    /// Asks again and again until the axis stands; 20 s at most.
    bool comesToRest(const RuntimeProcess& runtime) const
    {
        for (QElapsedTimer timer = startedTimer(); timer.elapsed() < 20000;) {
            const CliRun read = ask(runtime, {"read", "axis.Feed.velocity", "--json"});
            const QString value = json(read)["values"].toArray().first().toObject()["value"].toString();
            if (read.status == 0 && !value.isEmpty() && std::abs(value.toDouble()) < 0.5)
                return true;
        }
        return false;
    }

    /// A jog that goes on until it is killed, moving at speed when this returns.
    void startJog(QProcess& jog, const RuntimeProcess& runtime, const QString& velocity)
    {
        const CliRun enabled = ask(runtime, {"axis", "enable", "Feed"});
        QVERIFY2(enabled.status == 0, qPrintable(enabled.out + enabled.err));
        jog.setProcessEnvironment(m_cli.environment());
        jog.start(Cli::program(), at(runtime, {"axis", "jog", "Feed", "--velocity", velocity, "--for", "120s"}));
        const QString file = m_dir.filePath(QStringLiteral("speed.csv"));
        const CliRun traced = ask(runtime, {"trace", "axis.Feed.velocity", "--trigger", "axis.Feed.velocity", "--edge", "above", "--level", "19", "--for", "500ms", "--pre", "0", "--timeout", "60s", "--out", file});
        QVERIFY2(traced.status == 0, qPrintable(traced.out + traced.err + QString::fromUtf8(jog.readAllStandardError())));
    }

private slots:
    void downloadStartMonitorTraceAndStop()
    {
        RuntimeProcess runtime;
        prepare(runtime);
        CliRun status = ask(runtime, {"status", "--json"});
        QCOMPARE(json(status)["status"].toObject()["state"].toString(), QStringLiteral("STOP")); // after a download it stands
        QCOMPARE(ask(runtime, {"start"}).status, 0);
        QCOMPARE(json(ask(runtime, {"status", "--json"}))["status"].toObject()["state"].toString(), QStringLiteral("RUN"));

        const CliRun monitored = ask(runtime, {"monitor", "axis.Feed.position", "Pieces", "--for", "600ms", "--every", "100ms"});
        QCOMPARE(monitored.status, 0);
        QVERIFY2(monitored.out.count(QStringLiteral("axis.Feed.position = ")) >= 3, qPrintable(monitored.out));

        const QString file = m_dir.filePath(QStringLiteral("move.csv"));
        const CliRun traced = ask(runtime, {"trace", "axis.Feed.velocity", "--trigger", "axis.Feed.velocity", "--edge", "above", "--level", "50", "--for", "200ms", "--pre", "0.5", "--timeout", "60s", "--out", file});
        QVERIFY2(traced.status == 0, qPrintable(traced.out + traced.err));
        const QList<double> velocity = samples(file);
        QCOMPARE(velocity.size(), 200);
        QVERIFY(velocity[80] <= 50 && velocity[120] > 50); // the trigger lies in the middle

        QCOMPARE(ask(runtime, {"stop"}).status, 0);
        QCOMPARE(json(ask(runtime, {"status", "--json"}))["status"].toObject()["state"].toString(), QStringLiteral("STOP"));
    }

    void writeReadForceRelease()
    {
        RuntimeProcess runtime;
        prepare(runtime);
        QCOMPARE(ask(runtime, {"write", "%VR3000", "1,5"}).status, 0);
        QCOMPARE(number(runtime, "%VR3000"), 1.5);
        QCOMPARE(ask(runtime, {"write", "%VB3100", "16#FF"}).status, 0);
        QCOMPARE(ask(runtime, {"read", "%VB3100", "--base", "hex"}).out.trimmed(), QStringLiteral("%VB3100 = 16#FF"));
        QCOMPARE(ask(runtime, {"write", "%VB3100", "256"}).status, 1);
        QCOMPARE(ask(runtime, {"force", "%M500.0", "1"}).status, 0);
        QVERIFY(ask(runtime, {"read", "%M500.0"}).out.trimmed().endsWith(QStringLiteral("TRUE F")));
        QCOMPARE(ask(runtime, {"release"}).status, 0);
        const CliRun unknown = ask(runtime, {"read", "NoSuchName"});
        QCOMPARE(unknown.status, 5);
        QVERIFY2(unknown.err.contains(QStringLiteral("NoSuchName")), qPrintable(unknown.err));
    }

    void jogMovesAtTheCommandedSpeedAndStopsAtItsEnd()
    {
        RuntimeProcess runtime;
        prepare(runtime);
        QProcess jog;
        startJog(jog, runtime, QStringLiteral("20"));
        const QList<double> velocity = samples(m_dir.filePath(QStringLiteral("speed.csv")));
        QVERIFY(velocity.size() == 500);
        QVERIFY2(std::abs(velocity.last() - 20.0) < 0.5, qPrintable(QString::number(velocity.last())));
        signalTo(jog, SIGINT); // as Ctrl+C
        QVERIFY(jog.waitForFinished(60000));
        QVERIFY(comesToRest(runtime));
    }

    void aKilledClientLeavesAnAxisThatStopsByItself()
    {
        RuntimeProcess runtime;
        prepare(runtime);
        QProcess jog;
        startJog(jog, runtime, QStringLiteral("20"));
        signalTo(jog, SIGKILL);
        jog.waitForFinished();
        QVERIFY(comesToRest(runtime));
        // The controller's own log has the cycle of the last heartbeat and that of the stop at the bus (CONTRACTS 19).
        bool found = false;
        for (const QJsonValue& entry : json(ask(runtime, {"log", "--json"}))["log"].toArray()) {
            const QJsonObject row = entry.toObject();
            if (row["code"].toString() != QLatin1String(DeadManCode))
                continue;
            static const QRegularExpression Numbers(QStringLiteral("cycle (\\d+).*cycle (\\d+)"));
            const auto match = Numbers.match(row["text"].toString());
            QVERIFY2(match.hasMatch(), qPrintable(row["text"].toString()));
            const qint64 waited = match.captured(2).toLongLong() - match.captured(1).toLongLong();
            QVERIFY2(waited > 0 && waited <= 101, qPrintable(row["text"].toString()));
            found = true;
        }
        QVERIFY(found);
    }

    void aSecondClientIsRefusedControlAndMayWatch()
    {
        RuntimeProcess runtime;
        prepare(runtime);
        QProcess jog;
        startJog(jog, runtime, QStringLiteral("20"));
        const CliRun refused = ask(runtime, {"write", "%M0.0", "1"});
        QCOMPARE(refused.status, 5);
        QVERIFY2(refused.err.contains(QStringLiteral("CW7011")), qPrintable(refused.err));
        QCOMPARE(ask(runtime, {"monitor", "axis.Feed.position", "--for", "300ms"}).status, 0);
        QCOMPARE(ask(runtime, {"axis", "stop"}).status, 0); // stop is accepted from anyone
        QVERIFY(comesToRest(runtime));
        jog.kill();
        jog.waitForFinished();
    }

    void nobodyAnswersIsFour()
    {
        const CliRun run = m_cli.run({"status", "--at", "tcp://127.0.0.1:1"});
        QCOMPARE(run.status, 4);
        QVERIFY2(run.err.contains(QStringLiteral("127.0.0.1:1")), qPrintable(run.err));
        QVERIFY(m_cli.run({"status", "--at", "nonsense"}).status != 0);
    }

    void theLocalControllerIsStartedFoundAndEnded()
    {
        const QString project = Cli::example("ts600-marquee");
        const CliRun loaded = m_cli.run({"download", project, "--start"});
        QVERIFY2(loaded.status == 0, qPrintable(loaded.out + loaded.err));
        QCOMPARE(m_cli.run({"write", "X0", "1", "--project", project}).status, 0);
        QTRY_VERIFY_WITH_TIMEOUT(m_cli.run({"read", "Y0", "Y1", "Y2", "--project", project}).out.contains(QStringLiteral("TRUE")), 20000);
        const CliRun again = m_cli.run({"download", project});
        QVERIFY2(again.status == 5 || again.status == 0, qPrintable(again.out + again.err)); // runs: --stop is wanted
        QCOMPARE(m_cli.run({"stop", "--exit", "--project", project}).status, 0);
    }

    void theRuntimeListensOnThisMachineOnly()
    {
        QProcess runtime;
        runtime.start(QStringLiteral(CAMWRIGHT_BIN_DIR "/camwright-runtime"), {"--listen", "0.0.0.0:0"});
        QVERIFY(runtime.waitForFinished(30000));
        QCOMPARE(runtime.exitCode(), 2);
        QVERIFY(runtime.readAllStandardError().contains("0.0.0.0"));
    }

private:
    static constexpr const char* DeadManCode = "CW5012";
};

QTEST_GUILESS_MAIN(CliOnlineTest)
#include "tst_clionline.moc"
