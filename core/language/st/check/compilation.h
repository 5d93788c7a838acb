#pragma once

#include "core/base/diagnostic.h"
#include "core/base/result.h"
#include "core/base/value.h"
#include "core/language/st/check/types.h"
#include "core/language/st/syntax/names.h"
#include "core/language/st/syntax/textlines.h"

#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace camwright::st {

/// One text in ST. It must outlive the compilation.
struct Source {
    ObjectKey key;
    std::string_view text;
    bool isMain = false;              ///< its PROGRAM, or its CONFIGURATION, is what the controller runs each scan
};

/// A variable that is declared outside of ST, in a table of the project.
struct OuterVariable {
    std::string name;
    DataType type = DataType::Bool;
    Address address;
    bool isWritable = true;
};

/// What surrounds the texts: a project, or nothing for a loose file.
struct Environment {
    std::vector<OuterVariable> variables;
    std::vector<std::string> subroutines;                          ///< programs of other languages that can be called by name
    std::function<std::optional<Address>(std::string_view, DataType)> findAddress; ///< an address as the family writes it, as a type
    std::uint32_t variablesFrom = 0;                               ///< first free byte of VariablesArea
    bool isLoose = false;                                          ///< no controller is known: any IEC address is good
};

/// A PROGRAM the controller runs, in this order.
struct ProgramRun {
    PouInfo* program = nullptr;
    std::int64_t intervalNs = 0;       ///< 0: every scan
    std::int64_t priority = 0;
    std::uint32_t nextRun = 0;         ///< LINT in VariablesArea: when it is due, where there is an interval
};

/// A value to be written at power-on.
struct StartValue {
    std::uint32_t offset = 0;          ///< in VariablesArea
    Value value;
};

/// Texts on their way from characters to IR, and everything found out about them.
struct Compilation {
    Names names;
    Arena arena;
    std::vector<Source> sources;               ///< the last one is the standard library
    std::deque<TextLines> lines;
    std::vector<Unit> units;
    std::vector<Diagnostics> diagnostics;      ///< by source
    std::vector<Type> elementary;              ///< by Elementary
    Type bad, nothing, anyInteger, anyReal, anyText, null; ///< of what is wrong, of calls without a result, of literals
    std::deque<Type> types;
    std::deque<Symbol> symbols;
    std::deque<PouInfo> pous;
    std::deque<Constant> constants;
    std::deque<std::vector<Symbol*>> memberLists;
    std::vector<Symbol*> globals;              ///< VAR_GLOBAL, in order
    std::vector<ProgramRun> runs;
    std::vector<StartValue> startValues;
    std::vector<std::string> subroutines;
    std::uint32_t variableBytes = 0;           ///< end of what is used of VariablesArea

    bool hasErrors() const;
};

/// Memory that variables may take together; ours.
inline constexpr std::uint32_t MostVariableBytes = 16u << 20;

} // namespace camwright::st
