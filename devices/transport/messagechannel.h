#pragma once

#include "core/online/messages.h"
#include "devices/protocol/framing.h"
#include "devices/transport/bytestream.h"

#include <QObject>

#include <deque>
#include <functional>
#include <memory>
#include <string>

namespace camwright {

/// Messages over a byte stream. Urgent ones overtake everything that is not yet with the system, a whole frame at a time.
/// Reading takes turns with the rest of the event loop, so that one busy peer delays nobody.
class MessageChannel final : public QObject {
    Q_OBJECT
public:
    struct Listener {
        std::function<void(const Envelope&)> message;
        /// The channel is useless: the peer left, or sent what is no message (then `broken`). Called once, last.
        std::function<void(const std::string& reason, bool broken)> ended;
        std::function<void()> room; ///< waiting() became smaller; may be empty
    };

    MessageChannel(std::unique_ptr<ByteStream> stream, Listener listener, std::size_t frameLimit);
    ~MessageChannel() override;

    /// False, and nothing is sent, if the message is longer than a frame may be.
    bool send(const Envelope& envelope);
    std::size_t waiting() const { return m_waiting + m_stream->waiting(); } ///< bytes
    void setFrameLimit(std::size_t limit) { m_reader.setLimit(limit); }
    /// Stops and resumes reading; what the peer sends meanwhile waits on its side.
    void setPaused(bool paused);
    std::uint64_t messagesReceived() const { return m_received; }
    void close();
    std::string peer() const { return m_stream->peer().toStdString(); }

private:
    void readSome();
    void pump();
    void end(const std::string& reason, bool broken);

    std::unique_ptr<ByteStream> m_stream;
    Listener m_listener;
    FrameReader m_reader;
    std::deque<Bytes> m_urgent, m_ordinary;
    std::size_t m_waiting = 0;
    std::uint64_t m_received = 0;
    bool m_paused = false, m_ended = false, m_readScheduled = false;
};

} // namespace camwright
