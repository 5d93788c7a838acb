#include "editors/commissioning/commissioningeditor.h"
#include "editors/commissioning/panelcontrol.h"
#include "editors/commissioning/register.h"
#include "editors/shell/actions.h"
#include "editors/shell/context.h"
#include "editors/shell/quantityfield.h"
#include "editors/shell/registry.h"
#include "editors/shell/widgets.h"
#include "fakelink.h"

#include <QDialog>
#include <QLineEdit>
#include <QMainWindow>
#include <QPushButton>
#include <QShortcut>
#include <QSlider>
#include <QTabWidget>
#include <QThreadPool>
#include <QtTest>

using namespace camwright;
using Said = std::vector<std::string>;

namespace {

const ObjectKey Feed{ObjectKind::Axis, "Feed"};

Project feeder()
{
    ControllerSettings controller;
    controller.family = "kinco";
    controller.model = "KS101M-04DX";
    Axis axis;
    axis.mechanicalEquivalent = 100.0;
    axis.simulation.lowerLimitSwitch = -50.0;
    axis.simulation.upperLimitSwitch = 1050.0;
    return Project().withContent(controllerKey(), controller).withContent(Feed, axis);
}

} // namespace

/// The panel with real keys and clicks, in a window with another tab and another dock.
class CommissioningEditorTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        theme().applyToApplication();
    }

    void init()
    {
        m_link = std::make_unique<FakeLink>();
        m_document = std::make_unique<ProjectDocument>();
        m_document->adopt(feeder());
        m_context = std::make_unique<Context>(*m_document, m_actions, m_registry, m_pool);
        m_context->setLink(m_link.get());
        m_window = std::make_unique<QMainWindow>();
        auto* page = new QWidget;
        auto* column = new QVBoxLayout(page);
        m_tabs = new QTabWidget;
        m_editor = new CommissioningEditor(*m_context, Feed);
        m_tabs->addTab(m_editor, m_editor->title());
        m_tabs->addTab(new QLineEdit, "Other");
        m_dock = new QLineEdit;
        column->addWidget(m_tabs, 1);
        column->addWidget(m_dock);
        m_window->setCentralWidget(page);
        m_window->resize(1204, 560);
        m_window->show();
        m_window->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
        m_link->push();
    }
    void cleanup()
    {
        m_dialog.reset();
        m_window.reset();
        m_context.reset();
        m_document.reset();
    }

    void isRegisteredForAxesOnline()
    {
        Registry registry;
        registerCommissioning(registry, m_actions);
        const EditorFactory* view = registry.view("axis.commissioning");
        QVERIFY(view);
        QVERIFY(view->wantsLink);
        QCOMPARE(view->kind, ObjectKind::Axis);
        QVERIFY(!view->name.isEmpty());
    }

    void offlineSaysWhatToDo()
    {
        m_context->setLink(nullptr);
        QVERIFY(!part<QWidget>("stopAllAxes")->isVisible());
    }

    void axisThatDoesNotRunIsTold()
    {
        m_link->axis().name = "Other";
        m_link->push();
        QVERIFY(!part<QWidget>("stopAllAxes")->isVisible());
        m_link->axis().name = "Feed";
        m_link->push();
        QVERIFY(part<QWidget>("stopAllAxes")->isVisible());
    }

    void linkWithoutMotionShowsItsReasonInsteadOfControls()
    {
        m_link->m_can.motion = false;
        m_link->m_can.whyNoMotion = "Modbus has no dead-man.";
        m_link->push();
        QVERIFY(!part<QWidget>("arm")->isVisible());
        QVERIFY(part<QWidget>("actualPosition")->isVisible());
        const auto labels = part<QWidget>("whyNoMotion")->findChildren<QLabel*>();
        QVERIFY(std::ranges::any_of(labels, [](const QLabel* label) { return label->text().contains("Modbus has no dead-man."); }));
    }

    void saysThatItIsNoSafetyFunction()
    {
        QVERIFY(part<QLabel>("safetyNote")->text().contains("not a safety function"));
        QVERIFY(part<QLabel>("safetyNote")->isVisible());
    }

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

    // --- STOP, speeds, moves
    void stopActsWhenItGoesDown()
    {
        QVERIFY(part<QWidget>("stopAllAxes")->isEnabled());
        QTest::mousePress(part<QWidget>("stopAllAxes"), Qt::LeftButton);
        QCOMPARE(m_link->take(), Said({"stopAll"}));
        QTest::mouseRelease(part<QWidget>("stopAllAxes"), Qt::LeftButton);
        QCOMPARE(m_link->take(), Said());
    }

    void stopIsTheLargestControl()
    {
        const QSize stop = part<QWidget>("stopAllAxes")->size();
        QCOMPARE(stop.height(), 56);
        for (const QAbstractButton* other : m_editor->findChildren<QAbstractButton*>()) {
            if (other->isVisible() && other->objectName() != "stopAllAxes")
                QVERIFY(other->width() * other->height() < stop.width() * stop.height());
        }
    }

    void onlyTheSliderRaisesTheCap()
    {
        arm();
        type("maximumSpeed", "4000");
        QTest::keyPress(m_editor, Qt::Key_F4);
        QTest::keyRelease(m_editor, Qt::Key_F4);
        QCOMPARE(m_link->take(), Said({"jog Feed 50", "stop Feed"}));
        part<QSlider>("speedCap")->setValue(50);
        QTest::keyPress(m_editor, Qt::Key_F4);
        QTest::keyRelease(m_editor, Qt::Key_F4);
        QCOMPARE(m_link->take(), Said({"jog Feed 2000", "stop Feed"}));
        type("maximumSpeed", "100");
        QTest::keyPress(m_editor, Qt::Key_F4);
        QCOMPARE(m_link->take(), Said({"jog Feed 100"}));
    }

    void changingTheCapStopsAHeldJog()
    {
        arm();
        QTest::keyPress(m_editor, Qt::Key_F4);
        part<QSlider>("speedCap")->setValue(20);
        QCOMPARE(m_link->take(), Said({"jog Feed 50", "stop Feed"}));
    }

    void stepIsARelativeMove()
    {
        arm();
        part<QWidget>("jogMode")->findChildren<QAbstractButton*>().at(1)->click();
        type("stepSize", "2.5");
        QTest::mouseClick(part<HoldButton>("jogMinus"), Qt::LeftButton);
        QCOMPARE(m_link->take(), Said({"moveBy Feed -2.5 5"}));
    }

    void moveGoesToTheTargetBelowTheCap()
    {
        arm();
        type("moveTarget", "120");
        type("moveVelocity", "300");
        QTest::mouseClick(part<QPushButton>("move"), Qt::LeftButton);
        QCOMPARE(m_link->take(), Said({"moveTo Feed 120 50"}));
        QVERIFY(!part<QPushButton>("move")->isEnabled());
    }

    void illegalTargetMovesNothing()
    {
        arm();
        type("moveTarget", "12 apples");
        QVERIFY(!part<QPushButton>("move")->isEnabled());
    }

    void relativeMoveGoesByTheDistance()
    {
        arm();
        part<QWidget>("moveKind")->findChildren<QAbstractButton*>().at(1)->click();
        type("moveTarget", "-7");
        QTest::mouseClick(part<QPushButton>("move"), Qt::LeftButton);
        QCOMPARE(m_link->take(), Said({"moveBy Feed -7 50"}));
    }

    void ordersOfTheHead()
    {
        QVERIFY(!part<QPushButton>("enable")->isEnabled());
        arm();
        QTest::mouseClick(part<QPushButton>("enable"), Qt::LeftButton);
        QCOMPARE(m_link->take(), Said({"disable Feed"}));
        m_link->axis().enabled = false;
        m_link->push();
        QTest::mouseClick(part<QPushButton>("enable"), Qt::LeftButton);
        m_link->axis().error = 0x8611;
        m_link->push();
        QTest::mouseClick(part<QPushButton>("reset"), Qt::LeftButton);
        m_link->axis().error = 0;
        m_link->axis().enabled = true;
        m_link->push();
        QTest::mouseClick(part<QPushButton>("home"), Qt::LeftButton);
        QCOMPARE(m_link->take(), Said({"enable Feed", "reset Feed", "home Feed"}));
    }

    void whoHoldsControlIsShown()
    {
        m_link->status_.control = ControlHolder::Somebody;
        m_link->status_.controlOwner = "Anna";
        m_link->push();
        QVERIFY(part<QLabel>("armExplanation")->text().contains("Anna"));
        m_link->autoAnswer = false;
        QTest::mouseClick(part<QWidget>("arm"), Qt::LeftButton);
        m_link->answer(diagnostic(Code::ControlHeld, {"Anna"}));
        QVERIFY(part<QLabel>("panelMessage")->isVisible());
        QVERIFY(part<QLabel>("panelMessage")->text().contains("Anna"));
        QVERIFY(!part<QAbstractButton>("arm")->isChecked());
    }

    void everyControlHasItsNames()
    {
        arm();
        for (QWidget* widget : m_editor->findChildren<QWidget*>()) {
            if (!widget->isVisible() || widget->focusPolicy() == Qt::NoFocus || widget->focusProxy())
                continue;
            QVERIFY2(!widget->accessibleName().isEmpty(), qPrintable(widget->metaObject()->className() + widget->objectName()));
            QVERIFY2(!widget->toolTip().isEmpty(), qPrintable(widget->accessibleName()));
        }
    }

    void nothingIsCutAtSmallWidths()
    {
        for (const int width : {1440, 1204, 1100, 940}) {
            m_window->resize(width, 560);
            QVERIFY2(m_window->width() <= width, qPrintable(QString::number(m_window->width())));
        }
    }

    void pictures();

private:
    template <class W>
    W* part(const char* name)
    {
        W* found = m_editor->findChild<W*>(QLatin1String(name));
        if (!found)
            qFatal("no widget %s", name);
        return found;
    }

    void arm()
    {
        QTest::mouseClick(part<QWidget>("arm"), Qt::LeftButton);
        QCOMPARE(m_link->take(), Said({"arm Feed"}));
        QVERIFY(m_context->isArmed());
    }

    void type(const char* field, const QString& text)
    {
        QLineEdit* edit = part<QuantityField>(field)->lineEdit();
        edit->setFocus();
        edit->selectAll();
        QTest::keyClicks(edit, text);
        if (text.contains(' ')) // typed while armed a blank stops; here it is only about the field
            edit->setText(text), emit edit->textEdited(text);
        QTest::keyClick(edit, Qt::Key_Return);
        m_link->take();
    }

    void leaveBy(const QString& cause)
    {
        if (cause == "focus")
            part<QuantityField>("moveTarget")->lineEdit()->setFocus();
        else if (cause == "dock")
            m_dock->setFocus();
        else if (cause == "tab")
            m_tabs->setCurrentIndex(1);
        else if (cause == "hide")
            m_window->hide();
        else if (cause == "minimise")
            m_window->showMinimized();
        else if (cause == "deactivate")
            deactivate();
        else if (cause == "dialog")
            openDialog(true);
        else if (cause == "window")
            openDialog(false);
        else if (cause == "close")
            m_window->close();
        else if (cause == "disarm")
            m_editor->control().disarm();
        else if (cause == "disabled" || cause == "error") {
            (cause == "error" ? m_link->axis().error = 0x8611 : m_link->axis().enabled = false);
            m_link->push();
        } else if (cause == "lease") {
            m_link->axis().panelArmed = false;
            m_link->push();
        } else if (cause == "offline")
            m_context->setLink(nullptr);
        else
            delete m_tabs->widget(0);
    }
    void deactivate()
    {
        QEvent event(QEvent::WindowDeactivate);
        QCoreApplication::sendEvent(m_window.get(), &event);
    }
    void openDialog(bool modal)
    {
        m_dialog = std::make_unique<QDialog>(modal ? m_window.get() : nullptr);
        m_dialog->setModal(modal);
        m_dialog->show();
        m_dialog->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(m_dialog.get()));
    }

    ActionCatalogue m_actions;
    Registry m_registry;
    QThreadPool m_pool;
    std::unique_ptr<FakeLink> m_link;
    std::unique_ptr<ProjectDocument> m_document;
    std::unique_ptr<Context> m_context;
    std::unique_ptr<QMainWindow> m_window;
    std::unique_ptr<QDialog> m_dialog;
    QTabWidget* m_tabs = nullptr;
    CommissioningEditor* m_editor = nullptr;
    QLineEdit* m_dock = nullptr;
};

/// For people to look at: in motion and armed, light and dark, wide and narrow; disarmed with an error.
void CommissioningEditorTest::pictures()
{
    const QString folder = QCoreApplication::applicationDirPath() + "/../screenshots";
    QVERIFY(QDir().mkpath(folder));
    AxisStatus& axis = m_link->axis();
    const auto save = [&](const QString& name) {
        QTest::qWait(1);
        QVERIFY(m_editor->grab().save(folder + "/commissioning-" + name + ".png"));
    };
    m_window->resize(1204 + 24, 560);
    arm();
    type("moveTarget", "120");
    m_link->status_.time = 1000ms;
    axis.lastChange = 200ms;
    axis.lastCause = "enabled by a panel";
    m_link->push();
    QTest::mouseClick(part<QPushButton>("move"), Qt::LeftButton);
    m_link->status_.time = 2500ms;
    axis.state = 3;
    axis.moving = true;
    axis.lastChange = 1010ms;
    axis.lastCause = "motion of a panel";
    axis.position = 76.563;
    axis.setPosition = 81.563;
    axis.velocity = 49.7;
    axis.followingError = 5;
    axis.torque = 9;
    m_link->push();
    for (const Theme::Kind kind : {Theme::Kind::Light, Theme::Kind::Dark}) {
        theme().setKind(kind);
        save(kind == Theme::Kind::Dark ? "dark" : "light");
    }
    theme().setKind(Theme::Kind::Light);
    m_window->resize(1100, 560);
    save("1100");
    m_window->resize(940, 560);
    save("940");
    m_window->resize(1228, 560);
    axis.state = 1;
    axis.moving = false;
    axis.error = 0x8611;
    axis.lastChange = 2400ms;
    axis.lastCause = "alarm of the drive";
    axis.panelArmed = false;
    axis.homed = false;
    axis.enabled = false;
    m_link->push();
    save("error");
    m_context->setLink(nullptr);
    save("offline");
}

QTEST_MAIN(CommissioningEditorTest)
#include "tst_commissioningeditor.moc"
