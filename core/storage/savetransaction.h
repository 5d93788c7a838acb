#pragma once

#include "core/base/diagnostic.h"
#include "core/base/hash.h"
#include "core/storage/filesystem.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace camwright {

/// A file a save replaces or removes, by path relative to the project's folder.
struct FileChange {
    std::string path;
    std::optional<std::string> text; ///< nothing: the file is removed
    Hash before;                     ///< of the content it replaces; null: there was no file
};

/// What finishing an interrupted save did.
struct FinishedSave {
    Diagnostics notes;
    std::map<std::string, Hash> files; ///< path and hash of the new content; null: removed
};

/// The folder inside a project that holds locks, journal and what a save stages.
std::string privateFolder(const std::string& projectPath);

/// Makes the private folder, which ignores itself in git.
Result<void> makePrivateFolder(FileSystem& files, const std::string& projectPath);

/// Held by whoever saves, or finishes a save, so that no reader takes a save in progress for an interrupted one.
Result<std::unique_ptr<FileLock>> lockSaving(FileSystem& files, const std::string& projectPath);

/// All changes or none (CONTRACTS 5). New contents are staged in the private folder and synced, a record that lists them is
/// put in place by a rename and synced: from then on the save has happened. Then the files move to their places.
/// After SaveUnfinished the record stands and `finishSave` goes on; after any other error nothing happened.
/// The caller holds lockSaving and has called finishSave.
Result<void> runSave(FileSystem& files, const std::string& projectPath, const std::vector<FileChange>& changes);

/// Finishes a save whose record stands, drops one whose record does not. The caller holds lockSaving.
Result<FinishedSave> finishSave(FileSystem& files, const std::string& projectPath);

/// True when a save was cut off: finishSave has something to do.
bool hasInterruptedSave(FileSystem& files, const std::string& projectPath);

} // namespace camwright
