#include "core/fieldbus/busload.h"

#include "core/fieldbus/drivepdos.h"

#include <algorithm>
#include <vector>

namespace camwright {

double busLoad(std::span<const Time> intervals, std::uint32_t baudrate)
{
    double framesPerSecond = 0;
    for (const Time interval : intervals) {
        if (interval > Time{0})
            framesPerSecond += 1e9 / static_cast<double>(interval.count());
    }
    return framesPerSecond * kPdoBits / baudrate;
}

double axisBusLoad(std::span<const Time> inhibitTimes, std::uint32_t baudrate)
{
    std::vector<Time> intervals(inhibitTimes.begin(), inhibitTimes.end());
    for (Time& interval : intervals)
        interval = std::max<Time>(interval, 1ms);
    return kDriveTransmitPdos * busLoad(intervals, baudrate);
}

} // namespace camwright
