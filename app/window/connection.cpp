#include "app/window/connection.h"

#include "editors/shell/context.h"

namespace camwright {

Connection::Connection(Context& context, Services& services, QObject* parent)
    : QObject(parent), m_context(context), m_services(services)
{
    connect(&context, &Context::statusChanged, this, [this](const ControllerStatus& status) {
        if (status.state == RunState::Run && m_context.programMatches()) {
            m_lastRunAddress = m_address;
            m_lastRunSimulated = m_link && m_link->capabilities().simulated;
        }
    });
    connect(&context.document(), &ProjectDocument::pathChanged, this, [this] {
        m_lastRunAddress.clear();
        disconnectNow(); // the virtual controller belongs to its project
    });
}

Connection::~Connection()
{
    disconnectNow();
}

LinkState Connection::state() const
{
    return m_link ? m_link->state() : LinkState::Offline;
}

void Connection::connectTo(const QString& address)
{
    disconnectNow();
    auto link = m_services.connectTo(address.toStdString(), m_context.document().path().toStdString());
    if (!link) {
        m_context.notify(link.error());
        return;
    }
    m_address = address;
    m_link = std::move(*link);
    m_token = m_link->onStateChanged([this](LinkState state, const Diagnostic& why) { stateArrived(state, why); });
    m_context.setLink(m_link.get());
    emit stateChanged(m_link->state());
}

void Connection::disconnectNow()
{
    if (!m_link)
        return;
    m_link->forget(m_token);
    m_context.setLink(nullptr);
    // Deleted after this call: it may come from one of the link's own callbacks.
    auto* old = m_link.release();
    QMetaObject::invokeMethod(this, [old] { delete old; }, Qt::QueuedConnection);
    m_address.clear();
    emit stateChanged(LinkState::Offline);
}

void Connection::stateArrived(LinkState state, const Diagnostic& why)
{
    if (state == LinkState::Offline) {
        m_why = why;
        m_context.notify(why);
        disconnectNow();
        return;
    }
    emit stateChanged(state);
}

void Connection::withControl(std::function<void()> then)
{
    if (!m_context.isOnline())
        return;
    // Asked for even if the newest status says that it is held: that may be older than a lapse of the lease.
    m_link->takeControl([this, then = std::move(then)](Result<void> result) {
        if (result)
            then();
        else
            m_context.notify(result.error());
    });
}

void Connection::run()
{
    withControl([this] {
        m_link->run([this](Result<void> result) {
            if (!result)
                m_context.notify(result.error());
        });
    });
}

void Connection::stop()
{
    withControl([this] {
        m_link->stop([this](Result<void> result) {
            if (!result)
                m_context.notify(result.error());
        });
    });
}

void Connection::releaseForces()
{
    withControl([this] {
        m_link->release({}, [this](Result<void> result) {
            if (!result)
                m_context.notify(result.error());
        });
    });
}

} // namespace camwright
