#include "core/language/image/imageparts.h"
#include "core/language/image/packing.h"

#include <algorithm>

namespace camwright {

namespace {

void put(ByteWriter& writer, const SourcePlace& place)
{
    putVar(writer, place.object);
    putVar(writer, place.rung);
    putVar(writer, place.range.line);
    putVar(writer, place.range.column);
    putVar(writer, place.range.endLine);
    putVar(writer, place.range.endColumn);
}

SourcePlace getSourcePlace(ByteReader& reader)
{
    SourcePlace place;
    place.object = getVar(reader);
    place.rung = getVar(reader);
    place.range.line = getVar(reader);
    place.range.column = getVar(reader);
    place.range.endLine = getVar(reader);
    place.range.endColumn = getVar(reader);
    return place;
}

ObjectKey getKey(ByteReader& reader)
{
    ObjectKey key;
    key.kind = reader.get<ObjectKind>();
    key.name = reader.getText();
    if (key.kind > ObjectKind::WatchTable)
        reader.fail();
    return key;
}

struct Run {
    std::uint32_t length = 0;
    std::uint32_t source = 0;
};

std::vector<Run> runsOf(const IrRoutine& routine)
{
    std::vector<Run> runs;
    for (const IrInstruction& i : routine.code) {
        if (!runs.empty() && runs.back().source == i.source)
            ++runs.back().length;
        else
            runs.push_back({1, i.source});
    }
    return runs;
}

ImagePart routinePart(const IrRoutine& routine)
{
    ByteWriter writer;
    putList(writer, runsOf(routine), [&](const Run& run) {
        putVar(writer, run.length);
        putVar(writer, run.source);
    });
    return {ImageSection::DebugMap, routine.name, writer.take()};
}

ImagePart placesPart(const DebugMap& debug)
{
    ByteWriter writer;
    writer.putText(debug.projectName);
    putList(writer, debug.objects, [&](const ObjectKey& key) {
        writer.put(key.kind);
        writer.putText(key.name);
    });
    putList(writer, debug.sources, [&](const SourcePlace& place) { put(writer, place); });
    return {ImageSection::DebugMap, {}, writer.take()};
}

bool readPlaces(ByteReader& reader, DebugMap& debug)
{
    debug.projectName = reader.getText();
    debug.objects = getList(reader, [&] { return getKey(reader); });
    debug.sources = getList(reader, [&] { return getSourcePlace(reader); });
    const bool known = std::ranges::all_of(debug.sources, [&](const SourcePlace& place) { return place.object < debug.objects.size(); });
    return known && reader.ok() && reader.atEnd();
}

bool readRuns(ByteReader& reader, IrRoutine& routine, std::size_t sources)
{
    const std::vector<Run> runs = getList(reader, [&] {
        const std::uint32_t length = getVar(reader);
        return Run{length, getVar(reader)};
    });
    std::size_t at = 0;
    for (const Run& run : runs) {
        if (run.length > routine.code.size() - at || run.source > sources)
            return false;
        for (std::uint32_t i = 0; i < run.length; ++i)
            routine.code[at++].source = run.source;
    }
    return at == routine.code.size() && reader.ok() && reader.atEnd();
}

} // namespace

std::vector<ImagePart> debugParts(const ControllerImage& image)
{
    std::vector<ImagePart> parts{placesPart(image.debug)};
    for (const IrRoutine& routine : image.program.routines)
        parts.push_back(routinePart(routine));
    return parts;
}

bool readDebugPart(const ImagePart& part, ControllerImage& image)
{
    ByteReader reader(part.bytes);
    if (part.name.empty())
        return readPlaces(reader, image.debug);
    auto& routines = image.program.routines;
    const auto found = std::ranges::find(routines, part.name, &IrRoutine::name);
    return found != routines.end() && readRuns(reader, *found, image.debug.sources.size());
}

} // namespace camwright
