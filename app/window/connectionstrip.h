#pragma once

#include "app/window/connection.h"
#include "editors/shell/context.h"

#include <QFrame>

class QLabel;
class QPushButton;

namespace camwright {

class LinkLabel;
class Pill;

/// Which controller is this, in one glance: nothing while offline, blue for a virtual one, amber for a real machine, and how
/// many values are forced. Says in one sentence why live values are off.
class ConnectionStrip : public QFrame {
    Q_OBJECT
public:
    ConnectionStrip(Context& context, Connection& connection, QWidget* parent = nullptr);

signals:
    void showDifferencesRequested();
    void releaseForcesRequested();

private:
    void refresh();

    Context& m_context;
    Connection& m_connection;
    QLabel* m_sign;
    QLabel* m_words;
    Pill* m_forces;
    QLabel* m_differs;
    LinkLabel* m_showDifferences;
    QLabel* m_armed;
    LinkLabel* m_release;
};

} // namespace camwright
