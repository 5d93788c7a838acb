#include "editors/shell/quantity.h"

#include "core/base/value.h"

#include <QLocale>
#include <QRegularExpression>

#include <array>
#include <cmath>

namespace camwright {

namespace {

/// A unit people type: its dimension and how many base units it is.
struct Unit {
    const char* name;
    char dimension; // l length, a angle, t time, f frequency, n none of these
    double factor;
};

constexpr double Pi = 3.14159265358979323846;
constexpr std::array<Unit, 41> Units = {{
    {"mm", 'l', 1}, {"cm", 'l', 10}, {"m", 'l', 1000}, {"um", 'l', 0.001}, {"µm", 'l', 0.001}, {"nm", 'l', 1e-6},
    {"in", 'l', 25.4}, {"inch", 'l', 25.4}, {"\"", 'l', 25.4}, {"ft", 'l', 304.8},
    {"°", 'a', 1}, {"deg", 'a', 1}, {"degree", 'a', 1}, {"rad", 'a', 180 / Pi},
    {"ms", 't', 1}, {"s", 't', 1000}, {"us", 't', 0.001}, {"µs", 't', 0.001}, {"min", 't', 60000}, {"h", 't', 3600000},
    {"Hz", 'f', 1}, {"kHz", 'f', 1000}, {"bit/s", 'b', 1}, {"kbit/s", 'b', 1000},
    // As Russian fields show them and Russian keyboards type them.
    {"мм", 'l', 1}, {"см", 'l', 10}, {"м", 'l', 1000}, {"мкм", 'l', 0.001}, {"нм", 'l', 1e-6}, {"дюйм", 'l', 25.4},
    {"град", 'a', 1}, {"рад", 'a', 180 / Pi},
    {"мс", 't', 1}, {"с", 't', 1000}, {"мкс", 't', 0.001}, {"мин", 't', 60000}, {"ч", 't', 3600000},
    {"Гц", 'f', 1}, {"кГц", 'f', 1000}, {"бит/с", 'b', 1}, {"кбит/с", 'b', 1000},
}};

const Unit* findUnit(const QString& name)
{
    for (const Unit& unit : Units) {
        if (name == QString::fromUtf8(unit.name))
            return &unit;
    }
    for (const Unit& unit : Units) {
        if (name.compare(QString::fromUtf8(unit.name), Qt::CaseInsensitive) == 0)
            return &unit;
    }
    return nullptr;
}

bool isTurn(const QString& name)
{
    return name == QLatin1String("turn") || name == QLatin1String("turns") || name == QLatin1String("rev") || name == QLatin1String("U")
        || name == QStringLiteral("об");
}

/// How many `wanted` one `typed` is; nothing when they measure different things.
std::optional<double> simpleFactor(const QString& typed, const QString& wanted, double perTurn)
{
    if (typed == wanted || (isTurn(typed) && isTurn(wanted)))
        return 1;
    const Unit* to = findUnit(wanted);
    if (isTurn(typed)) {
        if (perTurn > 0 && to && (to->dimension == 'l' || to->dimension == 'a'))
            return perTurn;
        return to && to->dimension == 'a' ? std::optional(360 / to->factor) : std::nullopt;
    }
    const Unit* from = findUnit(typed);
    if (!from || !to || from->dimension != to->dimension)
        return std::nullopt;
    return from->factor / to->factor;
}

/// Also rates: "m/min" to "mm/s", "rpm" to "°/s".
std::optional<double> factorOf(const QString& typed, const QString& wanted, double perTurn)
{
    if (const auto simple = simpleFactor(typed, wanted, perTurn))
        return simple;
    const auto slash = [](const QString& unit) { return unit.indexOf(QLatin1Char('/')); };
    const QString asRate = typed == QLatin1String("rpm") ? QStringLiteral("turn/min") : typed;
    if (slash(asRate) < 0 || slash(wanted) < 0)
        return std::nullopt;
    const auto squared = [](QString unit) { return unit.endsWith(QStringLiteral("²")) ? std::pair(unit.chopped(1), 2) : std::pair(unit, 1); };
    const auto [typedTime, typedPower] = squared(asRate.mid(slash(asRate) + 1));
    const auto [wantedTime, wantedPower] = squared(wanted.mid(slash(wanted) + 1));
    const auto over = simpleFactor(typedTime, wantedTime, 0);
    const auto top = simpleFactor(asRate.left(slash(asRate)), wanted.left(slash(wanted)), perTurn);
    if (!over || !top || typedPower != wantedPower)
        return std::nullopt;
    return *top / std::pow(*over, typedPower);
}

std::optional<double> literal(const QString& text, const QString& unit)
{
    if (text.startsWith(QLatin1String("0x"), Qt::CaseInsensitive)) {
        bool ok = false;
        const qulonglong value = text.mid(2).toULongLong(&ok, 16);
        return ok ? std::optional(double(value)) : std::nullopt;
    }
    if (text.startsWith(QLatin1String("T#"), Qt::CaseInsensitive) || text.startsWith(QLatin1String("TIME#"), Qt::CaseInsensitive)) {
        const Unit* to = findUnit(unit);
        const auto value = parseValue(DataType::Time, text.toStdString());
        if (!value || !to || to->dimension != 't')
            return std::nullopt;
        return double(value->asInteger()) / to->factor;
    }
    const auto value = parseValue(DataType::Lint, text.toStdString());
    return value ? std::optional(double(value->asInteger())) : std::nullopt;
}

} // namespace

std::optional<double> parseQuantity(const QString& typed, const QString& unit, double perTurn)
{
    const QString text = typed.trimmed();
    if (text.contains(QLatin1Char('#')) || text.startsWith(QLatin1String("0x"), Qt::CaseInsensitive))
        return literal(text, unit);
    static const QRegularExpression form(
        QStringLiteral("^([+\\-−]?)\\s*([0-9][0-9 \u202f\u00a0]*(?:[.,][0-9]*)?|[.,][0-9]+)([eE][+-]?[0-9]+)?\\s*([kM](?=\\s*$|\\s+\\S))?\\s*(.*)$"));
    const QRegularExpressionMatch match = form.match(text);
    if (!match.hasMatch())
        return std::nullopt;
    QString digits = match.captured(2);
    static const QRegularExpression blanks(QStringLiteral("[ \u202f\u00a0]"));
    digits.remove(blanks).replace(QLatin1Char(','), QLatin1Char('.'));
    bool ok = false;
    double value = QLocale::c().toDouble(digits + match.captured(3), &ok);
    if (!ok)
        return std::nullopt;
    if (!match.captured(1).isEmpty() && match.captured(1) != QLatin1String("+"))
        value = -value;
    if (match.captured(4) == QLatin1String("k"))
        value *= 1e3;
    else if (match.captured(4) == QLatin1String("M"))
        value *= 1e6;
    const QString typedUnit = match.captured(5).trimmed();
    if (typedUnit.isEmpty())
        return value;
    const auto factor = factorOf(typedUnit, unit, perTurn);
    return factor ? std::optional(value * *factor) : std::nullopt;
}

QString formatQuantity(double value, int decimals)
{
    if (decimals >= 0)
        return QLocale::c().toString(value, 'f', decimals).remove(QLatin1Char(','));
    if (value == std::floor(value) && std::abs(value) < 1e15)
        return QString::number(qlonglong(value));
    return QString::number(value, 'g', QLocale::FloatingPointShortest);
}

} // namespace camwright
