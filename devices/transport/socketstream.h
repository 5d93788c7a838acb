#pragma once

#include "devices/transport/bytestream.h"

#include <memory>

class QIODevice;
class QLocalSocket;
class QTcpSocket;

namespace camwright {

/// A connected TCP or local (Unix) socket.
class SocketStream final : public ByteStream {
    Q_OBJECT
public:
    /// The sockets must be connected; the stream owns them from then on.
    explicit SocketStream(std::unique_ptr<QTcpSocket> socket);
    explicit SocketStream(std::unique_ptr<QLocalSocket> socket);
    ~SocketStream() override;

    void write(ByteSpan bytes) override;
    std::size_t waiting() const override;
    Bytes read(std::size_t maximum) override;
    void close() override;
    QString peer() const override { return m_peer; }

private:
    void watch();
    void end(const QString& reason);

    QIODevice* m_device = nullptr; ///< owned as a child
    QString m_peer;
    bool m_ended = false;
};

} // namespace camwright
