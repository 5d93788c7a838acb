#include "core/runtime/blocks/realtimeclock.h"

#include <chrono>

namespace camwright {

namespace {

constexpr std::chrono::sys_days Beginning = std::chrono::year{2000} / 1 / 1;
constexpr std::int64_t SecondsOfDay = 86400;
constexpr std::int64_t Century = 36525 * SecondsOfDay; ///< 2000 … 2099

std::int64_t wholeSeconds(Time now)
{
    return now / 1s;
}

std::chrono::year_month_day dateOf(const CalendarTime& moment)
{
    return {std::chrono::year{moment.year}, std::chrono::month{moment.month}, std::chrono::day{moment.day}};
}

} // namespace

bool CalendarTime::exists() const
{
    return year >= 2000 && year <= 2099 && dateOf(*this).ok() && hour < 24 && minute < 60 && second < 60;
}

CalendarTime RealTimeClock::read(Time now) const
{
    const std::int64_t seconds = (wholeSeconds(now) + m_offset) % Century;
    const std::chrono::sys_days day = Beginning + std::chrono::days{seconds / SecondsOfDay};
    const std::chrono::year_month_day date(day);
    const auto rest = static_cast<unsigned>(seconds % SecondsOfDay);
    return {static_cast<int>(date.year()), static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()), rest / 3600,
            rest / 60 % 60, rest % 60, std::chrono::weekday(day).c_encoding()};
}

void RealTimeClock::set(const CalendarTime& moment, Time now)
{
    const auto days = (std::chrono::sys_days(dateOf(moment)) - Beginning).count();
    const std::int64_t wanted = days * SecondsOfDay + moment.hour * 3600 + moment.minute * 60 + moment.second;
    m_offset = ((wanted - wholeSeconds(now)) % Century + Century) % Century;
}

void RealTimeClock::restore(ByteReader& reader)
{
    m_offset = reader.get<std::int64_t>();
    if (m_offset < 0 || m_offset >= Century)
        reader.fail();
}

} // namespace camwright
