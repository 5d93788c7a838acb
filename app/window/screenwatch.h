#pragma once

#include <QObject>
#include <QString>
#include <QStringList>

namespace camwright {

class Context;

/// Listens on the desktop's D-Bus for what takes the user away from the machine: the screen is locked, the computer goes to
/// sleep or wakes up. Every armed panel is disarmed then, and what it moves stops (CONTRACTS 19). It connects on a worker's
/// thread; without a bus it stays silent, and the dead-man of the controller is there as before.
class ScreenWatch : public QObject {
    Q_OBJECT
public:
    /// Addresses of the buses; empty: there is none.
    struct Buses {
        QString session;   ///< screen savers: org.freedesktop.ScreenSaver, org.gnome.ScreenSaver
        QString system;    ///< org.freedesktop.login1: sleep, and `loginctl lock-session`
    };
    /// What the environment names, and the usual sockets if they are there. Starts no bus.
    static Buses buses();

    ScreenWatch(Context& context, const Buses& buses, QObject* parent = nullptr);
    ~ScreenWatch() override;

signals:
    void listening(const QString& address);        ///< the bus answered; its signals are heard from now on
    void unreachable(const QString& address);

private slots:
    void screenSaverChanged(bool active);
    void locked();
    void sleepChanged(bool begins);

private:
    void connectTo(const QString& address, void (ScreenWatch::*subscribe)(const QString&));
    void subscribeSession(const QString& connection);
    void subscribeSystem(const QString& connection);

    Context& m_context;
    QStringList m_connections;
};

} // namespace camwright
