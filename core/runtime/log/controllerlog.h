#pragma once

#include "core/base/bytes.h"
#include "core/base/diagnostic.h"
#include "core/base/time.h"
#include "core/online/controllerlink.h"

#include <cstdint>
#include <deque>
#include <vector>

namespace camwright {

/// What the controller remembers of its own history: a bounded ring, oldest entries fall out. Sequence numbers count from 1
/// and are never used twice.
class ControllerLog {
public:
    static constexpr std::size_t kCapacity = 500;

    /// Cycle and time of the entries to come.
    void setMoment(std::uint64_t cycle, Time time);
    void add(Code code, std::vector<std::string> arguments = {});
    void add(Diagnostic message);

    std::vector<LogEntry> since(std::uint64_t sequence) const;
    std::uint64_t nextSequence() const { return m_next; }

    void save(ByteWriter& writer) const;
    void restore(ByteReader& reader);

private:
    std::deque<LogEntry> m_entries;
    std::uint64_t m_next = 1;
    std::uint64_t m_cycle = 0;
    Time m_time{};
};

} // namespace camwright
