#include "devices/server/samplequeue.h"

#include <algorithm>

namespace camwright {

namespace {
std::size_t rowsOf(const SampleBlock& block)
{
    return block.columns.empty() ? 0 : block.columns.front().size();
}
} // namespace

void SampleQueue::add(SampleBlock block)
{
    if (!m_started || block.channelSet != m_channelSet) {
        *this = SampleQueue();
        m_started = true;
        m_channelSet = block.channelSet;
    }
    if (!block.channels.empty())
        m_channels = std::move(block.channels);
    block.channels.clear();
    m_rows += rowsOf(block);
    m_values += rowsOf(block) * block.columns.size();
    m_waiting.push_back(std::move(block));
    m_burst = 0;
    while (m_values > MaximumValues && m_waiting.size() > 1)
        dropOldest();
}

void SampleQueue::dropOldest()
{
    const SampleBlock& oldest = m_waiting.front();
    m_rows -= rowsOf(oldest);
    m_values -= rowsOf(oldest) * oldest.columns.size();
    m_lost += rowsOf(oldest) + oldest.lostRows;
    // What is said once must not fall out with the rows.
    SampleBlock& next = m_waiting[1];
    next.triggerCycle = std::max(next.triggerCycle, oldest.triggerCycle);
    next.last = next.last || oldest.last;
    m_waiting.pop_front();
}

SampleBlock SampleQueue::cutFront(std::size_t rows)
{
    SampleBlock& front = m_waiting.front();
    const std::size_t all = rowsOf(front);
    if (rows >= all) {
        SampleBlock out = std::move(front);
        m_waiting.pop_front();
        return out;
    }
    SampleBlock out = front;
    const auto cut = static_cast<std::ptrdiff_t>(rows);
    for (auto& column : out.columns)
        column.resize(rows);
    for (auto& column : front.columns)
        column.erase(column.begin(), column.begin() + cut);
    out.last = false;
    front.firstCycle += static_cast<std::uint64_t>(rows) * front.stride;
    front.lostRows = 0;
    return out;
}

std::optional<SampleBlock> SampleQueue::next()
{
    // In pairs: after the first of a pair is taken the second is waited for, and the time between tells the line's speed.
    if (m_waiting.empty() || m_firstTaken || m_nextSequence - m_takenSequences >= message::PiecesInFlight)
        return std::nullopt;
    const std::size_t rowBytes = std::max<std::size_t>(m_waiting.front().columns.size(), 1) * sizeof(double);
    SampleBlock out = cutFront(std::max<std::size_t>(m_sizer.size() / rowBytes, 1));
    m_rows -= rowsOf(out);
    m_values -= rowsOf(out) * out.columns.size();
    m_lastPiece = std::max<std::size_t>(rowsOf(out) * rowBytes, 1);
    out.lostRows += m_lost;
    m_lost = 0;
    out.sequence = m_nextSequence++;
    m_isPair = ++m_burst == message::PiecesInFlight;
    out.channels = std::move(m_channels);
    m_channels.clear();
    return out;
}

void SampleQueue::taken(std::uint32_t channelSet, std::uint64_t sequence, Time now)
{
    if (channelSet != m_channelSet || sequence < m_takenSequences || sequence >= m_nextSequence)
        return;
    m_takenSequences = sequence + 1;
    m_burst = 0;
    if (m_takenSequences != m_nextSequence) {
        if (m_isPair)
            m_firstTaken = now;
    } else if (m_firstTaken) {
        m_sizer.onPair(m_lastPiece, now - *m_firstTaken);
        m_firstTaken.reset();
    }
}

} // namespace camwright
