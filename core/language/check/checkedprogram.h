#pragma once

#include "core/base/value.h"
#include "core/family/address.h"
#include "core/family/catalogue.h"
#include "core/language/check/resolvedprogram.h"
#include "core/language/source/rung.h"
#include "core/model/objects.h"

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace camwright {

/// An optional pin that was left empty.
struct NoOperand {
    bool operator==(const NoOperand&) const = default;
};

/// Memory. For a timer or counter pin the address of its bit, with the type of its value (Family::valueOf gives the place).
/// `type` is otherwise the type the instruction reads or writes there, already decided where the catalogue allows several.
struct AddressOperand {
    Address address;
    DataType type = DataType::Bool;
    std::string symbol; ///< the variable's name when it was written by name
    std::uint32_t elements = 0; ///< an array with a variable subscript: how many; `address` is the first. 0: none
    Address index{};            ///< the subscript, INT or DINT
    bool operator==(const AddressOperand&) const = default;
};

/// A constant, already of the pin's type and inside its range.
struct ConstantOperand {
    Value value;
    bool operator==(const ConstantOperand&) const = default;
};

/// The start of a list in memory. `elements` is known when the count is a constant or fixed by the instruction; the whole
/// block is then inside its area.
struct BlockOperand {
    Address start;
    DataType elementType = DataType::Byte;
    std::optional<std::uint32_t> elements;
    bool operator==(const BlockOperand&) const = default;
};

/// A subroutine that exists and does not lead back here, or an interrupt routine.
struct ProgramOperand {
    std::string name;
    bool operator==(const ProgramOperand&) const = default;
};

/// A label that stands once in the same program.
struct LabelOperand {
    std::string name;
    bool operator==(const LabelOperand&) const = default;
};

using OperandValue = std::variant<NoOperand, AddressOperand, ConstantOperand, BlockOperand, ProgramOperand, LabelOperand>;

/// One operand at its pin.
struct CheckedOperand {
    const Pin* pin = nullptr; ///< of the catalogue; never null
    OperandValue value;
    TextRange range;          ///< invalid for a pin that was not written
};

/// Statements without memory of their own.
inline constexpr std::uint32_t NoInstance = 0xFFFFFFFF;

/// One statement, all its operands known. Structural statements (StatementRole AndBlock … CloseGroup) have no operands
/// but for OpenAnd and OpenOr, whose optional contact is what the flow of the group begins with (NoOperand: flow on).
struct CheckedStatement {
    StatementRole role = StatementRole::Block;
    ContactForm form = ContactForm::None;
    const Instruction* instruction = nullptr; ///< of the catalogue; never null
    std::vector<CheckedOperand> operands;     ///< one for each pin of the instruction, in the catalogue's order; then a CALL's arguments
    DataType type = DataType::Bool;           ///< the type its operands share (MOVE, EQ, ADD); BOOL where there is none
    std::uint32_t instance = NoInstance;      ///< of edges (contacts, R_TRIG) and blocks: dense from 0 in each program
    TextRange range;
};

/// One power-flow chain. The statements in order are what runs, with a stack of flows as StatementRole says; that is also
/// true of a text rung. The tree is the same as a picture: its elements are indices into `statements`.
struct CheckedRung {
    std::vector<CheckedStatement> statements;
    bool drawable = true;
    RungNode tree;
    TextRange range;
};

struct CheckedNetwork {
    std::uint32_t number = 0;
    std::vector<CheckedRung> rungs;
    TextRange range;
};

/// A program without errors: every operand typed, in its area, in its range, and allowed on the model.
struct CheckedProgram {
    ObjectKey key;
    ProgramRole role = ProgramRole::Main;
    DialectId dialect = DialectId::KincoIl;
    std::vector<CheckedNetwork> networks;
    std::uint32_t instances = 0;  ///< how many instance numbers are in use
    /// The subroutine's variable table, which the pins of its own locals and of calls point to.
    std::shared_ptr<const std::vector<KnownParameter>> parameters{};
    std::optional<InterruptEvent> event{};
};

} // namespace camwright
