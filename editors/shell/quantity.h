#pragma once

#include <QString>

#include <optional>

namespace camwright {

/// Reads what people type into a field whose unit is `unit`: "12", "1,5", "2.5k", "1e3", "16#FF", "0x1A0", "1 in", "0.5 turn", "T#5s".
/// The result is in `unit`. `perTurn`: units per motor turn, 0 where turns mean nothing. Nothing when the text is no number
/// or its unit does not fit.
std::optional<double> parseQuantity(const QString& text, const QString& unit, double perTurn = 0);

/// The shortest text that reads back the same, or `decimals` digits after the point where that is not negative.
QString formatQuantity(double value, int decimals = -1);

} // namespace camwright
