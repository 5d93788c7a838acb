#pragma once

#include "core/base/bytes.h"
#include "core/runtime/kinco/exchange.h"

namespace camwright::kinco {

// Saved state of the exchange buffers. Restoring keeps the sizes the image gave them.
void saveCommands(ByteWriter& writer, const ScanCommands& commands);
void restoreCommands(ByteReader& reader, ScanCommands& commands);
void saveReports(ByteWriter& writer, const MotionReports& reports);
void restoreReports(ByteReader& reader, MotionReports& reports);

} // namespace camwright::kinco
