#pragma once

#include "core/base/place.h"
#include "core/language/source/dialect.h"

#include <cstdint>
#include <string>
#include <vector>

namespace camwright {

enum class OperandKind : std::uint8_t {
    Text,    ///< an address, a constant, a name: what it is says the next stage
    Missing, ///< ??? : to be filled in
    Empty,   ///< _ : an optional operand left empty
    Damaged, ///< has been reported: later stages leave it alone
};

struct Operand {
    OperandKind kind = OperandKind::Text;
    std::string text; ///< as written, without blanks around it
    std::string pin;  ///< the name before := ; empty when the place decides
    TextRange range;

    bool operator==(const Operand&) const = default;
};

/// One instruction with the comments that belong to it. Comments keep their delimiters.
struct Statement {
    StatementRole role = StatementRole::Block;
    ContactForm form = ContactForm::None;
    std::string mnemonic;                     ///< as written
    std::vector<Operand> operands;
    TextRange range;                          ///< from the mnemonic to the last operand
    std::vector<std::string> leadingComments; ///< on lines of their own before it
    std::string trailingComment;              ///< on its line, behind or between the operands

    bool operator==(const Statement&) const = default;
};

enum class NodeKind : std::uint8_t {
    Element,  ///< one statement: a contact, an edge, a comparison, a block, a coil
    Series,   ///< flow runs through the children from left to right
    Parallel, ///< every child gets the same flow; their results are joined by OR. Children hold contacts only
    Fork,     ///< every child gets the same flow (MPS, MRD, MPP); the flow behind it is that of the last child
};

/// A series-parallel tree. Depth is limited to MaximumRungDepth by the parser.
struct RungNode {
    NodeKind kind = NodeKind::Series;
    std::uint32_t statement = 0;     ///< Element: index into the rung's statements
    std::vector<RungNode> children;  ///< in the order they are drawn

    bool operator==(const RungNode&) const = default;
};

/// Nesting of branches a rung may have. Ours: the manuals give none for Kinco; TS600 ladder is far below.
inline constexpr unsigned MaximumRungDepth = 32;

/// One power-flow chain: statements in the order of the text, which is the order they run in, and their picture.
struct Rung {
    std::vector<Statement> statements;         ///< with the structural ones (ANB, MPS, AND( …)
    std::vector<std::string> closingComments;  ///< after the last statement, on lines of their own
    bool drawable = true;                      ///< false: a text rung, ladder cannot draw it; `tree` is then empty
    RungNode tree;                             ///< Series at the top; every non-structural statement occurs once
    TextRange range;                           ///< from its first statement to its last

    bool operator==(const Rung&) const = default;
};

} // namespace camwright
