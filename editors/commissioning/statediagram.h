#pragma once

#include <QRectF>
#include <QString>
#include <QWidget>

#include <vector>

class QPainter;
class QPainterPath;

namespace camwright {

/// A state as the diagram names it.
struct DiagramState {
    int number = 0;
    QString name;               ///< as the manual spells it: "Discrete_Motion"
    bool operator==(const DiagramState&) const = default;
};

/// The states of an axis with the current one lit by tint, glyph and weight, and the way it came thick. For the six states
/// of Kinco a diagram (KS-MC-26, KS-MC-27), for other families a list.
class StateDiagram : public QWidget {
    Q_OBJECT
public:
    explicit StateDiagram(QWidget* parent = nullptr);

    /// `isKinco`: the numbers are those of KS-MC-26.
    void setStates(std::vector<DiagramState> states, bool isKinco);
    /// `previous` is negative while unknown, `current` while there is no status.
    void setCurrent(int current, int previous, bool isMoving);
    int current() const { return m_current; }
    QSize sizeHint() const override { return {364, 268}; }
    QSize minimumSizeHint() const override { return {296, 236}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    struct Geometry;
    void paintDiagram(QPainter& painter) const;
    void paintList(QPainter& painter) const;
    void paintArrows(QPainter& painter, const Geometry& at) const;
    void paintTaken(QPainter& painter, const Geometry& at) const;
    void paintState(QPainter& painter, const QRectF& box, int number) const;
    QString nameOf(int number) const;

    std::vector<DiagramState> m_states;
    bool m_isKinco = true;
    int m_current = -1, m_previous = -1;
    bool m_isMoving = false;
};

} // namespace camwright
