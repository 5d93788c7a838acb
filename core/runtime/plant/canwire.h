#pragma once

#include "core/base/bytes.h"
#include "core/base/time.h"
#include "core/fieldbus/canframe.h"

#include <array>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <vector>

namespace camwright {

struct WireCounters {
    std::uint64_t frames = 0;    ///< carried, lost ones included
    std::uint64_t bits = 0;      ///< of all frames, repetitions included
    std::uint64_t repeated = 0;  ///< nobody acknowledged: sent again
    std::uint64_t lost = 0;      ///< by fault injection
    std::uint64_t refused = 0;   ///< the sender's queue was full
};

/// A simulated CAN bus: nodes with bounded send queues (first in, first out), arbitration by identifier, each frame
/// occupying its exact bits at the baud rate and delivered to all other connected nodes at its end. A frame that no other
/// node is there to acknowledge is repeated without end, as a controller on a cut cable does, until the queue is full.
class CanWire {
public:
    /// Called at the frame's end for every receiver, in the order of the nodes. It may send.
    using Deliver = std::function<void(unsigned node, const CanFrame& frame, Time at)>;

    explicit CanWire(std::uint32_t baudrate); ///< bit/s, not 0
    CanWire(const CanWire&) = delete;
    CanWire& operator=(const CanWire&) = delete;

    unsigned addNode(unsigned queueLength = 64);
    unsigned nodeCount() const { return static_cast<unsigned>(m_nodes.size()); }
    CanPort& port(unsigned node);
    void advance(Time until, const Deliver& deliver);

    Time now() const { return m_now; }
    std::uint32_t baudrate() const { return m_baudrate; }
    bool isIdle() const;
    unsigned queued(unsigned node) const;
    const WireCounters& counters() const { return m_counters; }
    /// Share of the last 10 finished tenths of a second in which the wire was busy, 0 … 1.
    double load() const;

    /// Fault injection. A disconnected node hears nothing and its frames wait; `clearQueue` drops what waits.
    void setConnected(unsigned node, bool connected);
    bool isConnected(unsigned node) const { return m_nodes[node]->connected; }
    void clearQueue(unsigned node);
    /// The next `count` frames of the node take their time on the wire and reach nobody.
    void loseFrames(unsigned node, unsigned count);

    void save(ByteWriter& writer) const;
    void restore(ByteReader& reader);

private:
    struct Node final : CanPort {
        bool send(const CanFrame& frame) override;
        bool sendFirst(const CanFrame& frame) override;
        CanWire* wire = nullptr;
        std::deque<CanFrame> queue;
        unsigned length = 64;
        unsigned toLose = 0;
        bool connected = true;
    };
    bool startFrame();
    void endFrame(const Deliver& deliver);
    void countBusy(Time from, Time to);
    void rollWindows(Time now);

    std::uint32_t m_baudrate;
    std::vector<std::unique_ptr<Node>> m_nodes;
    Time m_now{0};
    bool m_busy = false;
    unsigned m_sender = 0;
    CanFrame m_frame{};
    unsigned m_frameBits = 0;
    Time m_frameEnd{0};
    WireCounters m_counters;
    std::array<std::int64_t, 10> m_windows{};  ///< busy ns of the last finished tenths
    std::int64_t m_window = 0;                 ///< number of the present tenth
    std::int64_t m_windowBusy = 0;
};

} // namespace camwright
