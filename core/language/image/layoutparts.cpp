#include "core/language/image/imageparts.h"
#include "core/language/image/packing.h"

#include <algorithm>

namespace camwright {

namespace {

void put(ByteWriter& writer, const ImageArea& area)
{
    writer.put(area.id);
    writer.putText(area.name);
    putVar(writer, area.bytes);
    putVar(writer, area.retainedFrom);
    putVar(writer, area.retainedTo);
}

ImageArea getArea(ByteReader& reader)
{
    ImageArea area;
    area.id = reader.get<AreaId>();
    area.name = reader.getText();
    area.bytes = getVar(reader);
    area.retainedFrom = getVar(reader);
    area.retainedTo = getVar(reader);
    return area;
}

} // namespace

ImagePart targetPart(const ImageTarget& target)
{
    ByteWriter writer;
    writer.putText(target.family);
    writer.putText(target.model);
    writer.putBytes(target.catalogue.bytes);
    return {ImageSection::Target, {}, writer.take()};
}

bool readTargetPart(const ImagePart& part, ImageTarget& target)
{
    ByteReader reader(part.bytes);
    target.family = reader.getText();
    target.model = reader.getText();
    std::ranges::copy(reader.getBytes(target.catalogue.bytes.size()), target.catalogue.bytes.begin());
    return reader.ok() && reader.atEnd();
}

ImagePart layoutPart(const MemoryLayout& layout)
{
    ByteWriter writer;
    putList(writer, layout.areas, [&](const ImageArea& area) { put(writer, area); });
    putList(writer, layout.initialValues, [&](const InitialValue& initial) {
        put(writer, initial.address);
        put(writer, initial.value);
    });
    writer.put(layout.instructionErrorFlag.has_value());
    if (layout.instructionErrorFlag)
        put(writer, *layout.instructionErrorFlag);
    return {ImageSection::Layout, {}, writer.take()};
}

bool readLayoutPart(const ImagePart& part, MemoryLayout& layout)
{
    ByteReader reader(part.bytes);
    layout.areas = getList(reader, [&] { return getArea(reader); });
    layout.initialValues = getList(reader, [&] {
        const Address address = getAddress(reader);
        return InitialValue{address, getValue(reader)};
    });
    if (reader.getBool())
        layout.instructionErrorFlag = getAddress(reader);
    return reader.ok() && reader.atEnd();
}

ImagePart symbolsPart(const std::vector<Symbol>& symbols)
{
    ByteWriter writer;
    putList(writer, symbols, [&](const Symbol& symbol) {
        writer.putText(symbol.name);
        put(writer, symbol.address);
        writer.put(symbol.retain);
    });
    return {ImageSection::Symbols, {}, writer.take()};
}

bool readSymbolsPart(const ImagePart& part, std::vector<Symbol>& symbols)
{
    ByteReader reader(part.bytes);
    symbols = getList(reader, [&] {
        Symbol symbol;
        symbol.name = reader.getText();
        symbol.address = getAddress(reader);
        symbol.retain = reader.getBool();
        return symbol;
    });
    return reader.ok() && reader.atEnd();
}

std::vector<ImagePart> sourceParts(const std::vector<ArchivedFile>& source)
{
    std::vector<ImagePart> parts;
    for (const ArchivedFile& file : source)
        parts.push_back({ImageSection::Source, file.path, Bytes(file.text.begin(), file.text.end())});
    return parts;
}

bool readSourcePart(const ImagePart& part, std::vector<ArchivedFile>& source)
{
    source.push_back({part.name, std::string(part.bytes.begin(), part.bytes.end())});
    return !part.name.empty();
}

} // namespace camwright
