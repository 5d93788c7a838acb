#pragma once

#include "core/online/tracebuffer.h"

#include <QByteArray>

namespace camwright {

/// A recording as CSV: "time_s,NAME,…", one row a sample, an empty line where a gap is. Numbers read back the same; a
/// name with a comma or a quote is quoted.
QByteArray traceCsv(const TraceBuffer& buffer);

} // namespace camwright
