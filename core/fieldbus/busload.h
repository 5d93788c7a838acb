#pragma once

#include "core/base/time.h"

#include <cstdint>
#include <span>

namespace camwright {

/// Bits the bus-load calculator counts for a PDO: a standard frame of 8 bytes without stuff bits (KS-CAN-04).
inline constexpr unsigned kPdoBits = 111;

/// Share of the wire taken by PDOs sent at these intervals, 1 is full (KS-CAN-04). Intervals of 0 count nothing.
double busLoad(std::span<const Time> intervals, std::uint32_t baudrate);

/// The same for our mapping at its fullest: every axis sends its three PDOs once in each inhibit time, without one once in
/// each motion cycle of a millisecond. One entry an axis.
double axisBusLoad(std::span<const Time> inhibitTimes, std::uint32_t baudrate);

} // namespace camwright
