#pragma once

#include <QTabBar>

namespace camwright {

/// Tabs of the editors, painted by us: icon, name (italic for a preview), a dot for an unapplied page, a cross.
class EditorTabBar : public QTabBar {
    Q_OBJECT
public:
    explicit EditorTabBar(QWidget* parent = nullptr);

    void setTabIconName(int index, const QString& name);
    void setPreview(int index, bool preview);

protected:
    void paintEvent(QPaintEvent* event) override;
    QSize tabSizeHint(int index) const override;
    QSize minimumTabSizeHint(int index) const override { return tabSizeHint(index); }
    void mousePressEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    QRect crossRect(int index) const;
    QFont fontOf(int index) const;

    int m_hover = -1;
    int m_pressedCross = -1;
};

} // namespace camwright
