#pragma once

#include <chrono>

namespace camwright {

/// Time in the engine: nanoseconds in an int64, either since the controller's start or a span. Always passed in; nothing
/// in core reads a clock.
using Time = std::chrono::nanoseconds;

using namespace std::chrono_literals;

inline constexpr double seconds(Time time)
{
    return static_cast<double>(time.count()) * 1e-9;
}

} // namespace camwright
