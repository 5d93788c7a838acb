#include "core/runtime/plant/canwire.h"

#include "core/fieldbus/canbits.h"
#include "core/fieldbus/framebytes.h"

#include <algorithm>
#include <cassert>

namespace camwright {

namespace {

constexpr std::int64_t kWindow = 100'000'000; ///< ns over which the load is counted

} // namespace

CanWire::CanWire(std::uint32_t baudrate) : m_baudrate(baudrate) { assert(baudrate > 0); }

bool CanWire::Node::send(const CanFrame& frame)
{
    assert(frame.length <= 8);
    if (queue.size() >= length) {
        ++wire->m_counters.refused;
        return false;
    }
    queue.push_back(frame);
    return true;
}

/// A frame that is on the wire already ends first.
bool CanWire::Node::sendFirst(const CanFrame& frame)
{
    assert(frame.length <= 8);
    const bool onWire = wire->m_busy && wire->m_nodes[wire->m_sender].get() == this && !queue.empty();
    const auto waiting = queue.begin() + (onWire ? 1 : 0);
    const auto stale = [&](const CanFrame& other) { return other.id == frame.id && other.extended == frame.extended; };
    queue.erase(std::remove_if(waiting, queue.end(), stale), queue.end());
    queue.insert(queue.begin() + (onWire ? 1 : 0), frame);
    return true;
}

unsigned CanWire::addNode(unsigned queueLength)
{
    auto node = std::make_unique<Node>();
    node->wire = this;
    node->length = queueLength;
    m_nodes.push_back(std::move(node));
    return nodeCount() - 1;
}

CanPort& CanWire::port(unsigned node) { return *m_nodes[node]; }

unsigned CanWire::queued(unsigned node) const { return static_cast<unsigned>(m_nodes[node]->queue.size()); }

bool CanWire::isIdle() const
{
    return !m_busy && std::all_of(m_nodes.begin(), m_nodes.end(), [](const auto& node) { return !node->connected || node->queue.empty(); });
}

/// Arbitration among the heads of all queues. Two nodes with the same identifier collide on a real bus; here the first wins.
bool CanWire::startFrame()
{
    std::uint32_t best = 0xFFFFFFFF;
    bool found = false;
    for (unsigned i = 0; i < m_nodes.size(); ++i) {
        const Node& node = *m_nodes[i];
        if (!node.connected || node.queue.empty())
            continue;
        const std::uint32_t key = arbitrationKey(node.queue.front());
        if (!found || key < best) {
            best = key;
            m_sender = i;
            found = true;
        }
    }
    if (!found)
        return false;
    Node& sender = *m_nodes[m_sender];
    // A repetition has the length it had before.
    if (m_frameBits == 0 || m_frame != sender.queue.front()) {
        m_frame = sender.queue.front();
        m_frameBits = frameBits(m_frame);
    }
    m_busy = true;
    m_frameEnd = m_now + bitTime(m_frameBits, m_baudrate);
    return true;
}

void CanWire::endFrame(const Deliver& deliver)
{
    m_busy = false;
    ++m_counters.frames;
    m_counters.bits += m_frameBits;
    Node& sender = *m_nodes[m_sender];
    if (sender.queue.empty() || sender.queue.front() != m_frame)
        return; // taken back while it was on the wire
    const bool heard = std::any_of(m_nodes.begin(), m_nodes.end(), [&](const auto& node) { return node.get() != &sender && node->connected; });
    if (!sender.connected || !heard) {
        ++m_counters.repeated;
        return;
    }
    sender.queue.pop_front();
    if (sender.toLose > 0) {
        --sender.toLose;
        ++m_counters.lost;
        return;
    }
    const CanFrame frame = m_frame;
    const unsigned from = m_sender;
    for (unsigned i = 0; i < m_nodes.size(); ++i) {
        if (i != from && m_nodes[i]->connected)
            deliver(i, frame, m_now);
    }
}

void CanWire::advance(Time until, const Deliver& deliver)
{
    while (m_now < until) {
        if (!m_busy && !startFrame()) {
            m_now = until;
            break;
        }
        const Time end = std::min(m_frameEnd, until);
        countBusy(m_now, end);
        m_now = end;
        if (m_now == m_frameEnd)
            endFrame(deliver);
    }
    rollWindows(m_now);
}

void CanWire::rollWindows(Time now)
{
    const std::int64_t number = now.count() / kWindow;
    if (number - m_window > static_cast<std::int64_t>(m_windows.size())) {
        m_windows.fill(0);
        m_windowBusy = 0;
        m_window = number;
    }
    while (m_window < number) {
        m_windows[static_cast<std::size_t>(m_window) % m_windows.size()] = m_windowBusy;
        m_windowBusy = 0;
        ++m_window;
    }
}

void CanWire::countBusy(Time from, Time to)
{
    rollWindows(from);
    const Time border((m_window + 1) * kWindow);
    if (to <= border) {
        m_windowBusy += (to - from).count();
        return;
    }
    m_windowBusy += (border - from).count();
    countBusy(border, to);
}

double CanWire::load() const
{
    std::int64_t busy = 0;
    for (const std::int64_t window : m_windows)
        busy += window;
    return static_cast<double>(busy) / static_cast<double>(kWindow * static_cast<std::int64_t>(m_windows.size()));
}

void CanWire::setConnected(unsigned node, bool connected) { m_nodes[node]->connected = connected; }
void CanWire::clearQueue(unsigned node) { m_nodes[node]->queue.clear(); }
void CanWire::loseFrames(unsigned node, unsigned count) { m_nodes[node]->toLose = count; }

void CanWire::save(ByteWriter& writer) const
{
    writer.put(static_cast<std::uint32_t>(m_nodes.size()));
    for (const auto& node : m_nodes) {
        writer.put(static_cast<std::uint32_t>(node->queue.size()));
        for (const CanFrame& frame : node->queue)
            write(writer, frame);
        writer.put(node->toLose);
        writer.put(node->connected);
    }
    writer.put(m_now.count());
    writer.put(m_busy);
    writer.put(m_sender);
    write(writer, m_frame);
    writer.put(m_frameBits);
    writer.put(m_frameEnd.count());
    for (const std::uint64_t counter : {m_counters.frames, m_counters.bits, m_counters.repeated, m_counters.lost, m_counters.refused})
        writer.put(counter);
    for (const std::int64_t window : m_windows)
        writer.put(window);
    writer.put(m_window);
    writer.put(m_windowBusy);
}

void CanWire::restore(ByteReader& reader)
{
    if (reader.get<std::uint32_t>() != m_nodes.size())
        return reader.fail();
    for (const auto& node : m_nodes) {
        node->queue.clear();
        const auto count = reader.get<std::uint32_t>();
        for (std::uint32_t i = 0; i < count && reader.ok(); ++i)
            node->queue.push_back(readCanFrame(reader));
        node->toLose = reader.get<unsigned>();
        node->connected = reader.getBool();
    }
    m_now = Time(reader.get<std::int64_t>());
    m_busy = reader.getBool();
    m_sender = reader.get<unsigned>();
    m_frame = readCanFrame(reader);
    m_frameBits = reader.get<unsigned>();
    m_frameEnd = Time(reader.get<std::int64_t>());
    for (std::uint64_t* counter : {&m_counters.frames, &m_counters.bits, &m_counters.repeated, &m_counters.lost, &m_counters.refused})
        *counter = reader.get<std::uint64_t>();
    for (std::int64_t& window : m_windows)
        window = reader.get<std::int64_t>();
    m_window = reader.get<std::int64_t>();
    m_windowBusy = reader.get<std::int64_t>();
    if (m_sender >= std::max<std::size_t>(m_nodes.size(), 1)) {
        m_sender = 0;
        reader.fail();
    }
}

} // namespace camwright
