#pragma once

#include "core/base/result.h"
#include "devices/controller/controllerhost.h"
#include "devices/transport/bytestream.h"

#include <QObject>

#include <atomic>
#include <map>
#include <memory>
#include <string>

class QLocalServer;
class QTcpServer;
class QTimer;

namespace camwright {

class ClientConnection;

struct ServerOptions {
    std::string name = "camwright-runtime";
    bool mayExit = false;            ///< a local virtual controller: `exit` is accepted (CONTRACTS 14)
    std::size_t maximumClients = 32;
    Time handshakeTime = 2s;         ///< from the connection to `authenticate`
    Time silence = 10s;              ///< without a whole message from an authenticated client
    std::size_t messagesPerSecond = 4000; ///< of one client; more waits in its own socket
};

/// Offers a ControllerHost on sockets, one ClientConnection a client. Lives on one thread with a Qt event loop. Whatever
/// clients send, it holds a bounded amount of memory for each and never touches the thread of the scan.
class Server final : public QObject, private HostListener {
    Q_OBJECT
public:
    explicit Server(ControllerHost& host, ServerOptions options = {});
    ~Server() override;

    /// "127.0.0.1:17402", "[::1]:0"; port 0 takes a free one. Refuses every address but this machine's own.
    Result<void> listen(const std::string& address);
    /// A local socket that only this user can open; a stale one is replaced.
    Result<void> listenLocally(const std::string& path);
    std::uint16_t port() const;
    /// Takes an open connection, whatever carries it.
    void accept(std::unique_ptr<ByteStream> stream);
    std::size_t clientCount() const { return m_clients.size(); }
    void closeAll();

    // --- for connections ---
    ControllerHost& host() { return m_host; }
    const ServerOptions& options() const { return m_options; }
    ClientConnection* client(ClientId id) const;
    void drop(ClientId id);                     ///< the connection is gone; may be called from inside it
    void noteDropped(const std::string& who, const std::string& why);
    const ControllerStatus& lastStatus() const { return m_lastStatus; }
    ClientId holder() const { return m_holder; }
    const std::string& holderName() const { return m_holderName; }
    void setHolder(ClientId id, const std::string& name);
    void requestExit() { emit exitRequested(); }

signals:
    void exitRequested();
    void clientsChanged(); ///< clientCount() is another

private:
    void onStatus(const ControllerStatus& status, ClientId holder) override;
    void onUpdate(ClientId client, const message::Update& update) override;
    void onSamples(ClientId client, SampleBlock block) override;
    void onBeat(ClientId client, std::uint64_t cycle) override;
    void onLog(const LogEntry& entry) override;
    void watchClients();

    ControllerHost& m_host;
    ServerOptions m_options;
    std::unique_ptr<QTcpServer> m_tcp;
    std::unique_ptr<QLocalServer> m_local;
    std::unique_ptr<QTimer> m_watch;
    std::map<ClientId, std::unique_ptr<ClientConnection>> m_clients;
    ClientId m_nextClient = 1;
    ControllerStatus m_lastStatus;
    ClientId m_holder = 0;
    std::string m_holderName;
    int m_notesLeft = 0; ///< log entries about dropped peers in this second
    std::shared_ptr<std::atomic<bool>> m_woken;
};

} // namespace camwright
