#include "editors/commissioning/panelkeys.h"

#include <QCoreApplication>
#include <QKeyEvent>

namespace camwright {

namespace {

bool isStopKey(int key)
{
    return key == Qt::Key_Escape || key == Qt::Key_Space;
}

bool isJogKey(int key)
{
    return key >= Qt::Key_F1 && key <= Qt::Key_F4;
}

} // namespace

PanelKeys::PanelKeys(QObject* parent) : QObject(parent) {}

PanelKeys::~PanelKeys()
{
    if (m_installed)
        QCoreApplication::instance()->removeEventFilter(this);
}

void PanelKeys::setMode(Mode mode)
{
    m_mode = mode;
    refreshFilter();
}

void PanelKeys::refreshFilter()
{
    const bool wanted = m_mode != Mode::Off || !m_down.isEmpty();
    if (wanted == m_installed)
        return;
    m_installed = wanted;
    if (wanted)
        QCoreApplication::instance()->installEventFilter(this);
    else
        QCoreApplication::instance()->removeEventFilter(this);
}

bool PanelKeys::takes(const QKeyEvent& event) const
{
    if (m_mode != Mode::Off && isStopKey(event.key()))
        return true; // with any modifier: whoever hits them wants a stop
    const bool plain = (event.modifiers() & ~(Qt::KeypadModifier | Qt::ShiftModifier)) == Qt::NoModifier;
    return m_mode == Mode::StopAndJog && isJogKey(event.key()) && plain;
}

bool PanelKeys::pressed(const QKeyEvent& event)
{
    const int key = event.key();
    if (event.isAutoRepeat())
        return m_down.contains(key) || takes(event); // a held key says nothing new
    if (!takes(event)) {
        m_down.remove(key); // its release went to another program
        refreshFilter();
        return false;
    }
    m_down.insert(key);
    if (isStopKey(key))
        emit stopPressed();
    else
        emit jogPressed(key - Qt::Key_F1);
    return true;
}

bool PanelKeys::released(const QKeyEvent& event)
{
    const int key = event.key();
    if (!m_down.contains(key))
        return false;
    if (event.isAutoRepeat())
        return true;
    m_down.remove(key);
    if (isJogKey(key))
        emit jogReleased(key - Qt::Key_F1);
    refreshFilter();
    return true;
}

bool PanelKeys::eventFilter(QObject* watched, QEvent* event)
{
    switch (event->type()) {
    case QEvent::ShortcutOverride: {
        const auto& key = static_cast<const QKeyEvent&>(*event);
        if (!takes(key) && !m_down.contains(key.key()))
            break;
        event->accept(); // no shortcut of the window may have it; the key press follows
        return true;
    }
    case QEvent::KeyPress:
        if (pressed(static_cast<const QKeyEvent&>(*event)))
            return true;
        break;
    case QEvent::KeyRelease:
        if (released(static_cast<const QKeyEvent&>(*event)))
            return true;
        break;
    default:
        break;
    }
    return QObject::eventFilter(watched, event);
}

} // namespace camwright
