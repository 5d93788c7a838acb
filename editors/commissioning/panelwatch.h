#pragma once

#include <QObject>

class QWidget;

namespace camwright {

/// Looks whether the user is still at a panel. He has left it when its window is deactivated, covered by a dialog,
/// minimised or closed, when another tab hides it, or when the focus goes into another editor or window.
class PanelWatch : public QObject {
    Q_OBJECT
public:
    explicit PanelWatch(QWidget& panel);
    ~PanelWatch() override;

    /// Watches only while it matters.
    void setActive(bool active);
    bool eventFilter(QObject* watched, QEvent* event) override;

signals:
    void left();
    void focusMoved();      ///< within reach; what is held by a key ends

private:
    void focusChanged(QWidget* now);

    QWidget& m_panel;
    bool m_active = false;
};

} // namespace camwright
