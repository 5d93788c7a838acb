#pragma once

#include <QObject>
#include <QTimer>

namespace camwright {

class LiveChecks;
class MainWindow;

/// Says when the window is painted, its events are worked off and the checks of the open project have ended: the moment
/// from which somebody can work. For timing the start (`camwright --until-idle`).
class UntilIdle : public QObject {
    Q_OBJECT
public:
    UntilIdle(MainWindow& window, const LiveChecks& checks);

signals:
    void idle();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void look();

    MainWindow& m_window;
    const LiveChecks& m_checks;
    QTimer m_look;
    bool m_painted = false;
};

} // namespace camwright
