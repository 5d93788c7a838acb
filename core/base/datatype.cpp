#include "core/base/datatype.h"

#include <algorithm>

namespace camwright {

namespace {

struct Row {
    DataType type;
    std::string_view name;
    std::uint8_t bits;
    char kind; // b bool, u unsigned or bit string, s signed, f float
};

constexpr Row Rows[] = {
    {DataType::Bool, "BOOL", 1, 'b'},     {DataType::Byte, "BYTE", 8, 'u'},    {DataType::Word, "WORD", 16, 'u'},
    {DataType::Dword, "DWORD", 32, 'u'},  {DataType::Sint, "SINT", 8, 's'},    {DataType::Int, "INT", 16, 's'},
    {DataType::Dint, "DINT", 32, 's'},    {DataType::Usint, "USINT", 8, 'u'},  {DataType::Uint, "UINT", 16, 'u'},
    {DataType::Udint, "UDINT", 32, 'u'},  {DataType::Real, "REAL", 32, 'f'},   {DataType::Lreal, "LREAL", 64, 'f'},
    {DataType::Time, "TIME", 32, 's'},    {DataType::Lint, "LINT", 64, 's'},   {DataType::Ulint, "ULINT", 64, 'u'},
    {DataType::Lword, "LWORD", 64, 'u'},
};

const Row& row(DataType type)
{
    return Rows[static_cast<std::size_t>(type) - 1];
}

char upper(char c)
{
    return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
}

} // namespace

std::string_view name(DataType type) { return row(type).name; }
unsigned bitWidth(DataType type) { return row(type).bits; }
unsigned byteWidth(DataType type) { return row(type).bits == 1 ? 1 : row(type).bits / 8; }
bool isSigned(DataType type) { return row(type).kind == 's'; }
bool isFloat(DataType type) { return row(type).kind == 'f'; }
bool isInteger(DataType type) { return row(type).kind == 's' || row(type).kind == 'u'; }

std::optional<DataType> dataTypeByName(std::string_view name)
{
    for (const Row& r : Rows) {
        if (std::ranges::equal(r.name, name, {}, {}, upper))
            return r.type;
    }
    return std::nullopt;
}

} // namespace camwright
