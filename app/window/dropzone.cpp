#include "app/window/dropzone.h"

#include "editors/shell/theme.h"

#include <QPainter>

#include <algorithm>

namespace camwright {

namespace {

constexpr int NarrowestEdge = 40, WidestEdge = 160;

int edgeOf(int length)
{
    return std::min(std::clamp(length / 4, NarrowestEdge, WidestEdge), length / 2);
}

} // namespace

DropZone dropZoneOfPage(const QRect& page, const QPoint& position)
{
    const int across = edgeOf(page.width()), down = edgeOf(page.height());
    const int halfWidth = page.width() / 2, halfHeight = page.height() / 2;
    // The nearest side wins, measured in its own edge: corners belong to the side that is proportionally closer.
    const struct { Side side; double depth; QRect area; } sides[] = {
        {Side::Left, double(position.x() - page.left()) / across, {page.left(), page.top(), halfWidth, page.height()}},
        {Side::Right, double(page.right() - position.x()) / across, {page.right() + 1 - halfWidth, page.top(), halfWidth, page.height()}},
        {Side::Above, double(position.y() - page.top()) / down, {page.left(), page.top(), page.width(), halfHeight}},
        {Side::Below, double(page.bottom() - position.y()) / down, {page.left(), page.bottom() + 1 - halfHeight, page.width(), halfHeight}},
    };
    const auto* nearest = std::min_element(std::begin(sides), std::end(sides), [](const auto& a, const auto& b) { return a.depth < b.depth; });
    if (nearest->depth < 1)
        return {nearest->side, -1, nearest->area};
    return {std::nullopt, -1, page};
}

DropMark::DropMark()
{
    setObjectName(QStringLiteral("dropMark"));
    setAttribute(Qt::WA_TransparentForMouseEvents);
    hide();
}

void DropMark::showOn(QWidget* group, const QRect& area)
{
    if (parentWidget() != group)
        setParent(group);
    setGeometry(area);
    raise();
    show();
}

void DropMark::vanish()
{
    hide();
    setParent(nullptr);
}

void DropMark::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    QColor tint = theme().color(Role::Accent);
    tint.setAlpha(48);
    painter.fillRect(rect(), tint);
    painter.setPen(QPen(theme().color(Role::Accent), 2));
    painter.drawRect(rect().adjusted(1, 1, -1, -1));
}

} // namespace camwright
