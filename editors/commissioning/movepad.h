#pragma once

#include "editors/commissioning/axislimits.h"
#include "editors/commissioning/moveestimate.h"

#include <QWidget>

class QGridLayout;
class QLabel;
class QPushButton;

namespace camwright {

class ProfileView;
class QuantityField;
class SegmentedControl;

/// Moves to a position or by a distance: target, velocity below the cap, acceleration, and how long it takes.
class MovePad : public QWidget {
    Q_OBJECT
public:
    explicit MovePad(QWidget* parent = nullptr);

    void setLimits(const AxisLimits& limits);
    void setCap(double cap);
    void setMovable(bool movable, const QString& why);
    /// For the duration of an absolute move.
    void setPosition(double position);
    /// 0 … 1 while a move of this pad runs, negative otherwise.
    void setProgress(double progress);

    bool isRelative() const;
    double target() const;               ///< position or distance
    double velocity() const;             ///< below the cap
    double acceleration() const;         ///< of the estimate
    /// What goes with the command: 0 where the drive uses its own.
    double commandAcceleration() const;
    const MoveEstimate& estimate() const { return m_estimate; }

signals:
    void moveWanted();

private:
    QuantityField* addField(QGridLayout* grid, int row, int column, const QString& name, const char* objectName, QLabel** note = nullptr);
    void refresh();
    QString whyNot() const;

    AxisLimits m_limits;
    double m_cap = 0, m_position = 0;
    bool m_movable = false, m_started = false;
    QString m_why;
    MoveEstimate m_estimate;
    SegmentedControl* m_kind;
    QLabel* m_targetLabel = nullptr;
    QLabel* m_capNote = nullptr;
    QLabel* m_takes;
    QuantityField* m_target = nullptr;
    QuantityField* m_velocity = nullptr;
    QuantityField* m_acceleration = nullptr;
    ProfileView* m_profile;
    QPushButton* m_move;
};

} // namespace camwright
