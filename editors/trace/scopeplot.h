#pragma once

#include "core/online/tracebuffer.h"
#include "editors/shell/theme.h"
#include "editors/trace/statenames.h"

#include <qcustomplot.h>

#include <optional>
#include <vector>

namespace camwright {

class StateLane;

/// The curves of a recording, a lane for each channel under one time axis. It draws what TraceBuffer::columns gives for each
/// pixel column, so a view costs the same however long the recording is. Time is in seconds of the controller.
class ScopePlot : public QCustomPlot {
    Q_OBJECT
public:
    explicit ScopePlot(const TraceBuffer& buffer, QWidget* parent = nullptr);

    static Role channelRole(std::size_t channel);

    /// Whose states the channels of axes tell; for the next rebuild().
    void setFamily(const std::string& family) { m_family = family; }
    /// Builds the lanes anew for the buffer's channels: a curve for a quantity, named bands for a state.
    void rebuild();
    /// Takes newly arrived samples; with `follow` the newest sits at the right edge.
    void refresh(bool follow);
    void fit();
    void setLaneVisible(std::size_t channel, bool visible);
    void setSelected(std::size_t channel);
    /// Overlaid: all quantities in one lane, each at its own scale; states and booleans keep lanes of their own.
    void setOverlaid(bool overlaid);
    bool isOverlaid() const { return m_overlaid; }
    QCPRange timeRange() const { return m_range; }
    void setTimeRange(const QCPRange& range);
    const StateLane* stateLane(std::size_t channel) const; ///< null for a quantity, or a lane that is not shown

    std::uint64_t cursorCycle(int cursor) const; ///< 0 = A, 1 = B
    void placeCursorsInView();

signals:
    void cursorsMoved();
    void userNavigated(); ///< zoomed or panned by hand: live following pauses

protected:
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    struct Lane {
        QCPAxisRect* rect = nullptr;
        QCPGraph* graph = nullptr;
        StateLane* bands = nullptr;
        StateNames names;
        bool visible = true;
    };
    enum class Drag { None, CursorA, CursorB, Zoom, Pan };

    QCPAxisRect* newRect();
    QCPAxisRect* addRow(bool low);
    void makeCurve(Lane& lane);
    void makeBands(Lane& lane);
    void layLanes();
    void fillLane(std::size_t channel);
    void fillCurve(Lane& lane, const std::vector<TraceColumn>& columns, double start, double step);
    void fillAll();
    void scaleLane(Lane& lane, double low, double high);
    void addCursorLines();
    void moveCursorLines();
    void applyTheme();
    double secondsOf(std::uint64_t cycle) const;
    std::uint64_t cycleOf(double seconds) const;
    QCPAxisRect* firstRect() const;
    std::optional<int> cursorNear(double x) const;
    void zoom(double factor, double aroundX);

    const TraceBuffer& m_buffer;
    std::string m_family;
    std::vector<Lane> m_lanes;
    std::vector<QCPItemStraightLine*> m_cursorLines[2];
    std::vector<QCPItemStraightLine*> m_triggerLines;
    QCPItemRect* m_zoomBox = nullptr;
    QCPRange m_range{0, 1};
    double m_cursors[2] = {0.25, 0.75};
    std::size_t m_selected = 0;
    bool m_overlaid = false;
    Drag m_drag = Drag::None;
    QPoint m_pressed;
    QCPRange m_rangeAtPress;
};

} // namespace camwright
