#pragma once

#include <QString>
#include <QWidget>

#include <optional>

class QPainter;

namespace camwright {

/// What a travel bar shows, in user units.
struct Travel {
    double position = 0;
    double stopsAt = 0;                        ///< where the axis would stand if it were stopped now
    std::optional<double> target;
    std::optional<double> lower, upper;        ///< limits, where they are known
    QString unit;
    bool operator==(const Travel&) const = default;
};

/// Where the axis is between its limits: hatched beyond them, the position as triangle and line, the stopping distance as
/// a tint, the target as a flag. Without limits it shows the surroundings, in steps, so that the scale stands still.
class TravelBar : public QWidget {
    Q_OBJECT
public:
    explicit TravelBar(QWidget* parent = nullptr);
    void setTravel(const Travel& travel);
    QSize sizeHint() const override { return {268, 80}; }
    QSize minimumSizeHint() const override { return {200, 80}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    struct Range {
        double low, high;
    };
    void chooseRange();
    double x(double value) const;
    void paintScale(QPainter& painter) const;
    void paintTarget(QPainter& painter) const;
    void paintPosition(QPainter& painter) const;
    void paintEnds(QPainter& painter) const;

    Travel m_travel;
    Range m_range{-50, 50};
};

/// A round step so that about `count` of them make `span`.
double roundStep(double span, int count);

} // namespace camwright
