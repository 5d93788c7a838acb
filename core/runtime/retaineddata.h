#pragma once

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/language/image/controllerimage.h"
#include "core/runtime/memory/memory.h"

namespace camwright {

/// What survives a loss of power (CONTRACTS 13): the retained ranges of the areas, keyed by area name and byte, and retained
/// variables outside them, keyed by name and type. Format: version, target family, entries, each a key and its bytes.
Bytes collectRetained(const ControllerImage& image, const Memory& memory);

/// Puts back what `image` still has under the same key; the rest is left alone. Bytes that are no retained data change
/// nothing and give CW5042.
Result<void> applyRetained(ByteSpan retained, const ControllerImage& image, Memory& memory);

} // namespace camwright
