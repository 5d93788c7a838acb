#pragma once

#include "core/base/bytes.h"
#include "core/base/diagnostic.h"

namespace camwright {

/// A diagnostic in saved state. The code goes by its printed ID, which is permanent; the enumerator's number is not.
void saveDiagnostic(ByteWriter& writer, const Diagnostic& diagnostic);
Diagnostic restoreDiagnostic(ByteReader& reader);

} // namespace camwright
