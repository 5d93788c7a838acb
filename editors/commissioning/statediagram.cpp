#include "editors/commissioning/statediagram.h"

#include "editors/shell/icons.h"
#include "editors/shell/theme.h"

#include <QPainter>
#include <QPainterPath>

#include <algorithm>

namespace camwright {

namespace {

enum State { PowerOff = 0, ErrorStop = 1, Standstill = 2, Discrete = 3, Continuous = 4, Homing = 5 }; // KS-MC-26

constexpr double Corner = 6, Gap = 5, HeadLength = 6, HeadHalf = 3.6;
constexpr int BoxHeight = 32;

enum class Way { Right, Left, Up, Down };

void paintHead(QPainter& painter, QPointF tip, Way way, double scale = 1)
{
    const double l = HeadLength * scale, h = HeadHalf * scale;
    const QPointF along = way == Way::Right ? QPointF(-l, 0) : way == Way::Left ? QPointF(l, 0) : way == Way::Up ? QPointF(0, l) : QPointF(0, -l);
    const QPointF side = along.x() != 0 ? QPointF(0, h) : QPointF(h, 0);
    painter.save();
    painter.setBrush(painter.pen().color());
    painter.setPen(Qt::NoPen);
    painter.drawPolygon(QPolygonF({tip, tip + along + side, tip + along - side}));
    painter.restore();
}

} // namespace

/// Where everything stands; x stretches with the width, y with the height.
struct StateDiagram::Geometry {
    explicit Geometry(const QSize& size)
    {
        const double w = size.width() - 1, h = size.height() - 1;
        moving = QRectF(0.5, 0.5, w * 0.43, h);
        const double side = w < 340 ? 8 : 12, inner = moving.width() - 2 * side;
        const auto left = [&](double y) { return QRectF(moving.left() + side, h * y - BoxHeight / 2.0, inner, BoxHeight); };
        discrete = left(0.22);
        continuous = left(0.47);
        homing = left(0.78);
        const double rightWidth = w * 0.325, rightX = w - rightWidth - 14;
        const auto right = [&](double y) { return QRectF(rightX, h * y - BoxHeight / 2.0, rightWidth, BoxHeight); };
        standstill = right(0.30);
        powerOff = right(0.60);
        errorStop = right(0.90);
        stopY = h * 0.085;
        bus = (moving.right() + standstill.left()) / 2;
        center = standstill.center().x();
        rail = w - 3;
    }
    QRectF box(int state) const
    {
        switch (state) {
        case PowerOff: return powerOff;
        case ErrorStop: return errorStop;
        case Standstill: return standstill;
        case Discrete: return discrete;
        case Continuous: return continuous;
        default: return homing;
        }
    }
    /// From a moving state's right side to the left side of Standstill.
    QPainterPath busPath(const QRectF& from) const
    {
        const double y0 = std::round(from.center().y()) + 0.5, y1 = std::round(standstill.center().y()) + 0.5;
        QPainterPath path(QPointF(from.right() + Gap + 1, y0));
        const double turn = y0 < y1 ? Corner : -Corner;
        path.lineTo(bus - Corner, y0);
        path.quadTo(bus, y0, bus, y0 + turn);
        path.lineTo(bus, y1 - turn);
        path.quadTo(bus, y1, bus + Corner, y1);
        path.lineTo(standstill.left() - Gap - 1, y1);
        return path;
    }
    QPainterPath stopPath() const
    {
        const double y = std::round(stopY) + 0.5;
        QPainterPath path(QPointF(moving.right(), y));
        path.lineTo(center - Corner, y);
        path.quadTo(center, y, center, y + Corner);
        path.lineTo(center, standstill.top() - Gap - 1);
        return path;
    }
    /// From Errorstop along the right edge to Standstill.
    QPainterPath railPath() const
    {
        const double y0 = std::round(errorStop.center().y()) + 0.5, y1 = std::round(standstill.center().y()) + 0.5;
        QPainterPath path(QPointF(errorStop.right(), y0));
        path.lineTo(rail - Corner, y0);
        path.quadTo(rail, y0, rail, y0 - Corner);
        path.lineTo(rail, y1 + Corner);
        path.quadTo(rail, y1, rail - Corner, y1);
        path.lineTo(standstill.right() + Gap, y1);
        return path;
    }

    QRectF moving, discrete, continuous, homing, standstill, powerOff, errorStop;
    double stopY, bus, center, rail;
};

StateDiagram::StateDiagram(QWidget* parent) : QWidget(parent)
{
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setMaximumHeight(300);
    connect(&theme(), &Theme::changed, this, qOverload<>(&QWidget::update));
}

void StateDiagram::setStates(std::vector<DiagramState> states, bool isKinco)
{
    if (states == m_states && isKinco == m_isKinco)
        return;
    m_states = std::move(states);
    m_isKinco = isKinco;
    update();
}

void StateDiagram::setCurrent(int current, int previous, bool isMoving)
{
    if (current == m_current && previous == m_previous && isMoving == m_isMoving)
        return;
    m_current = current;
    m_previous = previous;
    m_isMoving = isMoving;
    setAccessibleDescription(nameOf(current));
    update();
}

QString StateDiagram::nameOf(int number) const
{
    const auto found = std::ranges::find(m_states, number, &DiagramState::number);
    return found == m_states.end() ? QString() : found->name;
}

void StateDiagram::paintState(QPainter& painter, const QRectF& box, int number) const
{
    const bool lit = number == m_current, was = !lit && number == m_previous;
    const bool bad = lit && m_isKinco && number == ErrorStop;
    const Role ink = bad ? Role::Error : lit ? Role::Accent : Role::Text;
    painter.setBrush(theme().color(bad ? Role::ErrorSoft : lit ? Role::AccentSoft : Role::Surface));
    painter.setPen(lit ? QPen(theme().color(ink), 2) : was ? QPen(theme().color(Role::Accent), 1, Qt::DashLine) : QPen(theme().color(Role::Line), 1));
    painter.drawRoundedRect(lit ? box.adjusted(1, 1, -1, -1) : box.adjusted(0.5, 0.5, -0.5, -0.5), 5, 5);
    QFont font = lit ? theme().boldFont() : theme().smallFont();
    const double room = box.width() - (lit ? 32 : 12);
    const QString name = nameOf(number);
    while (font.pixelSize() > 9 && QFontMetricsF(font).horizontalAdvance(name) > room)
        font.setPixelSize(font.pixelSize() - 1);
    painter.setFont(font);
    painter.setPen(theme().color(ink));
    if (!lit) {
        painter.drawText(box, Qt::AlignCenter, name);
        return;
    }
    const QString glyph = bad ? QStringLiteral("error") : m_isMoving ? QStringLiteral("triangle-right") : number == PowerOff && m_isKinco ? QStringLiteral("ring") : QStringLiteral("square");
    paintIcon(painter, QRectF(box.left() + 9, box.center().y() - 7, 14, 14), glyph, ink);
    painter.drawText(box.adjusted(26, 0, -6, 0), Qt::AlignCenter, name);
}

void StateDiagram::paintArrows(QPainter& painter, const Geometry& at) const
{
    const double y = std::round(at.standstill.center().y()) + 0.5;
    painter.setPen(QPen(theme().color(Role::Faint), 1));
    painter.setBrush(Qt::NoBrush);
    for (const QRectF& box : {at.discrete, at.continuous, at.homing}) {
        painter.drawPath(at.busPath(box));
        paintHead(painter, {box.right() + 1, std::round(box.center().y()) + 0.5}, Way::Left);
    }
    paintHead(painter, {at.standstill.left() - 1, y}, Way::Right);
    painter.drawPath(at.stopPath());
    paintHead(painter, {at.center, at.standstill.top() - 1}, Way::Down);
    painter.drawLine(QPointF(at.center, at.standstill.bottom() + Gap), QPointF(at.center, at.powerOff.top() - Gap));
    paintHead(painter, {at.center, at.powerOff.top() - 1}, Way::Down);
    paintHead(painter, {at.center, at.standstill.bottom() + 1}, Way::Up);
    painter.drawLine(QPointF(at.center, at.errorStop.top()), QPointF(at.center, at.powerOff.bottom() + Gap));
    paintHead(painter, {at.center, at.powerOff.bottom() + 1}, Way::Up);
    painter.drawPath(at.railPath());
    paintHead(painter, {at.standstill.right() + 1, y}, Way::Left);
    const double faultY = std::round(at.errorStop.center().y()) + 0.5;
    painter.setPen(QPen(theme().color(Role::Faint), 1, Qt::DashLine));
    painter.drawLine(QPointF(at.moving.right(), faultY), QPointF(at.errorStop.left() - Gap, faultY));
    paintHead(painter, {at.errorStop.left() - 1, faultY}, Way::Right);

    QFont small = theme().smallFont();
    small.setPixelSize(std::min(small.pixelSize(), 11));
    painter.setFont(small);
    painter.setPen(theme().color(Role::Dim));
    const double between = at.standstill.left() - at.moving.right();
    painter.drawText(QRectF(at.moving.right(), at.stopY - 16, between + 40, 15), Qt::AlignCenter, tr("Stop, done"));
    painter.drawText(QRectF(at.moving.right() - 6, faultY - 16, between + 12, 15), Qt::AlignCenter, tr("any fault"));
    painter.drawText(QRectF(at.center + 8, at.standstill.bottom(), 90, at.powerOff.top() - at.standstill.bottom()), Qt::AlignVCenter | Qt::AlignLeft, tr("power"));
    const QRectF resets(at.standstill.left() - 30, at.powerOff.bottom(), at.rail - at.standstill.left() + 26, at.errorStop.top() - at.powerOff.bottom());
    painter.drawText(QRectF(resets.left(), resets.top(), at.center - 8 - resets.left(), resets.height()), Qt::AlignVCenter | Qt::AlignRight, tr("reset, off"));
    painter.drawText(resets, Qt::AlignVCenter | Qt::AlignRight, tr("reset, on"));
}

/// The transition taken last, thick, with its head at the state it led to.
void StateDiagram::paintTaken(QPainter& painter, const Geometry& at) const
{
    if (m_previous < 0 || m_previous == m_current)
        return;
    const auto moves = [](int state) { return state >= Discrete; };
    const Role ink = m_current == ErrorStop ? Role::Error : Role::Accent;
    painter.setPen(QPen(theme().color(ink), 2));
    painter.setBrush(Qt::NoBrush);
    const double y = std::round(at.standstill.center().y()) + 0.5;
    if (m_previous == Standstill && moves(m_current)) {
        painter.drawPath(at.busPath(at.box(m_current)));
        paintHead(painter, {at.box(m_current).right() + 1, std::round(at.box(m_current).center().y()) + 0.5}, Way::Left, 1.3);
    } else if (moves(m_previous) && m_current == Standstill) {
        painter.drawPath(at.stopPath());
        paintHead(painter, {at.center, at.standstill.top() - 1}, Way::Down, 1.3);
    } else if (m_current == ErrorStop && moves(m_previous)) {
        const double faultY = std::round(at.errorStop.center().y()) + 0.5;
        painter.drawLine(QPointF(at.moving.right(), faultY), QPointF(at.errorStop.left() - Gap, faultY));
        paintHead(painter, {at.errorStop.left() - 1, faultY}, Way::Right, 1.3);
    } else if (m_previous == ErrorStop && m_current == Standstill) {
        painter.drawPath(at.railPath());
        paintHead(painter, {at.standstill.right() + 1, y}, Way::Left, 1.3);
    } else if (m_previous == ErrorStop && m_current == PowerOff) {
        painter.drawLine(QPointF(at.center, at.errorStop.top()), QPointF(at.center, at.powerOff.bottom() + Gap));
        paintHead(painter, {at.center, at.powerOff.bottom() + 1}, Way::Up, 1.3);
    } else if ((m_previous == PowerOff && m_current == Standstill) || (m_previous == Standstill && m_current == PowerOff)) {
        painter.drawLine(QPointF(at.center, at.standstill.bottom() + Gap), QPointF(at.center, at.powerOff.top() - Gap));
        const bool up = m_current == Standstill;
        paintHead(painter, {at.center, up ? at.standstill.bottom() + 1 : at.powerOff.top() - 1}, up ? Way::Up : Way::Down, 1.3);
    }
}

void StateDiagram::paintDiagram(QPainter& painter) const
{
    const Geometry at(size());
    painter.setPen(theme().color(Role::Line));
    painter.setBrush(theme().color(Role::Raised));
    painter.drawRoundedRect(at.moving, 8, 8);
    QFont caption = theme().smallFont();
    caption.setWeight(QFont::DemiBold);
    painter.setFont(caption);
    painter.setPen(theme().color(Role::Dim));
    painter.drawText(at.moving.adjusted(12, 6, -8, 0), Qt::AlignTop | Qt::AlignLeft, tr("Moving"));
    paintArrows(painter, at);
    paintTaken(painter, at);
    for (int state = PowerOff; state <= Homing; ++state)
        paintState(painter, at.box(state), state);
}

void StateDiagram::paintList(QPainter& painter) const
{
    if (m_states.empty())
        return;
    const double pitch = std::min(BoxHeight + 8.0, static_cast<double>(height()) / static_cast<double>(m_states.size()));
    double y = 0;
    for (const DiagramState& state : m_states) {
        paintState(painter, QRectF(0.5, y, std::min(240.0, width() - 1.0), pitch - 6), state.number);
        y += pitch;
    }
}

void StateDiagram::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    m_isKinco ? paintDiagram(painter) : paintList(painter);
}

} // namespace camwright
