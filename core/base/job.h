#pragma once

#include <atomic>
#include <functional>

namespace camwright {

/// Long work says how far it is and asks whether it should stop. Both sides may be on different threads.
class Job {
public:
    using Progress = std::function<void(double fraction)>; ///< called on the worker's thread, 0 … 1

    Job() = default;
    explicit Job(Progress progress) : m_progress(std::move(progress)) {}

    void cancel() { m_cancelled.store(true, std::memory_order_relaxed); }
    bool isCancelled() const { return m_cancelled.load(std::memory_order_relaxed); }
    void report(double fraction) const { if (m_progress) m_progress(fraction); }

private:
    std::atomic<bool> m_cancelled{false};
    Progress m_progress;
};

} // namespace camwright
