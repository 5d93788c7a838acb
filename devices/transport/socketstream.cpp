#include "devices/transport/socketstream.h"

#include "core/base/codes.h"

#include <QLocalSocket>
#include <QTcpSocket>

namespace camwright {

namespace {
// What the system and Qt may hold of a connection. Small, so that an urgent message is soon the next one on the line and
// a flood fills nobody's memory.
constexpr int SystemBuffer = 64 * 1024;
constexpr int ReadBuffer = 128 * 1024;
} // namespace

SocketStream::SocketStream(std::unique_ptr<QTcpSocket> socket)
{
    m_peer = QStringLiteral("%1:%2").arg(socket->peerAddress().toString()).arg(socket->peerPort());
    socket->setSocketOption(QAbstractSocket::LowDelayOption, 1);
    socket->setSocketOption(QAbstractSocket::SendBufferSizeSocketOption, SystemBuffer);
    socket->setReadBufferSize(ReadBuffer);
    QTcpSocket* tcp = socket.release();
    tcp->setParent(this);
    m_device = tcp;
    connect(tcp, &QTcpSocket::disconnected, this, [this] { end(QString::fromLatin1(CW_TEXT("Arguments", "the other side closed it"))); });
    connect(tcp, &QTcpSocket::errorOccurred, this, [this, tcp] { end(tcp->errorString()); });
    watch();
}

SocketStream::SocketStream(std::unique_ptr<QLocalSocket> socket)
{
    m_peer = QStringLiteral("local");
    socket->setReadBufferSize(ReadBuffer);
    QLocalSocket* local = socket.release();
    local->setParent(this);
    m_device = local;
    connect(local, &QLocalSocket::disconnected, this, [this] { end(QString::fromLatin1(CW_TEXT("Arguments", "the other side closed it"))); });
    connect(local, &QLocalSocket::errorOccurred, this, [this, local] { end(local->errorString()); });
    watch();
}

SocketStream::~SocketStream()
{
    m_ended = true;
}

void SocketStream::watch()
{
    connect(m_device, &QIODevice::readyRead, this, &ByteStream::readable);
    connect(m_device, &QIODevice::bytesWritten, this, &ByteStream::written);
    // Bytes may have come before anybody listened.
    QMetaObject::invokeMethod(this, &ByteStream::readable, Qt::QueuedConnection);
}

void SocketStream::end(const QString& reason)
{
    if (m_ended)
        return;
    m_ended = true;
    QMetaObject::invokeMethod(this, [this, reason] { emit closed(reason); }, Qt::QueuedConnection);
}

void SocketStream::write(ByteSpan bytes)
{
    if (!m_ended)
        m_device->write(reinterpret_cast<const char*>(bytes.data()), static_cast<qint64>(bytes.size()));
}

std::size_t SocketStream::waiting() const
{
    return static_cast<std::size_t>(m_device->bytesToWrite());
}

Bytes SocketStream::read(std::size_t maximum)
{
    Bytes out(std::min(maximum, static_cast<std::size_t>(std::max<qint64>(m_device->bytesAvailable(), 0))));
    const qint64 got = out.empty() ? 0 : m_device->read(reinterpret_cast<char*>(out.data()), static_cast<qint64>(out.size()));
    out.resize(static_cast<std::size_t>(std::max<qint64>(got, 0)));
    return out;
}

void SocketStream::close()
{
    m_ended = true;
    if (auto* tcp = qobject_cast<QTcpSocket*>(m_device)) {
        tcp->flush();
        tcp->disconnectFromHost();
    } else if (auto* local = qobject_cast<QLocalSocket*>(m_device)) {
        local->flush();
        local->disconnectFromServer();
    }
}

} // namespace camwright
