#pragma once

#include "devices/transport/bytestream.h"

#include <QPointer>

#include <cstdint>
#include <limits>
#include <memory>
#include <utility>

namespace camwright {

/// Two ends of a connection inside one thread, for tests: real bytes, no socket. It can be cut at any byte.
class MemoryStream final : public ByteStream {
    Q_OBJECT
public:
    static std::pair<std::unique_ptr<MemoryStream>, std::unique_ptr<MemoryStream>> pair();
    ~MemoryStream() override;

    /// After this many more bytes have left this end the line is cut: the rest is lost and both ends are told.
    void cutAfter(std::uint64_t bytes) { m_left = bytes; }
    std::uint64_t bytesSent() const { return m_sent; }

    void write(ByteSpan bytes) override;
    std::size_t waiting() const override { return 0; }
    Bytes read(std::size_t maximum) override;
    void close() override;
    QString peer() const override { return QStringLiteral("memory"); }

private:
    MemoryStream() = default;
    void breakOff(const QString& reason);

    QPointer<MemoryStream> m_other;
    Bytes m_arrived;
    std::uint64_t m_left = std::numeric_limits<std::uint64_t>::max();
    std::uint64_t m_sent = 0;
    bool m_ended = false;
};

} // namespace camwright
