#include "devices/controller/realtimeloop.h"

#include "devices/controller/controllerhost.h"

#include <cerrno>
#include <ctime>

#include <sys/prctl.h>

namespace camwright {

Time SteadyClock::now()
{
    timespec time{};
    clock_gettime(CLOCK_MONOTONIC, &time);
    return std::chrono::seconds(time.tv_sec) + Time(time.tv_nsec);
}

void SteadyClock::sleepUntil(Time time)
{
    timespec until{};
    until.tv_sec = static_cast<time_t>(time.count() / 1'000'000'000);
    until.tv_nsec = static_cast<long>(time.count() % 1'000'000'000);
    while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, nullptr) == EINTR) { }
}

Time ManualClock::now()
{
    const std::lock_guard lock(m_mutex);
    return m_now;
}

void ManualClock::sleepUntil(Time time)
{
    std::unique_lock lock(m_mutex);
    while (m_now < time && !m_interrupted) {
        m_sleeping = true;
        m_changed.notify_all();
        m_changed.wait(lock);
    }
    m_sleeping = false;
}

void ManualClock::interrupt()
{
    const std::lock_guard lock(m_mutex);
    m_interrupted = true;
    m_changed.notify_all();
}

void ManualClock::advance(Time span)
{
    std::unique_lock lock(m_mutex);
    m_changed.wait(lock, [this] { return m_sleeping || m_interrupted; });
    m_now += span;
    m_sleeping = false;
    m_changed.notify_all();
    m_changed.wait(lock, [this] { return m_sleeping || m_interrupted; });
}

void RealTimeLoop::start()
{
    m_thread = std::thread([this] { run(); });
}

void RealTimeLoop::stop()
{
    m_stop = true;
    m_clock.interrupt();
    if (m_thread.joinable())
        m_thread.join();
}

void RealTimeLoop::run()
{
    prctl(PR_SET_NAME, "motion");
    prctl(PR_SET_TIMERSLACK, 1UL); // ns; the default of 50 µs would be a twentieth of a cycle
    Time next = m_clock.now();
    while (!m_stop) {
        next += kMotionCycle;
        m_clock.sleepUntil(next);
        if (m_stop)
            return;
        const Time now = m_clock.now();
        const std::int64_t late = (now - next) / kMotionCycle;
        if (late > 0) {
            m_host.countLateCycles(static_cast<std::uint64_t>(late));
            next += late * kMotionCycle;
        }
        m_host.runCycle(now);
    }
}

} // namespace camwright
