#pragma once

#include "core/base/hash.h"
#include "core/model/project.h"
#include "core/storage/filesystem.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace camwright {

/// The newest format this program reads and the one it writes; `format` in project.toml.
inline constexpr std::int64_t ProjectFormat = 1;

/// What is known of a file of the project since it was last read or written.
struct KnownFile {
    ObjectPtr object; ///< what the text says
    FileStamp stamp;
    Hash hash;
    std::string text; ///< the bytes in the file; an edit changes only its own lines in them
};

/// The files of a project as this program knows them, by path relative to the project's folder.
using KnownFiles = std::map<std::string, KnownFile>;

struct LoadedProject {
    Project project;
    KnownFiles files;
    Diagnostics notes; ///< nothing that stops the work: an interrupted save was finished, a foreign file was set aside
};

/// Reads the project in the folder `path`, after finishing or dropping an interrupted save (CONTRACTS 5). Fails with every
/// reason found, each with file and line; an illegal value in a field is no reason (it is kept as typed, checks name it).
/// Takes no lock that outlives the call and changes nothing else.
Result<LoadedProject, Diagnostics> openProject(FileSystem& files, const std::string& path);

/// Who wins where a file to be written was changed by another program since `known`.
enum class Overwrite : std::uint8_t { Refuse, Allow };

/// Writes what differs between `known` and `now`, whole or not at all: after a failure, `kill -9` or a power cut the next
/// opener sees the old or the new project. Unchanged objects are not touched. Gives the files as they are now.
/// Fails with ChangedOutside (argument 1 the file) and writes nothing when another program changed a file it would replace.
/// After SaveUnfinished the new state is on disk and the next opener or save puts it in place.
/// `finishedJournals`: names in .camwright/ that the save makes needless; removed with it, in the same step.
Result<KnownFiles> saveProject(FileSystem& files, const std::string& path, const KnownFiles& known, const Project& now,
                               Overwrite overwrite = Overwrite::Refuse, const std::vector<std::string>& finishedJournals = {});

/// Writes a whole project into a folder that is missing, empty or holds no project: New, Save As, `convert`. With the
/// `from` of a loaded project, unchanged files are equal byte for byte. Refuses with AlreadyAProject.
Result<KnownFiles> createProject(FileSystem& files, const std::string& path, const Project& project, const KnownFiles& from = {});

/// The files another program changed, added or removed since `known`, relative to the project's folder, sorted.
/// Looks at contents only where the stamp differs.
std::vector<std::string> filesChangedOutside(FileSystem& files, const std::string& path, const KnownFiles& known);

/// The right to edit a project, held as long as its window is open (.camwright/lock). Fails with LockHeld when another
/// Camwright has it; the project then opens read-only.
Result<std::unique_ptr<FileLock>> lockProject(FileSystem& files, const std::string& path);

/// A hash over the value of the project, not over its files: equal projects have equal hashes.
Hash hashOf(const Project& project);

} // namespace camwright
