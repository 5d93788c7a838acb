#pragma once

#include "core/base/datatype.h"
#include "core/base/time.h"

#include <QByteArray>
#include <QString>
#include <QStringList>

#include <cstdint>
#include <optional>

namespace camwright::cli {

/// "10s", "500ms", "2m", "1.5s"; a bare number is seconds. Never negative.
std::optional<Time> parseTime(const QString& text);

/// Exact decimal seconds of a count of nanoseconds: "0.001", "12".
QByteArray formatSeconds(std::int64_t nanoseconds);

/// A sample as its type is written: BOOL 0 or 1, integers whole, REAL and LREAL in the shortest form that reads back the same.
QByteArray formatSample(DataType type, double value);

/// Splits at commas outside quotes: axis."Long, name".position stays one name.
QStringList splitNames(const QString& list);

} // namespace camwright::cli
