#pragma once

#include "core/base/bytes.h"
#include "core/base/result.h"

#include <cstddef>
#include <optional>

namespace camwright {

/// A frame is a length of four bytes, most significant first, and that many bytes.
inline constexpr std::size_t FrameHeader = 4;

Bytes frameOf(ByteSpan body);

/// Cuts a stream of bytes into frames. It holds no more than has arrived, whatever length is announced, and stops for good
/// at the first length that is zero or beyond the limit.
class FrameReader {
public:
    explicit FrameReader(std::size_t limit) : m_limit(limit) {}

    void setLimit(std::size_t limit) { m_limit = limit; } ///< for frames whose length has not been looked at yet
    void feed(ByteSpan bytes);
    /// The next whole frame's body; nothing yet; or why the stream is no longer readable, in English.
    Result<std::optional<Bytes>, std::string> next();
    bool isInsideFrame() const { return m_buffer.size() > m_position; }

private:
    std::size_t m_limit;
    Bytes m_buffer;
    std::size_t m_position = 0; ///< of the first byte not handed out yet
    bool m_broken = false;
};

} // namespace camwright
