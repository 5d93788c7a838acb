#pragma once

#include "core/family/catalogue.h"
#include "core/language/check/context.h"
#include "core/language/check/literals.h"
#include "core/language/source/ilparser.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace camwright {

/// Memory as written: by address, or by the name of a variable.
struct ResolvedMemory {
    Address address;
    const KnownVariable* variable = nullptr; ///< of the context; null for an address
    /// The variable that chooses the element of an array (TS-IDX-01); `address` is then the first element. Of the context.
    const KnownVariable* index = nullptr;
    Address indexAddress{};                  ///< where the index lies, an element of an array included
};

struct ResolvedProgramName {
    std::string name;
};

/// A label of the same program, in upper case.
struct ResolvedLabel {
    std::string name;
};

/// What stands at a pin. monostate: an optional pin left empty.
using ResolvedValue = std::variant<std::monostate, ResolvedMemory, Literal, ResolvedProgramName, ResolvedLabel>;

struct ResolvedOperand {
    const Pin* pin = nullptr; ///< never null
    ResolvedValue value;
    std::string text;         ///< as written; empty for a pin that was not
    TextRange range;
};

/// A statement whose words are known. `isComplete` is false where something was reported: the next stage leaves it alone.
struct ResolvedStatement {
    StatementRole role = StatementRole::Block;
    ContactForm form = ContactForm::None;
    const Instruction* instruction = nullptr; ///< null only where it is not complete
    std::vector<ResolvedOperand> operands;    ///< one for each pin, in the catalogue's order; then the arguments of a CALL
    bool isComplete = true;
    TextRange range;
};

struct ResolvedRung {
    std::vector<ResolvedStatement> statements; ///< as many as the parsed rung has, in its order
    bool drawable = true;
    RungNode tree;
    TextRange range;
};

struct ResolvedNetwork {
    std::uint32_t number = 0;
    std::vector<ResolvedRung> rungs;
    TextRange range;
};

/// The event of an interrupt routine (TS-INT-01 … 03).
struct InterruptEvent {
    enum class Kind : std::uint8_t { Timed, Rising, Falling };
    Kind kind = Kind::Timed;
    Address input;                  ///< Rising, Falling
    std::uint32_t milliseconds = 0; ///< Timed: 1 … 1000
};

/// A program whose mnemonics, addresses, names and pins are known. Refers to the context it was made with.
struct ResolvedProgram {
    ObjectKey key;
    ProgramRole role = ProgramRole::Main;
    DialectId dialect = DialectId::KincoIl;
    std::vector<ResolvedNetwork> networks;
    bool isComplete = true; ///< false if text or words had an error
    /// The variables of its own table. Operands point to them, so they stay where they are.
    std::shared_ptr<const std::vector<KnownParameter>> parameters{};
    std::optional<InterruptEvent> event{};
};

/// Looks up every word. What is wrong is added to `diagnostics`, at most MaximumDiagnostics.
ResolvedProgram resolve(const ParsedProgram& program, ProgramRole role, const LanguageContext& context, Diagnostics& diagnostics);

/// How an instruction is written: "MC_RPARAS EXEC, AXIS, ID, NUM, DONE, ERR, ERRID, PARAS"; optional operands in brackets.
std::string signature(const Dialect& dialect, const Instruction& instruction);

/// The nearest of some names to a misspelt one, or nothing if none is near. Case does not count.
std::string nearestName(std::string_view wanted, const std::vector<std::string_view>& names);

} // namespace camwright
