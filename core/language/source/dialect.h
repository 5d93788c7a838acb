#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace camwright {

/// The instruction-list dialects. Each is a table of structural mnemonics and a few lexical rules; what else a mnemonic
/// needs (operands, types, areas) stands in the family's catalogue.
enum class DialectId : std::uint8_t { KincoIl, Ts600Il, KoyoIl };

/// What a statement does to the power flow (the CR of Kinco, the energy flow of TS600). It is known from the mnemonic alone,
/// so a program whose instructions are misspelt still has its shape.
enum class StatementRole : std::uint8_t {
    Load,      ///< starts a flow with a contact; while a flow is open the old one is put on the stack
    And,       ///< flow = flow AND contact
    Or,        ///< flow = flow OR contact
    AndBlock,  ///< ANB: flow = stacked flow AND flow
    OrBlock,   ///< ORB: flow = stacked flow OR flow
    PushFlow,  ///< MPS: remembers the flow for branches
    ReadFlow,  ///< MRD: takes the remembered flow again
    PopFlow,   ///< MPP: takes it for the last time
    OpenAnd,   ///< AND( : keeps the flow, begins a group with flow on
    OpenOr,    ///< OR( : the same for OR
    CloseGroup,///< ) : joins the group with the flow kept
    Flow,      ///< makes a new flow of the old one without an operand: R_TRIG, F_TRIG, NOT, INV
    Output,    ///< ST, S, R, OUT, SET, RST: uses the flow, leaves it
    Block,     ///< any other instruction; what it makes of the flow says the catalogue
    Invalid,   ///< a line that is no statement; kept as text
};

/// How a contact or a comparison reads its operands.
enum class ContactForm : std::uint8_t {
    None, NormallyOpen, NormallyClosed, Rising, Falling, Equal, NotEqual, Greater, GreaterEqual, Less, LessEqual,
};

struct MnemonicShape {
    StatementRole role = StatementRole::Block;
    ContactForm form = ContactForm::None;
    DialectId dialect = DialectId::KincoIl;
    /// Width letter inside a TS600 comparison: ' ' for INT ("LD="), 'D' for DINT ("LDD="), 'R' for REAL ("LDR=").
    char width = ' ';

    bool operator==(const MnemonicShape&) const = default;
};

struct Dialect {
    DialectId id;
    std::string_view name;       ///< "Kinco IL"
    std::string_view family;     ///< "kinco": the family whose catalogue it uses
    bool commaSeparated;         ///< operands are separated by commas, else by blanks
    bool lineComments;           ///< "//" starts a comment (our extension of TS600 IL)
    bool networkHeaders;         ///< "(* Network n *)" heads every network; else networks are derived from the flow
    std::uint32_t firstNetwork;  ///< number of the first network: 0 on Kinco, 1 on TS600 and Koyo

    /// Role and form of a mnemonic, upper or lower case. A name the table does not know is a Block.
    MnemonicShape shapeOf(std::string_view mnemonic) const;
    /// The mnemonic a contact or comparison has at a place of the rung ("LDN" for Load and NormallyClosed); empty when
    /// the dialect has none. `width` as in MnemonicShape.
    std::string_view contactMnemonic(StatementRole position, ContactForm form, char width = ' ') const;
    /// Whether a block needs no flow in front of it: LBL and NEXT, which begin the flow anew behind them.
    static bool standsAlone(std::string_view mnemonic);
    /// The mnemonic of ANB, ORB, MPS, MRD, MPP, AND(, OR(, ); empty when the dialect has none.
    std::string_view structureMnemonic(StatementRole role) const;
};

const Dialect& kincoIl();
const Dialect& ts600Il();
const Dialect& koyoIl();
const Dialect& dialect(DialectId id);
/// The instruction list of a family ("kinco", "invt", "koyo"); null for a family that has none.
const Dialect* dialectOfFamily(std::string_view family);

} // namespace camwright
