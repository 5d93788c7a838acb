#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace camwright {

/// The elementary types of IEC 61131-3 that the families use. The numbers are permanent: images and the online protocol
/// carry them.
enum class DataType : std::uint8_t {
    Bool = 1, Byte = 2, Word = 3, Dword = 4, Sint = 5, Int = 6, Dint = 7, Usint = 8, Uint = 9, Udint = 10,
    Real = 11, Lreal = 12, Time = 13, Lint = 14, Ulint = 15, Lword = 16,
};

std::string_view name(DataType type);                              ///< "DINT"
std::optional<DataType> dataTypeByName(std::string_view name);     ///< upper or lower case
unsigned bitWidth(DataType type);                                  ///< 1 for BOOL, else 8 … 64
unsigned byteWidth(DataType type);                                 ///< bytes in memory; 1 for BOOL
bool isSigned(DataType type);
bool isFloat(DataType type);
bool isInteger(DataType type);                                     ///< signed, unsigned and bit-string types, not BOOL

} // namespace camwright
