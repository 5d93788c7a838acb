#include "editors/commissioning/panelwatch.h"

#include "editors/shell/editor.h"

#include <QApplication>
#include <QEvent>

namespace camwright {

PanelWatch::PanelWatch(QWidget& panel) : QObject(&panel), m_panel(panel)
{
    connect(qApp, &QApplication::focusChanged, this, [this](QWidget*, QWidget* now) {
        if (m_active)
            focusChanged(now);
    });
    connect(qApp, &QGuiApplication::applicationStateChanged, this, [this](Qt::ApplicationState state) {
        if (m_active && state != Qt::ApplicationActive)
            emit left();
    });
}

PanelWatch::~PanelWatch()
{
    setActive(false);
}

void PanelWatch::setActive(bool active)
{
    if (active == m_active)
        return;
    m_active = active;
    if (active)
        qApp->installEventFilter(this);
    else
        qApp->removeEventFilter(this);
}

void PanelWatch::focusChanged(QWidget* now)
{
    emit focusMoved();
    if (!now || now == &m_panel || m_panel.isAncestorOf(now))
        return; // no focus at all is the window's matter
    bool elsewhere = now->window() != m_panel.window();
    for (const QWidget* widget = now; widget && !elsewhere; widget = widget->parentWidget())
        elsewhere = qobject_cast<const Editor*>(widget) != nullptr;
    if (elsewhere)
        emit left();
}

bool PanelWatch::eventFilter(QObject* watched, QEvent* event)
{
    if (watched == &m_panel && event->type() == QEvent::Hide)
        emit left();
    if (watched == m_panel.window()) {
        switch (event->type()) {
        case QEvent::WindowDeactivate: case QEvent::WindowBlocked: case QEvent::Hide: case QEvent::Close:
            emit left();
            break;
        case QEvent::WindowStateChange:
            if (m_panel.window()->isMinimized())
                emit left();
            break;
        default:
            break;
        }
    }
    return QObject::eventFilter(watched, event);
}

} // namespace camwright
