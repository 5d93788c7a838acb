#include "core/storage/filenames.h"
#include "core/storage/objecttext.h"
#include "core/storage/tomlobject.h"
#include "core/storage/variabletext.h"

#include <algorithm>
#include <charconv>

namespace camwright {

namespace {

/// The n of "rows[n]" or "rows[n].address".
std::optional<std::size_t> rowOf(std::string_view field)
{
    if (!field.starts_with("rows["))
        return std::nullopt;
    std::size_t row = 0;
    const auto result = std::from_chars(field.data() + 5, field.data() + field.size(), row);
    const bool closed = result.ptr != field.data() + field.size() && *result.ptr == ']';
    return result.ec == std::errc{} && closed ? std::optional(row) : std::nullopt;
}

TextRange rangeInToml(std::string_view text, const std::string& field)
{
    const auto leaves = parseToml(text, {});
    if (!leaves)
        return {};
    const auto row = rowOf(field);
    for (const TomlLeaf& leaf : *leaves) {
        if (leaf.path == field)
            return leaf.value.range;
        if (row && leaf.path == "rows" && *row < leaf.value.elements.size())
            return leaf.value.elements[*row].range;
    }
    return {};
}

TextRange rangeInTable(std::string_view text, const std::string& field)
{
    const std::size_t settings = std::min(text.find('\n'), text.size() - 1) + 1;
    const auto table = readVariables(text.substr(settings), 2, {});
    const auto row = rowOf(field);
    return table && row && *row < table->rowRanges.size() ? table->rowRanges[*row] : TextRange{};
}

std::string caseKey(const ObjectKey& key)
{
    return foldedCase(key.name);
}

} // namespace

std::string fileOf(const ObjectKey& key)
{
    const FilePattern pattern = filePattern(key.kind);
    if (pattern.folder.empty())
        return std::string(pattern.ending);
    return std::string(pattern.folder) + stemOf(key.name) + std::string(pattern.ending);
}

std::string fileOf(const ObjectKey& key, const Project& project)
{
    FilePattern pattern = filePattern(key.kind);
    if (pattern.folder.empty())
        return std::string(pattern.ending);
    if (const auto* program = project.content<Program>(key); program && program->language == ProgramLanguage::StructuredText)
        pattern.ending = pattern.otherEnding;
    for (auto it = project.all().lower_bound(ObjectKey{key.kind, ""}); it != project.all().end() && it->first < key; ++it) {
        if (caseKey(it->first) == caseKey(key)) // the first of them keeps its plain name
            return std::string(pattern.folder) + distinctStemOf(key.name) + std::string(pattern.ending);
    }
    return std::string(pattern.folder) + stemOf(key.name) + std::string(pattern.ending);
}

Place filePlace(const Place& place, const Project& project, const KnownFiles& files)
{
    const ObjectPtr object = project.find(place.object);
    if (!object)
        return place;
    Place out = place;
    const auto known = std::find_if(files.begin(), files.end(), [&](const auto& file) { return file.second.object->key == place.object; });
    out.file = known == files.end() ? fileOf(place.object, project) : known->first;
    if (out.range.isValid()) {
        if (place.object.kind == ObjectKind::Program) {
            ++out.range.line;
            ++out.range.endLine;
        }
        return out;
    }
    const std::string text = known == files.end() ? toText(*object) : toTextKeeping(*object, known->second.text);
    if (place.object.kind == ObjectKind::VariableTable)
        out.range = rangeInTable(text, place.field);
    else if (isTomlKind(place.object.kind))
        out.range = rangeInToml(text, place.field);
    return out;
}

} // namespace camwright
