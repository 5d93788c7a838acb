#include "devices/transport/memorystream.h"

#include <algorithm>

namespace camwright {

std::pair<std::unique_ptr<MemoryStream>, std::unique_ptr<MemoryStream>> MemoryStream::pair()
{
    std::unique_ptr<MemoryStream> a(new MemoryStream), b(new MemoryStream);
    a->m_other = b.get();
    b->m_other = a.get();
    return {std::move(a), std::move(b)};
}

MemoryStream::~MemoryStream()
{
    close();
}

void MemoryStream::write(ByteSpan bytes)
{
    if (m_ended || !m_other)
        return;
    const auto taken = static_cast<std::size_t>(std::min<std::uint64_t>(bytes.size(), m_left));
    m_left -= taken;
    m_sent += taken;
    m_other->m_arrived.insert(m_other->m_arrived.end(), bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(taken));
    QMetaObject::invokeMethod(m_other, &ByteStream::readable, Qt::QueuedConnection);
    QMetaObject::invokeMethod(this, &ByteStream::written, Qt::QueuedConnection);
    if (m_left == 0) {
        m_other->breakOff(QStringLiteral("the line was cut"));
        breakOff(QStringLiteral("the line was cut"));
    }
}

Bytes MemoryStream::read(std::size_t maximum)
{
    const auto size = static_cast<std::ptrdiff_t>(std::min(maximum, m_arrived.size()));
    Bytes out(m_arrived.begin(), m_arrived.begin() + size);
    m_arrived.erase(m_arrived.begin(), m_arrived.begin() + size);
    return out;
}

void MemoryStream::breakOff(const QString& reason)
{
    if (m_ended)
        return;
    m_ended = true;
    QMetaObject::invokeMethod(this, [this, reason] { emit closed(reason); }, Qt::QueuedConnection);
}

void MemoryStream::close()
{
    m_ended = true;
    if (m_other)
        m_other->breakOff(QStringLiteral("the other side closed it"));
}

} // namespace camwright
