#include "editors/commissioning/travelbar.h"

#include "editors/commissioning/numbers.h"
#include "editors/shell/theme.h"

#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

namespace camwright {

namespace {

constexpr int Inset = 16, BarTop = 36, BarHeight = 12;
constexpr double SmallestSpan = 1e-3;

int decimalsFor(double step)
{
    return std::clamp(static_cast<int>(std::ceil(-std::log10(step) - 1e-9)), 0, 4);
}

} // namespace

double roundStep(double span, int count)
{
    const double raw = std::max(span, SmallestSpan) / count;
    const double decade = std::pow(10, std::floor(std::log10(raw)));
    for (const double factor : {1.0, 2.0, 5.0}) {
        if (raw <= factor * decade)
            return factor * decade;
    }
    return 10 * decade;
}

TravelBar::TravelBar(QWidget* parent) : QWidget(parent)
{
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    connect(&theme(), &Theme::changed, this, qOverload<>(&QWidget::update));
}

void TravelBar::setTravel(const Travel& travel)
{
    if (travel == m_travel)
        return;
    m_travel = travel;
    chooseRange();
    update();
}

void TravelBar::chooseRange()
{
    if (m_travel.lower && m_travel.upper && *m_travel.lower < *m_travel.upper) {
        m_range = {std::min(*m_travel.lower, m_travel.position), std::max(*m_travel.upper, m_travel.position)};
        return;
    }
    const double low = std::min({m_travel.position, m_travel.stopsAt, m_travel.target.value_or(m_travel.position)});
    const double high = std::max({m_travel.position, m_travel.stopsAt, m_travel.target.value_or(m_travel.position)});
    const bool fits = low >= m_range.low && high <= m_range.high && high - low > (m_range.high - m_range.low) / 40;
    if (fits)
        return;
    const double step = roundStep(std::max(high - low, 100.0), 2);
    m_range = {std::floor(low / step - 0.25) * step, std::ceil(high / step + 0.25) * step};
}

double TravelBar::x(double value) const
{
    const double inside = (value - m_range.low) / (m_range.high - m_range.low);
    return Inset + std::clamp(inside, 0.0, 1.0) * (width() - 2 * Inset);
}

void TravelBar::paintScale(QPainter& painter) const
{
    const QRectF frame(0.5, BarTop + 0.5, width() - 1, BarHeight - 1);
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme().color(Role::Raised));
    painter.drawRoundedRect(frame, 3, 3);
    painter.setBrush(QBrush(theme().color(Role::Faint), Qt::BDiagPattern));
    if (m_travel.lower)
        painter.drawRect(QRectF(frame.topLeft(), QPointF(x(*m_travel.lower), frame.bottom())));
    if (m_travel.upper)
        painter.drawRect(QRectF(QPointF(x(*m_travel.upper), frame.top()), frame.bottomRight()));
    painter.setPen(theme().color(Role::Line));
    painter.setBrush(Qt::NoBrush);
    painter.drawRoundedRect(frame, 3, 3);

    const double step = roundStep(m_range.high - m_range.low, std::max(2, width() / 64));
    painter.setFont(theme().monoFont());
    const int decimals = decimalsFor(step);
    for (double value = std::ceil(m_range.low / step) * step; value <= m_range.high + step * 1e-6; value += step) {
        const double at = std::floor(x(value)) + 0.5;
        painter.setPen(theme().color(Role::Faint));
        painter.drawLine(QPointF(at, BarTop + BarHeight), QPointF(at, BarTop + BarHeight + 4));
        painter.setPen(theme().color(Role::Dim));
        const double half = 44;
        const double left = std::clamp(at - half, -half + painter.fontMetrics().horizontalAdvance(shownNumber(value, decimals)) / 2.0, width() - half);
        painter.drawText(QRectF(left, BarTop + BarHeight + 5, 2 * half, 15), Qt::AlignCenter, shownNumber(value, decimals));
    }
}

void TravelBar::paintEnds(QPainter& painter) const
{
    QPen pen(theme().color(Role::Warn), 2);
    painter.setFont(theme().monoFont());
    const auto end = [&](const std::optional<double>& limit, Qt::Alignment side) {
        if (!limit)
            return;
        painter.setPen(pen);
        const double at = std::round(x(*limit));
        painter.drawLine(QPointF(at, BarTop - 5), QPointF(at, BarTop + BarHeight + 4));
        painter.setPen(theme().color(Role::Dim));
        painter.drawText(QRectF(0, BarTop + BarHeight + 19, width(), 14), side | Qt::AlignVCenter, shownNumber(*limit, 3));
    };
    end(m_travel.lower, Qt::AlignLeft);
    end(m_travel.upper, Qt::AlignRight);
}

void TravelBar::paintPosition(QPainter& painter) const
{
    const QColor accent = theme().color(Role::Accent);
    const double here = std::round(x(m_travel.position)), there = std::round(x(m_travel.stopsAt));
    QColor tint = accent;
    tint.setAlphaF(0.28f);
    painter.fillRect(QRectF(QPointF(std::min(here, there), BarTop + 1), QPointF(std::max(here, there), BarTop + BarHeight - 1)), tint);
    if (std::abs(here - there) > 2) {
        painter.setPen(QPen(accent, 1, Qt::DashLine));
        painter.drawLine(QPointF(there + 0.5, BarTop - 3), QPointF(there + 0.5, BarTop + BarHeight + 3));
    }
    painter.setPen(Qt::NoPen);
    painter.setBrush(accent);
    painter.drawRect(QRectF(here - 1, BarTop - 2, 2, BarHeight + 4));
    painter.drawPolygon(QPolygonF({{here, BarTop - 1.0}, {here - 5, BarTop - 9.0}, {here + 5, BarTop - 9.0}}));
}

void TravelBar::paintTarget(QPainter& painter) const
{
    if (!m_travel.target)
        return;
    const double at = std::round(x(*m_travel.target)) + 0.5;
    painter.setPen(theme().color(Role::Text));
    painter.drawLine(QPointF(at, BarTop + BarHeight), QPointF(at, 14));
    painter.setBrush(theme().color(Role::Surface));
    painter.drawPolygon(QPolygonF({{at, 5}, {at + 4.5, 9.5}, {at, 14}, {at - 4.5, 9.5}}));
    painter.setFont(theme().smallFont());
    const QString word = tr("target %1").arg(shownNumber(*m_travel.target, 3));
    const double wide = painter.fontMetrics().horizontalAdvance(word);
    const double left = at + 10 + wide <= width() ? at + 10 : std::max(0.0, at - 10 - wide);
    painter.setPen(theme().color(Role::Dim));
    painter.drawText(QRectF(left, 1, wide + 2, 17), Qt::AlignVCenter | Qt::AlignLeft, word);
}

void TravelBar::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    paintScale(painter);
    paintEnds(painter);
    paintTarget(painter);
    paintPosition(painter);
}

} // namespace camwright
