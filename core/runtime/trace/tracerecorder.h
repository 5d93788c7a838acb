#pragma once

#include "core/base/bytes.h"
#include "core/online/controllerlink.h"
#include "core/online/sampleblock.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace camwright {

/// Records rows of numbers, one every `stride` motion cycles, with trigger and pre-trigger, into a ring; takers drain it in
/// blocks (CONTRACTS 17). Rows that nobody took in time fall out and are counted. Recording a row allocates nothing.
///
/// The trigger is looked at in every cycle, the rows are those of the stride. An edge needs two cycles; Above and Below fire
/// in the first cycle that fulfils them. With `samples` N and pre-trigger p the trace holds at most N * p rows from before
/// the trigger and ends after N * (1 - p) more; with 0 it goes on until stopped.
class TraceRecorder {
public:
    static constexpr std::size_t kMaxChannels = 32;
    static constexpr std::uint32_t kMaxStride = 1000000;
    static constexpr std::uint32_t kMaxSamples = 1000000;
    static constexpr std::size_t kRingRows = 20000;  ///< rows kept for a taker that is late, the pre-trigger beside
    static constexpr std::size_t kBlockRows = 1000;  ///< at most in one block

    /// What is wrong with a setup; the channels' names are the engine's to judge.
    static Result<void> check(const TraceSetup& setup);

    void start(const TraceSetup& setup, std::vector<ChannelInfo> channels, std::uint64_t cycle);
    void stop();
    bool isRunning() const { return m_state == State::Waiting || m_state == State::Recording; }
    /// Whether the cycle needs a row; the trigger is to be looked at in any case.
    bool wantsRow(std::uint64_t cycle) const { return isRunning() && (cycle - m_startCycle) % m_setup.stride == 0; }
    /// Once each cycle, before record(): the value of the trigger channel.
    void lookAtTrigger(std::uint64_t cycle, double value);
    std::size_t channelCount() const { return m_channels.size(); }
    bool needsTrigger() const { return m_state == State::Waiting; }
    void record(std::uint64_t cycle, std::span<const double> row);

    std::optional<SampleBlock> take();

    void save(ByteWriter& writer) const;
    void restore(ByteReader& reader);

private:
    enum class State : std::uint8_t { Idle, Waiting, Recording, Ended };

    std::size_t capacity() const { return m_preRows + kRingRows; }
    void dropOldest();
    bool triggers(double value) const;

    State m_state = State::Idle;
    TraceSetup m_setup;
    std::vector<ChannelInfo> m_channels;
    std::size_t m_preRows = 0;
    std::uint64_t m_startCycle = 0;
    std::vector<double> m_ring;        ///< capacity() rows of one number a channel
    std::size_t m_first = 0, m_count = 0;
    std::uint64_t m_firstCycle = 0;    ///< of the oldest row
    std::uint64_t m_remaining = 0;     ///< rows still to record; only with `samples`
    std::int64_t m_triggerCycle = -1;
    bool m_hasPrevious = false;
    double m_previous = 0;
    std::uint64_t m_lost = 0;
    std::uint32_t m_set = 0;
    std::uint64_t m_sequence = 0;
    bool m_lastSent = false;
};

} // namespace camwright
