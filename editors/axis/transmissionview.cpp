#include "editors/axis/transmissionview.h"

#include "editors/shell/theme.h"

#include <QPainter>
#include <QPainterPath>

#include <cmath>

namespace camwright {

namespace {

constexpr double FloorY = 150, ShaftY = 100;
constexpr double MotorX = 40, MotorWidth = 110, CouplingX = 170, ScrewX = 215, ScrewEnd = 560;
constexpr int FormulaHeight = 34;

QString number(double value)
{
    return QString::number(value, 'g', 8);
}

void paintFloor(QPainter& painter, double from, double to)
{
    painter.drawLine(QPointF(from, FloorY), QPointF(to, FloorY));
    QPen fine = painter.pen();
    fine.setColor(theme().color(Role::Line));
    painter.save();
    painter.setPen(fine);
    for (double x = from; x < to; x += 10)
        painter.drawLine(QPointF(x, FloorY + 8), QPointF(x + 8, FloorY));
    painter.restore();
}

/// A dimension line with arrow heads and its text above.
void paintDimension(QPainter& painter, double from, double to, double y, const QString& text)
{
    painter.drawLine(QPointF(from, y), QPointF(to, y));
    for (const auto& [x, direction] : {std::pair{from, 1.0}, std::pair{to, -1.0}}) {
        painter.drawLine(QPointF(x, y), QPointF(x + direction * 6, y - 4));
        painter.drawLine(QPointF(x, y), QPointF(x + direction * 6, y + 4));
        painter.drawLine(QPointF(x, y - 8), QPointF(x, y + 8));
    }
    painter.drawText(QRectF(from - 100, y - 28, to - from + 200, 18), Qt::AlignCenter, text);
}

} // namespace

TransmissionView::TransmissionView(QWidget* parent)
    : QWidget(parent)
{
    setObjectName(QStringLiteral("transmissionView"));
    setAccessibleName(tr("Drawing of motor and load"));
    connect(&theme(), &Theme::changed, this, qOverload<>(&QWidget::update));
}

void TransmissionView::setAxis(const Axis& axis)
{
    m_axis = axis;
    setAccessibleDescription(formula());
    update();
}

bool TransmissionView::isRotary() const
{
    return m_axis.type.valueOr(AxisType::Linear) == AxisType::Rotary;
}

QString TransmissionView::unit() const
{
    return isRotary() ? tr("°") : tr("mm");
}

QString TransmissionView::formula() const
{
    if (!m_axis.encoderResolution.isValid() || !m_axis.mechanicalEquivalent.isValid() || m_axis.mechanicalEquivalent.value() <= 0)
        return {};
    const double pulses = static_cast<double>(m_axis.encoderResolution.value()), travel = m_axis.mechanicalEquivalent.value();
    return tr("%1 pulses ÷ %2 %4 = %3 pulses/%4").arg(number(pulses), number(travel), number(pulses / travel), unit());
}

void TransmissionView::paintMotor(QPainter& painter) const
{
    const QColor body = theme().color(Role::Surface), solid = theme().color(Role::FineLine);
    painter.setBrush(solid);
    painter.drawRect(QRectF(MotorX + 30, ShaftY + 26, 50, FloorY - ShaftY - 26));
    painter.setBrush(body);
    painter.drawRoundedRect(QRectF(MotorX - 14, ShaftY - 14, 22, 28), 2, 2);
    painter.drawRoundedRect(QRectF(MotorX, ShaftY - 30, MotorWidth, 60), 3, 3);
    for (int line = 0; line < 5; ++line)
        painter.drawLine(QPointF(MotorX + 16, ShaftY - 18 + line * 9), QPointF(MotorX + MotorWidth - 16, ShaftY - 18 + line * 9));
    painter.setBrush(solid);
    painter.drawRect(QRectF(MotorX + MotorWidth, ShaftY - 34, 8, 68));
    painter.drawRect(QRectF(MotorX + MotorWidth + 8, ShaftY - 4, ScrewX - MotorX - MotorWidth - 8, 8));
    painter.setBrush(body);
    painter.drawRoundedRect(QRectF(CouplingX, ShaftY - 12, 16, 24), 2, 2);
    painter.drawRoundedRect(QRectF(CouplingX + 18, ShaftY - 12, 16, 24), 2, 2);
    painter.setPen(theme().color(Role::Text));
    const QString pulses = m_axis.encoderResolution.isValid() ? tr("%1 pulses per turn").arg(m_axis.encoderResolution.value()) : tr("pulses per turn ?");
    painter.drawText(QRectF(MotorX - 30, ShaftY - 66, MotorWidth + 80, 18), Qt::AlignLeft, pulses);
}

void TransmissionView::paintScrew(QPainter& painter) const
{
    const double slide = 360, turn = 110;
    painter.setBrush(theme().color(Role::FineLine));
    painter.drawRect(QRectF(ScrewX, ShaftY - 22, 14, FloorY - ShaftY + 22));
    painter.drawRect(QRectF(ScrewEnd - 14, ShaftY - 22, 14, FloorY - ShaftY + 22));
    painter.setBrush(theme().color(Role::Surface));
    const QRectF screw(ScrewX + 14, ShaftY - 6, ScrewEnd - ScrewX - 28, 12);
    painter.drawRect(screw);
    for (double x = screw.left() + 6; x < screw.right() - 4; x += 13)
        painter.drawLine(QPointF(x, ShaftY + 6), QPointF(x + 5, ShaftY - 6));
    painter.save();
    QPen ghost(theme().color(Role::Accent), 1, Qt::DashLine);
    painter.setPen(ghost);
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(QRectF(slide + turn - 42, ShaftY - 30, 84, 18));
    painter.restore();
    painter.setBrush(theme().color(Role::AccentSoft));
    painter.drawRect(QRectF(slide - 42, ShaftY - 30, 84, 18));
    painter.drawRect(QRectF(slide - 26, ShaftY - 12, 52, 26));
    painter.setPen(QPen(theme().color(Role::Accent), 1.2));
    const QString travel = m_axis.mechanicalEquivalent.isValid() ? tr("%1 mm per motor turn").arg(number(m_axis.mechanicalEquivalent.value())) : tr("mm per motor turn ?");
    paintDimension(painter, slide, slide + turn, ShaftY - 46, travel);
}

void TransmissionView::paintTable(QPainter& painter) const
{
    const QPointF center(400, ShaftY - 8);
    painter.setBrush(theme().color(Role::FineLine));
    painter.drawRect(QRectF(ScrewX, ShaftY - 22, 40, FloorY - ShaftY + 22));
    painter.drawRect(QRectF(ScrewX + 40, ShaftY - 4, 100, 8));
    painter.drawRect(QRectF(center.x() - 60, ShaftY + 8, 120, FloorY - ShaftY - 8));
    painter.setBrush(theme().color(Role::Surface));
    painter.drawEllipse(center, 100, 34);
    const double degrees = m_axis.mechanicalEquivalent.isValid() ? m_axis.mechanicalEquivalent.value() : 0;
    QPainterPath wedge(center);
    wedge.arcTo(QRectF(center.x() - 100, center.y() - 34, 200, 68), 90, -std::fmod(degrees, 360.0));
    wedge.closeSubpath();
    painter.setBrush(theme().color(Role::AccentSoft));
    painter.drawPath(wedge);
    painter.setBrush(theme().color(Role::Surface));
    painter.drawEllipse(center, 10, 4);
    painter.setPen(theme().color(Role::Accent));
    const QString travel = m_axis.mechanicalEquivalent.isValid() ? tr("%1° per motor turn").arg(number(degrees)) : tr("° per motor turn ?");
    painter.drawText(QRectF(center.x() - 150, center.y() - 62, 300, 18), Qt::AlignCenter, travel);
}

void TransmissionView::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(theme().color(Role::Raised));
    painter.setPen(theme().color(Role::Line));
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 6, 6);
    painter.drawLine(0, height() - FormulaHeight, width(), height() - FormulaHeight);
    painter.save();
    painter.translate(std::max(0.0, (width() - 620) / 2.0), 8);
    painter.setPen(QPen(theme().color(Role::Idle), 1.2));
    paintFloor(painter, 30, 590);
    isRotary() ? paintTable(painter) : paintScrew(painter);
    painter.setPen(QPen(theme().color(Role::Idle), 1.2));
    paintMotor(painter);
    painter.restore();
    painter.setPen(theme().color(Role::Text));
    painter.setFont(theme().monoFont());
    painter.drawText(QRectF(16, height() - FormulaHeight, width() - 32, FormulaHeight), Qt::AlignVCenter | Qt::AlignLeft, formula());
}

} // namespace camwright
