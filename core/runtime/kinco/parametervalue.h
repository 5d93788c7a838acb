#pragma once

#include "core/family/family.h"
#include "core/fieldbus/canopenmaster.h"
#include "core/motion/units.h"

#include <cstdint>
#include <optional>

namespace camwright::kinco {

/// One of the 45 numbered drive parameters (KS-MC-15); null for any other number.
const DriveParameter* parameterOf(unsigned number);

/// The program's 4-byte cell as the drive's number (KS-MC-14). Nothing for a value outside the drive's range, NaN included.
std::optional<std::int64_t> driveValueOf(const DriveParameter& parameter, const AxisScale& scale, std::uint32_t cell);

/// What a read brought, as the program's cell. Nothing where the object's length does not fit.
std::optional<std::uint32_t> cellOf(const DriveParameter& parameter, const AxisScale& scale, const SdoResult& result);

} // namespace camwright::kinco
