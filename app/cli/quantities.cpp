#include "app/cli/quantities.h"

#include <cmath>

namespace camwright::cli {

std::optional<Time> parseTime(const QString& typed)
{
    const QString text = typed.trimmed().toLower();
    static constexpr struct { const char* suffix; double ns; } Units[] = {{"ms", 1e6}, {"us", 1e3}, {"ns", 1}, {"s", 1e9}, {"m", 60e9}, {"h", 3600e9}};
    QString number = text;
    double factor = 1e9;
    for (const auto& unit : Units) {
        if (text.endsWith(QLatin1String(unit.suffix))) {
            number = text.left(text.size() - qsizetype(qstrlen(unit.suffix)));
            factor = unit.ns;
            break;
        }
    }
    bool ok = false;
    const double value = number.toDouble(&ok) * factor;
    if (!ok || !(value >= 0) || value > 9e18)
        return std::nullopt;
    return Time(static_cast<std::int64_t>(std::llround(value)));
}

} // namespace camwright::cli
