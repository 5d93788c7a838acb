#include "devices/server/server.h"

#include "devices/server/clientconnection.h"
#include "devices/transport/socketstream.h"

#include <QHostAddress>
#include <QLocalServer>
#include <QLocalSocket>
#include <QTcpServer>
#include <QTcpSocket>
#include <QTimer>

#include <charconv>

namespace camwright {

namespace {

constexpr int NotesPerSecond = 20;
constexpr int WatchPeriodMs = 100;

struct HostPort {
    QHostAddress host;
    std::uint16_t port = 0;
};

std::optional<HostPort> parseHostPort(const std::string& text)
{
    const auto colon = text.rfind(':');
    if (colon == std::string::npos)
        return std::nullopt;
    std::string host = text.substr(0, colon);
    if (host.size() > 2 && host.front() == '[' && host.back() == ']')
        host = host.substr(1, host.size() - 2);
    HostPort out;
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data() + colon + 1, end, out.port);
    if (error != std::errc() || stop != end)
        return std::nullopt;
    if (host == "localhost")
        out.host = QHostAddress(QHostAddress::LocalHost);
    else if (!out.host.setAddress(QString::fromStdString(host)))
        return std::nullopt;
    return out;
}

} // namespace

Server::Server(ControllerHost& host, ServerOptions options)
    : m_host(host), m_options(std::move(options)), m_watch(std::make_unique<QTimer>()), m_notesLeft(NotesPerSecond),
      m_woken(std::make_shared<std::atomic<bool>>(false))
{
    m_host.setListener(this);
    m_host.setWake([this, woken = m_woken] {
        // One call on its way is enough; the loop's thread must not fill our queue.
        if (!woken->exchange(true))
            QMetaObject::invokeMethod(this, [this] {
                m_woken->store(false);
                m_host.deliver();
            }, Qt::QueuedConnection);
    });
    m_host.deliver(); // the state at the start: the first client must not find an empty one
    connect(m_watch.get(), &QTimer::timeout, this, &Server::watchClients);
    m_watch->start(WatchPeriodMs);
}

Server::~Server()
{
    m_host.setWake({});
    m_host.setListener(nullptr);
    closeAll();
}

Result<void> Server::listen(const std::string& address)
{
    const auto wanted = parseHostPort(address);
    if (!wanted)
        return diagnostic(Code::ListenFailed, {address, "it is not written HOST:PORT"});
    if (!wanted->host.isLoopback())
        return diagnostic(Code::ListenNotLocal, {address});
    m_tcp = std::make_unique<QTcpServer>();
    connect(m_tcp.get(), &QTcpServer::newConnection, this, [this] {
        while (std::unique_ptr<QTcpSocket> socket{m_tcp->nextPendingConnection()}) {
            socket->setParent(nullptr);
            accept(std::make_unique<SocketStream>(std::move(socket)));
        }
    });
    if (!m_tcp->listen(wanted->host, wanted->port))
        return diagnostic(Code::ListenFailed, {address, m_tcp->errorString().toStdString()});
    return {};
}

Result<void> Server::listenLocally(const std::string& path)
{
    const QString name = QString::fromStdString(path);
    QLocalServer::removeServer(name);
    m_local = std::make_unique<QLocalServer>();
    m_local->setSocketOptions(QLocalServer::UserAccessOption);
    connect(m_local.get(), &QLocalServer::newConnection, this, [this] {
        while (std::unique_ptr<QLocalSocket> socket{m_local->nextPendingConnection()}) {
            socket->setParent(nullptr);
            accept(std::make_unique<SocketStream>(std::move(socket)));
        }
    });
    if (!m_local->listen(name))
        return diagnostic(Code::ListenFailed, {path, m_local->errorString().toStdString()});
    return {};
}

std::uint16_t Server::port() const
{
    return m_tcp ? m_tcp->serverPort() : 0;
}

void Server::accept(std::unique_ptr<ByteStream> stream)
{
    const ClientId id = m_nextClient++;
    auto connection = std::make_unique<ClientConnection>(*this, id, std::move(stream));
    ClientConnection& client = *connection;
    const bool full = m_clients.size() >= m_options.maximumClients;
    m_clients[id] = std::move(connection);
    if (full)
        client.refuse(diagnostic(Code::TooManyClients, {std::to_string(m_options.maximumClients)}));
    emit clientsChanged();
}

ClientConnection* Server::client(ClientId id) const
{
    const auto found = m_clients.find(id);
    return found == m_clients.end() ? nullptr : found->second.get();
}

void Server::drop(ClientId id)
{
    const auto found = m_clients.find(id);
    if (found == m_clients.end())
        return;
    m_host.clientGone(id);
    // The connection may be the caller; it ends when the event loop is back.
    found->second.release()->deleteLater();
    m_clients.erase(found);
    emit clientsChanged();
}

void Server::closeAll()
{
    while (!m_clients.empty()) {
        m_clients.begin()->second->close();
        drop(m_clients.begin()->first);
    }
}

void Server::noteDropped(const std::string& who, const std::string& why)
{
    if (m_notesLeft <= 0)
        return;
    --m_notesLeft;
    m_host.note(diagnostic(Code::PeerDropped, {who, why}));
}

void Server::setHolder(ClientId id, const std::string& name)
{
    m_holder = id;
    m_holderName = name;
}

void Server::watchClients()
{
    m_notesLeft = std::min(m_notesLeft + NotesPerSecond * WatchPeriodMs / 1000, NotesPerSecond);
    std::vector<ClientId> ids;
    for (const auto& [id, connection] : m_clients)
        ids.push_back(id);
    for (const ClientId id : ids)
        if (ClientConnection* connection = client(id))
            connection->watch(std::chrono::milliseconds(WatchPeriodMs));
}

void Server::onStatus(const ControllerStatus& status, ClientId holder)
{
    setHolder(holder, status.controlOwner);
    m_lastStatus = status;
    for (const auto& [id, connection] : m_clients)
        connection->sendStatus(status, holder);
}

void Server::onUpdate(ClientId id, const message::Update& update)
{
    if (ClientConnection* connection = client(id))
        connection->sendUpdate(update);
}

void Server::onSamples(ClientId id, SampleBlock block)
{
    if (ClientConnection* connection = client(id))
        connection->sendSamples(std::move(block));
}

void Server::onBeat(ClientId id, std::uint64_t cycle)
{
    if (ClientConnection* connection = client(id))
        connection->sendBeat(cycle);
}

void Server::onLog(const LogEntry& entry)
{
    for (const auto& [id, connection] : m_clients)
        connection->sendLog(entry);
}

} // namespace camwright
