#pragma once

#include "core/storage/filesystem.h"
#include "core/storage/journal.h"
#include "core/storage/projectstore.h"

#include <memory>
#include <string>

namespace camwright {

/// What an open project holds on disk: its files as known, the right to edit, the journal.
class ProjectFiles {
public:
    PosixFileSystem system;
    KnownFiles known;
    std::unique_ptr<FileLock> lock;      ///< null: another Camwright has the project
    std::unique_ptr<Journal> journal;    ///< begins with the first edit
    Project saved;                       ///< the project as the files hold it
};

} // namespace camwright
