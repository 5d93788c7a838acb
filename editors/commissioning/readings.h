#pragma once

#include "core/online/controllerlink.h"

#include <QLabel>
#include <QWidget>

#include <array>
#include <optional>

class QGridLayout;

namespace camwright {

class BigDigits;
class LinkLabel;
class Pill;
class TravelBar;

/// What the readings need beside the status.
struct ReadingsInput {
    std::optional<double> target;          ///< of the panel's own move
    std::optional<double> lower, upper;    ///< limit switches, where known
    double deceleration = 0;               ///< for the stopping distance
};

/// Left column: position in large digits, what the axis does, a table with now and peak, the travel bar.
class Readings : public QWidget {
    Q_OBJECT
public:
    explicit Readings(QWidget* parent = nullptr);

    void present(const AxisStatus& axis, const ReadingsInput& input);
    void resetPeaks();
    double peak(int row) const { return m_peaks[static_cast<std::size_t>(row)]; }

private:
    enum Row { SetPosition, ToTarget, Velocity, FollowingError, Torque, RowCount };
    void buildTable(QGridLayout* table);
    void showState(const AxisStatus& axis);
    void showRow(Row row, std::optional<double> value, const QString& unit, int decimals, bool hasPeak);

    AxisStatus m_last;
    QLabel* m_homedIcon;
    QLabel* m_homed;
    BigDigits* m_digits;
    Pill* m_state;
    TravelBar* m_travel;
    QLabel* m_stopsWithin;
    std::array<QLabel*, RowCount> m_now{}, m_units{}, m_peakLabels{};
    std::array<double, RowCount> m_peaks{};
};

} // namespace camwright
