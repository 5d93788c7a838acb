#pragma once

#ifndef Q_MOC_RUN
#include <compare> // moc cannot read it as the first header of a file
#endif
#include <cstdint>
#include <string>

namespace camwright {

/// A stretch of text. Lines and columns count from 1, columns in UTF-8 bytes; the end is exclusive. Line 0: no range.
struct TextRange {
    std::uint32_t line = 0;
    std::uint32_t column = 0;
    std::uint32_t endLine = 0;
    std::uint32_t endColumn = 0;

    bool isValid() const { return line != 0; }
    auto operator<=>(const TextRange&) const = default;
};

/// What has a file of its own in a project.
enum class ObjectKind : std::uint8_t { Project, Controller, Axis, Network, Program, VariableTable, WatchTable };

/// The English word for a kind as file names and messages use it, for example "axis".
const char* kindName(ObjectKind kind);

/// Identity of an object, in memory and on disk: its kind and its name, unique within the kind.
struct ObjectKey {
    ObjectKind kind = ObjectKind::Project;
    std::string name;

    auto operator<=>(const ObjectKey&) const = default;
};

/// Where something is: an object, a field of it ("guardTime", "rows[3].address"), and a range where the field is text.
/// `file` is set by readers of loose files and filled in by storage when a project place is shown as a file.
struct Place {
    ObjectKey object;
    std::string field;
    TextRange range;
    std::string file;

    auto operator<=>(const Place&) const = default;
};

} // namespace camwright
