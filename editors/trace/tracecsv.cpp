#include "editors/trace/tracecsv.h"

#include "core/online/sampletext.h"

#include <utility>

namespace camwright {

QByteArray traceCsv(const TraceBuffer& buffer)
{
    QByteArray out = "time_s";
    for (const ChannelInfo& channel : buffer.channels())
        out += ',' + QByteArray::fromStdString(csvCell(channel.name));
    out += '\n';
    bool first = true;
    for (const TraceBuffer::Segment& segment : buffer.segments()) {
        if (!std::exchange(first, false))
            out += '\n';
        for (std::uint64_t row = segment.firstRow; row < segment.endRow(); ++row) {
            out += QByteArray::fromStdString(secondsText(static_cast<std::int64_t>(segment.cycleOf(row)) * buffer.cycleNs()));
            for (std::size_t channel = 0; channel < buffer.channelCount(); ++channel)
                out += ',' + QByteArray::fromStdString(sampleText(buffer.channels()[channel].type, buffer.value(channel, row)));
            out += '\n';
        }
    }
    return out;
}

} // namespace camwright
