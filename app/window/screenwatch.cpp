#include "app/window/screenwatch.h"

#include "editors/shell/context.h"

#include <QDBusConnection>
#include <QFileInfo>

#include <atomic>

namespace camwright {

namespace {

/// A name of its own for every connection of this process.
QString newConnectionName()
{
    static std::atomic<int> count{0};
    return QStringLiteral("camwright-screenwatch-%1").arg(++count);
}

QString socketAddress(const QString& path)
{
    return QFileInfo::exists(path) ? QStringLiteral("unix:path=") + path : QString();
}

} // namespace

ScreenWatch::Buses ScreenWatch::buses()
{
    Buses out{qEnvironmentVariable("DBUS_SESSION_BUS_ADDRESS"), qEnvironmentVariable("DBUS_SYSTEM_BUS_ADDRESS")};
    const QString runtime = qEnvironmentVariable("XDG_RUNTIME_DIR");
    if (out.session.isEmpty() && !runtime.isEmpty())
        out.session = socketAddress(runtime + QStringLiteral("/bus"));
    if (out.session.startsWith(QLatin1String("autolaunch:")))
        out.session.clear(); // it would start one
    if (out.system.isEmpty())
        out.system = socketAddress(QStringLiteral("/run/dbus/system_bus_socket"));
    return out;
}

ScreenWatch::ScreenWatch(Context& context, const Buses& buses, QObject* parent) : QObject(parent), m_context(context)
{
    connectTo(buses.session, &ScreenWatch::subscribeSession);
    connectTo(buses.system, &ScreenWatch::subscribeSystem);
}

ScreenWatch::~ScreenWatch()
{
    for (const QString& name : m_connections)
        QDBusConnection::disconnectFromBus(name);
}

/// The greeting waits for the bus: not on the interface's thread.
void ScreenWatch::connectTo(const QString& address, void (ScreenWatch::*subscribe)(const QString&))
{
    if (address.isEmpty())
        return;
    const QString name = newConnectionName();
    m_connections << name;
    m_context.runInBackground<bool>(
        this, [address, name] { return QDBusConnection::connectToBus(address, name).isConnected(); },
        [this, address, name, subscribe](bool connected) {
            if (!connected) {
                emit unreachable(address);
                return;
            }
            (this->*subscribe)(name);
            emit listening(address);
        });
}

// The sender is not asked for: finding out its owner would wait for the bus, and a false alarm only stops what can be armed again.

void ScreenWatch::subscribeSession(const QString& connection)
{
    QDBusConnection bus(connection);
    for (const char* interface : {"org.freedesktop.ScreenSaver", "org.gnome.ScreenSaver"})
        bus.connect({}, {}, QString::fromLatin1(interface), QStringLiteral("ActiveChanged"), this, SLOT(screenSaverChanged(bool)));
}

void ScreenWatch::subscribeSystem(const QString& connection)
{
    QDBusConnection bus(connection);
    bus.connect({}, {}, QStringLiteral("org.freedesktop.login1.Manager"), QStringLiteral("PrepareForSleep"), this, SLOT(sleepChanged(bool)));
    bus.connect({}, {}, QStringLiteral("org.freedesktop.login1.Session"), QStringLiteral("Lock"), this, SLOT(locked()));
}

void ScreenWatch::screenSaverChanged(bool active)
{
    if (active)
        locked();
}

void ScreenWatch::locked()
{
    m_context.disarmAll(tr("The screen was locked. Panel control is off."));
}

void ScreenWatch::sleepChanged(bool begins)
{
    // After waking too: the first sign may have come too late.
    m_context.disarmAll(begins ? tr("The computer goes to sleep. Panel control is off.") : tr("The computer was asleep. Panel control is off."));
}

} // namespace camwright
