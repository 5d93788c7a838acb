#pragma once

#include "core/base/result.h"
#include "core/model/project.h"
#include "core/storage/projectstore.h"

#include <string>
#include <string_view>

namespace camwright {

/// The canonical text of an object: what its file holds. Same object, same bytes.
std::string toText(const Object& object);

/// Reads an object's file. `file` is the name that diagnostics carry; every error has its line.
Result<Object, Diagnostics> fromText(const ObjectKey& key, std::string_view text, const std::string& file = {});

/// Like toText, but lines of `before` whose values did not change are kept as they are: comments, blanks, order, line
/// ends. `before` is a text that fromText accepts for the key.
std::string toTextKeeping(const Object& object, std::string_view before);

/// The path of an object's file relative to the project's folder: "axes/Feed.toml". Any name gives a safe file name:
/// no reserved word, control or direction character, at most 255 bytes; nameOfFile reads it back.
std::string fileOf(const ObjectKey& key);
/// The same, and different from every other object's file even where the file system takes upper and lower case as equal.
std::string fileOf(const ObjectKey& key, const Project& project);

/// A project place as a place in its file: `file` is set, and `range` counts in the file's lines. A program's text begins
/// behind the line with its settings; a field ("guard_time_ms", "rows[3].address") is found in the text of its object.
/// `files` are those of the loaded project; without them the canonical form is meant. A place without an object stays.
Place filePlace(const Place& place, const Project& project, const KnownFiles& files = {});

} // namespace camwright
