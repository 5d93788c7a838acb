#pragma once

#include "core/model/objects.h"

#include <QWidget>

namespace camwright {

/// A drawing of motor, coupling and load that follows the axis's values: encoder pulses at the motor, travel per turn at
/// the slide or the table; below it the formula with the numbers in it.
class TransmissionView : public QWidget {
    Q_OBJECT
public:
    explicit TransmissionView(QWidget* parent = nullptr);
    void setAxis(const Axis& axis);
    QSize sizeHint() const override { return {640, 210}; }
    QSize minimumSizeHint() const override { return {480, 210}; }

    /// "10 000 pulses ÷ 100 mm = 100 pulses/mm"; empty while a value is not legal.
    QString formula() const;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void paintMotor(QPainter& painter) const;
    void paintScrew(QPainter& painter) const;
    void paintTable(QPainter& painter) const;
    bool isRotary() const;
    QString unit() const;

    Axis m_axis;
};

} // namespace camwright
