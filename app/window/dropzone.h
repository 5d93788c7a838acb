#pragma once

#include <QRect>
#include <QSize>
#include <QWidget>

#include <optional>

namespace camwright {

enum class Side { Left, Right, Above, Below };

/// What dropping a tab at a place of a group would do.
struct DropZone {
    std::optional<Side> side;  ///< a new group there; none: into the group itself
    int at = -1;               ///< before this tab; −1: behind the last
    QRect area;                ///< of the group, that the tab would take; for the mark
};

/// A quarter of the page at each side (40 to 160 pixels) opens a new group, the middle takes the tab in. `page` is the group
/// without its strip.
DropZone dropZoneOfPage(const QRect& page, const QPoint& position);

/// Tints the place that a dragged tab would take.
class DropMark : public QWidget {
    Q_OBJECT
public:
    DropMark();
    void showOn(QWidget* group, const QRect& area);
    void vanish();

protected:
    void paintEvent(QPaintEvent* event) override;
};

} // namespace camwright
