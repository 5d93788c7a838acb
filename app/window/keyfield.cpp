#include "app/window/keyfield.h"

#include <QKeyEvent>
#include <QLineEdit>

namespace camwright {

KeyField::KeyField(QWidget* parent) : QKeySequenceEdit(parent) {}

void KeyField::setKey(const QKeySequence& key)
{
    m_key = key;
    setKeySequence(key);
    if (auto* line = findChild<QLineEdit*>())
        line->setPlaceholderText(accessibleName()); // Qt's own words are longer than the field
}

void KeyField::keyPressEvent(QKeyEvent* event)
{
    const int key = event->key();
    if (key == Qt::Key_Escape && event->modifiers() == Qt::NoModifier) {
        setKeySequence(m_key);
        clearFocus();
        return;
    }
    const bool modifierOnly = key == Qt::Key_Control || key == Qt::Key_Shift || key == Qt::Key_Alt || key == Qt::Key_Meta || key == Qt::Key_AltGr;
    if (modifierOnly || key == Qt::Key_unknown)
        return;
    const QKeySequence chosen(QKeyCombination(event->modifiers() & ~Qt::KeypadModifier, key == Qt::Key_Backtab ? Qt::Key_Tab : Qt::Key(key)));
    setKeySequence(chosen);
    emit pressed(chosen);
}

void KeyField::keyReleaseEvent(QKeyEvent* event)
{
    event->accept(); // one stroke is all: no waiting for a second
}

void KeyField::focusOutEvent(QFocusEvent* event)
{
    setKeySequence(m_key); // a stroke that was refused or not confirmed
    QKeySequenceEdit::focusOutEvent(event);
}

} // namespace camwright
