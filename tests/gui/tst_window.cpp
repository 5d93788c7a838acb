#include "app/window/badgetabbar.h"
#include "app/window/editortabbar.h"
#include "app/window/mainwindow.h"
#include "app/window/newprojectdialog.h"
#include "app/window/palette.h"
#include "app/window/recentlist.h"
#include "editors/document/editcommands.h"
#include "editors/shell/editor.h"
#include "editors/shell/icons.h"
#include "plainwindow.h"

#include <QLineEdit>
#include <QSettings>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QtTest>

using namespace camwright;

class WindowTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QStandardPaths::setTestModeEnabled(true);
        QCoreApplication::setOrganizationName("camwright-test");
        QCoreApplication::setApplicationName("window");
    }

    void init()
    {
        QSettings().clear();
        m_dir = std::make_unique<QTemporaryDir>();
        m_workspace = std::make_unique<Workspace>(fakeServices(), registerPlain);
        QVERIFY(m_workspace->document.create(twoAxes(), m_dir->filePath("two")).ok());
        m_window = std::make_unique<MainWindow>(*m_workspace);
        m_window->show();
        m_tabs = m_window->findChild<QTabBar*>("editorTabs");
        QVERIFY(m_tabs);
    }

    void cleanup()
    {
        m_window.reset();
        m_workspace.reset();
    }

    void closesWhileAPartOutsideTheEditorsHasTheFocus()
    {
        auto* presets = m_window->findChild<QTabBar*>("presets");
        QVERIFY(presets);
        m_window->activateWindow();
        presets->setFocus();
        QTRY_COMPARE(QApplication::focusWidget(), presets);
        m_window.reset(); // loses the focus in its last breath
        QVERIFY(!QApplication::focusWidget());
    }

    void nextPreviewReplacesTheFormer()
    {
        m_workspace->context.preview(Feed);
        m_workspace->context.preview(Turn);
        QCOMPARE(m_tabs->count(), 1);
        QCOMPARE(m_tabs->tabText(0), QString("Turn"));
        m_workspace->context.open(Turn);
        m_workspace->context.preview(Feed);
        QCOMPARE(m_tabs->count(), 2);
    }

    void backAndForwardFollowThePlaces()
    {
        m_workspace->context.open(Feed);
        m_workspace->context.open(Turn);
        press(Qt::Key_Left, Qt::AltModifier);
        QCOMPARE(m_window->editors().current()->key(), Feed);
        press(Qt::Key_Right, Qt::AltModifier);
        QCOMPARE(m_window->editors().current()->key(), Turn);
    }

    void undoKeyTakesBackAndShowsThePlace()
    {
        editObject<Axis>(m_workspace->document, Feed, "Change guard time", "guard_time_ms", [](Axis& axis) { axis.guardTimeMs = 5; });
        m_workspace->context.open(Turn);
        press(Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(m_workspace->document.content<Axis>(Feed)->guardTimeMs.value(), 1000);
        auto* editor = static_cast<PlainEditor*>(m_window->editors().current());
        QCOMPARE(editor->key(), Feed);
        QCOMPARE(editor->revealed.field, std::string("guard_time_ms"));
    }

    void undoIsOfferedByName()
    {
        editObject<Axis>(m_workspace->document, Feed, "Change guard time", "guard_time_ms", [](Axis& axis) { axis.guardTimeMs = 5; });
        QCOMPARE(m_workspace->actions.action("edit.undo")->text(), QString("&Undo Change guard time"));
    }

    void editActionGoesToTheCurrentEditor()
    {
        m_workspace->context.open(Feed);
        QVERIFY(m_workspace->actions.action("edit.find")->isEnabled());
        QVERIFY(!m_workspace->actions.action("edit.replace")->isEnabled());
        m_workspace->actions.action("edit.find")->trigger();
        QCOMPARE(static_cast<PlainEditor*>(m_window->editors().current())->performed, QStringList{"edit.find"});
    }

    void tabFollowsRenameAndClosesWithItsObject()
    {
        m_workspace->context.open(Feed);
        QVERIFY(renameObject(m_workspace->document, Feed, "Infeed").ok());
        QCOMPARE(m_tabs->tabText(0), QString("Infeed"));
        const ObjectKey key{ObjectKind::Axis, "Infeed"};
        removeObjects(m_workspace->document, std::span(&key, 1));
        QCOMPARE(m_tabs->count(), 0);
    }

    void saveKeyWritesTheFiles()
    {
        editObject<Axis>(m_workspace->document, Feed, "Change guard time", "guard_time_ms", [](Axis& axis) { axis.guardTimeMs = 777; });
        QVERIFY(m_window->isWindowModified());
        press(Qt::Key_S, Qt::ControlModifier);
        QVERIFY(!m_window->isWindowModified());
        QFile file(m_dir->filePath("two/axes/Feed.toml"));
        QVERIFY(file.open(QIODevice::ReadOnly));
        QVERIFY(file.readAll().contains("777"));
    }

    void liveValuesAreOffWhenTheProgramDiffers()
    {
        m_workspace->connection.connectTo("local");
        QVERIFY(!m_workspace->context.programMatches());
        m_workspace->workbench.build();
        QTRY_VERIFY(m_workspace->context.programMatches());
        editObject<Axis>(m_workspace->document, Feed, "Change guard time", "guard_time_ms", [](Axis& axis) { axis.guardTimeMs = 5; });
        QVERIFY(!m_workspace->context.programMatches());
    }

    void failedBuildListsItsReasons()
    {
        removeObjects(m_workspace->document, std::span(&Feed, 1));
        QSignalSpy notices(&m_workspace->context, &Context::notified);
        m_workspace->workbench.build();
        QTRY_COMPARE(m_workspace->document.errorCount(), 1);
        QCOMPARE(notices.size(), 1);
    }

    void armedPanelTakesItsKeysFromTheWindow()
    {
        m_workspace->connection.connectTo("local");
        QObject panel;
        QVERIFY(!m_workspace->actions.action("go.nextProblem")->shortcuts().isEmpty());
        m_workspace->context.arm(&panel);
        QVERIFY(m_workspace->actions.action("go.nextProblem")->shortcuts().isEmpty());
        QVERIFY(m_workspace->actions.action("help.docs")->shortcuts().isEmpty());
        m_workspace->context.disarm(&panel);
        QCOMPARE(m_workspace->actions.action("go.nextProblem")->shortcut(), QKeySequence(Qt::Key_F4));
    }

    void disconnectingDisarms()
    {
        m_workspace->connection.connectTo("local");
        QObject panel;
        m_workspace->context.arm(&panel);
        m_workspace->connection.disconnectNow();
        QVERIFY(!m_workspace->context.isArmed());
        QCOMPARE(m_workspace->actions.action("go.nextProblem")->shortcut(), QKeySequence(Qt::Key_F4));
    }

    void closingTheProjectShowsTheStartPage()
    {
        m_workspace->actions.action("file.close")->trigger();
        QVERIFY(!m_workspace->document.isOpen());
        QVERIFY(m_window->findChild<QWidget*>("startPage")->isVisible());
        QCOMPARE(m_workspace->settings.recentProjects().size(), 1);
    }

    void paletteFindsByLettersInOrder()
    {
        QVERIFY(matchScore("gt", "GuardTime") > matchScore("gt", "light"));
        QVERIFY(matchScore("feed", "Feed") > matchScore("feed", "OffsetErrorDelay"));
        QCOMPARE(matchScore("xyz", "Feed"), -1);
    }

    void paletteOpensWhatIsChosen()
    {
        Palette palette("Find", "Name", findableObjects(m_workspace->context), m_window.get());
        palette.setAttribute(Qt::WA_DeleteOnClose, false);
        palette.show();
        auto* line = palette.findChild<QLineEdit*>("paletteLine");
        QTest::keyClicks(line, "tur");
        QTest::keyClick(line, Qt::Key_Return);
        QVERIFY(m_window->editors().current());
        QCOMPARE(m_window->editors().current()->key(), Turn);
    }

    void everyActionHasTextAndToolTip()
    {
        for (const ActionRow& row : m_workspace->actions.rows()) {
            QVERIFY2(*row.text, row.id);
            QVERIFY2(*row.toolTip, row.id);
            QVERIFY2(!*row.icon || hasIcon(QString::fromLatin1(row.icon)), row.id);
        }
    }

    void noTwoActionsShareAKey()
    {
        QMap<QString, QString> seen;
        for (const ActionRow& row : m_workspace->actions.rows()) {
            for (const QKeySequence& key : m_workspace->actions.action(QString::fromLatin1(row.id))->shortcuts()) {
                QVERIFY2(!seen.contains(key.toString()), qPrintable(seen.value(key.toString()) + " and " + row.id + " on " + key.toString()));
                seen.insert(key.toString(), row.id);
            }
        }
    }

    void whenIsToldAsPeopleSayIt()
    {
        const QDateTime now(QDate(2026, 11, 22), QTime(12, 0));
        QCOMPARE(whenText(QDateTime(QDate(2026, 11, 22), QTime(9, 12)), now), QString("Today 09:12"));
        QCOMPARE(whenText(QDateTime(QDate(2026, 11, 21), QTime(9, 12)), now), QString("Yesterday"));
    }

private:
    void press(Qt::Key key, Qt::KeyboardModifiers modifiers)
    {
        QApplication::setActiveWindow(m_window.get());
        QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
        QTest::keyClick(m_window.get(), key, modifiers);
    }

    std::unique_ptr<QTemporaryDir> m_dir;
    std::unique_ptr<Workspace> m_workspace;
    std::unique_ptr<MainWindow> m_window;
    QTabBar* m_tabs = nullptr;
};

QTEST_MAIN(WindowTest)
#include "tst_window.moc"
