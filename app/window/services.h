#pragma once

#include "core/base/job.h"
#include "core/model/project.h"
#include "core/online/controllerlink.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace camwright {

struct BuildOutcome {
    Diagnostics diagnostics;
    std::optional<DownloadPackage> package; ///< set when no diagnostic is an error
};

/// What the window asks of the rest of the program; main() gives the real ones, tests their own.
struct Services {
    /// Everything wrong with a project, programs included. Called on a worker's thread.
    std::function<Diagnostics(const Project&)> check;
    /// Called on a worker's thread.
    std::function<BuildOutcome(const Project&, Job&)> build;
    /// Opens a link; returns at once. Called on the interface's thread.
    std::function<Result<std::unique_ptr<ControllerLink>>(const std::string& address, const std::string& projectPath)> connectTo;
};

} // namespace camwright
