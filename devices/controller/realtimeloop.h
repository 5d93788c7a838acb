#pragma once

#include "core/base/time.h"

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <thread>

namespace camwright {

class ControllerHost;

/// What the loop knows of time. now() never goes back.
class LoopClock {
public:
    virtual ~LoopClock() = default;
    virtual Time now() = 0;
    virtual void sleepUntil(Time time) = 0;
    virtual void interrupt() = 0; ///< from any thread: ends a sleep early, now and from then on
};

/// The machine's monotonic clock.
class SteadyClock final : public LoopClock {
public:
    Time now() override;
    void sleepUntil(Time time) override;
    void interrupt() override {} ///< sleeps last a cycle at most
};

/// Time that passes only when a test says so.
class ManualClock final : public LoopClock {
public:
    Time now() override;
    void sleepUntil(Time time) override;
    void interrupt() override;
    /// Lets `span` pass at once and returns when the loop sleeps again.
    void advance(Time span);

private:
    std::mutex m_mutex;
    std::condition_variable m_changed;
    Time m_now{};
    bool m_sleeping = false, m_interrupted = false;
};

/// Runs a host's cycle once a millisecond on a thread of its own. A cycle that comes late is counted and time slips by
/// whole cycles; missed ones are never made up for in a burst (CONTRACTS 19).
class RealTimeLoop {
public:
    RealTimeLoop(ControllerHost& host, LoopClock& clock) : m_host(host), m_clock(clock) {}
    ~RealTimeLoop() { stop(); }

    void start();
    void stop(); ///< returns when the thread has ended

private:
    void run();

    ControllerHost& m_host;
    LoopClock& m_clock;
    std::atomic<bool> m_stop{false};
    std::thread m_thread;
};

} // namespace camwright
