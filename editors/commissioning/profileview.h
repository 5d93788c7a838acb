#pragma once

#include "editors/commissioning/moveestimate.h"

#include <QWidget>

namespace camwright {

/// A small drawing of a move's velocity over time, with how far it has come.
class ProfileView : public QWidget {
    Q_OBJECT
public:
    explicit ProfileView(QWidget* parent = nullptr);
    void setEstimate(const MoveEstimate& estimate);
    /// 0 … 1 while the move runs, negative otherwise.
    void setProgress(double progress);
    QSize sizeHint() const override { return {160, 28}; }
    QSize minimumSizeHint() const override { return {80, 28}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    MoveEstimate m_estimate;
    double m_progress = -1;
};

} // namespace camwright
