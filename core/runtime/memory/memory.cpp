#include "core/runtime/memory/memory.h"

#include <algorithm>
#include <cstring>

namespace camwright {

namespace {

constexpr std::uint32_t Alignment = 8;

std::uint32_t aligned(std::uint32_t offset)
{
    return (offset + Alignment - 1) / Alignment * Alignment;
}

/// Floats are stored with one NaN only (CONTRACTS 12).
std::uint64_t canonicalBits(DataType type, std::uint64_t bits)
{
    if (type == DataType::Real)
        return Value::ofReal(static_cast<float>(Value{type, bits}.asDouble())).bits;
    if (type == DataType::Lreal)
        return Value::ofLreal(Value{type, bits}.asDouble()).bits;
    return bits;
}

} // namespace

Memory::Memory(const MemoryLayout& layout, std::uint32_t stateBytes)
{
    std::uint32_t offset = 0;
    for (const ImageArea& area : layout.areas) {
        m_areas[area.id] = {offset, area.bytes};
        offset = aligned(offset + area.bytes);
    }
    m_stateOffset = offset;
    m_scratchOffset = aligned(offset + stateBytes);
    m_bytes.resize(m_scratchOffset);
}

void Memory::reserveScratch(std::uint32_t bytes)
{
    m_bytes.resize(m_scratchOffset + bytes);
}

bool Memory::contains(const Address& address) const
{
    return std::uint64_t{address.byte} + byteWidth(address.type) <= m_areas[address.area].bytes && address.bit < 8;
}

Value Memory::read(const Address& address) const
{
    if (!contains(address))
        return {address.type, 0};
    const std::uint8_t* at = m_bytes.data() + offsetOf(address.area, address.byte);
    if (address.isBit)
        return Value::ofBool((*at >> address.bit) & 1);
    if (address.type == DataType::Bool)
        return Value::ofBool(*at != 0);
    Value value{address.type, 0};
    std::memcpy(&value.bits, at, byteWidth(address.type));
    return value;
}

bool Memory::write(const Address& address, const Value& value)
{
    if (!contains(address))
        return false;
    std::uint8_t* at = m_bytes.data() + offsetOf(address.area, address.byte);
    if (address.isBit) {
        const auto mask = static_cast<std::uint8_t>(1u << address.bit);
        *at = static_cast<std::uint8_t>(value.asBool() ? *at | mask : *at & ~mask);
    } else if (address.type == DataType::Bool) {
        *at = value.asBool() ? 1 : 0;
    } else {
        const std::uint64_t bits = canonicalBits(address.type, value.bits);
        std::memcpy(at, &bits, byteWidth(address.type));
    }
    return true;
}

std::span<std::uint8_t> Memory::area(AreaId id)
{
    return {m_bytes.data() + m_areas[id].offset, m_areas[id].bytes};
}

std::span<const std::uint8_t> Memory::area(AreaId id) const
{
    return {m_bytes.data() + m_areas[id].offset, m_areas[id].bytes};
}

void Memory::powerOn(const MemoryLayout& layout)
{
    std::fill_n(m_bytes.begin(), m_scratchOffset, std::uint8_t{0});
    for (const InitialValue& initial : layout.initialValues)
        write(initial.address, initial.value);
}

void Memory::save(ByteWriter& writer) const
{
    writer.putBlob({m_bytes.data(), m_scratchOffset});
}

bool Memory::restore(ByteReader& reader)
{
    const ByteSpan saved = reader.getBlob();
    if (!reader.ok() || saved.size() != m_scratchOffset)
        return false;
    std::ranges::copy(saved, m_bytes.begin());
    return true;
}

void applyForces(Memory& memory, std::span<const Force> forces)
{
    for (const Force& force : forces)
        memory.write(force.address, force.value);
}

} // namespace camwright
