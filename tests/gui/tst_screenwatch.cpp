// Screen lock and sleep end panel motion, heard on a D-Bus of the test's own. The bus is dbus-daemon, started here.
#include "app/window/screenwatch.h"
#include "tests/editors/commissioning/panelbench.h"

#include <QDBusConnection>
#include <QDBusMessage>
#include <QLocalServer>
#include <QLocalSocket>
#include <QProcess>
#include <QTemporaryDir>

using namespace camwright;

namespace {

constexpr int Patience = 20000; // ms; the machine may be busy

constexpr char BusConfig[] =
    "<!DOCTYPE busconfig PUBLIC \"-//freedesktop//DTD D-Bus Bus Configuration 1.0//EN\"\n"
    "\"http://www.freedesktop.org/standards/dbus/1.0/busconfig.dtd\">\n"
    "<busconfig>\n"
    "<type>session</type>\n"
    "<listen>unix:path=%1</listen>\n"
    "<auth>EXTERNAL</auth>\n"
    "<policy context=\"default\">\n"
    "<allow send_destination=\"*\" eavesdrop=\"true\"/>\n"
    "<allow eavesdrop=\"true\"/>\n"
    "<allow own=\"*\"/>\n"
    "</policy>\n"
    "</busconfig>\n";

} // namespace

class ScreenWatchTest : public PanelBench {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        theme().applyToApplication();
        QVERIFY(m_dir.isValid());
        QFile config(m_dir.filePath("bus.conf"));
        QVERIFY(config.open(QIODevice::WriteOnly));
        config.write(QString::fromLatin1(BusConfig).arg(m_dir.filePath("bus")).toUtf8());
        config.close();
        m_bus.setProcessChannelMode(QProcess::MergedChannels);
        m_bus.start("dbus-daemon", {"--config-file=" + config.fileName(), "--nofork", "--print-address=1"});
        QVERIFY2(m_bus.waitForStarted(Patience), "dbus-daemon is missing; script/bootstrap installs it");
        QVERIFY(m_bus.waitForReadyRead(Patience));
        m_address = QString::fromUtf8(m_bus.readLine()).trimmed();
        QVERIFY2(m_address.startsWith("unix:"), qPrintable(m_address));
        QVERIFY(QDBusConnection::connectToBus(m_address, "desktop").isConnected());
    }

    void cleanupTestCase()
    {
        QDBusConnection::disconnectFromBus("desktop");
        m_bus.terminate();
        QVERIFY(m_bus.waitForFinished(Patience));
    }

    void init() { open(); }
    void cleanup()
    {
        m_watch.reset();
        shut();
    }

    void signalOfTheDesktopStopsAndDisarms_data()
    {
        QTest::addColumn<QString>("path");
        QTest::addColumn<QString>("interface");
        QTest::addColumn<QString>("signal");
        QTest::addColumn<QVariantList>("arguments");
        QTest::newRow("screen saver") << "/org/freedesktop/ScreenSaver" << "org.freedesktop.ScreenSaver" << "ActiveChanged" << QVariantList{true};
        QTest::newRow("screen saver, old path") << "/ScreenSaver" << "org.freedesktop.ScreenSaver" << "ActiveChanged" << QVariantList{true};
        QTest::newRow("GNOME") << "/org/gnome/ScreenSaver" << "org.gnome.ScreenSaver" << "ActiveChanged" << QVariantList{true};
        QTest::newRow("session lock") << "/org/freedesktop/login1/session/_32" << "org.freedesktop.login1.Session" << "Lock" << QVariantList{};
        QTest::newRow("sleep") << "/org/freedesktop/login1" << "org.freedesktop.login1.Manager" << "PrepareForSleep" << QVariantList{true};
        QTest::newRow("awake again") << "/org/freedesktop/login1" << "org.freedesktop.login1.Manager" << "PrepareForSleep" << QVariantList{false};
    }

    void signalOfTheDesktopStopsAndDisarms()
    {
        QFETCH(QString, path);
        QFETCH(QString, interface);
        QFETCH(QString, signal);
        QFETCH(QVariantList, arguments);
        listen({m_address, m_address});
        arm();
        m_link->push();
        QTest::mousePress(part<HoldButton>("jogPlus"), Qt::LeftButton);
        QCOMPARE(m_link->take(), Said({"jog Feed 5"}));
        QSignalSpy notices(m_context.get(), &Context::notified);
        tell(path, interface, signal, arguments);
        QTRY_VERIFY_WITH_TIMEOUT(!m_context->isArmed(), Patience);
        QCOMPARE(m_link->take(), Said({"stop Feed", "disarm Feed"}));
        QCOMPARE(notices.size(), 1);
        const int beats = m_link->beats;
        QTest::mouseRelease(part<HoldButton>("jogPlus"), Qt::LeftButton);
        QTest::qWait(100); // five beats long
        QCOMPARE(m_link->beats, beats);
        QCOMPARE(m_link->take(), Said());
    }

    void armingUnderWayIsGivenUp()
    {
        listen({m_address, {}});
        m_link->autoAnswer = false;
        QTest::mouseClick(part<QWidget>("arm"), Qt::LeftButton);
        tell("/ScreenSaver", "org.freedesktop.ScreenSaver", "ActiveChanged", {true});
        QTRY_VERIFY_WITH_TIMEOUT(m_editor->control().arming() == PanelControl::Arming::Off, Patience);
        while (!m_link->waiting.empty())
            m_link->answer();
        QVERIFY(!m_context->isArmed());
    }

    void unlockingChangesNothing()
    {
        listen({m_address, {}});
        arm();
        tell("/ScreenSaver", "org.freedesktop.ScreenSaver", "ActiveChanged", {false});
        // The lock that follows on the same bus is heard after it.
        QSignalSpy disarms(m_context.get(), &Context::disarmRequested);
        tell("/ScreenSaver", "org.freedesktop.ScreenSaver", "ActiveChanged", {true});
        QTRY_VERIFY_WITH_TIMEOUT(!m_context->isArmed(), Patience);
        QCOMPARE(disarms.size(), 1);
    }

    void lockWithoutAnArmedPanelSaysNothing()
    {
        listen({m_address, {}});
        QSignalSpy notices(m_context.get(), &Context::notified);
        QSignalSpy disarms(m_context.get(), &Context::disarmRequested);
        tell("/ScreenSaver", "org.freedesktop.ScreenSaver", "ActiveChanged", {true});
        QTRY_COMPARE_WITH_TIMEOUT(disarms.size(), 1, Patience);
        QCOMPARE(notices.size(), 0);
        QCOMPARE(m_link->take(), Said());
    }

    void noBusIsHarmless_data()
    {
        QTest::addColumn<QString>("address");
        QTest::newRow("no socket") << "unix:path=" + m_dir.filePath("nothing");
        QTest::newRow("nonsense") << "moon:phase=full";
        QTest::newRow("half") << "unix:";
    }

    void noBusIsHarmless()
    {
        QFETCH(QString, address);
        QElapsedTimer time;
        time.start();
        m_watch = std::make_unique<ScreenWatch>(*m_context, ScreenWatch::Buses{address, {}});
        QSignalSpy unreachable(m_watch.get(), &ScreenWatch::unreachable);
        QVERIFY(time.elapsed() < 100); // nothing is waited for
        QTRY_COMPARE_WITH_TIMEOUT(unreachable.size(), 1, Patience);
        arm();
        QVERIFY(m_context->isArmed());
    }

    void busThatNeverAnswersHoldsNothingUp()
    {
        QLocalServer deaf; // takes the connection and says nothing
        QVERIFY(deaf.listen(m_dir.filePath("deaf")));
        QElapsedTimer time;
        time.start();
        m_watch = std::make_unique<ScreenWatch>(*m_context, ScreenWatch::Buses{"unix:path=" + deaf.fullServerName(), {}});
        QVERIFY(time.elapsed() < 100);
        arm();
        QVERIFY(m_context->isArmed());
        QTRY_VERIFY_WITH_TIMEOUT(deaf.hasPendingConnections(), Patience);
        deaf.close();
        while (QLocalSocket* waiting = deaf.nextPendingConnection())
            delete waiting; // so that the worker comes back
    }

    void withoutAnEnvironmentThereIsNoBusToStart()
    {
        const QByteArray session = qgetenv("DBUS_SESSION_BUS_ADDRESS"), runtime = qgetenv("XDG_RUNTIME_DIR");
        qunsetenv("DBUS_SESSION_BUS_ADDRESS");
        qputenv("XDG_RUNTIME_DIR", m_dir.path().toUtf8() + "/empty");
        QCOMPARE(ScreenWatch::buses().session, QString());
        qputenv("XDG_RUNTIME_DIR", m_dir.path().toUtf8());
        QCOMPARE(ScreenWatch::buses().session, "unix:path=" + m_dir.filePath("bus"));
        qputenv("DBUS_SESSION_BUS_ADDRESS", "autolaunch:");
        QCOMPARE(ScreenWatch::buses().session, QString());
        qputenv("XDG_RUNTIME_DIR", runtime);
        session.isNull() ? qunsetenv("DBUS_SESSION_BUS_ADDRESS") : qputenv("DBUS_SESSION_BUS_ADDRESS", session);
    }

private:
    void listen(const ScreenWatch::Buses& buses)
    {
        m_watch = std::make_unique<ScreenWatch>(*m_context, buses);
        QSignalSpy listening(m_watch.get(), &ScreenWatch::listening);
        const int wanted = buses.system.isEmpty() ? 1 : 2;
        QTRY_COMPARE_WITH_TIMEOUT(listening.size(), wanted, Patience);
    }

    static void tell(const QString& path, const QString& interface, const QString& signal, const QVariantList& arguments)
    {
        QDBusMessage message = QDBusMessage::createSignal(path, interface, signal);
        message.setArguments(arguments);
        QVERIFY(QDBusConnection("desktop").send(message));
    }

    QTemporaryDir m_dir;
    QProcess m_bus;
    QString m_address;
    std::unique_ptr<ScreenWatch> m_watch;
};

QTEST_MAIN(ScreenWatchTest)
#include "tst_screenwatch.moc"
