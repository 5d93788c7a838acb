#include "editors/trace/statelane.h"

#include "editors/shell/theme.h"

#include <algorithm>
#include <cmath>

namespace camwright {

namespace {

constexpr double Padding = 4;
constexpr int ShortestText = 3; // letters before the dots; less says nothing

} // namespace

std::vector<StateBand> bandsOf(const std::vector<TraceColumn>& columns, double start, double step)
{
    std::vector<StateBand> out;
    bool torn = true; // nothing to join to
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const TraceColumn& column = columns[i];
        const double from = start + step * static_cast<double>(i), to = from + step;
        torn = torn || column.gap;
        if (column.empty)
            continue;
        const std::optional<double> value = column.minimum == column.maximum ? std::optional(column.first) : std::nullopt;
        if (torn) {
            out.push_back({from, to, value});
        } else if (out.back().value == value) {
            out.back().to = to;
        } else {
            StateBand& last = out.back();
            last.to = from;
            const bool oneColumn = !last.value && last.to - last.from < step * 1.5;
            if (oneColumn && value) { // only the change itself lies in it: it belongs to what follows
                last.value = value;
                last.to = to;
            } else {
                out.push_back({from, to, value});
            }
        }
        torn = false;
    }
    return out;
}

QString bandText(const QString& name, const QFontMetrics& metrics, double width)
{
    const double room = width - 2 * Padding;
    if (metrics.horizontalAdvance(name) <= room)
        return name;
    const QString shortest = name.left(ShortestText) + QChar(0x2026);
    return metrics.horizontalAdvance(shortest) <= room ? metrics.elidedText(name, Qt::ElideRight, static_cast<int>(room)) : QString();
}

StateLane::StateLane(QCPAxis* time, QCPAxis* value) : QCPAbstractPlottable(time, value)
{
    setAntialiased(false);
}

double StateLane::selectTest(const QPointF&, bool, QVariant*) const
{
    return -1; // the lane is not picked by the mouse
}

QCPRange StateLane::getKeyRange(bool& found, QCP::SignDomain) const
{
    found = !m_bands.empty();
    return found ? QCPRange(m_bands.front().from, m_bands.back().to) : QCPRange();
}

QCPRange StateLane::getValueRange(bool& found, QCP::SignDomain, const QCPRange&) const
{
    found = !m_bands.empty();
    return {0, 1};
}

void StateLane::draw(QCPPainter* painter)
{
    const QRect room = mKeyAxis->axisRect()->rect();
    const double top = room.top() + 3, height = std::max(6, room.height() - 6);
    for (const StateBand& band : m_bands) {
        const double left = std::max<double>(mKeyAxis->coordToPixel(band.from), room.left());
        const double right = std::min<double>(mKeyAxis->coordToPixel(band.to), room.right() + 1);
        if (right > left)
            drawBand(*painter, QRectF(left, top, std::max(1.0, right - left), height), band);
    }
}

void StateLane::drawBand(QCPPainter& painter, const QRectF& area, const StateBand& band) const
{
    QColor ink = mPen.color();
    const bool off = m_names.isBool() && band.value == 0.0;
    // Neighbours differ in depth; the word says which state it is.
    const int number = band.value ? static_cast<int>(std::lround(*band.value)) : 0;
    QColor fill = ink;
    fill.setAlpha(!band.value ? 150 : off ? 0 : number % 2 ? 80 : 45);
    painter.fillRect(area, fill);
    painter.setPen(QPen(ink, 1));
    painter.drawLine(area.bottomLeft(), area.bottomRight());
    if (!off)
        painter.drawLine(area.topLeft(), area.topRight());
    painter.drawLine(area.topLeft(), area.bottomLeft());
    if (!band.value)
        return;
    const QString text = bandText(m_names.name(*band.value), QFontMetrics(theme().smallFont()), area.width());
    if (text.isEmpty() || area.height() < QFontMetrics(theme().smallFont()).ascent())
        return;
    painter.setFont(theme().smallFont());
    painter.setPen(theme().color(off ? Role::Dim : Role::Text));
    painter.drawText(area.adjusted(Padding, 0, -Padding + 2, 0), Qt::AlignVCenter | Qt::AlignLeft, text);
}

} // namespace camwright
