#pragma once

#include <QString>

#include <cstdint>
#include <string>

namespace camwright {

/// What AxisStatus::lastCause says, in the user's language; a cause not known here as the controller wrote it.
QString causeText(const std::string& cause);

/// What an axis's error code says: the family's own text where it has one, else the class of the CiA 301 emergency code.
QString axisErrorText(const std::string& family, std::uint32_t code);

/// "16#8130".
QString errorCodeText(std::uint32_t code);

} // namespace camwright
