#include "app/window/familycard.h"

#include "app/window/drawing.h"
#include "editors/shell/icons.h"

#include <QPainter>
#include <QPainterPath>

namespace camwright {

FamilyCard::FamilyCard(const QString& drawing, const QString& name, const QString& sentence, const QString& buses, const QString& busIcon, QWidget* parent)
    : QAbstractButton(parent), m_drawing(drawing), m_sentence(sentence), m_buses(buses), m_busIcon(busIcon)
{
    setText(name);
    setAccessibleName(tr("New project for %1").arg(name));
    setAccessibleDescription(sentence);
    setToolTip(tr("New project for %1").arg(name));
    setFixedSize(sizeHint());
    setCursor(Qt::PointingHandCursor);
    setFocusPolicy(Qt::StrongFocus);
    connect(&theme(), &Theme::changed, this, qOverload<>(&QWidget::update));
}

void FamilyCard::setMissing(const QString& reason)
{
    m_buses = reason;
    setEnabled(false);
    setToolTip(reason);
    setCursor(Qt::ArrowCursor);
    setAccessibleDescription(reason);
}

void FamilyCard::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF body = QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5);
    QPainterPath outline;
    outline.addRoundedRect(body, 6, 6);
    painter.fillPath(outline, theme().color(Role::Surface));
    painter.save();
    painter.setClipPath(outline);
    painter.fillRect(QRectF(0, 0, width(), 80), theme().color(Role::Raised));
    painter.fillRect(QRectF(0, 80, width(), 1), theme().color(Role::FineLine));
    painter.setOpacity(isEnabled() ? 1 : 0.45);
    paintDrawing(painter, QRectF(1, 0, 212, 80), m_drawing);
    painter.restore();
    const bool hot = isEnabled() && (underMouse() || hasFocus());
    painter.setPen(QPen(theme().color(hot ? Role::Accent : Role::Line), hasFocus() ? 2 : 1));
    painter.drawPath(outline);
    painter.setFont(theme().boldFont());
    painter.setPen(theme().color(isEnabled() ? Role::Text : Role::Dim));
    painter.drawText(QRectF(12, 90, width() - 24, 18), Qt::AlignVCenter | Qt::AlignLeft, text());
    painter.setFont(theme().smallFont());
    painter.setPen(theme().color(Role::Dim));
    painter.drawText(QRectF(12, 109, width() - 24, 36), int(Qt::AlignLeft | Qt::AlignTop) | Qt::TextWordWrap, m_sentence);
    if (isEnabled())
        paintIcon(painter, QRectF(12, height() - 27, 14, 14), m_busIcon, Role::Accent);
    painter.setPen(theme().color(isEnabled() ? Role::Text : Role::Dim));
    painter.drawText(QRectF(isEnabled() ? 32 : 12, height() - 30, width() - 40, 20), Qt::AlignVCenter | Qt::AlignLeft, m_buses);
}

void FamilyCard::enterEvent(QEnterEvent*) { update(); }
void FamilyCard::leaveEvent(QEvent*) { update(); }

} // namespace camwright
