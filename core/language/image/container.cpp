#include "core/language/image/container.h"

#include <algorithm>
#include <array>

namespace camwright {

namespace {

constexpr std::array<std::uint8_t, 8> Magic = {'C', 'A', 'M', 'W', 'I', 'M', 'G', 0x1A};
constexpr std::size_t HeaderBytes = Magic.size() + 2 + 2 + 4 + 4; // magic, version, reserved, parts, size of the table

struct Table {
    std::vector<ImagePartInfo> parts;
    std::size_t bytes = 0; ///< header, table and their hash
};

Diagnostic cutShort(std::size_t have, std::size_t need)
{
    return diagnostic(Code::ImageCutShort, {std::to_string(have), std::to_string(need)});
}

std::string partName(const ImagePartInfo& part)
{
    return part.name.empty() ? "section " + std::to_string(static_cast<int>(part.section)) : part.name;
}

std::vector<ImagePartInfo> readEntries(ByteReader& reader, std::uint32_t count)
{
    std::vector<ImagePartInfo> parts;
    for (std::uint32_t i = 0; i < count && reader.ok(); ++i) {
        ImagePartInfo part;
        part.section = reader.get<ImageSection>();
        part.name = reader.getText();
        part.size = reader.get<std::uint32_t>();
        const ByteSpan hash = reader.getBytes(part.hash.bytes.size());
        std::ranges::copy(hash, part.hash.bytes.begin());
        parts.push_back(std::move(part));
    }
    return parts;
}

Result<Table> readTable(ByteSpan bytes)
{
    if (!std::ranges::equal(bytes.first(std::min(bytes.size(), Magic.size())), std::span(Magic).first(std::min(bytes.size(), Magic.size()))))
        return diagnostic(Code::NotAnImage);
    if (bytes.size() < HeaderBytes)
        return cutShort(bytes.size(), HeaderBytes);
    ByteReader reader(bytes.subspan(Magic.size()));
    const auto version = reader.get<std::uint16_t>();
    if (version != ImageFormatVersion)
        return diagnostic(Code::ImageVersionUnknown, {std::to_string(version), std::to_string(ImageFormatVersion)});
    reader.get<std::uint16_t>();
    const auto count = reader.get<std::uint32_t>();
    const std::size_t tableEnd = HeaderBytes + reader.get<std::uint32_t>();
    Table table;
    table.bytes = tableEnd + sizeof Hash::bytes;
    if (bytes.size() < table.bytes)
        return cutShort(bytes.size(), table.bytes);
    const Hash hash = hashOf(bytes.first(tableEnd));
    if (!std::ranges::equal(hash.bytes, bytes.subspan(tableEnd, sizeof Hash::bytes)))
        return diagnostic(Code::ImagePartDamaged, {"table"});
    ByteReader entries(bytes.subspan(HeaderBytes, tableEnd - HeaderBytes));
    table.parts = readEntries(entries, count);
    if (!entries.ok() || !entries.atEnd())
        return diagnostic(Code::ImageMalformed, {"table"});
    return table;
}

} // namespace

std::vector<ImagePartInfo> partTable(const std::vector<ImagePart>& parts)
{
    std::vector<ImagePartInfo> table;
    table.reserve(parts.size());
    for (const ImagePart& part : parts)
        table.push_back({part.section, part.name, static_cast<std::uint32_t>(part.bytes.size()), hashOf(part.bytes)});
    return table;
}

Bytes writeContainer(const std::vector<ImagePart>& parts)
{
    ByteWriter table;
    for (const ImagePartInfo& part : partTable(parts)) {
        table.put(part.section);
        table.putText(part.name);
        table.put(part.size);
        table.putBytes(part.hash.bytes);
    }
    ByteWriter writer;
    writer.putBytes(Magic);
    writer.put(ImageFormatVersion);
    writer.put<std::uint16_t>(0);
    writer.put(static_cast<std::uint32_t>(parts.size()));
    writer.put(static_cast<std::uint32_t>(table.bytes().size()));
    writer.putBytes(table.bytes());
    const Hash hash = hashOf(writer.bytes());
    writer.putBytes(hash.bytes);
    for (const ImagePart& part : parts)
        writer.putBytes(part.bytes);
    return writer.take();
}

Result<std::vector<ImagePartInfo>> readPartTable(ByteSpan bytes)
{
    Result<Table> table = readTable(bytes);
    if (!table)
        return table.error();
    return std::move(table->parts);
}

Result<std::vector<ImagePart>> readContainer(ByteSpan bytes)
{
    const Result<Table> table = readTable(bytes);
    if (!table)
        return table.error();
    std::uint64_t end = table->bytes;
    for (const ImagePartInfo& part : table->parts)
        end += part.size;
    if (bytes.size() != end)
        return cutShort(bytes.size(), end);
    std::vector<ImagePart> parts;
    std::size_t at = table->bytes;
    for (const ImagePartInfo& info : table->parts) {
        const ByteSpan content = bytes.subspan(at, info.size);
        at += info.size;
        if (hashOf(content) != info.hash)
            return diagnostic(Code::ImagePartDamaged, {partName(info)});
        parts.push_back({info.section, info.name, Bytes(content.begin(), content.end())});
    }
    return parts;
}

Hash programHash(const std::vector<ImagePartInfo>& parts)
{
    ByteWriter writer;
    for (const ImagePartInfo& part : parts) {
        if (part.section >= ImageSection::DebugMap)
            continue;
        writer.put(part.section);
        writer.putText(part.name);
        writer.putBytes(part.hash.bytes);
    }
    return hashOf(writer.bytes());
}

} // namespace camwright
