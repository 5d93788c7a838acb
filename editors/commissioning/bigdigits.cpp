#include "editors/commissioning/bigdigits.h"

#include "editors/shell/theme.h"

#include <QPainter>

namespace camwright {

namespace {

constexpr int UnitGap = 8, SmallestDigits = 16;

} // namespace

BigDigits::BigDigits(QWidget* parent) : QWidget(parent)
{
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    connect(&theme(), &Theme::changed, this, qOverload<>(&QWidget::update));
}

void BigDigits::setValue(const QString& digits, const QString& unit)
{
    if (digits == m_digits && unit == m_unit)
        return;
    m_digits = digits;
    m_unit = unit;
    setAccessibleDescription(QStringLiteral("%1 %2").arg(digits, unit));
    update();
}

void BigDigits::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    QFont unitFont = theme().font();
    unitFont.setPixelSize(16);
    const qreal unitWidth = QFontMetricsF(unitFont).horizontalAdvance(m_unit);
    QFont digits = theme().digitsFont();
    const qreal room = width() - UnitGap - unitWidth;
    while (digits.pixelSize() > SmallestDigits && QFontMetricsF(digits).horizontalAdvance(m_digits) > room)
        digits.setPixelSize(digits.pixelSize() - 1);
    const QFontMetricsF metrics(digits);
    const qreal base = (height() + metrics.capHeight()) / 2;
    painter.setFont(digits);
    painter.setPen(theme().color(Role::Text));
    painter.drawText(QPointF(0, base), m_digits);
    painter.setFont(unitFont);
    painter.setPen(theme().color(Role::Dim));
    painter.drawText(QPointF(metrics.horizontalAdvance(m_digits) + UnitGap, base), m_unit);
}

} // namespace camwright
