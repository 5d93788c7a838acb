#include "editors/shell/widgets.h"

#include <QEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>

namespace camwright {

HoldButton::HoldButton(const QString& accessibleName, QWidget* parent) : QAbstractButton(parent)
{
    setAccessibleName(accessibleName);
    setFocusPolicy(Qt::StrongFocus);
}

void HoldButton::setCaption(const QString& big, const QString& small, const QString& key)
{
    m_big = big;
    m_small = small;
    m_key = key;
    setToolTip(key.isEmpty() ? accessibleName() : tr("%1 while held (%2 while armed)").arg(accessibleName(), key));
    update();
}

void HoldButton::hold()
{
    if (m_held || !isEnabled() || !isVisible())
        return;
    m_held = true;
    setDown(true);
    // The window may be deactivated or minimised while the button is down.
    window()->installEventFilter(this);
    emit held();
}

void HoldButton::letGo()
{
    if (!m_held)
        return;
    m_held = false;
    setDown(false);
    window()->removeEventFilter(this);
    emit letGone();
}

void HoldButton::mousePressEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton)
        return;
    setFocus(Qt::MouseFocusReason);
    hold();
}

void HoldButton::mouseReleaseEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton)
        letGo();
}

void HoldButton::keyPressEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_Space || event->key() == Qt::Key_Return) {
        if (!event->isAutoRepeat())
            hold();
        return;
    }
    QAbstractButton::keyPressEvent(event);
}

void HoldButton::keyReleaseEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_Space || event->key() == Qt::Key_Return) {
        if (!event->isAutoRepeat())
            letGo();
        return;
    }
    QAbstractButton::keyReleaseEvent(event);
}

void HoldButton::focusOutEvent(QFocusEvent* event)
{
    letGo();
    QAbstractButton::focusOutEvent(event);
}

void HoldButton::hideEvent(QHideEvent* event)
{
    letGo();
    QAbstractButton::hideEvent(event);
}

void HoldButton::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::EnabledChange && !isEnabled())
        letGo();
    QAbstractButton::changeEvent(event);
}

bool HoldButton::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::WindowDeactivate || event->type() == QEvent::Hide || event->type() == QEvent::WindowBlocked
        || event->type() == QEvent::Close)
        letGo();
    else if (event->type() == QEvent::WindowStateChange && window()->isMinimized())
        letGo();
    return QAbstractButton::eventFilter(watched, event);
}

void HoldButton::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF body = QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5);
    const bool on = isEnabled();
    painter.setPen(QPen(theme().color(m_held || hasFocus() ? Role::Accent : Role::Line), m_held ? 2 : 1));
    painter.setBrush(theme().color(m_held ? Role::Accent : on ? Role::Raised : Role::Surface));
    painter.drawRoundedRect(body, 5, 5);
    const Role ink = m_held ? Role::OnAccent : on ? Role::Text : Role::Faint;
    const Role quiet = m_held ? Role::OnAccent : on ? Role::Dim : Role::Faint;
    QFont big = theme().monoFont();
    big.setPixelSize(16);
    big.setWeight(QFont::Bold);
    painter.setFont(big);
    painter.setPen(theme().color(ink));
    painter.drawText(QRectF(0, 6, width(), 20), Qt::AlignCenter, m_big);
    painter.setFont(theme().monoFont());
    painter.setPen(theme().color(quiet));
    painter.drawText(QRectF(0, height() - 24, width(), 18), Qt::AlignCenter, m_small);
    if (m_key.isEmpty())
        return;
    QFont small = theme().smallFont();
    small.setPixelSize(10);
    painter.setFont(small);
    const qreal w = QFontMetricsF(small).horizontalAdvance(m_key) + 8;
    painter.setPen(QPen(theme().color(m_held ? Role::OnAccent : Role::Line), 1));
    painter.setBrush(Qt::NoBrush);
    painter.drawRoundedRect(QRectF(6.5, 6.5, w, 15), 3, 3);
    painter.setPen(theme().color(quiet));
    painter.drawText(QRectF(6.5, 6.5, w, 15), Qt::AlignCenter, m_key);
}

} // namespace camwright
