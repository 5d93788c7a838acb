#pragma once

#include "core/base/diagnostic.h"
#include "core/base/job.h"
#include "core/language/image/controllerimage.h"
#include "core/model/project.h"

#include <optional>
#include <string_view>
#include <vector>

namespace camwright {

class ValidProject;

struct BuildOptions {
    bool forVirtualController = true;     ///< say what is not simulated (CW4040, CW4042)
    std::vector<ArchivedFile> archive;    ///< files to travel with the image; empty: every object of the project in its canonical text
};

/// The image, or nothing if a diagnostic is an error or the job was cancelled (CW0002).
struct CompileResult {
    std::optional<ControllerImage> image;
    Diagnostics diagnostics;              ///< warnings too; in the order of the programs
};

/// Checks, lowers and links every program of the project. A pure function: the same project gives the same image.
CompileResult compile(const ValidProject& project, const BuildOptions& options, Job& job);

/// What is wrong with `text` as the source of the program `key` in `project`, for editors while somebody types. Looks at
/// this one program only; everything else of the project is taken as it stands, valid or not.
Diagnostics checkProgramText(const Project& project, const ObjectKey& key, std::string_view text);

} // namespace camwright
