#include "core/runtime/blocks/datablocks.h"

#include "core/family/invt/invtareas.h"

namespace camwright {

namespace datablocks {

namespace {

constexpr std::uint32_t IllegalParameterFlag = 24;

/// The families' instruction numbers tell them apart.
bool isInvt(PinValues& pins)
{
    return pins.block().instruction >= 2000 && pins.block().instruction < 3000;
}

} // namespace

void setFlag(PinValues& pins, std::uint32_t flag, bool on)
{
    pins.memory().write(bitAddress(invt::SM, flag), Value::ofBool(on));
}

void reportIllegalParameter(PinValues& pins)
{
    if (isInvt(pins))
        setFlag(pins, IllegalParameterFlag, true);
}

bool isModeOn(PinValues& pins, std::uint32_t flag)
{
    return pins.memory().read(bitAddress(invt::SM, flag)).asBool();
}

std::uint64_t elementBits(PinValues& pins, std::size_t pin, std::uint32_t index)
{
    const std::optional<Address> place = pins.element(pin, index);
    return place ? pins.memory().read(*place).bits : 0;
}

void setElement(PinValues& pins, std::size_t pin, std::uint32_t index, std::uint64_t bits)
{
    if (const std::optional<Address> place = pins.element(pin, index))
        pins.memory().write(*place, Value{place->type, bits});
}

bool hasElements(PinValues& pins, std::size_t pin, std::int64_t count)
{
    return count <= 0 || pins.element(pin, static_cast<std::uint32_t>(count - 1)).has_value();
}

std::optional<std::uint32_t> countAt(PinValues& pins, std::size_t pin, std::int64_t most)
{
    const std::int64_t count = pins.read(pin).asInteger();
    if (count >= 0 && count <= most)
        return static_cast<std::uint32_t>(count);
    reportIllegalParameter(pins);
    return std::nullopt;
}

} // namespace datablocks

bool runDataBlock(InstructionId instruction, PinValues& pins)
{
    using namespace datablocks;
    return runMoving(instruction, pins) || runCheckCode(instruction, pins) || runText(instruction, pins)
        || runTable(instruction, pins) || runNumber(instruction, pins);
}

} // namespace camwright
