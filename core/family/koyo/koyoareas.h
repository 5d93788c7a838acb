#pragma once

#include "core/family/address.h"

/// Permanent numbers of the Koyo DL205 memory areas. All of the controller's memory has a word address (V, in the words of
/// the D2-MLINK manual R); a stretch of words that has bit elements of its own is an area, so `X17` and bit 15 of `V40400`
/// are one place. What the word numbers of the bit elements are is published for DL205 and not in our manual.
namespace camwright::koyo {

enum Area : AreaId {
    X = 0, Y = 1, C = 2, S = 3, TimerBit = 4, CounterBit = 5, SP = 6, GX = 7, GY = 8,
    V = 9, TimerValue = 10, CounterValue = 11, Accumulator = 12,
};

/// Words [first, first + words) of V are the area.
struct Window {
    std::uint32_t first, words;
    AreaId area;
};
inline constexpr Window Windows[] = {
    {0, 0400, TimerValue},    {01000, 0400, CounterValue}, {040000, 0200, GX},       {040200, 0200, GY},
    {040400, 0100, X},        {040500, 0100, Y},           {040600, 0200, C},        {041000, 0100, S},
    {041100, 020, TimerBit},  {041140, 020, CounterBit},   {041200, 040, SP},
};

/// The accumulator's area: the accumulator, its stack, whether a load waits for its OUT, the loop counters. Bytes.
inline constexpr std::uint32_t AccumulatorByte = 0;
inline constexpr std::uint32_t StackByte = 4;
inline constexpr unsigned StackLevels = 8;
inline constexpr std::uint32_t LoadedByte = 36;   ///< BOOL: the accumulator was loaded and not written out since
inline constexpr std::uint32_t LoopsByte = 64;    ///< DWORD each
inline constexpr unsigned MaximumLoops = 64;

/// Special relays.
enum SpecialRelay : std::uint32_t {
    FirstScan = 0, AlwaysOn = 1, AlwaysOff = 2, Minute = 3, Second = 4, Tenth = 5, Twentieth = 6, Alternate = 7,
    IsLess = 060, IsEqual = 061, IsGreater = 062, IsZero = 063, Borrow = 065, Carry = 067, IsNegative = 070, NotBcd = 075, LoadedZero = 076,
};

/// Registers of the D2-MLINK modules (D2-REG-01, D2-REG-13).
inline constexpr std::uint32_t FirstPointer = 07661; ///< of slot 1; slot 7 has 07667
inline constexpr unsigned LastSlot = 7;
inline constexpr std::uint32_t BlockWords = 0760;    ///< of one module: 496

} // namespace camwright::koyo
