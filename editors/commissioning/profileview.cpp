#include "editors/commissioning/profileview.h"

#include "editors/shell/theme.h"

#include <QPainter>

#include <algorithm>
#include <array>

namespace camwright {

ProfileView::ProfileView(QWidget* parent) : QWidget(parent)
{
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setFixedHeight(28);
    connect(&theme(), &Theme::changed, this, qOverload<>(&QWidget::update));
}

void ProfileView::setEstimate(const MoveEstimate& estimate)
{
    m_estimate = estimate;
    update();
}

void ProfileView::setProgress(double progress)
{
    m_progress = std::min(progress, 1.0);
    update();
}

void ProfileView::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(theme().color(Role::FineLine));
    painter.setBrush(theme().color(Role::Raised));
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);
    if (m_estimate.duration <= 0)
        return;
    const double bottom = height() - 5.5, top = 6.5, left = 6, wide = width() - 12;
    const double ramp = m_estimate.rampTime / m_estimate.duration;
    const std::array<QPointF, 4> corners{QPointF(left, bottom), QPointF(left + ramp * wide, top), QPointF(left + (1 - ramp) * wide, top), QPointF(left + wide, bottom)};
    painter.setPen(QPen(theme().color(Role::Faint), 1.25));
    painter.drawPolyline(corners.data(), static_cast<int>(corners.size()));
    if (m_progress < 0)
        return;
    const double now = left + m_progress * wide;
    const double rising = ramp > 0 ? m_progress / ramp : 1, falling = ramp > 0 ? (1 - m_progress) / ramp : 1;
    const double y = bottom - std::clamp(std::min(rising, falling), 0.0, 1.0) * (bottom - top);
    QPolygonF done;
    for (const QPointF& corner : corners) {
        if (corner.x() < now)
            done << corner;
    }
    done << QPointF(now, y);
    painter.setPen(QPen(theme().color(Role::Accent), 1.75));
    painter.drawPolyline(done);
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme().color(Role::Accent));
    painter.drawEllipse(QPointF(now, y), 2.75, 2.75);
}

} // namespace camwright
