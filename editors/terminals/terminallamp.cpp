#include "editors/terminals/terminallamp.h"

#include "editors/shell/theme.h"

#include <QPainter>

namespace camwright {

TerminalLamp::TerminalLamp(const QString& address, bool isInput, QWidget* parent)
    : QAbstractButton(parent), m_address(address), m_isInput(isInput)
{
    setObjectName(QStringLiteral("terminal_") + address);
    setFocusPolicy(isInput ? Qt::StrongFocus : Qt::NoFocus);
    setCursor(isInput ? Qt::PointingHandCursor : Qt::ArrowCursor);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    if (isInput)
        connect(this, &QAbstractButton::clicked, this, [this] { emit switched(!m_on); });
    connect(&theme(), &Theme::changed, this, qOverload<>(&QWidget::update));
    refreshDescription();
}

void TerminalLamp::setSymbol(const QString& symbol)
{
    m_symbol = symbol;
    refreshDescription();
    update();
}

void TerminalLamp::setOn(bool on, bool forced)
{
    if (on == m_on && forced == m_forced)
        return;
    m_on = on;
    m_forced = forced;
    refreshDescription();
    update();
}

void TerminalLamp::refreshDescription()
{
    const QString name = m_symbol.isEmpty() ? m_address : QStringLiteral("%1 %2").arg(m_address, m_symbol);
    setAccessibleName(m_on ? tr("%1, on").arg(name) : tr("%1, off").arg(name));
    setToolTip(m_isInput ? tr("Input %1. Click to switch it on or off; it stays until clicked again.").arg(name) : tr("Output %1.").arg(name));
}

void TerminalLamp::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF frame = QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5);
    const QColor on = theme().color(m_forced ? Role::Forced : m_isInput ? Role::Energised : Role::Ok);
    painter.setPen(hasFocus() ? QPen(theme().color(Role::Accent), 1.5) : QPen(theme().color(Role::Line), 1));
    painter.setBrush(theme().color(m_isInput ? Role::Raised : Role::Surface));
    painter.drawRoundedRect(frame, 5, 5);
    const QRectF lamp(8, height() / 2.0 - 9, 18, 18);
    painter.setPen(QPen(m_on ? on : theme().color(Role::Idle), 1.5));
    painter.setBrush(m_on ? QBrush(on) : Qt::NoBrush);
    m_isInput ? painter.drawRoundedRect(lamp, 3, 3) : painter.drawEllipse(lamp);
    painter.setPen(m_on ? theme().color(Role::OnAccent) : theme().color(Role::Dim));
    painter.setFont(theme().monoFont());
    painter.drawText(lamp, Qt::AlignCenter, m_on ? QStringLiteral("1") : QStringLiteral("0"));
    painter.setPen(theme().color(Role::Text));
    const int addressWidth = painter.fontMetrics().horizontalAdvance(m_address);
    painter.drawText(QRectF(34, 0, addressWidth + 2, height()), Qt::AlignVCenter, m_address);
    painter.setFont(theme().smallFont());
    painter.setPen(theme().color(Role::Dim));
    const QRectF rest(42 + addressWidth, 0, width() - 50 - addressWidth, height());
    painter.drawText(rest, Qt::AlignVCenter, painter.fontMetrics().elidedText(m_symbol, Qt::ElideRight, static_cast<int>(rest.width())));
}

} // namespace camwright
