#pragma once

#include "core/base/bytes.h"
#include "core/online/manifest.h"

namespace camwright {

/// What an image is made of, for a download plan. Of bytes that are no image: a manifest without parts.
Manifest manifestOf(ByteSpan image);

} // namespace camwright
