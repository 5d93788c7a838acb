#pragma once

#include "core/online/sampleblock.h"

#include <array>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace camwright {

/// What one pixel column of a curve needs to know of the samples behind it.
struct TraceColumn {
    bool empty = true;          ///< no sample lies in it
    bool gap = false;           ///< the line must not be joined to the column before, or is torn inside
    double minimum = 0, maximum = 0, first = 0, last = 0; ///< NaN samples are left out; all NaN counts as empty
    bool operator==(const TraceColumn&) const = default;
};

/// The samples of one recording (CONTRACTS 17). Appending costs the same however much there is; a query of n columns looks
/// at a few nodes of a pyramid of extremes each, never at all samples. Gaps stay visible as gaps.
class TraceBuffer {
public:
    /// Rows kept at most; older ones fall out, a chunk at a time. 0: all.
    explicit TraceBuffer(std::uint64_t maximumRows = 0);

    /// Takes a block. Another channel set than before starts anew. Returns false for a block that does not fit: another
    /// number of columns, columns of unequal length, or a first cycle that goes back.
    bool append(const SampleBlock& block);
    void clear();

    const std::vector<ChannelInfo>& channels() const { return m_channels; }
    std::size_t channelCount() const { return m_series.size(); }
    std::uint64_t rows() const { return m_endRow - m_firstRow; }
    std::uint64_t lostRows() const { return m_lostRows; } ///< told by the controller, in all
    bool isComplete() const { return m_complete; }
    std::int64_t triggerCycle() const { return m_triggerCycle; } ///< −1: none yet
    std::int64_t cycleNs() const { return m_cycleNs; }

    /// Cycles of the oldest and the newest sample kept; only if rows() > 0.
    std::uint64_t firstCycle() const;
    std::uint64_t lastCycle() const;

    /// A stretch of samples without a gap.
    struct Segment {
        std::uint64_t firstRow = 0, rows = 0, firstCycle = 0;
        std::uint32_t stride = 1;
        std::uint64_t cycleOf(std::uint64_t row) const { return firstCycle + (row - firstRow) * stride; }
        std::uint64_t endRow() const { return firstRow + rows; }
    };
    std::span<const Segment> segments() const { return m_segments; }

    /// Cycles [from, to) cut into `count` equal columns; a cycle belongs to column (cycle − from) · count / (to − from).
    std::vector<TraceColumn> columns(std::size_t channel, std::uint64_t from, std::uint64_t to, std::size_t count) const;

    /// The newest sample at or before a cycle, if it lies in no gap there.
    std::optional<double> valueAt(std::size_t channel, std::uint64_t cycle) const;
    /// A row counted as segments() counts them; it must be one of those kept.
    double value(std::size_t channel, std::uint64_t row) const;

private:
    static constexpr std::uint64_t Fan = 16;          ///< nodes of a level per node of the next
    static constexpr std::uint64_t ChunkRows = 65536; ///< Fan⁴
    static constexpr std::size_t ChunkLevels = 4;

    struct Extremes {
        double minimum = std::numeric_limits<double>::infinity();
        double maximum = -std::numeric_limits<double>::infinity();
        void add(double value);
        void add(const Extremes& other);
    };
    struct Chunk {
        std::vector<double> raw;
        std::array<std::vector<Extremes>, ChunkLevels> levels; ///< levels[i] nodes cover Fan^(i+1) rows; the last has one node
    };
    struct Series {
        std::vector<std::unique_ptr<Chunk>> chunks;
    };

    void appendValue(Series& series, double value) const;
    void dropOldChunks();
    void addSegment(const SampleBlock& block, std::uint64_t rows);
    const Chunk& chunkOf(const Series& series, std::uint64_t row) const;
    Extremes extremesOf(const Series& series, std::uint64_t from, std::uint64_t to) const;
    static Extremes extremesInChunk(const Chunk& chunk, std::uint64_t from, std::uint64_t to);
    void addRows(const Series& series, std::uint64_t from, std::uint64_t to, TraceColumn& column) const;

    std::uint64_t m_maximumRows;
    std::uint32_t m_channelSet = 0;
    bool m_started = false;
    bool m_complete = false;
    std::vector<ChannelInfo> m_channels;
    std::vector<Series> m_series;
    std::vector<Segment> m_segments;
    std::uint64_t m_firstChunk = 0; ///< number of the chunk at the front of every series
    std::uint64_t m_firstRow = 0, m_endRow = 0;
    std::uint64_t m_lostRows = 0, m_nextSequence = 0;
    std::int64_t m_triggerCycle = -1, m_cycleNs = 1000000;
};

} // namespace camwright
