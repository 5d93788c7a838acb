#include "editors/trace/tracestatistics.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace camwright {

namespace {

struct Sums {
    double minimum = std::numeric_limits<double>::infinity(), maximum = -std::numeric_limits<double>::infinity();
    double sum = 0, squares = 0;
    std::uint64_t count = 0;

    void add(double value)
    {
        if (std::isnan(value))
            return;
        minimum = std::min(minimum, value);
        maximum = std::max(maximum, value);
        sum += value;
        squares += value * value;
        ++count;
    }
};

} // namespace

TraceStatistics statisticsBetween(const TraceBuffer& buffer, std::size_t channel, std::uint64_t cycleA, std::uint64_t cycleB)
{
    TraceStatistics out;
    const std::uint64_t from = std::min(cycleA, cycleB), to = std::max(cycleA, cycleB);
    Sums sums;
    for (const TraceBuffer::Segment& segment : buffer.segments()) {
        const std::uint64_t before = from > segment.firstCycle ? (from - segment.firstCycle + segment.stride - 1) / segment.stride : 0;
        for (std::uint64_t row = segment.firstRow + before; row < segment.endRow() && segment.cycleOf(row) <= to; ++row)
            sums.add(buffer.value(channel, row));
    }
    out.deltaTime = (static_cast<double>(cycleB) - static_cast<double>(cycleA)) * static_cast<double>(buffer.cycleNs()) * 1e-9;
    out.atA = buffer.valueAt(channel, cycleA);
    out.atB = buffer.valueAt(channel, cycleB);
    out.samples = sums.count;
    if (sums.count == 0)
        return out;
    out.minimum = sums.minimum;
    out.maximum = sums.maximum;
    out.mean = sums.sum / static_cast<double>(sums.count);
    out.rms = std::sqrt(sums.squares / static_cast<double>(sums.count));
    if (out.deltaTime != 0 && std::isfinite(out.deltaValue().value_or(std::numeric_limits<double>::quiet_NaN())))
        out.slope = *out.deltaValue() / out.deltaTime;
    return out;
}

} // namespace camwright
