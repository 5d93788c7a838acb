#include "core/language/assist/freememory.h"

#include "core/language/assist/crossreference.h"
#include "core/language/check/operandtypes.h"

#include <algorithm>

namespace camwright {

FreeMemory::FreeMemory(const Project& project, const LanguageContext& context) : m_context(context)
{
    for (const MemoryArea& area : context.family->areas())
        m_used[area.id].resize(std::size_t{context.model->area(area.id).bytes} * 8);
    for (const SymbolUse& use : crossReference(project)) {
        const auto* memory = std::get_if<MemoryTarget>(&use.target);
        if (memory && memory->address.area != VariablesArea)
            mark(memory->address.area, std::uint64_t{memory->address.byte} * 8 + (memory->address.isBit ? memory->address.bit : 0), memory->bits);
    }
}

void FreeMemory::mark(AreaId area, std::uint64_t bit, std::uint64_t bits)
{
    std::vector<bool>& used = m_used[area];
    for (std::uint64_t at = bit; at < std::min<std::uint64_t>(bit + bits, used.size()); ++at)
        used[at] = true;
}

bool FreeMemory::isFree(AreaId area, std::uint64_t bit, std::uint64_t bits) const
{
    const std::vector<bool>& used = m_used.at(area);
    if (bit + bits > used.size())
        return false;
    for (std::uint64_t at = bit; at < bit + bits; ++at)
        if (used[at])
            return false;
    return true;
}

bool FreeMemory::isUsable(const Address& address) const
{
    return m_context.family->isWritable(address) && m_context.family->withType(address, address.type, *m_context.model).ok();
}

std::optional<Address> FreeMemory::takeBit(AreaId area)
{
    const std::uint64_t bytes = m_used.at(area).size() / 8;
    const bool oneByteEach = m_context.family->area(area).kind == AreaKind::Bits;
    const unsigned bitsOfByte = oneByteEach ? 1 : 8;
    const auto fromByte = [&](std::uint64_t byte) -> std::optional<Address> {
        for (unsigned bit = 0; bit < bitsOfByte; ++bit) {
            const Address address = bitAddress(area, static_cast<std::uint32_t>(byte), bit);
            if (!isFree(area, byte * 8 + bit, 1) || !isUsable(address))
                continue;
            mark(area, byte * 8 + bit, 1);
            return address;
        }
        return std::nullopt;
    };
    if (const auto open = m_openByte.find(area); open != m_openByte.end())
        if (auto address = fromByte(open->second))
            return address;
    for (const bool whole : {true, false})
        for (std::uint64_t byte = 0; byte < bytes; ++byte)
            if (isFree(area, byte * 8, whole ? bitsOfByte : 0))
                if (auto address = fromByte(byte)) {
                    m_openByte[area] = byte;
                    return address;
                }
    return std::nullopt;
}

std::optional<Address> FreeMemory::take(AreaId area, DataType type)
{
    const AreaKind kind = m_context.family->area(area).kind;
    if (kind != AreaKind::Bytes && kind != AreaKind::Bits && kind != AreaKind::Words)
        return std::nullopt;
    if (type == DataType::Bool)
        return kind == AreaKind::Words ? std::nullopt : takeBit(area);
    if (kind == AreaKind::Bits)
        return std::nullopt;
    const std::uint64_t width = byteWidth(type), bytes = m_used.at(area).size() / 8;
    for (std::uint64_t byte = 0; byte + width <= bytes; byte += std::max<std::uint64_t>(width, kind == AreaKind::Words ? 2 : 1)) {
        const auto typed = m_context.family->withType(valueAddress(area, static_cast<std::uint32_t>(byte), type), type, *m_context.model);
        if (!typed || !isFree(area, byte * 8, width * 8) || !isUsable(*typed))
            continue;
        mark(area, byte * 8, width * 8);
        return *typed;
    }
    return std::nullopt;
}

std::optional<Address> FreeMemory::takeFor(const Pin* pin, DataType type)
{
    const auto takes = [&](AreaId area) { return !pin || pin->areas.empty() || std::ranges::find(pin->areas, area) != pin->areas.end(); };
    for (const char* name : {type == DataType::Bool ? "M" : "V", type == DataType::Bool ? "C" : "D"}) {
        const MemoryArea* area = m_context.family->findArea(name);
        if (!area || area->local || !takes(area->id))
            continue;
        if (auto address = take(area->id, type))
            return address;
    }
    if (pin)
        for (const AreaId area : pin->areas)
            if (!m_context.family->area(area).local)
                if (auto address = take(area, type))
                    return address;
    return std::nullopt;
}

} // namespace camwright
