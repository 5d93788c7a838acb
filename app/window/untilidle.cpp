#include "app/window/untilidle.h"

#include "app/window/mainwindow.h"
#include "editors/document/livechecks.h"

#include <QEvent>

namespace camwright {

UntilIdle::UntilIdle(MainWindow& window, const LiveChecks& checks) : m_window(window), m_checks(checks)
{
    m_window.installEventFilter(this);
    connect(&m_look, &QTimer::timeout, this, &UntilIdle::look);
    m_look.start(0); // fires only when every other event has been worked off
}

bool UntilIdle::eventFilter(QObject* watched, QEvent* event)
{
    m_painted = m_painted || event->type() == QEvent::Paint;
    return QObject::eventFilter(watched, event);
}

void UntilIdle::look()
{
    if (!m_painted || m_checks.isRunning())
        return;
    m_look.stop();
    emit idle();
}

} // namespace camwright
