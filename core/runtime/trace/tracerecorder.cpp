#include "core/runtime/trace/tracerecorder.h"

#include <algorithm>
#include <cmath>

namespace camwright {

Result<void> TraceRecorder::check(const TraceSetup& setup)
{
    if (setup.channels.empty() || setup.channels.size() > kMaxChannels)
        return diagnostic(Code::TraceWithoutChannels, {std::to_string(kMaxChannels)});
    if (setup.stride < 1 || setup.stride > kMaxStride)
        return diagnostic(Code::TraceBadSetting, {"stride", "1 to " + std::to_string(kMaxStride)});
    if (setup.samples > kMaxSamples)
        return diagnostic(Code::TraceBadSetting, {"samples", "0 to " + std::to_string(kMaxSamples)});
    if (!(setup.preTrigger >= 0 && setup.preTrigger < 1))
        return diagnostic(Code::TraceBadSetting, {"preTrigger", "0 to below 1"});
    if (setup.trigger != TriggerKind::Immediate && !std::isfinite(setup.triggerLevel))
        return diagnostic(Code::TraceBadSetting, {"triggerLevel", CW_TEXT("Arguments", "any finite number")});
    return {};
}

void TraceRecorder::start(const TraceSetup& setup, std::vector<ChannelInfo> channels, std::uint64_t cycle)
{
    const bool immediate = setup.trigger == TriggerKind::Immediate;
    m_setup = setup;
    m_channels = std::move(channels);
    m_preRows = immediate ? 0 : static_cast<std::size_t>(setup.samples * setup.preTrigger);
    m_state = immediate ? State::Recording : State::Waiting;
    m_startCycle = cycle;
    m_ring.assign(capacity() * m_channels.size(), 0.0);
    m_first = m_count = 0;
    m_firstCycle = cycle;
    m_remaining = setup.samples - m_preRows;
    m_triggerCycle = -1;
    m_hasPrevious = false;
    m_lost = 0;
    ++m_set;
    m_sequence = 0;
    m_lastSent = false;
}

void TraceRecorder::stop()
{
    if (isRunning())
        m_state = State::Ended;
}

bool TraceRecorder::triggers(double value) const
{
    const double level = m_setup.triggerLevel;
    switch (m_setup.trigger) {
    case TriggerKind::Immediate: return true;
    case TriggerKind::RisingEdge: return m_hasPrevious && m_previous < level && value >= level;
    case TriggerKind::FallingEdge: return m_hasPrevious && m_previous > level && value <= level;
    case TriggerKind::Above: return value > level;
    case TriggerKind::Below: return value < level;
    }
    return false;
}

void TraceRecorder::lookAtTrigger(std::uint64_t cycle, double value)
{
    if (m_state != State::Waiting)
        return;
    if (triggers(value)) {
        m_state = State::Recording;
        m_triggerCycle = static_cast<std::int64_t>(cycle);
    }
    m_previous = value;
    m_hasPrevious = true;
}

void TraceRecorder::dropOldest()
{
    m_first = (m_first + 1) % capacity();
    --m_count;
    m_firstCycle += m_setup.stride;
}

void TraceRecorder::record(std::uint64_t cycle, std::span<const double> row)
{
    if (m_state == State::Waiting && m_preRows == 0)
        return;
    if (m_state == State::Waiting && m_count == m_preRows)
        dropOldest();
    if (m_count == capacity()) {
        dropOldest();
        ++m_lost;
    }
    if (m_count == 0)
        m_firstCycle = cycle;
    const std::size_t at = (m_first + m_count) % capacity() * m_channels.size();
    std::copy(row.begin(), row.end(), m_ring.begin() + static_cast<std::ptrdiff_t>(at));
    ++m_count;
    if (m_state == State::Recording && m_setup.samples && --m_remaining == 0)
        m_state = State::Ended;
}

std::optional<SampleBlock> TraceRecorder::take()
{
    const bool ended = m_state == State::Ended;
    if (m_state == State::Idle || m_state == State::Waiting || (ended && m_lastSent) || (!ended && m_count == 0))
        return std::nullopt;
    SampleBlock block;
    const std::size_t rows = std::min(m_count, kBlockRows);
    block.channelSet = m_set;
    block.sequence = m_sequence++;
    block.firstCycle = m_firstCycle;
    block.stride = m_setup.stride;
    block.lostRows = std::exchange(m_lost, 0);
    block.triggerCycle = m_triggerCycle;
    if (block.sequence == 0)
        block.channels = m_channels;
    block.columns.assign(m_channels.size(), std::vector<double>(rows));
    for (std::size_t i = 0; i < rows; ++i) {
        const std::size_t at = (m_first + i) % capacity() * m_channels.size();
        for (std::size_t channel = 0; channel < m_channels.size(); ++channel)
            block.columns[channel][i] = m_ring[at + channel];
    }
    m_first = (m_first + rows) % capacity();
    m_count -= rows;
    m_firstCycle += rows * m_setup.stride;
    block.last = m_lastSent = ended && m_count == 0;
    return block;
}

void TraceRecorder::save(ByteWriter& writer) const
{
    writer.put(m_state);
    writer.put(m_set);
    if (m_state == State::Idle)
        return;
    writer.put(static_cast<std::uint32_t>(m_channels.size()));
    for (const ChannelInfo& channel : m_channels) {
        writer.putText(channel.name);
        writer.put(channel.type);
        writer.putText(channel.unit);
    }
    writer.put(m_setup.stride);
    writer.put(m_setup.trigger);
    writer.putText(m_setup.triggerChannel);
    writer.put(m_setup.triggerLevel);
    writer.put(m_setup.preTrigger);
    writer.put(m_setup.samples);
    for (const std::uint64_t number : {m_startCycle, m_firstCycle, m_remaining, m_lost, m_sequence})
        writer.put(number);
    writer.put(m_triggerCycle);
    writer.put(m_hasPrevious);
    writer.put(m_previous);
    writer.put(m_lastSent);
    writer.put(static_cast<std::uint64_t>(m_count));
    for (std::size_t i = 0; i < m_count; ++i) {
        const std::size_t at = (m_first + i) % capacity() * m_channels.size();
        for (std::size_t channel = 0; channel < m_channels.size(); ++channel)
            writer.put(m_ring[at + channel]);
    }
}

void TraceRecorder::restore(ByteReader& reader)
{
    *this = {};
    m_state = reader.get<State>();
    m_set = reader.get<std::uint32_t>();
    if (m_state > State::Ended)
        reader.fail();
    if (m_state == State::Idle || !reader.ok())
        return;
    const auto channels = reader.get<std::uint32_t>();
    for (std::uint32_t i = 0; i < channels && reader.ok(); ++i) {
        ChannelInfo channel;
        channel.name = reader.getText();
        channel.type = reader.get<DataType>();
        channel.unit = reader.getText();
        m_setup.channels.push_back(channel.name);
        m_channels.push_back(std::move(channel));
    }
    m_setup.stride = reader.get<std::uint32_t>();
    m_setup.trigger = reader.get<TriggerKind>();
    m_setup.triggerChannel = reader.getText();
    m_setup.triggerLevel = reader.get<double>();
    m_setup.preTrigger = reader.get<double>();
    m_setup.samples = reader.get<std::uint32_t>();
    for (std::uint64_t* number : {&m_startCycle, &m_firstCycle, &m_remaining, &m_lost, &m_sequence})
        *number = reader.get<std::uint64_t>();
    m_triggerCycle = reader.get<std::int64_t>();
    m_hasPrevious = reader.getBool();
    m_previous = reader.get<double>();
    m_lastSent = reader.getBool();
    const auto count = reader.get<std::uint64_t>();
    if (!reader.ok() || !check(m_setup))
        return reader.fail();
    if (m_setup.trigger != TriggerKind::Immediate)
        m_preRows = static_cast<std::size_t>(m_setup.samples * m_setup.preTrigger);
    if (count > capacity())
        return reader.fail();
    m_ring.assign(capacity() * m_channels.size(), 0.0);
    m_count = count;
    for (std::size_t i = 0; i < m_count * m_channels.size(); ++i)
        m_ring[i] = reader.get<double>();
}

} // namespace camwright
