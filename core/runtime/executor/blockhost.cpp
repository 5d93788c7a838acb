#include "core/runtime/executor/blockhost.h"

namespace camwright {

namespace {

Address typedAddress(const IrPin& pin)
{
    Address address;
    address.area = pin.address.area;
    address.byte = pin.address.byte;
    address.type = pin.type;
    address.isBit = pin.type == DataType::Bool && pin.address.bit != IrAddress::WholeByte;
    address.bit = address.isBit ? pin.address.bit : std::uint8_t{0};
    return address;
}

} // namespace

bool PinValues::isOpen(std::size_t pin) const
{
    return pin >= count() || m_block.pins[pin].kind == IrPin::Kind::Open;
}

bool PinValues::isConstant(std::size_t pin) const
{
    return pin < count() && m_block.pins[pin].kind == IrPin::Kind::Constant;
}

Value PinValues::read(std::size_t pin) const
{
    if (isConstant(pin))
        return {m_block.pins[pin].type, m_block.pins[pin].constant};
    const std::optional<Address> place = address(pin);
    return place ? m_memory.read(*place) : Value{};
}

void PinValues::write(std::size_t pin, const Value& value)
{
    if (const std::optional<Address> place = address(pin))
        m_memory.write(*place, value);
}

std::optional<Address> PinValues::address(std::size_t pin) const
{
    if (pin >= count() || m_block.pins[pin].kind != IrPin::Kind::Memory)
        return std::nullopt;
    return typedAddress(m_block.pins[pin]);
}

std::optional<Address> PinValues::element(std::size_t pin, std::uint32_t index) const
{
    std::optional<Address> place = address(pin);
    if (!place)
        return std::nullopt;
    const std::uint64_t byte = place->byte + std::uint64_t{index} * byteWidth(place->type);
    if (byte > 0xFFFFFFFF)
        return std::nullopt;
    place->byte = static_cast<std::uint32_t>(byte);
    return m_memory.contains(*place) ? place : std::nullopt;
}

} // namespace camwright
