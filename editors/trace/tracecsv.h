#pragma once

#include "core/online/tracebuffer.h"

#include <QByteArray>

namespace camwright {

/// A recording as CSV: "time_s,NAME,…", one row a sample, an empty line where a gap is. Numbers read back the same.
QByteArray traceCsv(const TraceBuffer& buffer);

} // namespace camwright
