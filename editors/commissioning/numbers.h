#pragma once

#include <QString>

#include <cmath>

namespace camwright {

/// A number as people read it: a true minus, never "-0". `width` decimals are kept free, so that points stand below one another.
inline QString shownNumber(double value, int decimals, int width = 0)
{
    QString digits = QString::number(std::abs(value), 'f', decimals);
    const bool zero = digits.toDouble() == 0;
    if (value < 0 && !zero)
        digits.prepend(QChar(0x2212));
    const int missing = width <= decimals ? 0 : width - decimals + (decimals == 0 ? 1 : 0);
    return digits + QString(missing, QChar(0x00a0));
}

} // namespace camwright
