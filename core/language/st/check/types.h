#pragma once

#include "core/base/codes.h"
#include "core/base/datatype.h"
#include "core/family/address.h"
#include "core/language/st/syntax/tree.h"

#include <cstdint>
#include <string>
#include <vector>

namespace camwright::st {

/// The elementary types of IEC 61131-3. The order inside a group is that of implicit widening.
enum class Elementary : std::uint8_t {
    None, Bool, Byte, Word, Dword, Lword, Sint, Int, Dint, Lint, Usint, Uint, Udint, Ulint, Real, Lreal,
    Time, Ltime, Date, Ldate, Tod, Ltod, Dt, Ldt,
};

enum class TypeKind : std::uint8_t { Bad, Void, Elementary, Enum, Subrange, Text, Array, Struct, Block, Interface, Reference, AnyInteger, AnyReal, AnyText, Null };

struct PouInfo;

/// A type. Each exists once where it is elementary or named; arrays, strings and references compare by `isSame`.
struct Type {
    TypeKind kind = TypeKind::Bad;
    Elementary elementary = Elementary::None; ///< Elementary; Enum and Subrange: of their base
    DataType data = DataType::Dint;           ///< how a value lies in memory, of scalar types
    NameId name = 0;
    std::uint32_t size = 0;                   ///< bytes
    std::uint32_t alignment = 1;
    const Type* element = nullptr;            ///< Array, Reference: of what; Subrange: base
    std::int64_t low = 0, high = 0;           ///< Array: of its one subscript; Subrange: its range
    std::uint32_t capacity = 0;               ///< Text: characters
    bool isWide = false;                      ///< Text: of 16 bits
    std::vector<struct Symbol*>* members = nullptr; ///< Struct, Block: sorted by name
    const TypeSpec* spec = nullptr;
    const Expr* initial = nullptr;            ///< given in the TYPE declaration
    PouInfo* pou = nullptr;                   ///< Block, Interface

    bool isScalar() const { return kind == TypeKind::Elementary || kind == TypeKind::Enum || kind == TypeKind::Subrange || kind == TypeKind::Reference || kind == TypeKind::Interface; }
};

/// What an expression is before the program runs: a whole number of any type, a real, or a string.
__extension__ using Wide = __int128;

struct Constant {
    Wide integer = 0;        ///< integers, BOOL, enumerations, times and dates in the unit of their type
    double real = 0;
    std::string_view text;   ///< the string, escapes replaced; UTF-16 units of WSTRING as UTF-8
    bool isReal = false;
    bool isText = false;
};

enum class SymbolKind : std::uint8_t { Variable, EnumValue, Type, Pou, Method, Standard, Subroutine };

/// Where a variable lives.
enum class Storage : std::uint8_t {
    Static,   ///< at `offset` of VariablesArea
    Instance, ///< at `offset` of the function block's instance
    Located,  ///< at `address`, in an area of the family
    Constant, ///< nowhere: it has a value only
};

struct Symbol {
    SymbolKind kind = SymbolKind::Variable;
    NameId name = 0;
    const Type* type = nullptr;
    Storage storage = Storage::Static;
    Section section = Section::Local;
    bool isConstant = false;
    bool isRetain = false;
    bool isPointer = false;          ///< VAR_IN_OUT: the place holds a pointer to the variable
    mutable bool isRead = false, isWritten = false;
    std::uint32_t offset = 0;
    std::uint32_t fresh = 0;         ///< of what begins anew with each call and is no scalar: its initial bytes in VariablesArea
    Address address;                 ///< Located
    const Constant* constant = nullptr;
    const Variable* declaration = nullptr;
    const Expr* initial = nullptr;
    std::uint32_t file = 0;          ///< index of the source it is declared in
    std::uint32_t place = 0, placeEnd = 0;
    PouInfo* pou = nullptr;          ///< Pou, Method
    std::uint32_t standard = 0;      ///< Standard: see standard.h; Subroutine: number of it
};

/// A POU after its head was read.
struct PouInfo {
    Pou* tree = nullptr;
    Symbol* symbol = nullptr;
    std::uint32_t file = 0;
    PouInfo* owner = nullptr;              ///< Method: its function block or interface
    PouInfo* base = nullptr;               ///< EXTENDS
    std::vector<PouInfo*> interfaces;      ///< IMPLEMENTS; of interfaces what they extend
    Type* type = nullptr;                  ///< FunctionBlock, Program, Interface: of an instance
    Symbol* result = nullptr;              ///< Function, Method: the variable with its name
    std::vector<Symbol*> variables;        ///< own ones, as declared
    std::vector<Symbol*> parameters;       ///< Input, Output and InOut, as declared; of blocks those of the base first
    std::vector<PouInfo*> methods;         ///< own ones
    std::vector<PouInfo*> callees;         ///< what it calls, for recursion
    bool isResolved = false, isResolving = false;
    bool isPrelude = false;                ///< of the standard library
};

/// The name of a type as people write it: "ARRAY [0..9] OF INT".
std::string typeText(const Type& type, const Names& names);
std::string_view elementaryName(Elementary elementary);
DataType dataTypeOf(Elementary elementary);

bool isSigned(Elementary e);
bool isUnsigned(Elementary e);
bool isAnyInteger(Elementary e);   ///< SINT … ULINT
bool isBits(Elementary e);         ///< BYTE … LWORD
bool isAnyReal(Elementary e);
bool isNumber(Elementary e);
bool isDuration(Elementary e);     ///< TIME, LTIME
bool isMoment(Elementary e);       ///< DATE … LDT

/// Whether a value of one type becomes one of the other without being written as a conversion.
bool widens(Elementary from, Elementary to);
/// The smallest type both widen to; None if there is none.
Elementary commonOf(Elementary a, Elementary b);
bool isSame(const Type& a, const Type& b);

/// The range of an integer, bit string, time or date type.
Wide smallestOf(Elementary e);
Wide largestOf(Elementary e);

std::string wideText(Wide number);

} // namespace camwright::st
