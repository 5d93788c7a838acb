#include "devices/protocol/framing.h"

namespace camwright {

Bytes frameOf(ByteSpan body)
{
    Bytes out;
    out.reserve(FrameHeader + body.size());
    for (int shift = 24; shift >= 0; shift -= 8)
        out.push_back(static_cast<std::uint8_t>(body.size() >> shift));
    out.insert(out.end(), body.begin(), body.end());
    return out;
}

void FrameReader::feed(ByteSpan bytes)
{
    if (m_broken)
        return;
    if (m_position == m_buffer.size()) {
        m_buffer.clear();
        m_position = 0;
    } else if (m_position > 4096) {
        m_buffer.erase(m_buffer.begin(), m_buffer.begin() + static_cast<std::ptrdiff_t>(m_position));
        m_position = 0;
    }
    m_buffer.insert(m_buffer.end(), bytes.begin(), bytes.end());
}

Result<std::optional<Bytes>, std::string> FrameReader::next()
{
    if (m_broken)
        return std::string("the stream is broken");
    const std::size_t available = m_buffer.size() - m_position;
    if (available < FrameHeader)
        return std::optional<Bytes>();
    std::size_t length = 0;
    for (std::size_t i = 0; i < FrameHeader; ++i)
        length = length << 8 | m_buffer[m_position + i];
    if (length == 0 || length > m_limit) {
        m_broken = true;
        m_buffer = {};
        m_position = 0;
        return "a frame of " + std::to_string(length) + " bytes, where 1 to " + std::to_string(m_limit) + " are allowed";
    }
    if (available < FrameHeader + length)
        return std::optional<Bytes>();
    const auto begin = m_buffer.begin() + static_cast<std::ptrdiff_t>(m_position + FrameHeader);
    m_position += FrameHeader + length;
    return std::optional<Bytes>(Bytes(begin, begin + static_cast<std::ptrdiff_t>(length)));
}

} // namespace camwright
