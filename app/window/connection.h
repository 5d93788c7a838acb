#pragma once

#include "app/window/services.h"

#include <QObject>
#include <QString>

namespace camwright {

class Context;

/// The window's link to a controller: connects, disconnects, tells how it stands. Owns the link; views reach it through the
/// context only.
class Connection : public QObject {
    Q_OBJECT
public:
    Connection(Context& context, Services& services, QObject* parent = nullptr);
    ~Connection() override;

    /// A failure that is known at once is told through the context.
    void connectTo(const QString& address);
    void disconnectNow();
    LinkState state() const;
    QString address() const { return m_address; }
    Diagnostic whyOffline() const { return m_why; }

    /// Calls `then` once this window holds control, or tells why not.
    void withControl(std::function<void()> then);
    void run();
    void stop();
    void releaseForces();

    QString lastRunAddress() const { return m_lastRunAddress; } ///< where the open project last ran; empty: not
    bool lastRunSimulated() const { return m_lastRunSimulated; }

signals:
    void stateChanged(camwright::LinkState state);

private:
    void stateArrived(LinkState state, const Diagnostic& why);

    Context& m_context;
    Services& m_services;
    std::unique_ptr<ControllerLink> m_link;
    int m_token = 0;
    QString m_address;
    Diagnostic m_why;
    QString m_lastRunAddress;
    bool m_lastRunSimulated = true;
};

} // namespace camwright
