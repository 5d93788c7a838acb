#include "core/runtime/blocks/datablocks.h"

#include <vector>

namespace camwright::datablocks {

namespace {

constexpr std::uint32_t ByteModeFlag = 32; // one byte a word (TS-MEM-09)
constexpr std::int64_t MostBytes = 512;

/// N bytes from pin 0 on; nothing if they are not all there, which has been reported.
std::optional<std::vector<std::uint8_t>> bytesOf(PinValues& pins)
{
    const auto count = countAt(pins, 1, MostBytes);
    if (!count)
        return std::nullopt;
    const bool byteAWord = isModeOn(pins, ByteModeFlag);
    const std::uint32_t words = byteAWord ? *count : (*count + 1) / 2;
    if (!hasElements(pins, 0, words)) {
        reportIllegalParameter(pins);
        return std::nullopt;
    }
    std::vector<std::uint8_t> out(*count);
    for (std::uint32_t i = 0; i < *count; ++i) {
        const std::uint64_t word = elementBits(pins, 0, byteAWord ? i : i / 2);
        out[i] = static_cast<std::uint8_t>(!byteAWord && i % 2 == 1 ? word >> 8 : word);
    }
    return out;
}

/// Polynomial x^16 + x^12 + x^5 + 1, highest bit first, start 0 (the start is ours).
std::uint16_t ccitt(const std::vector<std::uint8_t>& bytes)
{
    unsigned crc = 0;
    for (const std::uint8_t byte : bytes) {
        crc ^= static_cast<unsigned>(byte) << 8;
        for (int bit = 0; bit < 8; ++bit)
            crc = (crc & 0x8000u) != 0 ? (crc << 1) ^ 0x1021u : crc << 1;
    }
    return static_cast<std::uint16_t>(crc);
}

/// As Modbus RTU sends it (TS-MB-05): the low byte first.
std::uint16_t crc16(const std::vector<std::uint8_t>& bytes)
{
    unsigned crc = 0xFFFF;
    for (const std::uint8_t byte : bytes) {
        crc ^= byte;
        for (int bit = 0; bit < 8; ++bit)
            crc = (crc & 1u) != 0 ? (crc >> 1) ^ 0xA001u : crc >> 1;
    }
    return static_cast<std::uint16_t>(crc);
}

std::uint16_t sumOf(const std::vector<std::uint8_t>& bytes)
{
    unsigned sum = 0;
    for (const std::uint8_t byte : bytes)
        sum += byte;
    return static_cast<std::uint16_t>(sum);
}

std::uint8_t parityOf(const std::vector<std::uint8_t>& bytes)
{
    unsigned out = 0;
    for (const std::uint8_t byte : bytes)
        out ^= byte;
    return static_cast<std::uint8_t>(out);
}

} // namespace

bool runCheckCode(InstructionId instruction, PinValues& pins)
{
    const bool isOne = instruction == InstructionId::InvtCcitt || instruction == InstructionId::InvtCrc16
        || instruction == InstructionId::InvtLrc || instruction == InstructionId::InvtCd;
    if (!isOne)
        return false;
    const auto bytes = bytesOf(pins);
    if (!bytes)
        return true;
    switch (instruction) {
    case InstructionId::InvtCcitt: setElement(pins, 2, 0, ccitt(*bytes)); break;
    case InstructionId::InvtCrc16: setElement(pins, 2, 0, crc16(*bytes)); break;
    case InstructionId::InvtLrc: setElement(pins, 2, 0, static_cast<std::uint8_t>(-sumOf(*bytes))); break;
    default:
        setElement(pins, 2, 0, sumOf(*bytes));
        setElement(pins, 2, 1, parityOf(*bytes));
    }
    return true;
}

} // namespace camwright::datablocks
