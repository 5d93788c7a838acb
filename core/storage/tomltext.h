#pragma once

#include "core/base/diagnostic.h"
#include "core/base/result.h"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace camwright {

struct TomlMember;

/// A value in a TOML file with its place. toml++ stays behind this face, in one source file.
struct TomlValue {
    enum class Kind : std::uint8_t { String, Integer, Float, Boolean, Date, Array, Table };
    Kind kind = Kind::String;
    std::string string;                                     ///< of a String
    std::int64_t integer = 0;
    double number = 0;                                      ///< of a Float
    std::vector<TomlValue> elements;                        ///< of an Array
    std::vector<TomlMember> members;                        ///< of an inline Table, by place in the file
    bool hasHeaders = false;                                ///< an Array written as [[name]]
    TextRange range;
    std::size_t begin = 0;                                  ///< bytes in the text; without meaning when hasHeaders
    std::size_t end = 0;
    std::string text;                                       ///< as written; for an Array with headers one in brackets
};

struct TomlMember {
    std::string key;
    TomlValue value;
};

/// A key with a value that is no table of its own: tables given by [header] or dotted keys are part of the path.
struct TomlLeaf {
    std::string path;        ///< dotted, parts quoted where TOML wants it: simulation.home_switch
    TomlValue value;
};

/// All leaves by place in the file. `file` is named in the diagnostic.
Result<std::vector<TomlLeaf>> parseToml(std::string_view text, const std::string& file);

std::string tomlString(std::string_view text); ///< quoted; what is not UTF-8 becomes U+FFFD
std::string tomlNumber(double value);          ///< shortest that reads back the same; always with a point or exponent
std::string tomlKey(std::string_view part);    ///< quoted where it must be

/// A path and its value as TOML text, in the order of the file.
using TomlLines = std::vector<std::pair<std::string, std::string>>;

/// A file of these lines: keys without a table first; `tables` are written as [headers], other dotted paths stay dotted.
std::string writeToml(const TomlLines& lines, const std::vector<std::string>& tables);

/// `before` with the values of `was` that differ in `is` replaced in place, missing ones added beside their neighbours,
/// and those no longer there removed. Nothing when it cannot be done in place.
std::optional<std::string> patchToml(std::string_view before, const std::vector<TomlLeaf>& leaves, const TomlLines& was,
                                     const TomlLines& is, const std::vector<std::string>& tables);

} // namespace camwright
