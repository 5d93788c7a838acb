// Key maps: which keys each map gives, what the user changes, conflicts told, kept for the next start. By real keys.
#include "app/window/composition.h"
#include "app/window/keybook.h"
#include "app/window/keyfield.h"
#include "app/window/settingsdialog.h"
#include "plainwindow.h"

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSettings>
#include <QStandardPaths>
#include <QTableView>
#include <QTemporaryDir>
#include <QtTest>

using namespace camwright;

class KeysTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QStandardPaths::setTestModeEnabled(true);
        QCoreApplication::setOrganizationName("camwright-test");
        QCoreApplication::setApplicationName("keys");
    }

    void init()
    {
        QSettings().clear();
        m_dir = std::make_unique<QTemporaryDir>();
        start();
        QVERIFY(m_workspace->document.create(twoAxes(), m_dir->filePath("two")).ok());
        m_window = std::make_unique<MainWindow>(*m_workspace);
        m_window->show();
        m_dialog = std::make_unique<SettingsDialog>(m_workspace->settings, m_workspace->keys, m_workspace->actions, m_window.get());
        m_dialog->findChild<QTabWidget*>("settingsPages")->setCurrentIndex(1);
        m_dialog->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_dialog.get()));
    }

    void cleanup()
    {
        m_dialog.reset();
        m_window.reset();
        m_workspace.reset();
    }

    // --- the maps

    void mapsNameActionsThatExist_data() { addMaps(); }
    void mapsNameActionsThatExist()
    {
        QFETCH(QString, map);
        for (const QString& action : actionsOfMap(map)) {
            QVERIFY2(m_workspace->actions.action(action), qPrintable(action));
            const auto keys = keysOfMap(map, action);
            QVERIFY2(keys && !keys->isEmpty(), qPrintable(action));
            for (const QKeySequence& key : *keys)
                QVERIFY2(isUsableKey(key), qPrintable(action + " " + key.toString()));
        }
    }

    void noTwoActionsShareAKeyInAnyMap_data() { addMaps(); }
    void noTwoActionsShareAKeyInAnyMap()
    {
        QFETCH(QString, map);
        m_workspace->keys.setMap(map);
        QMap<QString, QString> seen;
        for (const ActionRow& row : m_workspace->actions.rows()) {
            for (const QKeySequence& key : m_workspace->actions.keys(row.id)) {
                QVERIFY2(!seen.contains(key.toString()), qPrintable(seen.value(key.toString()) + " and " + row.id));
                seen.insert(key.toString(), row.id);
            }
        }
    }

    void everyMapKeepsAKeyForWhatStopsAndRuns_data() { addMaps(); }
    void everyMapKeepsAKeyForWhatStopsAndRuns()
    {
        QFETCH(QString, map);
        m_workspace->keys.setMap(map);
        for (const char* action : {"online.run", "online.stop", "online.stopAxes", "online.connect", "online.disconnect", "online.download", "project.build", "edit.undo", "file.save"})
            QVERIFY2(!m_workspace->actions.keys(action).isEmpty(), action);
    }

    void defaultKeysAreThoseOfTheCatalogue()
    {
        for (const ActionRow& row : m_workspace->actions.rows())
            QCOMPARE(m_workspace->actions.keys(row.id), ActionCatalogue::defaultKeys(row));
    }

    void knownKeysOfOtherTools()
    {
        m_workspace->keys.setMap("codesys");
        QCOMPARE(m_workspace->keys.holder(QKeySequence("Shift+F8")), QString("online.stop"));
        QCOMPARE(m_workspace->keys.holder(QKeySequence("F11")), QString("project.build"));
        m_workspace->keys.setMap("twincat");
        QCOMPARE(m_workspace->keys.holder(QKeySequence("F11")), QString("online.connect"));
        QCOMPARE(m_workspace->keys.holder(QKeySequence("Ctrl+Shift+B")), QString("project.build"));
        m_workspace->keys.setMap("gx");
        QCOMPARE(m_workspace->keys.holder(QKeySequence("F4")), QString("project.build"));
        for (const char* key : {"F5", "F6", "F7", "F8", "F9", "F10"})
            QVERIFY2(m_workspace->keys.holder(QKeySequence(key)).isEmpty(), key);
    }

    void chosenMapIsInForceAtOnceAndAfterTheNextStart()
    {
        auto* maps = m_dialog->findChild<QComboBox*>("keyMap");
        maps->setFocus();
        QTest::keyClick(maps, Qt::Key_Down);
        QTest::keyClick(maps, Qt::Key_Down);
        QCOMPARE(m_workspace->keys.map(), QString("twincat"));
        QCOMPARE(m_workspace->actions.action("online.connect")->shortcut(), QKeySequence("F11"));
        m_dialog.reset();
        m_window.reset();
        start();
        QCOMPARE(m_workspace->keys.map(), QString("twincat"));
        QCOMPARE(m_workspace->actions.action("online.connect")->shortcut(), QKeySequence("F11"));
    }

    // --- the user's own

    void pressedKeyBecomesTheActionsKey()
    {
        choose("project.check");
        QTest::keyClick(field("firstKey"), Qt::Key_F2, Qt::ControlModifier | Qt::ShiftModifier);
        QCOMPARE(m_workspace->actions.action("project.check")->shortcuts(), QList<QKeySequence>{QKeySequence("Ctrl+Shift+F2")});
        QVERIFY(m_workspace->actions.action("project.check")->toolTip().contains("Ctrl+Shift+F2"));
        QSignalSpy triggered(m_workspace->actions.action("project.check"), &QAction::triggered);
        m_dialog->close();
        press(Qt::Key_F2, Qt::ControlModifier | Qt::ShiftModifier);
        QCOMPARE(triggered.size(), 1);
        press(Qt::Key_C, Qt::ControlModifier | Qt::ShiftModifier);
        QCOMPARE(triggered.size(), 1);
    }

    void secondKeyKeepsTheFirst()
    {
        choose("file.save");
        QTest::keyClick(field("secondKey"), Qt::Key_F9);
        QCOMPARE(m_workspace->actions.keys("file.save"), (QList<QKeySequence>{QKeySequence("Ctrl+S"), QKeySequence("F9")}));
    }

    void conflictIsToldAndNothingChangesBeforeTheUserSaysSo()
    {
        choose("project.check");
        QTest::keyClick(field("firstKey"), Qt::Key_S, Qt::ControlModifier);
        auto* take = m_dialog->findChild<QPushButton*>("takeKey");
        QVERIFY(take->isVisible());
        QVERIFY(bannerText().contains("Ctrl+S"));
        QVERIFY(bannerText().contains("\"Save\""));
        QCOMPARE(m_workspace->keys.holder(QKeySequence("Ctrl+S")), QString("file.save"));
        QTest::keyClick(take, Qt::Key_Space);
        QCOMPARE(m_workspace->keys.holder(QKeySequence("Ctrl+S")), QString("project.check"));
        QVERIFY(m_workspace->actions.keys("file.save").isEmpty());
        QVERIFY(!take->isVisible());
    }

    void takenKeyOfAChangedActionIsTakenToo()
    {
        m_workspace->keys.change("file.save", {QKeySequence("F9"), QKeySequence("Ctrl+S")});
        m_workspace->keys.change("project.check", {QKeySequence("F9")});
        QCOMPARE(m_workspace->actions.keys("file.save"), QList<QKeySequence>{QKeySequence("Ctrl+S")});
    }

    void bareLetterIsRefusedWithTheReason()
    {
        choose("project.check");
        QTest::keyClick(field("firstKey"), Qt::Key_B);
        QVERIFY(bannerText().contains("typing"));
        QVERIFY(!m_dialog->findChild<QPushButton*>("takeKey")->isVisible());
        QCOMPARE(m_workspace->actions.keys("project.check"), QList<QKeySequence>{QKeySequence("Ctrl+Shift+C")});
    }

    void escapeLeavesTheFieldAsItWas()
    {
        choose("project.check");
        field("firstKey")->setFocus();
        QTest::keyClick(field("firstKey"), Qt::Key_Escape);
        QVERIFY(m_dialog->isVisible());
        QCOMPARE(m_workspace->actions.keys("project.check"), QList<QKeySequence>{QKeySequence("Ctrl+Shift+C")});
    }

    void removedKeyDoesNothingAndResetBringsItBack()
    {
        choose("file.save");
        QTest::keyClick(m_dialog->findChild<QPushButton*>("removeKeys"), Qt::Key_Space);
        QVERIFY(m_workspace->actions.keys("file.save").isEmpty());
        QVERIFY(m_workspace->keys.isChanged("file.save"));
        QTest::keyClick(m_dialog->findChild<QPushButton*>("resetKeys"), Qt::Key_Space);
        QCOMPARE(m_workspace->actions.keys("file.save"), QList<QKeySequence>{QKeySequence("Ctrl+S")});
        QVERIFY(!m_workspace->keys.isChanged("file.save"));
    }

    void resetAllForgetsEveryChangeOfTheMap()
    {
        m_workspace->keys.change("file.save", {QKeySequence("F9")});
        m_workspace->keys.change("project.check", {});
        QTest::keyClick(m_dialog->findChild<QPushButton*>("resetAllKeys"), Qt::Key_Space);
        defaultKeysAreThoseOfTheCatalogue();
    }

    void changesAreKeptForTheNextStartAndPerMap()
    {
        m_workspace->keys.change("file.save", {QKeySequence("F9"), QKeySequence("Ctrl+Alt+S")});
        m_workspace->keys.setMap("gx");
        QCOMPARE(m_workspace->actions.keys("file.save"), QList<QKeySequence>{QKeySequence("Ctrl+S")});
        m_workspace->keys.setMap("iec");
        m_dialog.reset();
        m_window.reset();
        start();
        QCOMPARE(m_workspace->actions.keys("file.save"), (QList<QKeySequence>{QKeySequence("F9"), QKeySequence("Ctrl+Alt+S")}));
    }

    void tableFindsByNameAndByKey()
    {
        auto* filter = m_dialog->findChild<QLineEdit*>("keyFilter");
        auto* table = m_dialog->findChild<QTableView*>("keyTable");
        QTest::keyClicks(filter, "ctrl+shift+c");
        QCOMPARE(table->model()->rowCount(), 1);
        filter->clear();
        QTest::keyClicks(filter, "redo");
        QCOMPARE(table->model()->rowCount(), 1);
        QVERIFY(table->model()->index(0, 1).data().toString().contains("Ctrl+Y"));
    }

    void armedPanelWithholdsItsKeysInEveryMap()
    {
        m_workspace->keys.setMap("gx");
        m_workspace->connection.connectTo("local");
        QObject panel;
        m_workspace->context.arm(&panel);
        QVERIFY(m_workspace->actions.action("project.build")->shortcuts().isEmpty()); // F4
        m_workspace->keys.setMap("iec"); // changed meanwhile: still withheld
        QVERIFY(m_workspace->actions.action("go.nextProblem")->shortcuts().isEmpty());
        m_workspace->context.disarm(&panel);
        QCOMPARE(m_workspace->actions.action("go.nextProblem")->shortcut(), QKeySequence("F4"));
        QCOMPARE(m_workspace->actions.action("project.build")->shortcut(), QKeySequence("Ctrl+Shift+F8"));
    }

    void damagedSettingsGiveTheDefaults()
    {
        QSettings().setValue("keys/map", "moon");
        QSettings().setValue("keys/changed-iec/file.save", "Ctrl+ Nonsense++ F9");
        QSettings().setValue("keys/changed-iec/no.such.action", "F10");
        m_dialog.reset();
        m_window.reset();
        start();
        QCOMPARE(m_workspace->keys.map(), QString("iec"));
        QCOMPARE(m_workspace->actions.keys("file.save"), QList<QKeySequence>{QKeySequence("F9")});
    }

private:
    void start()
    {
        m_workspace.reset();
        m_workspace = std::make_unique<Workspace>(fakeServices(), registerEverything);
    }

    static void addMaps()
    {
        QTest::addColumn<QString>("map");
        for (const KeyMap& map : keyMaps())
            QTest::newRow(map.id) << map.id;
    }

    void choose(const QString& action)
    {
        auto* table = m_dialog->findChild<QTableView*>("keyTable");
        const auto hits = table->model()->match(table->model()->index(0, 0), Qt::UserRole, action, 1, Qt::MatchExactly);
        QCOMPARE(hits.size(), 1);
        table->setCurrentIndex(hits.first());
    }

    KeyField* field(const char* name) const { return m_dialog->findChild<KeyField*>(name); }

    QString bannerText() const
    {
        QStringList out;
        for (const QLabel* label : m_dialog->findChildren<QLabel*>()) {
            if (label->isVisible())
                out << label->text();
        }
        return out.join('\n');
    }

    void press(Qt::Key key, Qt::KeyboardModifiers modifiers)
    {
        QApplication::setActiveWindow(m_window.get());
        QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
        QTest::keyClick(m_window.get(), key, modifiers);
    }

    std::unique_ptr<QTemporaryDir> m_dir;
    std::unique_ptr<Workspace> m_workspace;
    std::unique_ptr<MainWindow> m_window;
    std::unique_ptr<SettingsDialog> m_dialog;
};

QTEST_MAIN(KeysTest)
#include "tst_keys.moc"
