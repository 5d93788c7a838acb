#include "core/online/tracebuffer.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace camwright {

namespace {
/// Wide enough for cycles times columns.
__extension__ using Wide = unsigned __int128;
} // namespace

void TraceBuffer::Extremes::add(double value)
{
    // Comparisons with NaN are false, so that NaN is left out.
    if (value < minimum)
        minimum = value;
    if (value > maximum)
        maximum = value;
}

void TraceBuffer::Extremes::add(const Extremes& other)
{
    minimum = std::min(minimum, other.minimum);
    maximum = std::max(maximum, other.maximum);
}

TraceBuffer::TraceBuffer(std::uint64_t maximumRows) : m_maximumRows(maximumRows) {}

void TraceBuffer::clear()
{
    *this = TraceBuffer(m_maximumRows);
}

bool TraceBuffer::append(const SampleBlock& block)
{
    if (!m_started || block.channelSet != m_channelSet) {
        clear();
        m_started = true;
        m_channelSet = block.channelSet;
        m_series.resize(block.columns.size());
        m_nextSequence = block.sequence;
    }
    const std::size_t rows = block.columns.empty() ? 0 : block.columns.front().size();
    const bool even = std::all_of(block.columns.begin(), block.columns.end(), [rows](const auto& c) { return c.size() == rows; });
    if (!even || block.columns.size() != m_series.size() || block.stride == 0)
        return false;
    if (rows > 0 && !m_segments.empty() && block.firstCycle <= lastCycle())
        return false;
    if (!block.channels.empty())
        m_channels = block.channels;
    m_cycleNs = block.cycleNs;
    m_lostRows += block.lostRows;
    if (block.triggerCycle >= 0)
        m_triggerCycle = block.triggerCycle;
    m_complete = m_complete || block.last;
    if (rows > 0)
        addSegment(block, rows);
    for (std::size_t i = 0; i < m_series.size(); ++i)
        for (const double value : block.columns[i])
            appendValue(m_series[i], value);
    m_endRow += rows;
    m_nextSequence = block.sequence + 1;
    dropOldChunks();
    return true;
}

void TraceBuffer::addSegment(const SampleBlock& block, std::uint64_t rows)
{
    if (!m_segments.empty()) {
        Segment& newest = m_segments.back();
        const bool follows = block.sequence == m_nextSequence && block.lostRows == 0 && block.stride == newest.stride
            && block.firstCycle == newest.cycleOf(newest.endRow());
        if (follows) {
            newest.rows += rows;
            return;
        }
    }
    m_segments.push_back({m_endRow, rows, block.firstCycle, block.stride});
}

void TraceBuffer::appendValue(Series& series, double value) const
{
    if (series.chunks.empty() || series.chunks.back()->raw.size() == ChunkRows)
        series.chunks.push_back(std::make_unique<Chunk>());
    Chunk& chunk = *series.chunks.back();
    std::uint64_t node = chunk.raw.size();
    chunk.raw.push_back(value);
    for (auto& level : chunk.levels) {
        node /= Fan;
        if (node == level.size())
            level.emplace_back();
        level[node].add(value);
    }
}

void TraceBuffer::dropOldChunks()
{
    if (m_maximumRows == 0)
        return;
    while (rows() > m_maximumRows && (m_firstChunk + 1) * ChunkRows <= m_endRow - std::min(m_endRow, m_maximumRows)) {
        for (Series& series : m_series)
            series.chunks.erase(series.chunks.begin());
        ++m_firstChunk;
        m_firstRow = m_firstChunk * ChunkRows;
    }
    while (!m_segments.empty() && m_segments.front().endRow() <= m_firstRow)
        m_segments.erase(m_segments.begin());
    if (!m_segments.empty() && m_segments.front().firstRow < m_firstRow) {
        Segment& oldest = m_segments.front();
        oldest.firstCycle = oldest.cycleOf(m_firstRow);
        oldest.rows = oldest.endRow() - m_firstRow;
        oldest.firstRow = m_firstRow;
    }
}

std::uint64_t TraceBuffer::firstCycle() const
{
    assert(!m_segments.empty());
    return m_segments.front().firstCycle;
}

std::uint64_t TraceBuffer::lastCycle() const
{
    assert(!m_segments.empty());
    return m_segments.back().cycleOf(m_segments.back().endRow() - 1);
}

const TraceBuffer::Chunk& TraceBuffer::chunkOf(const Series& series, std::uint64_t row) const
{
    return *series.chunks[static_cast<std::size_t>(row / ChunkRows - m_firstChunk)];
}

double TraceBuffer::value(std::size_t channel, std::uint64_t row) const
{
    assert(row >= m_firstRow && row < m_endRow);
    return chunkOf(m_series[channel], row).raw[static_cast<std::size_t>(row % ChunkRows)];
}

TraceBuffer::Extremes TraceBuffer::extremesInChunk(const Chunk& chunk, std::uint64_t from, std::uint64_t to)
{
    Extremes out;
    // Climb: whole nodes in the middle are left to the next level, single ones at both ends are taken here.
    for (std::size_t level = 0; from < to; ++level) {
        const auto take = [&](std::uint64_t i) {
            if (level == 0)
                out.add(chunk.raw[static_cast<std::size_t>(i)]);
            else
                out.add(chunk.levels[level - 1][static_cast<std::size_t>(i)]);
        };
        if (level == ChunkLevels) {
            for (; from < to; ++from)
                take(from);
            break;
        }
        for (; from < to && from % Fan != 0; ++from)
            take(from);
        for (; from < to && to % Fan != 0; --to)
            take(to - 1);
        from /= Fan;
        to /= Fan;
    }
    return out;
}

TraceBuffer::Extremes TraceBuffer::extremesOf(const Series& series, std::uint64_t from, std::uint64_t to) const
{
    Extremes out;
    while (from < to) {
        const std::uint64_t base = from / ChunkRows * ChunkRows;
        const std::uint64_t end = std::min(to, base + ChunkRows);
        const Chunk& chunk = chunkOf(series, from);
        if (from == base && end == base + ChunkRows)
            out.add(chunk.levels.back().front());
        else
            out.add(extremesInChunk(chunk, from - base, end - base));
        from = end;
    }
    return out;
}

void TraceBuffer::addRows(const Series& series, std::uint64_t from, std::uint64_t to, TraceColumn& column) const
{
    const Extremes found = extremesOf(series, from, to);
    if (found.minimum > found.maximum)
        return; // all NaN
    const auto at = [&](std::uint64_t row) { return chunkOf(series, row).raw[static_cast<std::size_t>(row % ChunkRows)]; };
    std::uint64_t first = from;
    while (std::isnan(at(first)))
        ++first;
    std::uint64_t last = to - 1;
    while (std::isnan(at(last)))
        --last;
    if (column.empty) {
        column.first = at(first);
        column.minimum = found.minimum;
        column.maximum = found.maximum;
    } else {
        column.gap = true;
        column.minimum = std::min(column.minimum, found.minimum);
        column.maximum = std::max(column.maximum, found.maximum);
    }
    column.empty = false;
    column.last = at(last);
}

namespace {

/// First cycle of column i: the smallest c with (c − from) · count / (to − from) >= i.
std::uint64_t columnStart(std::uint64_t from, std::uint64_t span, std::uint64_t count, std::uint64_t i)
{
    const auto product = static_cast<Wide>(i) * span;
    return from + static_cast<std::uint64_t>((product + count - 1) / count);
}

} // namespace

std::vector<TraceColumn> TraceBuffer::columns(std::size_t channel, std::uint64_t from, std::uint64_t to, std::size_t count) const
{
    std::vector<TraceColumn> out(count);
    if (to <= from || channel >= m_series.size())
        return out;
    const Series& series = m_series[channel];
    for (const Segment& segment : m_segments) {
        const std::uint64_t segmentEnd = segment.cycleOf(segment.endRow() - 1) + 1;
        if (segmentEnd <= from || segment.firstCycle >= to)
            continue;
        const auto rowAt = [&](std::uint64_t cycle) { // the first row of the segment at or after a cycle
            if (cycle <= segment.firstCycle)
                return segment.firstRow;
            return std::min(segment.firstRow + (cycle - segment.firstCycle + segment.stride - 1) / segment.stride, segment.endRow());
        };
        const std::uint64_t span = to - from;
        std::uint64_t i = segment.firstCycle <= from ? 0
            : static_cast<std::uint64_t>(static_cast<Wide>(segment.firstCycle - from) * count / span);
        bool startsHere = segment.firstRow > m_firstRow && segment.firstCycle >= from;
        for (; i < count; ++i) {
            const std::uint64_t begin = rowAt(columnStart(from, span, count, i));
            const std::uint64_t end = rowAt(columnStart(from, span, count, i + 1));
            if (begin >= segment.endRow())
                break;
            if (begin >= end)
                continue;
            addRows(series, begin, end, out[i]);
            out[i].gap = out[i].gap || startsHere;
            startsHere = false;
        }
    }
    return out;
}

std::optional<double> TraceBuffer::valueAt(std::size_t channel, std::uint64_t cycle) const
{
    const auto after = std::upper_bound(m_segments.begin(), m_segments.end(), cycle,
        [](std::uint64_t c, const Segment& segment) { return c < segment.firstCycle; });
    if (after == m_segments.begin() || channel >= m_series.size())
        return std::nullopt;
    const Segment& segment = *std::prev(after);
    const std::uint64_t row = segment.firstRow + (cycle - segment.firstCycle) / segment.stride;
    if (row >= segment.endRow())
        return std::nullopt;
    return value(channel, row);
}

} // namespace camwright
