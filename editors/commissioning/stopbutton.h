#pragma once

#include <QAbstractButton>

namespace camwright {

/// STOP of all axes: the largest control, the only solid red, with its keys on it. It acts when it goes down, not when it is
/// let go, so connect to pressed().
class StopButton : public QAbstractButton {
    Q_OBJECT
public:
    explicit StopButton(QWidget* parent = nullptr);
    QSize sizeHint() const override { return {420, 56}; }
    QSize minimumSizeHint() const override { return {300, 56}; }

protected:
    void paintEvent(QPaintEvent* event) override;
};

} // namespace camwright
