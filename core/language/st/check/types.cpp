#include "core/language/st/check/types.h"

#include <algorithm>

namespace camwright::st {

namespace {

struct Row {
    std::string_view name;
    DataType data;
};

constexpr Row Rows[] = {
    {"", DataType::Dint}, {"BOOL", DataType::Bool}, {"BYTE", DataType::Byte}, {"WORD", DataType::Word}, {"DWORD", DataType::Dword},
    {"LWORD", DataType::Lword}, {"SINT", DataType::Sint}, {"INT", DataType::Int}, {"DINT", DataType::Dint}, {"LINT", DataType::Lint},
    {"USINT", DataType::Usint}, {"UINT", DataType::Uint}, {"UDINT", DataType::Udint}, {"ULINT", DataType::Ulint},
    {"REAL", DataType::Real}, {"LREAL", DataType::Lreal}, {"TIME", DataType::Time}, {"LTIME", DataType::Lint},
    {"DATE", DataType::Udint}, {"LDATE", DataType::Lint}, {"TOD", DataType::Udint}, {"LTOD", DataType::Lint},
    {"DT", DataType::Udint}, {"LDT", DataType::Lint},
};

unsigned widthOf(Elementary e)
{
    return bitWidth(dataTypeOf(e));
}

bool isBetween(Elementary e, Elementary first, Elementary last)
{
    return e >= first && e <= last;
}

} // namespace

std::string_view elementaryName(Elementary elementary)
{
    return Rows[static_cast<unsigned>(elementary)].name;
}

DataType dataTypeOf(Elementary elementary)
{
    return Rows[static_cast<unsigned>(elementary)].data;
}

bool isSigned(Elementary e) { return isBetween(e, Elementary::Sint, Elementary::Lint); }
bool isUnsigned(Elementary e) { return isBetween(e, Elementary::Usint, Elementary::Ulint); }
bool isAnyInteger(Elementary e) { return isBetween(e, Elementary::Sint, Elementary::Ulint); }
bool isBits(Elementary e) { return isBetween(e, Elementary::Byte, Elementary::Lword); }
bool isAnyReal(Elementary e) { return e == Elementary::Real || e == Elementary::Lreal; }
bool isNumber(Elementary e) { return isAnyInteger(e) || isAnyReal(e); }
bool isDuration(Elementary e) { return e == Elementary::Time || e == Elementary::Ltime; }
bool isMoment(Elementary e) { return isBetween(e, Elementary::Date, Elementary::Ldt); }

bool widens(Elementary from, Elementary to)
{
    if (from == to)
        return true;
    if (isSigned(from) && isSigned(to))
        return from < to;
    if (isUnsigned(from) && isUnsigned(to))
        return from < to;
    if (isUnsigned(from) && isSigned(to))
        return widthOf(from) < widthOf(to);
    if (isBits(from) && isBits(to))
        return from < to;
    if (isAnyInteger(from) && isAnyReal(to))
        return widthOf(from) <= (to == Elementary::Real ? 16u : 32u);
    if (from == Elementary::Real)
        return to == Elementary::Lreal;
    const bool isShortTime = from == Elementary::Time || from == Elementary::Date || from == Elementary::Tod || from == Elementary::Dt;
    return isShortTime && static_cast<unsigned>(to) == static_cast<unsigned>(from) + 1;
}

Elementary commonOf(Elementary a, Elementary b)
{
    if (widens(a, b))
        return b;
    if (widens(b, a))
        return a;
    for (const Elementary e : {Elementary::Int, Elementary::Dint, Elementary::Lint, Elementary::Real, Elementary::Lreal}) {
        if (widens(a, e) && widens(b, e))
            return e;
    }
    return Elementary::None;
}

bool isSame(const Type& a, const Type& b)
{
    if (&a == &b)
        return true;
    if (a.kind != b.kind)
        return false;
    switch (a.kind) {
    case TypeKind::Elementary: return a.elementary == b.elementary;
    case TypeKind::Text: return a.capacity == b.capacity && a.isWide == b.isWide;
    case TypeKind::Array: return a.low == b.low && a.high == b.high && isSame(*a.element, *b.element);
    case TypeKind::Reference: return isSame(*a.element, *b.element);
    default: return false;
    }
}

Wide smallestOf(Elementary e)
{
    const bool negative = isSigned(e) || e == Elementary::Time || dataTypeOf(e) == DataType::Lint;
    return negative ? -(Wide{1} << (widthOf(e) - 1)) : Wide{0};
}

Wide largestOf(Elementary e)
{
    const bool negative = smallestOf(e) < 0;
    return (Wide{1} << (widthOf(e) - (negative ? 1 : 0))) - 1;
}

std::string wideText(Wide number)
{
    if (number == 0)
        return "0";
    std::string out;
    const bool negative = number < 0;
    for (Wide rest = number; rest != 0; rest /= 10) {
        const int digit = static_cast<int>(rest % 10);
        out += static_cast<char>('0' + (digit < 0 ? -digit : digit));
    }
    if (negative)
        out += '-';
    std::ranges::reverse(out);
    return out;
}

std::string typeText(const Type& type, const Names& names)
{
    if (type.name != 0)
        return std::string(names.text(type.name));
    switch (type.kind) {
    case TypeKind::Elementary: return std::string(elementaryName(type.elementary));
    case TypeKind::Subrange: return std::string(elementaryName(type.elementary)) + " (" + std::to_string(type.low) + ".." + std::to_string(type.high) + ")";
    case TypeKind::Text: return std::string(type.isWide ? "WSTRING" : "STRING") + "[" + std::to_string(type.capacity) + "]";
    case TypeKind::Array:
        return "ARRAY [" + std::to_string(type.low) + ".." + std::to_string(type.high) + "] OF " + typeText(*type.element, names);
    case TypeKind::Reference: return "REF_TO " + typeText(*type.element, names);
    case TypeKind::Enum: return "(…)";
    case TypeKind::Struct: return "STRUCT";
    case TypeKind::AnyInteger: return CW_TEXT("Arguments", "a whole number");
    case TypeKind::AnyReal: return CW_TEXT("Arguments", "a real number");
    case TypeKind::AnyText: return CW_TEXT("Arguments", "a string");
    case TypeKind::Null: return "NULL";
    case TypeKind::Void: return CW_TEXT("Arguments", "nothing");
    default: return "?";
    }
}

} // namespace camwright::st
