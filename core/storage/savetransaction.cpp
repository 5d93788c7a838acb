#include "core/storage/savetransaction.h"

#include "core/storage/filenames.h"
#include "core/storage/quotedtext.h"

#include <algorithm>
#include <set>
#include <sstream>

namespace camwright {

namespace {

constexpr std::uint64_t LargestFile = std::uint64_t{1} << 30;
constexpr std::string_view RecordHead = "camwright-save 1";
constexpr std::string_view NoHash = "-";

ByteSpan bytesOf(std::string_view text)
{
    return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

std::string stagingFolder(const std::string& projectPath) { return privateFolder(projectPath) + "/save"; }
std::string recordPath(const std::string& projectPath) { return stagingFolder(projectPath) + "/commit"; }

std::string folderOf(const std::string& path)
{
    return path.substr(0, path.rfind('/'));
}

bool isMissing(const Diagnostic& error) { return error.code == Code::FileNotFound; }

/// Null when there is no such file.
Result<Hash> contentHash(FileSystem& files, const std::string& path)
{
    const auto text = files.read(path, LargestFile);
    if (text)
        return hashOf(bytesOf(*text));
    return isMissing(text.error()) ? Result<Hash>(Hash{}) : Result<Hash>(text.error());
}

Result<void> removeIfThere(FileSystem& files, const std::string& path)
{
    auto removed = files.remove(path);
    return removed || isMissing(removed.error()) ? Result<void>() : removed;
}

/// One line of the record: where the staged file goes, and what lay there.
struct Step {
    std::string staged; ///< name in the staging folder; empty: the target is removed
    std::string target;
    std::string before; ///< hex
    std::string after;
};

std::string hexOrNone(const Hash& hash)
{
    return hash.isNull() ? std::string(NoHash) : toHex(hash);
}

std::string recordText(const std::vector<Step>& steps)
{
    std::string out(RecordHead);
    out += '\n';
    for (const Step& step : steps) {
        out += step.staged.empty() ? std::string(NoHash) : step.staged;
        out += ' ' + step.before + ' ' + step.after + ' ' + quoted(step.target) + '\n';
    }
    return out + "end " + toHex(hashOf(bytesOf(out))) + '\n';
}

/// A project from a stranger may carry a record: only files that a save of ours writes are named in one.
bool isOurFile(std::string_view path)
{
    if (path.find('\0') != std::string_view::npos || path.find("..") == 0)
        return false;
    if (path == filePattern(ObjectKind::Project).ending || path == filePattern(ObjectKind::Controller).ending)
        return true;
    std::string_view rest = path;
    for (const ObjectKind kind : {ObjectKind::Axis, ObjectKind::Network, ObjectKind::Program, ObjectKind::VariableTable, ObjectKind::WatchTable}) {
        const FilePattern pattern = filePattern(kind);
        if (rest.starts_with(pattern.folder) && rest.ends_with(pattern.ending))
            return rest.substr(pattern.folder.size()).find('/') == std::string_view::npos;
    }
    return rest.starts_with(".camwright/journal.") && rest.find('/', 11) == std::string_view::npos;
}

bool isStagedName(std::string_view name)
{
    return !name.empty() && std::all_of(name.begin(), name.end(), [](char c) { return c >= '0' && c <= '9'; });
}

/// Nothing when the record is not whole; then nothing was moved either.
std::optional<std::vector<Step>> readRecord(const std::string& text)
{
    const std::size_t end = text.rfind("end ");
    if (!text.starts_with(RecordHead) || end == std::string::npos
        || text.substr(end) != "end " + toHex(hashOf(bytesOf(std::string_view(text).substr(0, end)))) + '\n')
        return std::nullopt;
    std::istringstream lines(text.substr(0, end));
    std::string line;
    std::getline(lines, line);
    std::vector<Step> out;
    while (std::getline(lines, line)) {
        std::istringstream words(line);
        Step step;
        words >> step.staged >> step.before >> step.after;
        const std::size_t quote = line.find('"');
        if (quote == std::string::npos || line.size() < quote + 2)
            return std::nullopt;
        step.target = unescaped(std::string_view(line).substr(quote + 1, line.size() - quote - 2));
        if (step.staged == NoHash)
            step.staged.clear();
        if (!isOurFile(step.target) || (!step.staged.empty() && !isStagedName(step.staged)))
            return std::nullopt;
        out.push_back(std::move(step));
    }
    return out;
}

/// Moves staged files to their places. May be run again from the start after it stopped anywhere.
class Mover {
public:
    Mover(FileSystem& files, const std::string& projectPath) : m_files(files), m_root(projectPath) {}

    Result<void> run(const std::vector<Step>& steps)
    {
        for (const Step& step : steps) {
            if (auto moved = move(step); !moved)
                return moved;
        }
        for (const std::string& folder : m_touched) {
            if (auto synced = m_files.syncDirectory(folder); !synced)
                return synced;
        }
        return {};
    }
    Diagnostics takeNotes() { return std::move(m_notes); }

private:
    Result<void> move(const Step& step)
    {
        const std::string target = m_root + '/' + step.target;
        const std::string staged = stagingFolder(m_root) + '/' + step.staged;
        if (!step.staged.empty()) {
            const auto there = m_files.stamp(staged);
            if (!there)
                return isMissing(there.error()) ? touch(target) : Result<void>(there.error()); // moved before
            if (folderOf(target) != m_root) {
                if (auto made = m_files.makeDirectory(folderOf(target)); !made)
                    return made;
            }
        }
        if (auto aside = setAside(step, target); !aside)
            return aside;
        auto done = step.staged.empty() ? removeIfThere(m_files, target) : m_files.rename(staged, target);
        return done ? touch(target) : done;
    }

    /// What another program put at the target since the save began is kept.
    Result<void> setAside(const Step& step, const std::string& target)
    {
        if (step.target.starts_with(".camwright/"))
            return {};
        const auto now = contentHash(m_files, target);
        if (!now)
            return now.error();
        const std::string hex = hexOrNone(*now);
        if (now->isNull() || hex == step.before || hex == step.after)
            return {};
        const std::string folder = privateFolder(m_root) + "/kept";
        const std::string name = step.target.substr(step.target.rfind('/') + 1) + '.' + shortHex(*now);
        if (auto made = m_files.makeDirectory(folder); !made)
            return made;
        m_notes.push_back(diagnostic(Code::FileSetAside, {step.target, ".camwright/kept/" + name}));
        return m_files.rename(target, folder + '/' + name);
    }

    Result<void> touch(const std::string& target)
    {
        m_touched.insert(folderOf(target));
        m_touched.insert(m_root); // a folder may have been made in it
        return {};
    }

    FileSystem& m_files;
    const std::string& m_root;
    std::set<std::string> m_touched;
    Diagnostics m_notes;
};

/// Empties the staging folder, the record first.
Result<void> clearStaging(FileSystem& files, const std::string& projectPath)
{
    const std::string folder = stagingFolder(projectPath);
    if (auto removed = removeIfThere(files, recordPath(projectPath)); !removed)
        return removed;
    if (auto synced = files.syncDirectory(folder); !synced)
        return synced;
    const auto entries = files.list(folder);
    if (!entries)
        return entries.error();
    for (const DirectoryEntry& entry : *entries) {
        if (auto removed = removeIfThere(files, folder + '/' + entry.name); !removed)
            return removed;
    }
    return removeIfThere(files, folder);
}

Result<std::vector<Step>> stage(FileSystem& files, const std::string& projectPath, const std::vector<FileChange>& changes)
{
    const std::string folder = stagingFolder(projectPath);
    if (auto made = files.makeDirectory(folder); !made)
        return made.error();
    std::vector<Step> steps;
    for (const FileChange& change : changes) {
        Step step{"", change.path, hexOrNone(change.before), std::string(NoHash)};
        if (change.text) {
            step.staged = std::to_string(steps.size());
            step.after = toHex(hashOf(bytesOf(*change.text)));
            if (auto written = files.writeSynced(folder + '/' + step.staged, bytesOf(*change.text)); !written)
                return written.error();
        }
        steps.push_back(std::move(step));
    }
    const std::string draft = folder + "/commit.new";
    if (auto written = files.writeSynced(draft, bytesOf(recordText(steps))); !written)
        return written.error();
    for (const std::string& parent : {folder, privateFolder(projectPath), projectPath}) {
        if (auto synced = files.syncDirectory(parent); !synced)
            return synced.error();
    }
    return steps;
}

Diagnostic unfinished(const Diagnostic& reason)
{
    std::string text = englishText(reason);
    if (text.ends_with('.'))
        text.pop_back();
    return diagnostic(Code::SaveUnfinished, {text});
}

} // namespace

std::string privateFolder(const std::string& projectPath)
{
    return projectPath + "/.camwright";
}

Result<void> makePrivateFolder(FileSystem& files, const std::string& projectPath)
{
    const std::string folder = privateFolder(projectPath);
    if (auto made = files.makeDirectory(folder); !made)
        return made;
    if (files.stamp(folder + "/.gitignore"))
        return {};
    return files.writeSynced(folder + "/.gitignore", bytesOf("*\n"));
}

Result<std::unique_ptr<FileLock>> lockSaving(FileSystem& files, const std::string& projectPath)
{
    return files.lock(privateFolder(projectPath) + "/saving", LockWait::UntilFree);
}

Result<void> runSave(FileSystem& files, const std::string& projectPath, const std::vector<FileChange>& changes)
{
    const auto steps = stage(files, projectPath, changes);
    if (!steps) {
        (void)clearStaging(files, projectPath); // what stays is dropped by the next opener
        return steps.error();
    }
    const std::string record = recordPath(projectPath);
    if (auto committed = files.rename(record + ".new", record); !committed) {
        (void)clearStaging(files, projectPath);
        return committed;
    }
    if (auto synced = files.syncDirectory(stagingFolder(projectPath)); !synced) {
        // Whether the record survives a power cut is not known; taken away again, the save has not happened.
        if (!removeIfThere(files, record) || !files.syncDirectory(stagingFolder(projectPath)))
            return unfinished(synced.error());
        (void)clearStaging(files, projectPath);
        return synced;
    }
    Mover mover(files, projectPath);
    auto moved = mover.run(*steps);
    if (moved)
        moved = clearStaging(files, projectPath);
    return moved ? moved : unfinished(moved.error());
}

bool hasInterruptedSave(FileSystem& files, const std::string& projectPath)
{
    return files.stamp(stagingFolder(projectPath)).ok();
}

Result<FinishedSave> finishSave(FileSystem& files, const std::string& projectPath)
{
    FinishedSave out;
    if (!hasInterruptedSave(files, projectPath))
        return out;
    const auto text = files.read(recordPath(projectPath), LargestFile);
    if (!text && !isMissing(text.error()))
        return text.error();
    if (const auto steps = text ? readRecord(*text) : std::nullopt) {
        Mover mover(files, projectPath);
        if (auto moved = mover.run(*steps); !moved)
            return moved.error();
        out.notes = mover.takeNotes();
        out.notes.insert(out.notes.begin(), diagnostic(Code::SaveFinished));
        for (const Step& step : *steps) {
            const auto hash = step.staged.empty() ? Result<Hash>(Hash{}) : contentHash(files, projectPath + '/' + step.target);
            if (!hash)
                return hash.error();
            out.files.emplace(step.target, *hash);
        }
    }
    if (auto cleared = clearStaging(files, projectPath); !cleared)
        return cleared.error();
    return out;
}

} // namespace camwright
