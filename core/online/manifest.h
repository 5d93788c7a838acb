#pragma once

#include "core/base/hash.h"
#include "core/online/controllerlink.h"

#include <string>
#include <vector>

namespace camwright {

enum class PartKind : std::uint8_t { Program, Axis, Network, Variables, Controller, Retained };

/// One part of an image that a person knows by name, and a digest of what the controller executes of it.
struct ManifestPart {
    PartKind kind = PartKind::Program;
    std::string name;      ///< "Main", "Feed"; for Retained the area or variable
    Hash hash;
    bool operator==(const ManifestPart&) const = default;
};

/// What an image is made of: enough to say what a download changes, small enough to send before it.
struct Manifest {
    Hash program;
    std::string family, model;
    std::vector<ManifestPart> parts; ///< sorted by kind, then name
    bool operator==(const Manifest&) const = default;
};

/// What the download of `next` would change, stop and lose on a controller in `status` that has `current` loaded; a null
/// `current.program` means it has none.
DownloadPlan planDownload(const Manifest& current, const Manifest& next, const ControllerStatus& status);

} // namespace camwright
