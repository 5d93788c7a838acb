#include "editors/trace/scopeplot.h"

#include "editors/trace/statelane.h"

#include <algorithm>
#include <cmath>

namespace camwright {

namespace {

constexpr int LeftMargin = 64, CursorReach = 5;
constexpr double ShortestView = 0.002; // seconds

Role roleOfChannel(std::size_t channel)
{
    static constexpr Role Roles[] = {Role::Channel1, Role::Channel2, Role::Channel3, Role::Channel4, Role::Forced, Role::Warn, Role::Error, Role::Idle};
    return Roles[channel % std::size(Roles)];
}

} // namespace

ScopePlot::ScopePlot(const TraceBuffer& buffer, QWidget* parent)
    : QCustomPlot(parent), m_buffer(buffer)
{
    setObjectName(QStringLiteral("scopePlot"));
    setAccessibleName(tr("Curves of the recording"));
    setToolTip(tr("Drag to zoom, wheel to zoom time, Shift and drag to move, double-click to fit; drag a cursor to measure."));
    setMinimumHeight(160);
    setFocusPolicy(Qt::StrongFocus);
    setNoAntialiasingOnDrag(true);
    connect(&theme(), &Theme::changed, this, &ScopePlot::applyTheme);
    rebuild();
}

Role ScopePlot::channelRole(std::size_t channel)
{
    return roleOfChannel(channel);
}

// Lanes

QCPAxisRect* ScopePlot::newRect()
{
    auto* rect = new QCPAxisRect(this, true);
    rect->setAutoMargins(QCP::msBottom);
    rect->setMargins(QMargins(LeftMargin, 4, 12, 0));
    rect->setMinimumSize(50, 28);
    rect->axis(QCPAxis::atLeft)->ticker()->setTickCount(3);
    rect->axis(QCPAxis::atBottom)->grid()->setVisible(true);
    return rect;
}

QCPAxisRect* ScopePlot::addRow(bool low)
{
    const int row = plotLayout()->elementCount();
    auto* rect = newRect();
    plotLayout()->addElement(row, 0, rect);
    plotLayout()->setRowStretchFactor(row, low ? 0.35 : 1.0);
    return rect;
}

void ScopePlot::rebuild()
{
    m_lanes.clear();
    for (const ChannelInfo& channel : m_buffer.channels()) {
        Lane lane;
        lane.names = StateNames::of(channel, m_family);
        m_lanes.push_back(lane);
    }
    layLanes();
}

void ScopePlot::makeCurve(Lane& lane)
{
    const bool shares = m_overlaid && graphCount() > 0;
    lane.rect = shares ? graph(0)->keyAxis()->axisRect() : addRow(false);
    QCPAxis* y = lane.rect->axis(QCPAxis::atLeft);
    if (shares) { // each curve at its own scale; the first one's is shown
        y = lane.rect->addAxis(QCPAxis::atLeft);
        y->setVisible(false);
    }
    lane.graph = addGraph(lane.rect->axis(QCPAxis::atBottom), y);
    lane.graph->setAdaptiveSampling(false); // the series is decimated already
}

void ScopePlot::makeBands(Lane& lane)
{
    lane.rect = addRow(true);
    QCPAxis* y = lane.rect->axis(QCPAxis::atLeft);
    y->setRange(0, 1);
    y->setTicks(false);
    y->setTickLabels(false);
    y->grid()->setVisible(false);
    lane.bands = new StateLane(lane.rect->axis(QCPAxis::atBottom), y);
    lane.bands->setNames(lane.names);
}

void ScopePlot::layLanes()
{
    clearItems();
    clearPlottables();
    plotLayout()->clear();
    for (auto& lines : m_cursorLines)
        lines.clear();
    m_triggerLines.clear();
    plotLayout()->setRowSpacing(0);
    for (Lane& lane : m_lanes) {
        lane.rect = nullptr;
        lane.graph = nullptr;
        lane.bands = nullptr;
    }
    // Overlaid, the curves stand above and the states below them, else all in the order of the list.
    for (int round = 0; round < (m_overlaid ? 2 : 1); ++round) {
        for (Lane& lane : m_lanes) {
            if (lane.visible && (!m_overlaid || lane.names.hasNames() == (round == 1)))
                lane.names.hasNames() ? makeBands(lane) : makeCurve(lane);
        }
    }
    if (plotLayout()->elementCount() == 0)
        addRow(false);
    for (QCPAxisRect* rect : axisRects())
        rect->axis(QCPAxis::atBottom)->setTickLabels(rect == axisRects().last());
    addCursorLines();
    applyTheme();
    fillAll();
}

const StateLane* ScopePlot::stateLane(std::size_t channel) const
{
    return channel < m_lanes.size() ? m_lanes[channel].bands : nullptr;
}

void ScopePlot::addCursorLines()
{
    const auto line = [this](QCPAxisRect* rect, Qt::PenStyle style, Role role) {
        auto* item = new QCPItemStraightLine(this);
        item->setClipAxisRect(rect);
        item->point1->setAxes(rect->axis(QCPAxis::atBottom), rect->axis(QCPAxis::atLeft));
        item->point2->setAxes(rect->axis(QCPAxis::atBottom), rect->axis(QCPAxis::atLeft));
        item->setPen(QPen(theme().color(role), 1, style));
        return item;
    };
    for (QCPAxisRect* rect : axisRects()) {
        m_cursorLines[0].push_back(line(rect, Qt::SolidLine, Role::Text));
        m_cursorLines[1].push_back(line(rect, Qt::SolidLine, Role::Text));
        m_triggerLines.push_back(line(rect, Qt::DotLine, Role::Ok));
    }
    m_zoomBox = new QCPItemRect(this);
    m_zoomBox->setVisible(false);
    m_zoomBox->topLeft->setType(QCPItemPosition::ptAbsolute);
    m_zoomBox->bottomRight->setType(QCPItemPosition::ptAbsolute);
    moveCursorLines();
}

void ScopePlot::moveCursorLines()
{
    const auto place = [](QCPItemStraightLine* item, double x) {
        item->point1->setCoords(x, 0);
        item->point2->setCoords(x, 1);
    };
    for (int cursor = 0; cursor < 2; ++cursor) {
        for (QCPItemStraightLine* item : m_cursorLines[cursor]) {
            item->setVisible(m_buffer.rows() > 0); // nothing to measure before
            place(item, m_cursors[cursor]);
        }
    }
    for (QCPItemStraightLine* item : m_triggerLines) {
        item->setVisible(m_buffer.triggerCycle() >= 0);
        place(item, secondsOf(static_cast<std::uint64_t>(std::max<std::int64_t>(0, m_buffer.triggerCycle()))));
    }
}

void ScopePlot::applyTheme()
{
    setBackground(theme().color(Role::Surface));
    const QPen fine(theme().color(Role::FineLine), 1), line(theme().color(Role::Line), 1);
    for (QCPAxisRect* rect : axisRects()) {
        for (QCPAxis* axis : rect->axes()) {
            axis->setBasePen(line);
            axis->setTickPen(line);
            axis->setSubTickPen(Qt::NoPen);
            axis->setTickLabelFont(theme().smallFont());
            axis->setTickLabelColor(theme().color(Role::Dim));
            axis->grid()->setPen(fine);
            axis->grid()->setZeroLinePen(line);
        }
    }
    for (std::size_t i = 0; i < m_lanes.size(); ++i) {
        const QPen pen(theme().color(channelRole(i)), i == m_selected ? 2.0 : 1.4);
        if (m_lanes[i].graph)
            m_lanes[i].graph->setPen(pen);
        if (m_lanes[i].bands)
            m_lanes[i].bands->setPen(pen);
    }
    for (auto& lines : m_cursorLines) {
        for (QCPItemStraightLine* item : lines)
            item->setPen(QPen(theme().color(Role::Text), 1));
    }
    if (m_zoomBox) {
        QColor tint = theme().color(Role::Accent);
        m_zoomBox->setPen(QPen(tint, 1));
        tint.setAlpha(40);
        m_zoomBox->setBrush(tint);
    }
    replot(QCustomPlot::rpQueuedReplot);
}

// Samples

double ScopePlot::secondsOf(std::uint64_t cycle) const
{
    return static_cast<double>(cycle) * static_cast<double>(m_buffer.cycleNs()) * 1e-9;
}

std::uint64_t ScopePlot::cycleOf(double seconds) const
{
    const double cycle = std::round(seconds / (static_cast<double>(m_buffer.cycleNs()) * 1e-9));
    return cycle <= 0 ? 0 : static_cast<std::uint64_t>(cycle);
}

void ScopePlot::scaleLane(Lane& lane, double low, double high)
{
    QCPAxis* axis = lane.graph->valueAxis();
    if (low > high)
        return;
    const double middle = (low + high) / 2, half = std::max((high - low) / 2, std::max(1e-6, std::abs(middle) * 1e-6));
    axis->setRange(middle - half * 1.12, middle + half * 1.12);
}

void ScopePlot::fillLane(std::size_t channel)
{
    Lane& lane = m_lanes[channel];
    if ((!lane.graph && !lane.bands) || m_buffer.rows() == 0)
        return;
    const std::uint64_t from = cycleOf(m_range.lower), to = std::max(from + 1, cycleOf(m_range.upper) + 1);
    const auto pixels = static_cast<std::size_t>(std::max(50, width() - LeftMargin - 12));
    const std::size_t count = std::min<std::size_t>(pixels, to - from);
    const auto columns = m_buffer.columns(channel, from, to, count);
    const double step = static_cast<double>(to - from) / static_cast<double>(count) * static_cast<double>(m_buffer.cycleNs()) * 1e-9;
    if (lane.bands)
        lane.bands->setBands(bandsOf(columns, secondsOf(from), step));
    else
        fillCurve(lane, columns, secondsOf(from), step);
}

void ScopePlot::fillCurve(Lane& lane, const std::vector<TraceColumn>& columns, double start, double step)
{
    QVector<QCPGraphData> data;
    data.reserve(static_cast<qsizetype>(columns.size()) * 4);
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const TraceColumn& column = columns[i];
        const double x = start + step * static_cast<double>(i);
        if (column.gap && !data.isEmpty()) // never a gap drawn as a line
            data.append(QCPGraphData(x, std::numeric_limits<double>::quiet_NaN()));
        if (column.empty)
            continue;
        data.append(QCPGraphData(x, column.first));
        if (column.minimum != column.maximum) {
            data.append(QCPGraphData(x + step * 0.3, column.minimum));
            data.append(QCPGraphData(x + step * 0.6, column.maximum));
            data.append(QCPGraphData(x + step * 0.9, column.last));
        }
        low = std::min(low, column.minimum);
        high = std::max(high, column.maximum);
    }
    lane.graph->data()->set(data, true);
    scaleLane(lane, low, high);
}

void ScopePlot::fillAll()
{
    for (QCPAxisRect* rect : axisRects())
        rect->axis(QCPAxis::atBottom)->setRange(m_range);
    for (std::size_t i = 0; i < m_lanes.size(); ++i)
        fillLane(i);
    moveCursorLines();
    replot(QCustomPlot::rpQueuedReplot);
}

void ScopePlot::refresh(bool follow)
{
    if (m_buffer.channels().size() != m_lanes.size())
        rebuild();
    if (follow && m_buffer.rows() > 0) {
        const double newest = secondsOf(m_buffer.lastCycle());
        m_range = QCPRange(newest - m_range.size(), newest);
    }
    fillAll();
}

void ScopePlot::fit()
{
    if (m_buffer.rows() < 2)
        return;
    setTimeRange(QCPRange(secondsOf(m_buffer.firstCycle()), secondsOf(m_buffer.lastCycle())));
}

void ScopePlot::setTimeRange(const QCPRange& range)
{
    m_range = range.size() < ShortestView ? QCPRange(range.center() - ShortestView / 2, range.center() + ShortestView / 2) : range;
    fillAll();
}

void ScopePlot::setLaneVisible(std::size_t channel, bool visible)
{
    if (channel < m_lanes.size() && m_lanes[channel].visible != visible) {
        m_lanes[channel].visible = visible;
        layLanes();
    }
}

void ScopePlot::setSelected(std::size_t channel)
{
    m_selected = channel;
    applyTheme();
}

void ScopePlot::setOverlaid(bool overlaid)
{
    m_overlaid = overlaid;
    layLanes();
}

// Cursors and the mouse

std::uint64_t ScopePlot::cursorCycle(int cursor) const
{
    return cycleOf(m_cursors[cursor]);
}

void ScopePlot::placeCursorsInView()
{
    m_cursors[0] = m_range.lower + m_range.size() * 0.25;
    m_cursors[1] = m_range.lower + m_range.size() * 0.75;
    moveCursorLines();
    replot(QCustomPlot::rpQueuedReplot);
    emit cursorsMoved();
}

QCPAxisRect* ScopePlot::firstRect() const
{
    const QList<QCPAxisRect*> rects = axisRects();
    return rects.isEmpty() ? nullptr : rects.first();
}

std::optional<int> ScopePlot::cursorNear(double x) const
{
    for (int cursor = 0; cursor < 2 && m_buffer.rows() > 0; ++cursor) {
        if (firstRect() && std::abs(firstRect()->axis(QCPAxis::atBottom)->coordToPixel(m_cursors[cursor]) - x) <= CursorReach)
            return cursor;
    }
    return std::nullopt;
}

void ScopePlot::mousePressEvent(QMouseEvent* event)
{
    if (!firstRect() || event->button() != Qt::LeftButton)
        return;
    m_pressed = event->position().toPoint();
    m_rangeAtPress = m_range;
    if (const auto cursor = cursorNear(event->position().x()))
        m_drag = *cursor == 0 ? Drag::CursorA : Drag::CursorB;
    else
        m_drag = event->modifiers() & Qt::ShiftModifier ? Drag::Pan : Drag::Zoom;
}

void ScopePlot::mouseMoveEvent(QMouseEvent* event)
{
    if (!firstRect())
        return;
    QCPAxis* time = firstRect()->axis(QCPAxis::atBottom);
    const double x = event->position().x();
    setCursor(m_drag == Drag::None && cursorNear(x) ? Qt::SplitHCursor : m_drag == Drag::Pan ? Qt::ClosedHandCursor : Qt::ArrowCursor);
    switch (m_drag) {
    case Drag::None: return;
    case Drag::CursorA:
    case Drag::CursorB:
        m_cursors[m_drag == Drag::CursorA ? 0 : 1] = std::clamp(time->pixelToCoord(x), m_range.lower, m_range.upper);
        moveCursorLines();
        emit cursorsMoved();
        break;
    case Drag::Pan: {
        const double shift = time->pixelToCoord(m_pressed.x()) - time->pixelToCoord(x);
        m_range = QCPRange(m_rangeAtPress.lower + shift, m_rangeAtPress.upper + shift);
        m_pressed = event->position().toPoint();
        m_rangeAtPress = m_range;
        fillAll();
        emit userNavigated();
        break;
    }
    case Drag::Zoom:
        m_zoomBox->topLeft->setPixelPosition(QPointF(std::min<double>(m_pressed.x(), x), 0));
        m_zoomBox->bottomRight->setPixelPosition(QPointF(std::max<double>(m_pressed.x(), x), height()));
        m_zoomBox->setVisible(true);
        break;
    }
    replot(QCustomPlot::rpQueuedReplot);
}

void ScopePlot::mouseReleaseEvent(QMouseEvent* event)
{
    const Drag ended = std::exchange(m_drag, Drag::None);
    if (ended != Drag::Zoom || !firstRect())
        return;
    m_zoomBox->setVisible(false);
    const double x = event->position().x();
    QCPAxis* time = firstRect()->axis(QCPAxis::atBottom);
    if (std::abs(x - m_pressed.x()) > 4) {
        emit userNavigated();
        setTimeRange(QCPRange(time->pixelToCoord(std::min<double>(m_pressed.x(), x)), time->pixelToCoord(std::max<double>(m_pressed.x(), x))));
    }
    replot(QCustomPlot::rpQueuedReplot);
}

void ScopePlot::mouseDoubleClickEvent(QMouseEvent*)
{
    emit userNavigated();
    fit();
}

void ScopePlot::zoom(double factor, double aroundX)
{
    if (!firstRect())
        return;
    const double center = firstRect()->axis(QCPAxis::atBottom)->pixelToCoord(aroundX);
    emit userNavigated();
    setTimeRange(QCPRange(center - (center - m_range.lower) * factor, center + (m_range.upper - center) * factor));
}

void ScopePlot::wheelEvent(QWheelEvent* event)
{
    zoom(event->angleDelta().y() > 0 ? 0.8 : 1.25, event->position().x());
    event->accept();
}

void ScopePlot::keyPressEvent(QKeyEvent* event)
{
    const double step = m_range.size() / 10;
    if (event->key() == Qt::Key_Plus || event->key() == Qt::Key_Minus) {
        zoom(event->key() == Qt::Key_Plus ? 0.8 : 1.25, width() / 2.0);
    } else if (event->key() == Qt::Key_Left || event->key() == Qt::Key_Right) {
        const double shift = event->key() == Qt::Key_Left ? -step : step;
        emit userNavigated();
        setTimeRange(QCPRange(m_range.lower + shift, m_range.upper + shift));
    } else if (event->key() == Qt::Key_Home) {
        emit userNavigated();
        fit();
    } else {
        QCustomPlot::keyPressEvent(event);
    }
}

void ScopePlot::resizeEvent(QResizeEvent* event)
{
    QCustomPlot::resizeEvent(event);
    fillAll();
}

} // namespace camwright
