#pragma once

#include "core/base/result.h"
#include "core/model/objects.h"

#include <string>
#include <string_view>
#include <vector>

namespace camwright {

/// Programs and tables of variables: a line with settings, then text.
std::string writeTextObject(const Object& object);
Result<Object, Diagnostics> readTextObject(const ObjectKey& key, std::string_view text, const std::string& file);

/// `before` with the lines of a table replaced that differ between `was`, which it holds, and `is`; comments between rows
/// stay. Nothing when it cannot be done in place.
std::optional<std::string> patchVariables(std::string_view before, const Object& was, const Object& is);

} // namespace camwright
