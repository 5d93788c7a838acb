#pragma once

#include "core/online/controllerlink.h"

#include <QDateTime>
#include <QWidget>

class QLabel;

namespace camwright {

class StateDiagram;

/// Middle column: the state diagram, and below it the last transition with its cause and time.
class StateView : public QWidget {
    Q_OBJECT
public:
    explicit StateView(QWidget* parent = nullptr);

    void setFamily(const std::string& family);
    void present(const AxisStatus& axis, Time controllerTime);
    void forget();                    ///< another controller: what was seen before means nothing
    StateDiagram* diagram() const { return m_diagram; }

private:
    QString stateName(int number) const;
    void showTransition(const AxisStatus& axis, Time age);

    std::string m_family;
    QLabel* m_number;
    StateDiagram* m_diagram;
    QLabel* m_transition;
    QLabel* m_time;
    QLabel* m_cause;
    int m_current = -1, m_previous = -1;
    Time m_lastChange{-1};
    QDateTime m_changedAt;            ///< wall clock of the last transition
};

} // namespace camwright
