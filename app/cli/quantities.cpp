#include "app/cli/quantities.h"

#include <charconv>
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

QByteArray formatSeconds(std::int64_t nanoseconds)
{
    QByteArray out = QByteArray::number(nanoseconds / 1'000'000'000);
    QByteArray fraction = QByteArray::number(nanoseconds % 1'000'000'000).rightJustified(9, '0');
    while (fraction.endsWith('0'))
        fraction.chop(1);
    return fraction.isEmpty() ? out : out + '.' + fraction;
}

QByteArray formatSample(DataType type, double value)
{
    char buffer[64];
    const auto end = buffer + sizeof buffer;
    if (type == DataType::Real)
        return {buffer, std::to_chars(buffer, end, static_cast<float>(value)).ptr - buffer};
    if (type == DataType::Lreal)
        return {buffer, std::to_chars(buffer, end, value).ptr - buffer};
    return QByteArray::number(static_cast<qint64>(value));
}

QStringList splitNames(const QString& list)
{
    QStringList out;
    QString name;
    bool quoted = false;
    for (const QChar c : list) {
        if (c == QLatin1Char('"'))
            quoted = !quoted;
        if (c == QLatin1Char(',') && !quoted) {
            out << name.trimmed();
            name.clear();
        } else {
            name += c;
        }
    }
    out << name.trimmed();
    out.removeAll(QString());
    return out;
}

} // namespace camwright::cli
