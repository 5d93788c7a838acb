#pragma once

#include <QWidget>

class QLabel;
class QPushButton;

namespace camwright {

class PanelControl;
class Switch;

/// The switch of panel control with what it means, and the orders that move nothing by themselves: enable, reset, home.
class ArmBar : public QWidget {
    Q_OBJECT
public:
    ArmBar(PanelControl& control, QWidget* parent = nullptr);
    void refresh();
    /// Who holds control of the controller, empty where nobody else does.
    void setHolder(const QString& holder);

private:
    void toggled();
    void refreshButtons();

    PanelControl& m_control;
    QString m_holder;
    Switch* m_switch;
    QLabel* m_title;
    QLabel* m_explanation;
    QPushButton* m_enable;
    QPushButton* m_reset;
    QPushButton* m_home;
};

} // namespace camwright
