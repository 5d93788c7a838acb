#pragma once

#include "core/base/bytes.h"
#include "core/base/time.h"

#include <cstdint>

namespace camwright {

/// A moment of the calendar. Years 2000 … 2099.
struct CalendarTime {
    int year = 2000;
    unsigned month = 1;
    unsigned day = 1;
    unsigned hour = 0;
    unsigned minute = 0;
    unsigned second = 0;
    unsigned weekday = 6; ///< 0 is Sunday

    bool exists() const; ///< the weekday does not count
};

/// The clock of the virtual controller. It begins at 1 January 2000 with the controller (ours: no wall clock comes into the
/// engine, CONTRACTS 12) and runs with the controller's time.
class RealTimeClock {
public:
    CalendarTime read(Time now) const;
    /// The moment must exist.
    void set(const CalendarTime& moment, Time now);

    void save(ByteWriter& writer) const { writer.put(m_offset); }
    void restore(ByteReader& reader);

private:
    std::int64_t m_offset = 0; ///< seconds that the clock is ahead of the controller's time
};

} // namespace camwright
