#include "core/storage/projectstore.h"

#include "core/storage/filenames.h"
#include "core/storage/objecttext.h"
#include "core/storage/projectreader.h"
#include "core/storage/savetransaction.h"

#include <algorithm>
#include <set>

namespace camwright {

namespace {

ByteSpan bytesOf(std::string_view text)
{
    return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

/// The known files by the object in them.
std::map<ObjectKey, KnownFiles::const_iterator> byObject(const KnownFiles& files)
{
    std::map<ObjectKey, KnownFiles::const_iterator> out;
    for (auto it = files.begin(); it != files.end(); ++it)
        out.emplace(it->second.object->key, it);
    return out;
}

/// A removed object of the same kind and content: the object was renamed, and its file's comments go with it.
const KnownFile* renamedFrom(const Object& object, const KnownFiles& known, const Project& now)
{
    for (const auto& [path, file] : known) {
        if (file.object->key.kind == object.key.kind && !now.find(file.object->key) && file.object->content == object.content)
            return &file;
    }
    return nullptr;
}

std::string textFor(const ObjectPtr& object, const KnownFile* known)
{
    if (!known)
        return toText(*object);
    return known->object == object ? known->text : toTextKeeping(*object, known->text);
}

/// What a save has to do, and the files as they are when it is done (their stamps still missing).
struct SavePlan {
    std::vector<FileChange> changes;
    KnownFiles after;
};

SavePlan planSave(const KnownFiles& known, const Project& now)
{
    SavePlan out;
    const auto objects = byObject(known);
    for (const auto& [key, object] : now.all()) {
        const auto found = objects.find(key);
        const KnownFile* before = found == objects.end() ? renamedFrom(*object, known, now) : &found->second->second;
        const std::string path = found == objects.end() ? fileOf(key, now) : found->second->first;
        const auto here = known.find(path);
        if (here != known.end() && here->second.object == object) {
            out.after.emplace(path, here->second);
            continue;
        }
        std::string text = textFor(object, before);
        KnownFile file{object, {}, hashOf(bytesOf(text)), text};
        if (here != known.end() && here->second.text == text)
            file.stamp = here->second.stamp;
        else
            out.changes.push_back({path, std::move(text), here == known.end() ? Hash{} : here->second.hash});
        out.after.emplace(path, std::move(file));
    }
    for (const auto& [path, file] : known) {
        if (!out.after.contains(path))
            out.changes.push_back({path, std::nullopt, file.hash});
    }
    return out;
}

/// Sets what each change really replaces; refuses when that is another program's work.
Result<void> checkOutsideChanges(FileSystem& files, const std::string& path, std::vector<FileChange>& changes,
                                 const FinishedSave& finished, Overwrite overwrite)
{
    for (FileChange& change : changes) {
        const auto text = files.read(path + '/' + change.path, LargestProjectFile);
        if (!text && text.error().code != Code::FileNotFound)
            return text.error();
        const Hash now = text ? hashOf(bytesOf(*text)) : Hash{};
        const auto ours = finished.files.find(change.path);
        const bool expected = now == change.before || (ours != finished.files.end() && ours->second == now)
            || (change.text && text && *change.text == *text) || (!change.text && !text);
        if (!expected && overwrite == Overwrite::Refuse)
            return diagnostic(Code::ChangedOutside, {change.path});
        change.before = now;
    }
    return {};
}

/// A file whose stamp cannot be had is looked into when somebody asks whether it changed.
void setStamps(FileSystem& files, const std::string& path, const std::vector<FileChange>& changes, KnownFiles& known)
{
    for (const FileChange& change : changes) {
        if (!change.text)
            continue;
        if (const auto stamp = files.stamp(path + '/' + change.path))
            known[change.path].stamp = *stamp;
    }
}

Result<KnownFiles> save(FileSystem& files, const std::string& path, SavePlan plan, Overwrite overwrite,
                        const std::vector<std::string>& finishedJournals)
{
    if (plan.changes.empty() && finishedJournals.empty() && !hasInterruptedSave(files, path))
        return std::move(plan.after);
    if (auto made = makePrivateFolder(files, path); !made)
        return made.error();
    const auto lock = lockSaving(files, path);
    if (!lock)
        return lock.error();
    const auto finished = finishSave(files, path);
    if (!finished)
        return finished.error();
    if (auto checked = checkOutsideChanges(files, path, plan.changes, *finished, overwrite); !checked)
        return checked.error();
    for (const std::string& journal : finishedJournals)
        plan.changes.push_back({".camwright/" + journal, std::nullopt, {}});
    if (!plan.changes.empty()) {
        if (auto saved = runSave(files, path, plan.changes); !saved)
            return saved.error();
    }
    std::erase_if(plan.changes, [](const FileChange& change) { return change.path.starts_with(".camwright/"); });
    setStamps(files, path, plan.changes, plan.after);
    return std::move(plan.after);
}

} // namespace

Result<LoadedProject, Diagnostics> openProject(FileSystem& files, const std::string& path)
{
    std::unique_ptr<FileLock> lock;
    Diagnostics notes;
    if (files.stamp(privateFolder(path))) {
        auto locked = lockSaving(files, path);
        if (locked)
            lock = std::move(*locked);
        else if (hasInterruptedSave(files, path))
            return Diagnostics{locked.error()};
        // A read-only folder without an interrupted save can be read without a lock.
    }
    if (lock) {
        auto finished = finishSave(files, path);
        if (!finished)
            return Diagnostics{finished.error()};
        notes = std::move(finished->notes);
    }
    auto loaded = readProjectFiles(files, path);
    if (loaded)
        loaded->notes.insert(loaded->notes.begin(), notes.begin(), notes.end());
    return loaded;
}

Result<KnownFiles> saveProject(FileSystem& files, const std::string& path, const KnownFiles& known, const Project& now,
                               Overwrite overwrite, const std::vector<std::string>& finishedJournals)
{
    return save(files, path, planSave(known, now), overwrite, finishedJournals);
}

Result<KnownFiles> createProject(FileSystem& files, const std::string& path, const Project& project, const KnownFiles& from)
{
    if (files.stamp(path + '/' + fileOf(projectKey())))
        return diagnostic(Code::AlreadyAProject, {path});
    if (auto made = files.makeDirectory(path); !made)
        return made.error();
    SavePlan plan = planSave(from, project);
    plan.changes.clear();
    for (const auto& [file, known] : plan.after)
        plan.changes.push_back({file, known.text, {}});
    return save(files, path, std::move(plan), Overwrite::Refuse, {});
}

std::vector<std::string> filesChangedOutside(FileSystem& files, const std::string& path, const KnownFiles& known)
{
    std::set<std::string> out;
    for (const auto& [name, file] : known) {
        const auto stamp = files.stamp(path + '/' + name);
        if (stamp && *stamp == file.stamp)
            continue;
        const auto text = stamp ? files.read(path + '/' + name, LargestProjectFile) : Result<std::string>(stamp.error());
        if (!text || hashOf(bytesOf(*text)) != file.hash)
            out.insert(name);
    }
    for (const std::string& name : projectFileNames(files, path)) {
        if (!known.contains(name))
            out.insert(name);
    }
    return {out.begin(), out.end()};
}

Result<std::unique_ptr<FileLock>> lockProject(FileSystem& files, const std::string& path)
{
    if (auto made = makePrivateFolder(files, path); !made)
        return made.error();
    return files.lock(privateFolder(path) + "/lock", LockWait::No);
}

Hash hashOf(const Project& project)
{
    ByteWriter out;
    for (const auto& [key, object] : project.all()) {
        out.put(key.kind);
        out.putText(key.name);
        out.putText(toText(*object));
    }
    return hashOf(out.bytes());
}

} // namespace camwright
