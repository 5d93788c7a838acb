#pragma once

#include "core/base/bytes.h"
#include "core/base/hash.h"
#include "core/storage/journal.h"

#include <optional>
#include <variant>
#include <vector>

namespace camwright {

/// First record of a segment: the project it stands on.
struct JournalBase {
    Hash project;
};

/// One object's change as it lies in the journal.
struct RecordedDelta {
    enum class Form : std::uint8_t { Removed = 0, Whole = 1, SourceStretch = 2, TableRows = 3 };
    ObjectKey key;
    Form form = Form::Removed;
    std::uint64_t first = 0;   ///< byte of the source, or row
    std::uint64_t removed = 0; ///< bytes or rows
    std::string text;          ///< of the object, the inserted source, or a table of the inserted rows
};

struct JournalEdit {
    std::string label;
    std::vector<RecordedDelta> deltas;
};

struct JournalDraft {
    ObjectKey key;
    std::optional<std::string> text;
};

using JournalRecord = std::variant<JournalBase, JournalEdit, JournalDraft>;

RecordedDelta recorded(const ObjectDelta& delta);
/// The project with the change made; nothing when it does not fit.
std::optional<Project> replayed(const Project& project, const RecordedDelta& delta);

/// Length, checksum, payload.
Bytes writeRecord(const JournalRecord& record);

struct JournalSegment {
    std::vector<JournalRecord> records;
    bool torn = false; ///< bytes behind the last whole record
};
JournalSegment readSegment(ByteSpan bytes);

} // namespace camwright
