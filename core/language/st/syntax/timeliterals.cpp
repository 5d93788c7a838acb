#include "core/language/st/syntax/timeliterals.h"

#include <charconv>

namespace camwright::st {

namespace {

struct Prefix {
    std::string_view text;
    TokenKind kind;
};

constexpr Prefix Prefixes[] = {
    {"T", TokenKind::Duration}, {"TIME", TokenKind::Duration}, {"LT", TokenKind::LongDuration}, {"LTIME", TokenKind::LongDuration},
    {"D", TokenKind::Date}, {"DATE", TokenKind::Date}, {"LD", TokenKind::LongDate}, {"LDATE", TokenKind::LongDate},
    {"TOD", TokenKind::TimeOfDay}, {"TIME_OF_DAY", TokenKind::TimeOfDay}, {"LTOD", TokenKind::LongTimeOfDay},
    {"LTIME_OF_DAY", TokenKind::LongTimeOfDay}, {"DT", TokenKind::DateTime}, {"DATE_AND_TIME", TokenKind::DateTime},
    {"LDT", TokenKind::LongDateTime}, {"LDATE_AND_TIME", TokenKind::LongDateTime},
};

struct Unit {
    std::string_view text;
    std::int64_t ns;
};

// Falling; "ms" before "m" and "s", so that the longest fits.
constexpr Unit Units[] = {
    {"d", 86'400'000'000'000}, {"h", 3'600'000'000'000}, {"ms", 1'000'000}, {"m", 60'000'000'000}, {"s", 1'000'000'000}, {"us", 1'000}, {"ns", 1},
};

/// Reads numbers and signs off the front of a text.
class Reader {
public:
    explicit Reader(std::string_view text) : m_rest(text) {}

    bool atEnd() const { return m_rest.empty(); }
    bool take(char c)
    {
        if (m_rest.empty() || m_rest.front() != c)
            return false;
        m_rest.remove_prefix(1);
        return true;
    }

    bool isDigit() const { return !m_rest.empty() && m_rest.front() >= '0' && m_rest.front() <= '9'; }

    /// Digits with underscores between them, at most 18.
    std::optional<std::int64_t> number(unsigned* count = nullptr)
    {
        std::int64_t out = 0;
        unsigned digits = 0;
        while (isDigit() || (digits > 0 && m_rest.size() > 1 && m_rest.front() == '_' && m_rest[1] >= '0' && m_rest[1] <= '9')) {
            if (m_rest.front() != '_') {
                out = out * 10 + (m_rest.front() - '0');
                if (++digits > 18)
                    return std::nullopt;
            }
            m_rest.remove_prefix(1);
        }
        if (count)
            *count = digits;
        return digits > 0 ? std::optional(out) : std::nullopt;
    }

    const Unit* unit()
    {
        for (const Unit& unit : Units) {
            if (m_rest.size() >= unit.text.size() && isSameName(m_rest.substr(0, unit.text.size()), unit.text)) {
                m_rest.remove_prefix(unit.text.size());
                return &unit;
            }
        }
        return nullptr;
    }

private:
    std::string_view m_rest;
};

/// digits / 10^count of a unit, in ns; what is less than a ns is cut off.
std::int64_t fractionOf(std::int64_t digits, unsigned count, std::int64_t unit)
{
    __extension__ using Wide = __int128;
    Wide power = 1;
    for (unsigned i = 0; i < count; ++i)
        power *= 10;
    return static_cast<std::int64_t>(Wide{digits} * unit / power);
}

std::optional<std::int64_t> parseClock(Reader& reader)
{
    const auto hours = reader.number();
    if (!hours || *hours > 23 || !reader.take(':'))
        return std::nullopt;
    const auto minutes = reader.number();
    if (!minutes || *minutes > 59)
        return std::nullopt;
    std::int64_t ns = (*hours * 60 + *minutes) * 60'000'000'000;
    if (!reader.take(':'))
        return ns;
    const auto seconds = reader.number();
    if (!seconds || *seconds > 59)
        return std::nullopt;
    ns += *seconds * 1'000'000'000;
    if (reader.take('.')) {
        unsigned count = 0;
        const auto digits = reader.number(&count);
        if (!digits)
            return std::nullopt;
        ns += fractionOf(*digits, count, 1'000'000'000);
    }
    return ns;
}

unsigned daysOfMonth(std::int64_t year, std::int64_t month)
{
    constexpr unsigned Days[] = {31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
    const bool leap = (year % 4 == 0 && year % 100 != 0) || year % 400 == 0;
    return month == 2 && leap ? 29 : Days[month - 1];
}

std::optional<std::int64_t> parseDay(Reader& reader)
{
    const auto year = reader.number();
    if (!year || *year < 1970 || *year > 2261 || !reader.take('-'))
        return std::nullopt;
    const auto month = reader.number();
    if (!month || *month < 1 || *month > 12 || !reader.take('-'))
        return std::nullopt;
    const auto day = reader.number();
    if (!day || *day < 1 || *day > daysOfMonth(*year, *month))
        return std::nullopt;
    return daysFromCivil(*year, static_cast<unsigned>(*month), static_cast<unsigned>(*day)) * 86'400'000'000'000;
}

} // namespace

std::optional<TokenKind> timeLiteralKind(std::string_view prefix)
{
    for (const Prefix& p : Prefixes) {
        if (isSameName(p.text, prefix))
            return p.kind;
    }
    return std::nullopt;
}

std::string_view exampleOf(TokenKind kind)
{
    switch (kind) {
    case TokenKind::Duration: return "T#1h30m2.5s";
    case TokenKind::LongDuration: return "LTIME#1s250us";
    case TokenKind::Date: return "D#2026-11-22";
    case TokenKind::LongDate: return "LDATE#2026-11-22";
    case TokenKind::TimeOfDay: return "TOD#15:36:55.36";
    case TokenKind::LongTimeOfDay: return "LTOD#15:36:55.36";
    case TokenKind::DateTime: return "DT#2026-11-22-15:36:55";
    default: return "LDT#2026-11-22-15:36:55.36";
    }
}

std::optional<std::int64_t> parseDuration(std::string_view text)
{
    Reader reader(text);
    const bool negative = reader.take('-');
    if (!negative)
        reader.take('+');
    __extension__ using Wide = __int128;
    Wide total = 0;
    std::int64_t smallest = INT64_MAX;
    bool hasFraction = false;
    do {
        reader.take('_');
        const auto whole = reader.number();
        if (!whole || hasFraction)
            return std::nullopt;
        std::int64_t digits = 0;
        unsigned count = 0;
        if (reader.take('.')) {
            const auto fraction = reader.number(&count);
            if (!fraction)
                return std::nullopt;
            digits = *fraction;
            hasFraction = true;
        }
        const Unit* unit = reader.unit();
        if (!unit || unit->ns >= smallest)
            return std::nullopt;
        smallest = unit->ns;
        total += Wide{*whole} * unit->ns + fractionOf(digits, count, unit->ns);
        if (total > INT64_MAX)
            return std::nullopt;
    } while (!reader.atEnd());
    const auto ns = static_cast<std::int64_t>(total);
    return negative ? -ns : ns;
}

std::optional<std::int64_t> parseDate(TokenKind kind, std::string_view text)
{
    Reader reader(text);
    std::int64_t ns = 0;
    const bool hasDay = kind != TokenKind::TimeOfDay && kind != TokenKind::LongTimeOfDay;
    const bool hasClock = kind != TokenKind::Date && kind != TokenKind::LongDate;
    if (hasDay) {
        const auto day = parseDay(reader);
        if (!day || (hasClock && !reader.take('-')))
            return std::nullopt;
        ns += *day;
    }
    if (hasClock) {
        const auto clock = parseClock(reader);
        if (!clock)
            return std::nullopt;
        ns += *clock;
    }
    return reader.atEnd() ? std::optional(ns) : std::nullopt;
}

std::int64_t daysFromCivil(std::int64_t year, unsigned month, unsigned day)
{
    const std::int64_t y = month <= 2 ? year - 1 : year;
    const std::int64_t era = y / 400;
    const std::int64_t yearOfEra = y - era * 400;
    const std::int64_t dayOfYear = (153 * (static_cast<std::int64_t>(month) + (month > 2 ? -3 : 9)) + 2) / 5 + day - 1;
    return era * 146097 + yearOfEra * 365 + yearOfEra / 4 - yearOfEra / 100 + dayOfYear - 719468;
}

} // namespace camwright::st
