#include "editors/shell/widgets.h"

#include <QLineEdit>
#include <QSignalSpy>
#include <QVBoxLayout>
#include <QtTest>

using namespace camwright;

class ShellWidgetsTest : public QObject {
    Q_OBJECT

private slots:
    void init()
    {
        m_window = std::make_unique<QWidget>();
        auto* column = new QVBoxLayout(m_window.get());
        m_button = new HoldButton("Jog plus");
        m_other = new QLineEdit;
        column->addWidget(m_button);
        column->addWidget(m_other);
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
    }

    void holdEndsOnMouseRelease()
    {
        QSignalSpy held(m_button, &HoldButton::held);
        QSignalSpy let(m_button, &HoldButton::letGone);
        QTest::mousePress(m_button, Qt::LeftButton);
        QCOMPARE(held.size(), 1);
        QVERIFY(m_button->isHeld());
        QTest::mouseRelease(m_button, Qt::LeftButton);
        QCOMPARE(let.size(), 1);
    }

    void holdEndsOnceWhateverEndsIt_data()
    {
        QTest::addColumn<QString>("cause");
        for (const char* cause : {"focus", "hide", "disable", "deactivate", "minimise"})
            QTest::newRow(cause) << cause;
    }

    void holdEndsOnceWhateverEndsIt()
    {
        QFETCH(QString, cause);
        QSignalSpy let(m_button, &HoldButton::letGone);
        QTest::mousePress(m_button, Qt::LeftButton);
        if (cause == "focus") {
            QFocusEvent event(QEvent::FocusOut);
            QCoreApplication::sendEvent(m_button, &event);
        } else if (cause == "hide") {
            m_button->hide();
        } else if (cause == "disable") {
            m_button->setEnabled(false);
        } else if (cause == "deactivate") {
            QEvent event(QEvent::WindowDeactivate);
            QCoreApplication::sendEvent(m_window.get(), &event);
        } else {
            m_window->showMinimized();
        }
        QCOMPARE(let.size(), 1);
        QTest::mouseRelease(m_button, Qt::LeftButton);
        QCOMPARE(let.size(), 1);
    }

    void repeatedKeyDoesNotStartAgain()
    {
        QSignalSpy held(m_button, &HoldButton::held);
        QSignalSpy let(m_button, &HoldButton::letGone);
        m_button->setFocus();
        QKeyEvent press(QEvent::KeyPress, Qt::Key_Space, Qt::NoModifier);
        QKeyEvent repeat(QEvent::KeyPress, Qt::Key_Space, Qt::NoModifier, {}, true);
        QKeyEvent repeatedRelease(QEvent::KeyRelease, Qt::Key_Space, Qt::NoModifier, {}, true);
        QKeyEvent release(QEvent::KeyRelease, Qt::Key_Space, Qt::NoModifier);
        for (QKeyEvent* event : {&press, &repeatedRelease, &repeat, &release})
            QCoreApplication::sendEvent(m_button, event);
        QCOMPARE(held.size(), 1);
        QCOMPARE(let.size(), 1);
    }

    void segmentAnnouncesOnlyTheUsersChoice()
    {
        SegmentedControl control("Speed");
        control.addSegment("Slow");
        control.addSegment("Fast");
        QSignalSpy chosen(&control, &SegmentedControl::chosen);
        control.setCurrentIndex(1);
        QCOMPARE(chosen.size(), 0);
        control.findChildren<QAbstractButton*>().at(0)->click();
        QCOMPARE(chosen.size(), 1);
        QCOMPARE(control.currentIndex(), 0);
    }

private:
    std::unique_ptr<QWidget> m_window;
    HoldButton* m_button = nullptr;
    QLineEdit* m_other = nullptr;
};

QTEST_MAIN(ShellWidgetsTest)
#include "tst_shellwidgets.moc"
