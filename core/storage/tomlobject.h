#pragma once

#include "core/base/result.h"
#include "core/model/objects.h"
#include "core/storage/tomltext.h"

#include <string>
#include <vector>

namespace camwright {

/// The kinds of objects that are stored as keys and values: all but programs and tables of variables.
bool isTomlKind(ObjectKind kind);

/// Every key of the object's file with its value, in canonical order.
TomlLines tomlLines(const Object& object);
/// The tables of the kind that get a [header].
std::vector<std::string> tomlTables(ObjectKind kind);

/// The object a file's leaves describe. Missing keys have their default value.
Result<Object, Diagnostics> readTomlObject(const ObjectKey& key, const std::vector<TomlLeaf>& leaves, const std::string& file);

} // namespace camwright
