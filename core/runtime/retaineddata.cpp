#include "core/runtime/retaineddata.h"

#include <algorithm>
#include <map>

namespace camwright {

namespace {

constexpr std::uint32_t kVersion = 1;

struct RetainedRange {
    std::uint32_t from = 0;
    ByteSpan bytes;
};

struct RetainedVariable {
    DataType type = DataType::Bool;
    std::uint64_t bits = 0;
};

struct RetainedContent {
    std::string family;
    std::map<std::string, RetainedRange, std::less<>> areas; ///< by area name and kind
    std::map<std::string, RetainedVariable, std::less<>> variables;
};

/// Bit and value areas of timers share a name; the number tells them apart.
std::string areaKey(const ImageArea& area)
{
    return area.name + "#" + std::to_string(area.id);
}

bool isInRetainedArea(const ControllerImage& image, const Address& address)
{
    for (const ImageArea& area : image.layout.areas) {
        if (area.id == address.area)
            return address.byte >= area.retainedFrom && address.byte + byteWidth(address.type) <= area.retainedTo;
    }
    return false;
}

bool read(ByteSpan bytes, RetainedContent& out)
{
    ByteReader reader(bytes);
    if (reader.get<std::uint32_t>() != kVersion)
        return false;
    out.family = reader.getText();
    const auto areas = reader.get<std::uint32_t>();
    for (std::uint32_t i = 0; i < areas && reader.ok(); ++i) {
        std::string key = reader.getText();
        const auto from = reader.get<std::uint32_t>();
        out.areas[std::move(key)] = {from, reader.getBlob()};
    }
    const auto variables = reader.get<std::uint32_t>();
    for (std::uint32_t i = 0; i < variables && reader.ok(); ++i) {
        std::string key = reader.getText();
        const auto type = reader.get<DataType>();
        out.variables[std::move(key)] = {type, reader.get<std::uint64_t>()};
    }
    return reader.ok() && reader.atEnd();
}

void applyArea(const RetainedRange& range, const ImageArea& area, Memory& memory)
{
    const std::span<std::uint8_t> bytes = memory.area(area.id);
    const std::uint64_t rangeEnd = std::uint64_t{range.from} + range.bytes.size();
    const std::uint64_t from = std::max<std::uint64_t>(range.from, area.retainedFrom);
    const std::uint64_t to = std::min({rangeEnd, std::uint64_t{area.retainedTo}, std::uint64_t{bytes.size()}});
    for (std::uint64_t at = from; at < to; ++at)
        bytes[at] = range.bytes[at - range.from];
}

} // namespace

Bytes collectRetained(const ControllerImage& image, const Memory& memory)
{
    ByteWriter writer;
    writer.put(kVersion);
    writer.putText(image.target.family);
    std::vector<const ImageArea*> areas;
    for (const ImageArea& area : image.layout.areas) {
        if (area.retainedTo > area.retainedFrom)
            areas.push_back(&area);
    }
    writer.put(static_cast<std::uint32_t>(areas.size()));
    for (const ImageArea* area : areas) {
        writer.putText(areaKey(*area));
        writer.put(area->retainedFrom);
        writer.putBlob(memory.area(area->id).subspan(area->retainedFrom, area->retainedTo - area->retainedFrom));
    }
    std::vector<const Symbol*> variables;
    for (const Symbol& symbol : image.symbols) {
        if (symbol.retain && !isInRetainedArea(image, symbol.address))
            variables.push_back(&symbol);
    }
    writer.put(static_cast<std::uint32_t>(variables.size()));
    for (const Symbol* symbol : variables) {
        writer.putText(symbol->name);
        writer.put(symbol->address.type);
        writer.put(memory.read(symbol->address).bits);
    }
    return writer.take();
}

Result<void> applyRetained(ByteSpan retained, const ControllerImage& image, Memory& memory)
{
    RetainedContent content;
    if (!read(retained, content))
        return diagnostic(Code::RetainedDamaged);
    if (content.family != image.target.family)
        return {};
    for (const ImageArea& area : image.layout.areas) {
        const auto found = content.areas.find(areaKey(area));
        if (found != content.areas.end() && area.retainedTo > area.retainedFrom)
            applyArea(found->second, area, memory);
    }
    for (const Symbol& symbol : image.symbols) {
        const auto found = content.variables.find(symbol.name);
        if (symbol.retain && found != content.variables.end() && found->second.type == symbol.address.type)
            memory.write(symbol.address, {found->second.type, found->second.bits});
    }
    return {};
}

} // namespace camwright
