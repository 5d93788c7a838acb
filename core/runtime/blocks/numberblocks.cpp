#include "core/runtime/blocks/datablocks.h"

#include "core/base/realmath.h"

#include <array>
#include <bit>
#include <limits>

namespace camwright::datablocks {

namespace {

using Function = double (*)(double);

Function functionOf(InstructionId instruction)
{
    switch (instruction) {
    case InstructionId::KincoSin:
    case InstructionId::InvtSin: return sine;
    case InstructionId::KincoCos:
    case InstructionId::InvtCos: return cosine;
    case InstructionId::KincoTan:
    case InstructionId::InvtTan: return tangent;
    case InstructionId::KincoAsin: return arcSine;
    case InstructionId::KincoAcos: return arcCosine;
    case InstructionId::KincoAtan: return arcTangent;
    case InstructionId::KincoLn:
    case InstructionId::InvtLn: return naturalLogarithm;
    case InstructionId::KincoLog:
    case InstructionId::InvtLog: return decimalLogarithm;
    case InstructionId::KincoExp:
    case InstructionId::InvtExp: return exponential;
    default: return nullptr;
    }
}

/// Rounds once; what is too large for a REAL is infinite, as IEEE 754 says.
float toReal(double value)
{
    constexpr double Most = 3.4028235677973366e38; // half a step above the largest float
    if (value >= Most)
        return std::numeric_limits<float>::infinity();
    return value <= -Most ? -std::numeric_limits<float>::infinity() : static_cast<float>(value);
}

void toBcd(PinValues& pins, unsigned digits)
{
    std::int64_t rest = pins.read(0).asInteger();
    std::uint64_t out = 0;
    unsigned at = 0;
    for (; rest > 0 && at < digits; ++at, rest /= 10)
        out |= static_cast<std::uint64_t>(rest % 10) << (4 * at);
    if (rest != 0)
        return reportIllegalParameter(pins);
    setElement(pins, 1, 0, out);
}

void fromBcd(PinValues& pins, unsigned digits)
{
    const std::uint64_t bcd = pins.read(0).bits;
    std::uint64_t out = 0;
    for (unsigned at = digits; at-- > 0;) {
        const std::uint64_t digit = bcd >> (4 * at) & 0xF;
        if (digit > 9)
            return reportIllegalParameter(pins);
        out = out * 10 + digit;
    }
    setElement(pins, 1, 0, out);
}

constexpr std::array<std::uint8_t, 16> Segments{0x3F, 0x06, 0x5B, 0x4F, 0x66, 0x6D, 0x7D, 0x07, 0x7F, 0x6F, 0x77, 0x7C, 0x39, 0x5E, 0x79, 0x71};

void encode(PinValues& pins)
{
    const std::uint64_t word = pins.read(0).bits;
    setElement(pins, 1, 0, word == 0 ? 0 : static_cast<std::uint64_t>(std::countr_zero(word)));
}

} // namespace

bool runNumber(InstructionId instruction, PinValues& pins)
{
    if (const Function function = functionOf(instruction)) {
        pins.write(1, Value::ofReal(toReal(function(pins.read(0).asDouble()))));
        return true;
    }
    switch (instruction) {
    case InstructionId::KincoIToBcd:
    case InstructionId::InvtBcd: toBcd(pins, 4); return true;
    case InstructionId::InvtDbcd: toBcd(pins, 8); return true;
    case InstructionId::KincoBcdToI:
    case InstructionId::InvtBin: fromBcd(pins, 4); return true;
    case InstructionId::InvtDbin: fromBcd(pins, 8); return true;
    case InstructionId::KincoSeg:
    case InstructionId::InvtSeg: setElement(pins, 1, 0, Segments[pins.read(0).bits & 0xF]); return true;
    case InstructionId::KincoEnco: encode(pins); return true;
    case InstructionId::KincoDeco: setElement(pins, 1, 0, 1u << (pins.read(0).bits & 0xF)); return true;
    default: return false;
    }
}

} // namespace camwright::datablocks
