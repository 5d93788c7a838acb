#pragma once

#include "editors/commissioning/commissioningeditor.h"
#include "editors/commissioning/panelcontrol.h"
#include "editors/shell/actions.h"
#include "editors/shell/context.h"
#include "editors/shell/quantityfield.h"
#include "editors/shell/registry.h"
#include "editors/shell/widgets.h"
#include "fakelink.h"

#include <QDialog>
#include <QLineEdit>
#include <QMainWindow>
#include <QTabWidget>
#include <QThreadPool>
#include <QtTest>

namespace camwright {

using Said = std::vector<std::string>;

inline const ObjectKey Feed{ObjectKind::Axis, "Feed"};

/// A Kinco project with one axis of 100 mm a turn between limit switches.
inline Project feeder()
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

/// The panel in a window with another tab and another dock, on a link that writes down what it is asked.
class PanelBench : public QObject {
protected:
    void open()
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
    void shut()
    {
        m_dialog.reset();
        m_window.reset();
        m_context.reset();
        m_document.reset();
    }

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

} // namespace camwright
