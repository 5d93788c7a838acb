#pragma once

#include "core/base/time.h"
#include "core/runtime/memory/memory.h"

#include <string_view>

namespace camwright {

/// What the system flags of a family say about a scan.
struct ScanMoment {
    Time now{};
    bool running = false;
    bool firstScan = false;        ///< the first after STOP to RUN
    bool firstAfterPowerOn = false;
    bool toggle = false;           ///< changes with every scan
    bool error = false;            ///< an instruction failed in an earlier scan of this run
};

/// Writes the flags that the controller itself keeps: Kinco SM0.0 and SM0.1 (KS-MEM-09); TS600 SM0 to SM3, the clocks SM10 to
/// SM14 and SM15 (TS-MEM-09); SM23 and SM24, which instructions set, are off at a scan's beginning (ours). A clock is on in the first half of its period, counted from the controller's start (ours).
void writeSystemBits(std::string_view family, Memory& memory, const ScanMoment& moment);

} // namespace camwright
