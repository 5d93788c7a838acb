#include "editors/trace/tracecsv.h"

#include <charconv>

namespace camwright {

namespace {

QByteArray shortest(DataType type, double value)
{
    char text[64];
    char* const end = text + sizeof text;
    if (!isFloat(type))
        return QByteArray::number(static_cast<qint64>(value));
    const auto written = type == DataType::Real ? std::to_chars(text, end, static_cast<float>(value)) : std::to_chars(text, end, value);
    return {text, written.ptr - text};
}

/// Exact decimal seconds.
QByteArray secondsText(std::uint64_t nanoseconds)
{
    QByteArray fraction = QByteArray::number(qulonglong(nanoseconds % 1'000'000'000)).rightJustified(9, '0');
    while (fraction.endsWith('0'))
        fraction.chop(1);
    const QByteArray whole = QByteArray::number(qulonglong(nanoseconds / 1'000'000'000));
    return fraction.isEmpty() ? whole : whole + '.' + fraction;
}

} // namespace

QByteArray traceCsv(const TraceBuffer& buffer)
{
    QByteArray out = "time_s";
    for (const ChannelInfo& channel : buffer.channels())
        out += ',' + QByteArray::fromStdString(channel.name);
    out += '\n';
    bool first = true;
    for (const TraceBuffer::Segment& segment : buffer.segments()) {
        if (!std::exchange(first, false))
            out += '\n';
        for (std::uint64_t row = segment.firstRow; row < segment.endRow(); ++row) {
            out += secondsText(segment.cycleOf(row) * static_cast<std::uint64_t>(buffer.cycleNs()));
            for (std::size_t channel = 0; channel < buffer.channelCount(); ++channel)
                out += ',' + shortest(buffer.channels()[channel].type, buffer.value(channel, row));
            out += '\n';
        }
    }
    return out;
}

} // namespace camwright
