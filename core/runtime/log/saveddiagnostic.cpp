#include "core/runtime/log/saveddiagnostic.h"

namespace camwright {

namespace {

void savePlace(ByteWriter& writer, const Place& place)
{
    writer.put(place.object.kind);
    writer.putText(place.object.name);
    writer.putText(place.field);
    writer.put(place.range.line);
    writer.put(place.range.column);
    writer.put(place.range.endLine);
    writer.put(place.range.endColumn);
    writer.putText(place.file);
}

Place restorePlace(ByteReader& reader)
{
    Place place;
    place.object.kind = static_cast<ObjectKind>(reader.get<std::uint8_t>());
    if (place.object.kind > ObjectKind::WatchTable)
        reader.fail();
    place.object.name = reader.getText();
    place.field = reader.getText();
    place.range.line = reader.get<std::uint32_t>();
    place.range.column = reader.get<std::uint32_t>();
    place.range.endLine = reader.get<std::uint32_t>();
    place.range.endColumn = reader.get<std::uint32_t>();
    place.file = reader.getText();
    return place;
}

} // namespace

void saveDiagnostic(ByteWriter& writer, const Diagnostic& diagnostic)
{
    writer.putText(codeInfo(diagnostic.code).id);
    writer.put(static_cast<std::uint8_t>(diagnostic.arguments.size()));
    for (const std::string& argument : diagnostic.arguments)
        writer.putText(argument);
    savePlace(writer, diagnostic.place);
    writer.put(diagnostic.related.has_value());
    if (diagnostic.related)
        savePlace(writer, *diagnostic.related);
}

Diagnostic restoreDiagnostic(ByteReader& reader)
{
    Diagnostic out;
    const std::string id = reader.getText();
    bool known = false;
    for (const CodeInfo& info : allCodes()) {
        if (info.id == id) {
            out.code = info.code;
            known = true;
        }
    }
    if (!known)
        reader.fail();
    const auto count = reader.get<std::uint8_t>();
    for (unsigned i = 0; i < count && reader.ok(); ++i)
        out.arguments.push_back(reader.getText());
    out.place = restorePlace(reader);
    if (reader.getBool())
        out.related = restorePlace(reader);
    return out;
}

} // namespace camwright
