#pragma once

#include "core/family/family.h"
#include "core/language/image/controllerimage.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace camwright {

/// A variable as the tables declare it.
struct DeclaredVariable {
    std::string name;
    DataType type = DataType::Bool;
    std::optional<Address> address; ///< empty: the compiler finds a place
    std::optional<Value> initial;
    bool retain = false;
};

/// Where the variables lie.
struct PlacedVariables {
    std::vector<Symbol> symbols;    ///< by name
    std::uint32_t bytes = 0;        ///< of VariablesArea
    std::uint32_t retainedBytes = 0; ///< the first ones of it
    std::vector<InitialValue> initialValues;
};

/// Bound variables lie where they are bound. The others lie in VariablesArea, the retained first, each kind in the order
/// of the tables; a BOOL takes a byte, longer types begin at a multiple of their size up to 4 (ours; TS-VAR-14 keeps these
/// addresses from being seen).
PlacedVariables placeVariables(std::span<const DeclaredVariable> variables, const Family& family, const ControllerModel& model);

/// The areas of a model. Areas that belong to a program block are as often there as there are routines.
MemoryLayout memoryLayout(const Family& family, const ControllerModel& model, const PlacedVariables& variables, std::size_t routines);

} // namespace camwright
