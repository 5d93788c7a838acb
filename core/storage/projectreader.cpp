#include "core/storage/projectreader.h"

#include "core/storage/filenames.h"
#include "core/storage/objecttext.h"
#include "core/storage/settingsline.h"
#include "core/storage/tomlobject.h"

#include <algorithm>

namespace camwright {

namespace {

constexpr ObjectKind NamedKinds[] = {ObjectKind::Axis, ObjectKind::Network, ObjectKind::Program, ObjectKind::VariableTable,
                                     ObjectKind::WatchTable};

/// The name an object's file carries inside because it is too long for a file name.
std::optional<std::string> nameInside(ObjectKind kind, std::string_view text, const std::string& file)
{
    if (!isTomlKind(kind)) {
        const auto line = readSettingsLine(text, file, "");
        const auto found = line ? line->values.find("name") : std::map<std::string, std::string>::const_iterator();
        return line && found != line->values.end() ? nameOfStem(settingValue(found->second)) : std::nullopt;
    }
    const auto leaves = parseToml(text, file);
    if (!leaves)
        return std::nullopt;
    for (const TomlLeaf& leaf : *leaves) {
        if (leaf.path == "name" && leaf.value.kind == TomlValue::Kind::String)
            return nameOfStem(leaf.value.string);
    }
    return std::nullopt;
}

class ProjectReader {
public:
    ProjectReader(FileSystem& files, const std::string& path) : m_files(files), m_path(path) {}

    Result<LoadedProject, Diagnostics> read()
    {
        if (const auto folder = m_files.stamp(m_path); !folder)
            return Diagnostics{folder.error()};
        if (auto settings = readText(fileOf(projectKey())); !settings) {
            const bool missing = settings.error().code == Code::FileNotFound;
            return Diagnostics{missing ? diagnostic(Code::NotAProject, {m_path}) : settings.error()};
        } else {
            addObject(projectKey(), fileOf(projectKey()), std::move(*settings));
        }
        if (!m_errors.empty() && m_errors.front().code == Code::NewerFormat)
            return std::move(m_errors); // what else looks wrong may be right in that format
        readController();
        for (const ObjectKind kind : NamedKinds)
            readFolder(kind);
        if (!m_errors.empty())
            return std::move(m_errors);
        return std::move(m_out);
    }

private:
    void readController()
    {
        auto text = readText(fileOf(controllerKey()));
        if (text)
            addObject(controllerKey(), fileOf(controllerKey()), std::move(*text));
        else if (text.error().code != Code::FileNotFound) // that there is none is found by the checks
            m_errors.push_back(text.error());
    }

    void readFolder(ObjectKind kind)
    {
        const FilePattern pattern = filePattern(kind);
        const std::string folder(pattern.folder);
        const auto entries = m_files.list(m_path + '/' + folder.substr(0, folder.size() - 1));
        if (!entries) {
            if (entries.error().code != Code::FileNotFound)
                m_errors.push_back(entries.error());
            return;
        }
        for (const DirectoryEntry& entry : *entries) {
            const auto ending = pattern.endingOf(entry.name);
            if (entry.kind == EntryKind::File && ending && !entry.name.starts_with('.'))
                readNamed(kind, folder + entry.name, entry.name.substr(0, entry.name.size() - ending->size()));
        }
    }

    void readNamed(ObjectKind kind, const std::string& file, const std::string& stem)
    {
        auto text = readText(file);
        if (!text) {
            m_errors.push_back(text.error());
            return;
        }
        const auto name = isShortened(stem) ? nameInside(kind, *text, file) : nameOfStem(stem);
        if (!name || (isShortened(stem) && stemOf(*name) != stem && distinctStemOf(*name) != stem)) {
            Place place;
            place.file = file;
            m_errors.push_back(diagnostic(Code::FileNameWrong, {file}, place));
            return;
        }
        addObject({kind, *name}, file, std::move(*text));
    }

    void addObject(const ObjectKey& key, const std::string& file, std::string text)
    {
        auto object = fromText(key, text, file);
        if (!object) {
            m_errors.insert(m_errors.end(), object.error().begin(), object.error().end());
            return;
        }
        for (const auto& [other, known] : m_out.files) {
            if (known.object->key == key) {
                Place place{key, {}, {}, file};
                m_errors.push_back(diagnostic(Code::ObjectTwice, {other, file, key.name}, place));
                return;
            }
        }
        const auto stamp = m_files.stamp(m_path + '/' + file);
        if (!stamp) {
            m_errors.push_back(stamp.error());
            return;
        }
        const auto pointer = std::make_shared<const Object>(std::move(*object));
        const auto* bytes = reinterpret_cast<const std::uint8_t*>(text.data());
        const Hash hash = hashOf(ByteSpan(bytes, text.size()));
        m_out.project = m_out.project.with(key, pointer);
        m_out.files.emplace(file, KnownFile{pointer, *stamp, hash, std::move(text)});
    }

    Result<std::string> readText(const std::string& file) { return m_files.read(m_path + '/' + file, LargestProjectFile); }

    FileSystem& m_files;
    const std::string& m_path;
    LoadedProject m_out;
    Diagnostics m_errors;
};

} // namespace

Result<LoadedProject, Diagnostics> readProjectFiles(FileSystem& files, const std::string& path)
{
    return ProjectReader(files, path).read();
}

std::vector<std::string> projectFileNames(FileSystem& files, const std::string& path)
{
    std::vector<std::string> out;
    for (const ObjectKey& key : {projectKey(), controllerKey()}) {
        if (files.stamp(path + '/' + fileOf(key)))
            out.push_back(fileOf(key));
    }
    for (const ObjectKind kind : NamedKinds) {
        const FilePattern pattern = filePattern(kind);
        const std::string folder(pattern.folder);
        const auto entries = files.list(path + '/' + folder.substr(0, folder.size() - 1));
        if (!entries)
            continue;
        for (const DirectoryEntry& entry : *entries) {
            if (entry.kind == EntryKind::File && pattern.endingOf(entry.name) && !entry.name.starts_with('.'))
                out.push_back(folder + entry.name);
        }
    }
    return out;
}

} // namespace camwright
