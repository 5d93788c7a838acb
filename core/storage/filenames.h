#pragma once

#include "core/base/place.h"

#include <optional>
#include <string>
#include <string_view>

namespace camwright {

/// A name as a file's stem: safe on Linux, Windows and macOS, and read back by nameOfStem. A byte that cannot stand in
/// a file name becomes %XX. A name too long for a file gives a stem with a hash, which cannot be read back; such an
/// object carries its name inside its file.
std::string stemOf(std::string_view name);

/// The name a stem stands for; nothing when a % in it is not the beginning of %XX.
std::optional<std::string> nameOfStem(std::string_view stem);
bool isShortened(std::string_view stem);

/// The stem for an object whose name differs from another's only in upper and lower case: all its letters are written %XX.
std::string distinctStemOf(std::string_view name);

/// The name with every special byte as %XX and without a limit of length, for use inside a file.
std::string encodedName(std::string_view name);

/// ASCII letters in lower case; the comparison that file systems and IEC languages make of names.
std::string foldedCase(std::string_view name);

/// The folder and ending of a kind's files: {"axes/", ".toml"}. Project and controller have a file without folder. Programs in
/// Structured Text have an ending of their own.
struct FilePattern {
    std::string_view folder;
    std::string_view ending;
    std::string_view otherEnding = {}; ///< empty: none

    /// The ending a file name has of the two; nothing if it has neither.
    std::optional<std::string_view> endingOf(std::string_view file) const;
};
FilePattern filePattern(ObjectKind kind);

} // namespace camwright
