#include "devices/session/connectors.h"

#include "core/base/codes.h"
#include "devices/transport/socketstream.h"

#include <QTcpSocket>

namespace camwright {

namespace {
constexpr int TimeoutMs = 5000;
} // namespace

TcpConnector::TcpConnector(std::string address, QString host, std::uint16_t port)
    : m_address(std::move(address)), m_host(std::move(host)), m_port(port)
{
    m_timeout.setSingleShot(true);
    QObject::connect(&m_timeout, &QTimer::timeout, &m_context, [this] { finish(QString::fromLatin1(CW_TEXT("Arguments", "no answer within 5 s"))); });
}

TcpConnector::~TcpConnector() = default;

void TcpConnector::open(Opened opened)
{
    m_opened = std::move(opened);
    m_socket = std::make_unique<QTcpSocket>();
    QTcpSocket* socket = m_socket.get();
    QObject::connect(socket, &QTcpSocket::connected, &m_context, [this] { finish({}); }, Qt::QueuedConnection);
    QObject::connect(socket, &QTcpSocket::errorOccurred, &m_context, [this, socket] { finish(socket->errorString()); },
                     Qt::QueuedConnection);
    m_timeout.start(TimeoutMs);
    socket->connectToHost(m_host, m_port);
}

void TcpConnector::finish(const QString& error)
{
    if (!m_opened)
        return;
    m_timeout.stop();
    const Opened opened = std::move(m_opened);
    m_opened = nullptr;
    std::unique_ptr<QTcpSocket> socket = std::move(m_socket);
    QObject::disconnect(socket.get(), nullptr, &m_context, nullptr);
    if (error.isEmpty()) {
        opened(std::unique_ptr<ByteStream>(std::make_unique<SocketStream>(std::move(socket))));
    } else {
        socket.release()->deleteLater();
        opened(diagnostic(Code::CannotConnect, {m_address, error.toStdString()}));
    }
}

} // namespace camwright
