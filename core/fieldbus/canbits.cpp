#include "core/fieldbus/canbits.h"

#include <algorithm>
#include <array>

namespace camwright {

namespace {

// After the checksum, never stuffed: its delimiter, the acknowledge slot and its delimiter, seven bits of end of frame,
// three of interframe space.
constexpr unsigned kTailBits = 1 + 2 + 7 + 3;
constexpr unsigned kChecksumBits = 15;
constexpr std::uint16_t kPolynomial = 0x4599;

/// The frame's bits from the start bit on, most significant first. 118 at most: 39 of an extended head, 64 of data, 15.
class BitString {
public:
    void put(std::uint32_t value, unsigned width)
    {
        for (unsigned i = width; i-- > 0;)
            m_bits[m_count++] = static_cast<std::uint8_t>((value >> i) & 1U);
    }
    unsigned count() const { return m_count; }
    std::uint16_t checksum() const
    {
        std::uint16_t crc = 0;
        for (unsigned i = 0; i < m_count; ++i) {
            const bool invert = m_bits[i] != ((crc >> 14) & 1U);
            crc = static_cast<std::uint16_t>((crc << 1) & 0x7FFF);
            if (invert)
                crc ^= kPolynomial;
        }
        return crc;
    }
    /// After five equal bits the sender inserts one of the opposite value, which counts towards the next five.
    unsigned stuffBits() const
    {
        unsigned stuffed = 0;
        unsigned run = 0;
        std::uint8_t last = 2;
        for (unsigned i = 0; i < m_count; ++i) {
            run = m_bits[i] == last ? run + 1 : 1;
            last = m_bits[i];
            if (run == 5) {
                ++stuffed;
                last ^= 1U;
                run = 1;
            }
        }
        return stuffed;
    }

private:
    std::array<std::uint8_t, 128> m_bits{};
    unsigned m_count = 0;
};

unsigned dataBytes(const CanFrame& frame) { return frame.remote ? 0U : std::min<unsigned>(frame.length, 8); }

BitString stuffedRegionWithoutChecksum(const CanFrame& frame)
{
    BitString bits;
    bits.put(0, 1); // start of frame, dominant
    if (frame.extended) {
        bits.put((frame.id >> 18) & 0x7FF, 11);
        bits.put(3, 2); // substitute remote request and identifier extension, recessive
        bits.put(frame.id & 0x3FFFF, 18);
        bits.put(frame.remote ? 1 : 0, 1);
        bits.put(0, 2); // two reserved bits
    } else {
        bits.put(frame.id & 0x7FF, 11);
        bits.put(frame.remote ? 1 : 0, 1);
        bits.put(0, 2); // identifier extension and one reserved bit, dominant
    }
    bits.put(std::min<unsigned>(frame.length, 8), 4);
    for (unsigned i = 0; i < dataBytes(frame); ++i)
        bits.put(frame.data[i], 8);
    return bits;
}

unsigned stuffedRegionBits(const CanFrame& frame)
{
    return (frame.extended ? 39U : 19U) + 8 * dataBytes(frame) + kChecksumBits;
}

} // namespace

unsigned frameBits(const CanFrame& frame)
{
    BitString bits = stuffedRegionWithoutChecksum(frame);
    bits.put(bits.checksum(), kChecksumBits);
    return bits.count() + bits.stuffBits() + kTailBits;
}

unsigned unstuffedFrameBits(const CanFrame& frame) { return stuffedRegionBits(frame) + kTailBits; }

unsigned worstCaseFrameBits(const CanFrame& frame)
{
    // The first stuff bit needs five equal bits, every further one four.
    return unstuffedFrameBits(frame) + (stuffedRegionBits(frame) - 1) / 4;
}

std::uint16_t frameChecksum(const CanFrame& frame) { return stuffedRegionWithoutChecksum(frame).checksum(); }

Time bitTime(unsigned bits, std::uint32_t baudrate)
{
    return Time((std::int64_t{bits} * 1'000'000'000 + baudrate - 1) / baudrate);
}

std::uint32_t arbitrationKey(const CanFrame& frame)
{
    const std::uint32_t remote = frame.remote ? 1 : 0;
    if (!frame.extended)
        return ((frame.id & 0x7FF) << 21) | (remote << 20);
    const std::uint32_t base = (frame.id >> 18) & 0x7FF;
    return (base << 21) | (1U << 20) | (1U << 19) | ((frame.id & 0x3FFFF) << 1) | remote;
}

} // namespace camwright
