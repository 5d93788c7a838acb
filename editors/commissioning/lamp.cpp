#include "editors/commissioning/lamp.h"

#include <QPainter>

namespace camwright {

namespace {

constexpr int Side = 14, Glyph = 9, Gap = 7;

QFont wordFont(bool on)
{
    QFont font = theme().smallFont();
    if (on)
        font.setWeight(QFont::DemiBold);
    return font;
}

} // namespace

Lamp::Lamp(const QString& name, const char* objectName, QWidget* parent) : QWidget(parent), m_name(name)
{
    setObjectName(QLatin1String(objectName));
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    setState(false, {}, Role::Ok);
    connect(&theme(), &Theme::changed, this, qOverload<>(&QWidget::update));
}

void Lamp::setState(bool on, const QString& word, Role onRole)
{
    if (on == m_on && word == m_word && onRole == m_onRole)
        return;
    m_on = on;
    m_word = word;
    m_onRole = onRole;
    setAccessibleName(QStringLiteral("%1: %2").arg(m_name, word));
    setToolTip(accessibleName());
    updateGeometry();
    update();
}

QSize Lamp::sizeHint() const
{
    const int name = QFontMetrics(theme().smallFont()).horizontalAdvance(m_name), word = QFontMetrics(wordFont(true)).horizontalAdvance(m_word);
    return {2 * Side + Glyph + Gap + name + Gap + word, 28};
}

void Lamp::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF dot(Side, (height() - Glyph) / 2.0, Glyph, Glyph);
    const QColor color = theme().color(m_on ? m_onRole : Role::Dim);
    painter.setPen(QPen(color, 1.5));
    painter.setBrush(m_on ? QBrush(color) : Qt::NoBrush);
    painter.drawEllipse(dot.adjusted(0.75, 0.75, -0.75, -0.75));
    painter.setFont(theme().smallFont());
    painter.setPen(theme().color(Role::Dim));
    const int left = Side + Glyph + Gap, name = painter.fontMetrics().horizontalAdvance(m_name);
    painter.drawText(QRect(left, 0, name + 2, height()), Qt::AlignVCenter | Qt::AlignLeft, m_name);
    painter.setFont(wordFont(m_on));
    painter.setPen(theme().color(m_on ? m_onRole : Role::Text));
    painter.drawText(QRect(left + name + Gap, 0, width() - left - name - Gap, height()), Qt::AlignVCenter | Qt::AlignLeft, m_word);
    painter.setPen(theme().color(Role::FineLine));
    painter.drawLine(width() - 1, 2, width() - 1, height() - 3);
}

} // namespace camwright
