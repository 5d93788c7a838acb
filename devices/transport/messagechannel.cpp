#include "devices/transport/messagechannel.h"

#include "devices/protocol/codec.h"

#include <QPointer>

namespace camwright {

namespace {
constexpr std::size_t ReadPortion = 16 * 1024; ///< bytes a turn
constexpr std::size_t StreamFill = 4096;       ///< handed to the stream ahead of what the system takes
} // namespace

MessageChannel::MessageChannel(std::unique_ptr<ByteStream> stream, Listener listener, std::size_t frameLimit)
    : m_stream(std::move(stream)), m_listener(std::move(listener)), m_reader(frameLimit)
{
    connect(m_stream.get(), &ByteStream::readable, this, &MessageChannel::readSome);
    connect(m_stream.get(), &ByteStream::written, this, [this] {
        pump();
        if (m_listener.room)
            m_listener.room();
    });
    connect(m_stream.get(), &ByteStream::closed, this, [this](const QString& reason) {
        // What came before the end still counts.
        QPointer<MessageChannel> alive(this);
        for (std::size_t before = m_received + 1; alive && !m_ended && !m_paused && before != m_received;) {
            before = m_received;
            readSome();
        }
        if (alive)
            end(reason.toStdString(), false);
    });
}

MessageChannel::~MessageChannel() = default;

bool MessageChannel::send(const Envelope& envelope)
{
    Bytes frame = frameOf(encode(envelope));
    if (frame.size() > FrameHeader + message::MaximumFrame)
        return false;
    if (m_ended)
        return true; // like everything that is on its way when a connection ends
    m_waiting += frame.size();
    (ruleOf(envelope.message).urgent ? m_urgent : m_ordinary).push_back(std::move(frame));
    pump();
    return true;
}

void MessageChannel::pump()
{
    while (!m_ended && m_stream->waiting() < StreamFill) {
        auto& queue = m_urgent.empty() ? m_ordinary : m_urgent;
        if (queue.empty())
            return;
        const Bytes frame = std::move(queue.front());
        queue.pop_front();
        m_waiting -= frame.size();
        m_stream->write(frame);
    }
}

void MessageChannel::setPaused(bool paused)
{
    m_paused = paused;
    if (!paused && !m_readScheduled) {
        m_readScheduled = true;
        QMetaObject::invokeMethod(this, [this] { m_readScheduled = false; readSome(); }, Qt::QueuedConnection);
    }
}

void MessageChannel::readSome()
{
    if (m_paused || m_ended)
        return;
    const Bytes bytes = m_stream->read(ReadPortion);
    m_reader.feed(bytes);
    const QPointer<MessageChannel> alive(this);
    while (alive && !m_ended && !m_paused) {
        auto body = m_reader.next();
        if (!body) {
            end(body.error(), true);
            return;
        }
        if (!*body)
            break;
        auto envelope = decode(**body);
        if (!envelope) {
            end(envelope.error(), true);
            return;
        }
        ++m_received;
        m_listener.message(*envelope);
    }
    if (alive && !bytes.empty() && !m_readScheduled) {
        m_readScheduled = true; // there may be more than one portion
        QMetaObject::invokeMethod(this, [this] { m_readScheduled = false; readSome(); }, Qt::QueuedConnection);
    }
}

void MessageChannel::end(const std::string& reason, bool broken)
{
    if (m_ended)
        return;
    m_ended = true;
    if (broken)
        m_stream->close();
    if (m_listener.ended)
        m_listener.ended(reason, broken);
}

void MessageChannel::close()
{
    m_ended = true;
    // What was sent last (a refusal, say) should still arrive.
    for (auto* queue : {&m_urgent, &m_ordinary}) {
        for (const Bytes& frame : *queue)
            m_stream->write(frame);
        queue->clear();
    }
    m_waiting = 0;
    m_stream->close();
}

} // namespace camwright
