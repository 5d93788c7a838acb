#pragma once

#include "devices/session/onlinesession.h"

#include <QObject>
#include <QString>
#include <QTimer>

#include <memory>

class QLocalSocket;
class QTcpSocket;

namespace camwright {

/// `tcp://HOST[:PORT]`.
class TcpConnector final : public Connector {
public:
    TcpConnector(std::string address, QString host, std::uint16_t port);
    ~TcpConnector() override;
    void open(Opened opened) override;
    std::string address() const override { return m_address; }

private:
    void finish(const QString& error);

    std::string m_address;
    QString m_host;
    std::uint16_t m_port;
    QObject m_context; ///< its end forbids every call on its way
    QTimer m_timeout;
    std::unique_ptr<QTcpSocket> m_socket;
    Opened m_opened;
};

/// `local`: finds the virtual controller of a project by its socket file, and starts it the first time it is not there
/// (CONTRACTS 14). A controller that went away later is not started again by itself: its program and axes are gone too.
class LocalConnector final : public Connector {
public:
    struct Paths {
        QString socket; ///< the socket file
        QString data;   ///< the controller's folder
    };
    /// Where a project's controller is found; makes the folders. An error if there is no private folder to be had.
    static Result<Paths> pathsFor(const std::string& projectPath);

    LocalConnector(Paths paths, QString program);
    ~LocalConnector() override;
    void open(Opened opened) override;
    std::string address() const override { return "local"; }

private:
    void attempt();
    void failed();
    void end(Result<std::unique_ptr<ByteStream>> result);

    Paths m_paths;
    QString m_program;
    QObject m_context;
    QTimer m_retry;
    std::unique_ptr<QLocalSocket> m_socket;
    Opened m_opened;
    bool m_started = false;
    int m_attemptsLeft = 0;
};

} // namespace camwright
