#pragma once

#include "core/online/controllerlink.h"
#include "editors/commissioning/axislimits.h"

#include <QWidget>

#include <optional>

class QLabel;

namespace camwright {

class ArmBar;
class JogPad;
class MovePad;
class PanelControl;
class StopButton;

/// Right column: panel control, jog, moves, STOP. What the user does here becomes commands of PanelControl.
class MotionColumn : public QWidget {
    Q_OBJECT
public:
    MotionColumn(PanelControl& control, QWidget* parent = nullptr);

    void setLimits(const AxisLimits& limits);
    void present(const ControllerStatus& status);
    void refresh();
    void say(const QString& sentence);
    /// For the keys.
    void hold(int index);
    void letGo(int index);
    void letGoAll();

    std::optional<double> target() const { return m_target; } ///< of the last move, until another motion begins
    double deceleration() const;
    JogPad* jogPad() const { return m_jog; }

signals:
    void moveBegan();                       ///< peaks begin anew

private:
    void wire();
    void move();
    void step(double distance, double velocity);
    void showProgress(const ControllerStatus& status);

    PanelControl& m_control;
    ArmBar* m_arm;
    QLabel* m_message;
    JogPad* m_jog;
    MovePad* m_move;
    StopButton* m_stop;
    std::optional<double> m_target;
    Time m_now{}, m_moveStart{};
    double m_moveDuration = 0;              ///< s; 0 while no move of the pad runs
};

} // namespace camwright
