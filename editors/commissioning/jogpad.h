#pragma once

#include "editors/commissioning/axislimits.h"

#include <QWidget>

#include <array>

class QLabel;
class QSlider;

namespace camwright {

class HoldButton;
class PlainField;
class QuantityField;
class SegmentedControl;

/// Four buttons that move the axis while they are held, or by a step a press; the cap on every speed of the panel, 5 % at
/// first. Only the slider raises the cap: a larger maximum speed leaves it where it is.
class JogPad : public QWidget {
    Q_OBJECT
public:
    explicit JogPad(QWidget* parent = nullptr);

    /// Units, ranges and first values; what the user has typed stays while the unit does.
    void setLimits(const AxisLimits& limits);
    void setMovable(bool movable, const QString& why);
    double cap() const { return m_cap; }                  ///< user units per second
    double speed(int index) const;                        ///< signed; 0 … 3: −−, −, +, ++
    bool isStepping() const;
    double step() const;

    /// For the keys: a button goes down or up. A second one at the same time ends the first and starts nothing.
    void hold(int index);
    void letGo(int index);
    void letGoAll();

signals:
    void jogWanted(double velocity);
    void stepWanted(double distance, double velocity);
    void jogEnded();
    void capChanged();

private:
    QWidget* buildButtons();
    QWidget* buildHead();
    QWidget* buildCap();
    void held(int index);
    void capMoved(int percent);
    void maximumEdited();
    void setCap(double cap);
    void refresh();

    AxisLimits m_limits;
    double m_maximum = 0;
    double m_cap = 0;
    std::array<HoldButton*, 4> m_buttons{};
    SegmentedControl* m_mode;
    QLabel* m_hint;
    QSlider* m_slider;
    QLabel* m_percent;
    QLabel* m_capText;
    QuantityField* m_maximumField;
    QuantityField* m_step;
    PlainField* m_stepHolder;
};

} // namespace camwright
