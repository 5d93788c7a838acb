#pragma once

#include "core/model/project.h"
#include "core/storage/journal.h"
#include "editors/document/projectchange.h"

#include <QString>

#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace camwright {

/// A stretch of a program's source replaced. Offsets and lengths count UTF-8 bytes.
struct TextDelta {
    ObjectKey key;
    std::size_t offset = 0;
    std::string removed;
    std::string inserted;
};

using Delta = std::variant<ObjectDelta, TextDelta>;

/// What the user did, once: a label for the menu ("Change guard time"), the deltas, where it was. It keeps old and new
/// pointers or a text delta, never a project (CONTRACTS 2).
struct ProjectEdit {
    QString label;                 ///< translated, as the menu shows it after "Undo"
    std::vector<Delta> deltas;
    std::set<std::string> properties;
    Place place;                   ///< where the user worked; undo goes back there
    /// Edits with the same non-empty key that follow each other merge into one step until a pause, a line end, a cursor
    /// move or ProjectDocument::closeMerge().
    QString mergeKey;
};

/// The project after the edit. A delta whose object is missing changes nothing.
Project applied(const Project& project, const std::vector<Delta>& deltas);
/// The same edit backwards.
std::vector<Delta> reversed(const std::vector<Delta>& deltas);
/// Leaves out deltas that change nothing.
std::vector<Delta> withoutNoise(std::vector<Delta> deltas);
ProjectChange changeOf(const std::vector<Delta>& deltas, const std::set<std::string>& properties);
const ObjectKey& keyOf(const Delta& delta);

} // namespace camwright
