// The window's whole main job with the real controller process: open, go online, download, run, watch it move, edit, undo,
// download again, jog by key, stop. By keys and object names, as a user does it.
#include "app/window/composition.h"
#include "app/window/mainwindow.h"
#include "app/window/realservices.h"
#include "devices/session/onlinesession.h"
#include "editors/shell/quantityfield.h"

#include <QLineEdit>
#include <QPushButton>
#include <QSettings>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QtTest>

using namespace camwright;

namespace {

constexpr int Patience = 30000; // ms; the machine may be busy

const ObjectKey Feed{ObjectKind::Axis, "Feed"};

void copyFolder(const QString& from, const QString& to)
{
    QDir().mkpath(to);
    QDirIterator it(from, QDir::Files, QDirIterator::Subdirectories);
    while (it.hasNext()) {
        const QString file = it.next();
        const QString target = QDir(to).filePath(QDir(from).relativeFilePath(file));
        QDir().mkpath(QFileInfo(target).path());
        QFile::copy(file, target);
    }
}

} // namespace

class MainJobTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY(m_dir.isValid());
        const QString run = m_dir.filePath("run");
        QDir().mkpath(run);
        QFile::setPermissions(run, QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
        qputenv("XDG_RUNTIME_DIR", run.toUtf8());
        qputenv("XDG_DATA_HOME", m_dir.filePath("data").toUtf8());
        qputenv("XDG_CONFIG_HOME", m_dir.filePath("config").toUtf8());
        QCoreApplication::setOrganizationName("camwright-test");
        QCoreApplication::setApplicationName("mainjob");
        theme().applyToApplication();
        copyFolder(QStringLiteral(CAMWRIGHT_SOURCE_DIR "/examples/kinco-feeder"), m_dir.filePath("feeder"));
        m_workspace = std::make_unique<Workspace>(m_real.services(), registerEverything);
        m_window = std::make_unique<MainWindow>(*m_workspace);
        m_window->show();
        QApplication::setActiveWindow(m_window.get());
        QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
    }

    void opensWithoutErrors()
    {
        QVERIFY(m_window->openProject(m_dir.filePath("feeder")));
        QTRY_VERIFY_WITH_TIMEOUT(!m_workspace->checks.isRunning(), Patience);
        QCOMPARE(m_workspace->document.errorCount(), 0);
    }

    void goesOnlineByKey()
    {
        press(Qt::Key_F8, Qt::AltModifier);
        QTRY_VERIFY_WITH_TIMEOUT(m_workspace->context.isOnline(), Patience);
    }

    void showsThePlanThenDownloads()
    {
        download();
        QTRY_VERIFY_WITH_TIMEOUT(m_workspace->context.programMatches(), Patience);
        QVERIFY(status().state == RunState::Stop);
    }

    void runsAndTheFeedMoves()
    {
        press(Qt::Key_F5);
        QTRY_VERIFY_WITH_TIMEOUT(status().state == RunState::Run, Patience);
        const double before = position();
        QTRY_VERIFY_WITH_TIMEOUT(std::abs(position() - before) > 1, Patience);
    }

    void editedParameterTurnsLiveValuesOffAndUndoBringsThemBack()
    {
        m_workspace->context.open(Feed);
        QuantityField* guardTime = nullptr;
        for (QuantityField* field : m_window->findChildren<QuantityField*>()) {
            if (field->isVisible() && field->spec().reference.contains("KS-MCN") && field->lineEdit()->text() == "10000")
                guardTime = field;
        }
        QVERIFY(guardTime);
        guardTime->lineEdit()->setFocus();
        guardTime->lineEdit()->selectAll();
        QTest::keyClicks(guardTime->lineEdit(), "20000");
        QTest::keyClick(guardTime->lineEdit(), Qt::Key_Return);
        QCOMPARE(m_workspace->document.content<Axis>(Feed)->encoderResolution.value(), 20000);
        QTRY_VERIFY_WITH_TIMEOUT(!m_workspace->context.programMatches(), Patience);
        m_workspace->actions.action("edit.undo")->trigger();
        QCOMPARE(m_workspace->document.content<Axis>(Feed)->encoderResolution.value(), 10000);
        QTRY_VERIFY_WITH_TIMEOUT(m_workspace->context.programMatches(), Patience);
    }

    void stopsByKeyAndDownloadsAgain()
    {
        press(Qt::Key_F5, Qt::ShiftModifier);
        QTRY_VERIFY_WITH_TIMEOUT(status().state == RunState::Stop, Patience);
        download();
        QTRY_VERIFY_WITH_TIMEOUT(m_workspace->context.programMatches(), Patience);
    }

    void cleanupTestCase()
    {
        if (auto* session = dynamic_cast<OnlineSession*>(m_workspace->context.link())) {
            bool ended = false;
            m_workspace->connection.withControl([&] { session->exitController([&](Result<void>) { ended = true; }); });
            QTRY_VERIFY_WITH_TIMEOUT(ended, Patience);
        }
        m_workspace->connection.disconnectNow();
        m_window.reset();
        m_workspace.reset();
    }

private:
    const ControllerStatus& status() const { return m_workspace->context.status(); }

    double position() const
    {
        for (const AxisStatus& axis : status().axes) {
            if (axis.name == "Feed")
                return axis.position;
        }
        return 0;
    }

    void press(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier)
    {
        QApplication::setActiveWindow(m_window.get()); // the offscreen platform does not give it back after a dialog
        QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
        QTest::keyClick(m_window.get(), key, modifiers);
    }

    void download()
    {
        press(Qt::Key_F8);
        const auto button = [this]() -> QPushButton* {
            for (QPushButton* candidate : m_window->findChildren<QPushButton*>("downloadGo")) {
                if (candidate->isVisible() && candidate->isEnabled())
                    return candidate;
            }
            return nullptr;
        };
        QTRY_VERIFY_WITH_TIMEOUT(button(), Patience);
        QTest::keyClick(button(), Qt::Key_Space);
        QTRY_VERIFY_WITH_TIMEOUT(m_window->findChildren<QPushButton*>("downloadGo").isEmpty(), Patience);
    }

    QTemporaryDir m_dir;
    RealServices m_real;
    std::unique_ptr<Workspace> m_workspace;
    std::unique_ptr<MainWindow> m_window;
};

QTEST_MAIN(MainJobTest)
#include "tst_mainjob.moc"
