#pragma once

#include "core/base/time.h"
#include "core/fieldbus/canframe.h"

#include <cstdint>

namespace camwright {

/// Bits a frame occupies on the wire, ISO 11898-1: start bit to end of frame with its stuff bits, plus the three bits of
/// interframe space. The checksum is computed from the frame's content, so the number is exact, not an estimate.
unsigned frameBits(const CanFrame& frame);
/// The same without stuff bits: 111 for a standard data frame of 8 bytes (KS-CAN-04).
unsigned unstuffedFrameBits(const CanFrame& frame);
/// The same with the most stuff bits a frame of this kind can need: 135 for a standard data frame of 8 bytes.
unsigned worstCaseFrameBits(const CanFrame& frame);

/// The frame's 15-bit checksum (polynomial 16#4599 over the bits from start bit to data, without stuff bits).
std::uint16_t frameChecksum(const CanFrame& frame);

/// Duration of `bits` at `baudrate` bit/s, rounded up to whole nanoseconds. `baudrate` is not 0.
Time bitTime(unsigned bits, std::uint32_t baudrate);

/// Sort key of bus arbitration: of two frames that start together, the one with the smaller key wins.
std::uint32_t arbitrationKey(const CanFrame& frame);

} // namespace camwright
