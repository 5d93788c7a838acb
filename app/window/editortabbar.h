#pragma once

#include <QTabBar>

namespace camwright {

/// Tabs of the editors, painted by us: icon, name (italic for a preview), a cross. A tab is dragged along the bar to reorder
/// it; out of the bar it is announced to whoever can place it elsewhere, until it is dropped or Escape is pressed.
class EditorTabBar : public QTabBar {
    Q_OBJECT
public:
    explicit EditorTabBar(QWidget* parent = nullptr);

    void setTabIconName(int index, const QString& name);
    void setPreview(int index, bool preview);
    /// The bar of the group that keys and new tabs go to; only there is the current tab marked in the accent colour.
    void setActive(bool active);
    /// Where a tab dropped at `x` would come to stand.
    int insertionAt(int x) const;

signals:
    void draggedOut(int index, const QPoint& global);
    void droppedOutside(int index, const QPoint& global);
    void dragEnded();                          ///< dropped, back in the bar, or given up

protected:
    void paintEvent(QPaintEvent* event) override;
    QSize tabSizeHint(int index) const override;
    QSize minimumTabSizeHint(int index) const override { return tabSizeHint(index); }
    void mousePressEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void tabRemoved(int index) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    enum class Drag { None, Pressed, Inside, Outside };

    QRect crossRect(int index) const;
    QFont fontOf(int index) const;
    void paintTab(QPainter& painter, int index);
    void drag(const QPoint& position, const QPoint& global);
    void reorder(int x);
    void setDrag(Drag drag);

    int m_hover = -1;
    int m_pressedCross = -1;
    int m_dragged = -1;
    QPoint m_pressedAt;
    Drag m_drag = Drag::None;
    bool m_active = true;
};

} // namespace camwright
