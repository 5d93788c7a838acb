#pragma once

#include "core/base/hash.h"
#include "core/model/project.h"
#include "core/storage/filesystem.h"

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace camwright {

/// An object before and after an edit; null: it did not exist, or does not any more.
struct ObjectDelta {
    ObjectKey key;
    ObjectPtr before;
    ObjectPtr after;
};

/// The edits of a project since its last save, appended to a file in .camwright/ so that `kill -9` loses none (CONTRACTS 5).
/// Every record carries its own checksum; a tail torn by a power cut is dropped on reading. Programs and tables are
/// recorded as the changed stretch, not whole. Undo and redo are edits like any other.
///
/// A save on another thread works on a snapshot while editing goes on, therefore the journal is a chain of segments:
/// call `rotate(snapshot)` before the save and give `finished()` to saveProject, which removes them with the save.
class Journal {
public:
    /// Begins a journal on the project as it is saved. Older segments are left: read them with readJournal first and
    /// remove them with discardJournal, or nothing unsaved is lost.
    static Result<std::unique_ptr<Journal>> begin(FileSystem& files, const std::string& projectPath, const Project& saved);

    /// After return the edit survives `kill -9`; after the next sync also a power cut. After an error (disk full) it is
    /// kept here, and the next call tries again.
    Result<void> append(const std::string& label, const std::vector<ObjectDelta>& deltas);
    /// The state of a page that was not applied yet; null when it was applied or cancelled. The last one counts.
    Result<void> setDraft(const ObjectKey& key, const ObjectPtr& draft);
    /// To be called at the latest 2 s after an append.
    Result<void> sync();

    /// True when something was appended since begin or rotate.
    bool hasEntries() const { return m_entries != 0; }

    /// A new segment that stands on `snapshot`; drafts move along. The former ones are `finished()`.
    Result<void> rotate(const Project& snapshot);
    const std::vector<std::string>& finished() const { return m_finished; }
    void forgetFinished() { m_finished.clear(); } ///< after the save that removed them

private:
    Journal(FileSystem& files, std::string folder);
    Result<void> openSegment(const Project& base);
    Result<void> write(const Bytes& record);
    Result<void> flush();

    FileSystem& m_files;
    std::string m_folder;
    std::uint32_t m_segment = 0;
    std::unique_ptr<AppendFile> m_file;
    std::vector<std::string> m_finished;
    std::map<ObjectKey, ObjectPtr> m_drafts;
    std::uint64_t m_entries = 0;
    Bytes m_pending;           ///< records that are not in the file yet
    std::uint64_t m_whole = 0; ///< bytes of the file up to the last whole record
};

/// What an earlier session left unsaved.
struct JournalContent {
    Project project;                       ///< the saved project with all edits replayed
    std::map<ObjectKey, ObjectPtr> drafts; ///< pages not applied
    std::vector<std::string> labels;       ///< of the edits, in order; undo steps by name
    bool torn = false;                     ///< the last record was incomplete and is left out
};

/// Reads the journal, if there is one with anything in it. Fails with JournalOfAnotherBase when it was written on another
/// state of the project than `saved` (somebody changed files since), JournalDamaged when it cannot be read at all;
/// the files stay until discardJournal.
Result<std::optional<JournalContent>> readJournal(FileSystem& files, const std::string& projectPath, const Project& saved);

/// Removes every segment an earlier session left. Call before Journal::begin when their content was taken over or refused.
Result<void> discardJournal(FileSystem& files, const std::string& projectPath);

} // namespace camwright
