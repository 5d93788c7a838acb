#pragma once

#include "core/base/time.h"

#include <QString>

#include <optional>

namespace camwright::cli {

/// "10s", "500ms", "2m", "1.5s"; a bare number is seconds. Never negative.
std::optional<Time> parseTime(const QString& text);

} // namespace camwright::cli
