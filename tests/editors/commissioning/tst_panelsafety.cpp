#include "panelbench.h"

#include <QShortcut>
#include <QSlider>

using namespace camwright;

/// What holds and ends a motion, with real keys and clicks (CONTRACTS 19, 23).
class PanelSafetyTest : public PanelBench {
    Q_OBJECT

private slots:
    void initTestCase() { theme().applyToApplication(); }
    void init() { open(); }
    void cleanup() { shut(); }

    // --- jog by mouse
    void heldButtonJogsAndReleaseStops()
    {
        arm();
        QTest::mousePress(part<HoldButton>("jogPlus"), Qt::LeftButton);
        QCOMPARE(m_link->take(), Said({"jog Feed 5"})); // 10 turn/s of 100 mm, 5 %, slow
        QTest::mouseRelease(part<HoldButton>("jogPlus"), Qt::LeftButton);
        QCOMPARE(m_link->take(), Said({"stop Feed"}));
    }

    void everyWayOutOfAHeldButtonStops_data()
    {
        QTest::addColumn<QString>("cause");
        for (const char* cause : {"focus", "dock", "tab", "hide", "minimise", "deactivate", "dialog", "window", "close", "disarm", "disabled", "error", "lease", "offline", "delete"})
            QTest::newRow(cause) << cause;
    }

    void everyWayOutOfAHeldButtonStops()
    {
        QFETCH(QString, cause);
        arm();
        m_link->push();
        QTest::mousePress(part<HoldButton>("jogFastMinus"), Qt::LeftButton);
        QCOMPARE(m_link->take(), Said({"jog Feed -50"}));
        leaveBy(cause);
        const Said said = m_link->take();
        QVERIFY(!said.empty());
        QCOMPARE(said.front(), std::string("stop Feed"));
        QCOMPARE(std::ranges::count(said, "stop Feed"), 1);
        for (const std::string& line : said)
            QVERIFY2(line == "stop Feed" || line == "disarm Feed", line.c_str());
    }

    void everyWayAwayFromThePanelDisarms_data()
    {
        QTest::addColumn<QString>("cause");
        for (const char* cause : {"tab", "hide", "minimise", "deactivate", "dialog", "window", "close", "offline", "delete"})
            QTest::newRow(cause) << cause;
    }

    void everyWayAwayFromThePanelDisarms()
    {
        QFETCH(QString, cause);
        arm();
        leaveBy(cause);
        QVERIFY(!m_context->isArmed());
        QCOMPARE(m_link->take(), Said({"disarm Feed"}));
    }

    void lostLinkDisarmsAndTheReleaseSendsNothing()
    {
        arm();
        QTest::mousePress(part<HoldButton>("jogPlus"), Qt::LeftButton);
        m_link->take();
        m_link->setState(LinkState::Lost);
        QVERIFY(!m_context->isArmed());
        QTest::mouseRelease(part<HoldButton>("jogPlus"), Qt::LeftButton);
        m_link->setState(LinkState::Online);
        m_link->push();
        QCOMPARE(m_link->take(), Said());
        QVERIFY(!part<HoldButton>("jogPlus")->isEnabled());
    }

    // --- keys
    void jogKeysActWhileHeld()
    {
        arm();
        m_dock->setFocus();
        QTest::keyPress(m_dock, Qt::Key_F4);
        QCOMPARE(m_link->take(), Said({"jog Feed 50"}));
        QVERIFY(part<HoldButton>("jogFastPlus")->isHeld());
        QTest::keyRelease(m_dock, Qt::Key_F4);
        QCOMPARE(m_link->take(), Said({"stop Feed"}));
    }

    void repeatedKeysAreOneKey()
    {
        arm();
        QKeyEvent press(QEvent::KeyPress, Qt::Key_F3, Qt::NoModifier);
        QKeyEvent repeat(QEvent::KeyPress, Qt::Key_F3, Qt::NoModifier, {}, true);
        QKeyEvent repeatedRelease(QEvent::KeyRelease, Qt::Key_F3, Qt::NoModifier, {}, true);
        QKeyEvent release(QEvent::KeyRelease, Qt::Key_F3, Qt::NoModifier);
        for (QKeyEvent* event : {&press, &repeatedRelease, &repeat, &repeatedRelease, &repeat})
            QCoreApplication::sendEvent(m_dock, event);
        QCOMPARE(m_link->take(), Said({"jog Feed 5"}));
        QCoreApplication::sendEvent(m_dock, &release);
        QCOMPARE(m_link->take(), Said({"stop Feed"}));
    }

    void keysOfTwoDirectionsMoveNothing()
    {
        arm();
        QTest::keyPress(m_dock, Qt::Key_F3);
        QTest::keyPress(m_dock, Qt::Key_F2);
        QCOMPARE(m_link->take(), Said({"jog Feed 5", "stop Feed"}));
        QTest::keyRelease(m_dock, Qt::Key_F2);
        QTest::keyRelease(m_dock, Qt::Key_F3);
        QCOMPARE(m_link->take(), Said());
    }

    void keyHoldEndsWhenTheFocusMoves()
    {
        arm();
        QTest::keyPress(m_editor, Qt::Key_F3);
        m_dock->setFocus();
        QCOMPARE(m_link->take(), Said({"jog Feed 5", "stop Feed"}));
        QVERIFY(m_context->isArmed());
        QTest::keyRelease(m_dock, Qt::Key_F3);
        QCOMPARE(m_link->take(), Said());
    }

    void unarmedKeysBelongToOthers()
    {
        m_dock->setFocus();
        QTest::keyClick(m_dock, Qt::Key_F3);
        QTest::keyClicks(m_dock, "a b");
        QTest::keyClick(m_dock, Qt::Key_Escape);
        QCOMPARE(m_dock->text(), QString("a b"));
        QCOMPARE(m_link->take(), Said());
    }

    void armedEscAndSpaceStopAllAxesWhereverTheFocusIs_data()
    {
        QTest::addColumn<int>("key");
        QTest::addColumn<QString>("focus");
        for (const int key : {int(Qt::Key_Escape), int(Qt::Key_Space)}) {
            for (const char* focus : {"dock", "field", "switch", "jog", "stop"})
                QTest::addRow("%s in %s", key == Qt::Key_Space ? "Space" : "Esc", focus) << key << QString(focus);
        }
    }

    void armedEscAndSpaceStopAllAxesWhereverTheFocusIs()
    {
        QFETCH(int, key);
        QFETCH(QString, focus);
        arm();
        QWidget* target = focus == "dock" ? m_dock : focus == "field" ? part<QuantityField>("moveTarget")->lineEdit() : part<QWidget>(focus == "switch" ? "arm" : focus == "jog" ? "jogPlus" : "stopAllAxes");
        target->setFocus();
        QTest::keyClick(target, Qt::Key(key));
        QCOMPARE(m_link->take(), Said({"stopAll"}));
        QVERIFY(m_dock->text().isEmpty());
        QVERIFY(m_context->isArmed());
    }

    void stopKeyEndsAHeldJogForGood()
    {
        arm();
        QTest::mousePress(part<HoldButton>("jogPlus"), Qt::LeftButton);
        QTest::keyClick(m_dock, Qt::Key_Space);
        QCOMPARE(m_link->take(), Said({"jog Feed 5", "stop Feed", "stopAll"}));
        QTest::mouseRelease(part<HoldButton>("jogPlus"), Qt::LeftButton);
        QCOMPARE(m_link->take(), Said());
    }

    void stopKeysActUntilTheAxisRests()
    {
        arm();
        QTest::keyPress(m_editor, Qt::Key_F4);
        m_link->axis().moving = true;
        m_link->push();
        QTest::mouseClick(part<QWidget>("arm"), Qt::LeftButton); // disarms, the axis is still braking
        m_link->push();
        m_link->push();
        m_link->take();
        QTest::keyClick(m_dock, Qt::Key_Space);
        QCOMPARE(m_link->take(), Said({"stopAll"}));
        m_link->axis().moving = false;
        m_link->push();
        m_link->push();
        QTest::keyClick(m_dock, Qt::Key_Space);
        QCOMPARE(m_link->take(), Said());
        QCOMPARE(m_dock->text(), QString(" "));
    }

    void shortcutsOfTheWindowDoNotTakeTheKeys()
    {
        QShortcut four(QKeySequence(Qt::Key_F4), m_window.get());
        QShortcut escape(QKeySequence(Qt::Key_Escape), m_window.get());
        QSignalSpy taken(&four, &QShortcut::activated);
        QSignalSpy escaped(&escape, &QShortcut::activated);
        arm();
        m_dock->setFocus();
        QTest::keyClick(m_dock, Qt::Key_F4);
        QTest::keyClick(m_dock, Qt::Key_Escape);
        QCOMPARE(taken.size(), 0);
        QCOMPARE(escaped.size(), 0);
        QCOMPARE(m_link->take(), Said({"jog Feed 50", "stop Feed", "stopAll"}));
    }

    void altF4ClosesTheWindow()
    {
        arm();
        QTest::keyClick(m_dock, Qt::Key_F4, Qt::AltModifier);
        QCOMPARE(m_link->take(), Said());
    }
};

QTEST_MAIN(PanelSafetyTest)
#include "tst_panelsafety.moc"
