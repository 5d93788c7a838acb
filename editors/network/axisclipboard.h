#pragma once

#include "core/model/objects.h"

#include <optional>

namespace camwright {

/// Copies an axis as the text of its file, so that it can be pasted into another Camwright, or into a mail.
void copyAxisToClipboard(const Object& axis);
/// The axis on the clipboard, if it holds one.
std::optional<Object> axisFromClipboard();

} // namespace camwright
