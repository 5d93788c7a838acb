#pragma once

#include "core/storage/projectstore.h"

namespace camwright {

/// No file of a project is larger; guards against a log or disk image that lies in the folder.
inline constexpr std::uint64_t LargestProjectFile = std::uint64_t{64} << 20;

/// Reads all files as they lie there.
Result<LoadedProject, Diagnostics> readProjectFiles(FileSystem& files, const std::string& path);

/// The paths of all files that belong to a project by folder and ending, relative to it. Unreadable folders count as empty.
std::vector<std::string> projectFileNames(FileSystem& files, const std::string& path);

} // namespace camwright
