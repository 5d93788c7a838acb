#pragma once

#include "core/language/check/context.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace camwright {

/// A stretch of memory that has a use. Bit and value of a timer or counter count as one place, that of the bit.
struct MemoryTarget {
    Address address;
    std::uint64_t bits = 1;   ///< from the address on; of a list as many as are known to be in use
    std::string program;      ///< only of areas that belong to the program block that runs (L; LM and V): its name

    bool operator==(const MemoryTarget&) const = default;
};

/// An axis, by number: an instruction may name one that the project does not have.
struct AxisTarget {
    std::uint32_t number = 0;
    bool operator==(const AxisTarget&) const = default;
};

struct ProgramTarget {
    std::string name;
    bool operator==(const ProgramTarget&) const = default;
};

/// What can be looked for.
using ReferenceTarget = std::variant<MemoryTarget, AxisTarget, ProgramTarget>;

enum class UseKind : std::uint8_t {
    Declares,      ///< the row of a variable, the axis, the program itself
    Reads,
    Writes,
    ReadsAndWrites,///< a timer, INC
    Calls,         ///< of a subroutine
    Commands,      ///< an instruction acts on the axis
    Watches,       ///< a row of a watch table
};

/// One place of the project that uses something.
struct SymbolUse {
    UseKind kind = UseKind::Reads;
    ReferenceTarget target;
    Place place;              ///< the operand in a program, "rows[n]" of a table, or the object
    std::string text;         ///< as written
    std::string line;         ///< the program's line without blanks around it; empty elsewhere
    std::string instruction;  ///< its mnemonic; empty outside programs
    std::uint32_t network = 0;///< number of the network; in programs

    bool operator==(const SymbolUse&) const = default;
};

/// Every use in the programs, variable tables and watch tables of a project, declarations first, then by program in the
/// order of the project and by place, then watch tables. Programs with errors are read as far as they can be understood.
/// A pure function, linear in the size of the project; empty where family or model is unknown. What it is good for: find
/// references, a cross-reference list, finding memory that nothing uses.
std::vector<SymbolUse> crossReference(const Project& project);

/// What stands under a place of a program's text: a variable, an address, the number or name of an axis at an axis operand,
/// a subroutine. `program` says whose local memory is meant. Nothing at instructions, constants, comments and blanks.
std::optional<ReferenceTarget> targetAt(const LanguageContext& context, const std::string& program, std::string_view text, std::size_t offset);

/// What a name means outside programs: a variable, an address as people type it, `axis.Feed.position` (the axis), the name of
/// an axis or a program.
std::optional<ReferenceTarget> targetNamed(const LanguageContext& context, std::string_view name);

/// "FeedTarget (%VR100)", "%VW2", "Feed (axis 1)" without the word: name, then address or number in parentheses.
std::string nameOf(const LanguageContext& context, const ReferenceTarget& target);

enum class ReferenceMatch : std::uint8_t {
    None,
    Same,     ///< the same thing: the same first bit and as many
    Overlap,  ///< shares memory: %VD0 and %VW2
};
ReferenceMatch match(const ReferenceTarget& sought, const ReferenceTarget& used);

struct Reference {
    SymbolUse use;
    bool overlaps = false; ///< it shares memory with what is sought, and is not the same
};

/// The uses that concern a target, in their order.
std::vector<Reference> referencesTo(const ReferenceTarget& target, const std::vector<SymbolUse>& uses);

} // namespace camwright
