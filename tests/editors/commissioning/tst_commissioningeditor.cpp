#include "editors/commissioning/register.h"
#include "editors/words/words.h"
#include "panelbench.h"
#include "tests/editors/fits.h"

#include <QPushButton>
#include <QSlider>
#include <QTranslator>

using namespace camwright;

/// What the panel shows, and the commands of its controls.
class CommissioningEditorTest : public PanelBench {
    Q_OBJECT

private slots:
    void initTestCase() { theme().applyToApplication(); }
    void init() { open(); }
    void cleanup() { shut(); }

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

    void longWordsFit();
    void textsFitInEveryLanguageWhileTheAxisMoves_data();
    void textsFitInEveryLanguageWhileTheAxisMoves();
    void pictures();
};

namespace {

/// Every text half as long again, as Russian can be.
class LongWords : public QTranslator {
public:
    QString translate(const char*, const char* text, const char*, int) const override
    {
        const QString english = QString::fromUtf8(text);
        return english.size() < 3 ? english : english + QString(std::max<qsizetype>(1, english.size() * 2 / 5), QChar(0x0436));
    }
    bool isEmpty() const override { return false; }
};

} // namespace

void CommissioningEditorTest::longWordsFit()
{
    shut();
    LongWords words;
    QVERIFY(qApp->installTranslator(&words));
    open();
    arm();
    m_link->axis().moving = true; // the travel bar tells its stopping distance
    m_link->axis().velocity = -4950;
    m_link->push();
    QVERIFY(!part<QLabel>("stopsWithin")->text().isEmpty());
    for (const int width : {1440, 1204, 1100}) {
        m_window->resize(width, 600);
        QTest::qWait(1);
        QVERIFY2(m_window->width() == width, qPrintable(QString::number(m_window->width())));
        m_editor->grab().save(QCoreApplication::applicationDirPath() + QStringLiteral("/../screenshots/commissioning-long-%1.png").arg(width));
        const QStringList cut = cutTexts(*m_editor);
        QVERIFY2(cut.isEmpty(), qPrintable(QString::number(width) + ": " + cut.join(", ")));
    }
    qApp->removeTranslator(&words);
}

void CommissioningEditorTest::textsFitInEveryLanguageWhileTheAxisMoves_data()
{
    QTest::addColumn<QString>("language");
    for (const QString& language : words::languages())
        QTest::newRow(qPrintable(language)) << language;
}

void CommissioningEditorTest::textsFitInEveryLanguageWhileTheAxisMoves()
{
    QFETCH(QString, language);
    shut();
    QVERIFY(words::setLanguage(*qApp, language));
    open();
    arm();
    AxisStatus& axis = m_link->axis();
    for (const int width : {1440, 1204, 1100, 940}) {
        axis.moving = false; // the columns are laid out while it stands
        m_link->push();
        m_window->resize(width, 600);
        QTest::qWait(1);
        axis.moving = true;
        axis.velocity = -199.9;
        axis.position = axis.setPosition = 876.543;
        m_link->push();
        QTest::qWait(1);
        QVERIFY(savePicture(*m_editor, QStringLiteral("commissioning-%1-%2").arg(language).arg(width)));
        QVERIFY(!part<QLabel>("stopsWithin")->text().isEmpty());
        const QStringList cut = cutTexts(*m_editor);
        QVERIFY2(cut.isEmpty(), qPrintable(QString::number(width) + ": " + cut.join(", ")));
    }
    QVERIFY(words::setLanguage(*qApp, QStringLiteral("en")));
}

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
