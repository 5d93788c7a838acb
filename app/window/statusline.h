#pragma once

#include "app/window/connection.h"
#include "app/window/workbench.h"
#include "editors/shell/context.h"

#include <QFrame>

class QLabel;

namespace camwright {

class Pill;

/// The line at the foot: state of the controller, scan time, same program or not, control, bus, forces; where the user is.
class StatusLine : public QFrame {
    Q_OBJECT
public:
    StatusLine(Context& context, Connection& connection, Workbench& workbench, QWidget* parent = nullptr);
    void setPosition(const QString& text);

private:
    void refresh();
    void refreshOnline();
    void refreshOffline();

    Context& m_context;
    Connection& m_connection;
    Workbench& m_workbench;
    Pill* m_state;
    QLabel* m_problems;
    QLabel* m_scan;
    QLabel* m_program;
    QLabel* m_control;
    QLabel* m_bus;
    QLabel* m_forces;
    QLabel* m_position;
    QLabel* m_project;
};

} // namespace camwright
