#pragma once

#include "app/cli/verb.h"
#include "core/base/bytes.h"
#include "core/base/hash.h"
#include "core/storage/projectstore.h"

#include <optional>

namespace camwright::cli {

/// Opens a project folder; prints why it cannot be read (exit 3).
std::optional<LoadedProject> readProject(Invocation& call, const QString& path);

/// A project built to an image, or the exit status that says why not; its diagnostics are printed.
struct BuiltProject {
    int status = 0;
    Bytes image;
    Hash program;

    explicit operator bool() const { return status == 0; }
};

BuiltProject buildProject(Invocation& call, const QString& path);

/// Says that a file could not be written; returns CannotRead, the status for files that refuse.
int cannotWrite(const QString& file);

} // namespace camwright::cli
