#pragma once

#include "core/base/hash.h"
#include "core/base/result.h"
#include "core/family/address.h"
#include "core/family/instructionid.h"
#include "core/family/text.h"

#include <cstdint>
#include <initializer_list>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace camwright {

/// Version of the catalogue's data format. A reader refuses any other.
inline constexpr int CatalogueFormatVersion = 1;

/// A set of elementary types.
class TypeSet {
public:
    constexpr TypeSet() = default;
    constexpr TypeSet(std::initializer_list<DataType> types) { for (DataType t : types) insert(t); }
    constexpr void insert(DataType type) { m_bits |= 1u << static_cast<unsigned>(type); }
    constexpr bool contains(DataType type) const { return (m_bits >> static_cast<unsigned>(type)) & 1u; }
    constexpr bool isEmpty() const { return m_bits == 0; }
    std::vector<DataType> list() const; ///< in the order of the numbers
    constexpr bool operator==(const TypeSet&) const = default;

private:
    std::uint32_t m_bits = 0;
};

enum class PinDirection : std::uint8_t { In, Out, InOut };

/// What an operand is.
enum class PinKind : std::uint8_t {
    Value,     ///< one value: a constant or a place of one of `types`
    Block,     ///< start of a row of elements of `elementBytes` each: the operand is an address, never a constant
    Timer,     ///< a timer element: T0
    Counter,   ///< a counter element: C0
    Program,   ///< the name of a subroutine
    Arguments, ///< any number of further operands, those of the subroutine called
    Axis,      ///< the name or number of an axis (TS600 motion blocks)
    Label,     ///< the name or number of a label of the same program
    Interrupt, ///< the name of an interrupt routine
};

/// One operand of an instruction, in the order of the instruction list.
struct Pin {
    std::string name;                     ///< "EXEC"; operand names of contacts and coils are ours
    PinDirection direction = PinDirection::In;
    PinKind kind = PinKind::Value;
    TypeSet types;                        ///< Value: types allowed. Block: type of an element; any form of that width may name its start
    DataType mainType = DataType::Bool;   ///< the first of `types`: what an operand is taken as that has no type of its own (D100)
    std::uint8_t typeGroup = 0;           ///< pins with the same non-zero number have one common type; of a counter, that of its value
    std::vector<AreaId> areas;            ///< memory areas allowed; empty: no memory
    bool constantAllowed = false;
    bool optional = false;                ///< may be left empty (`_`): an input takes `defaultValue`, an output is dropped
    std::string defaultValue;             ///< of an optional input, as it would be typed; may be empty
    char linkGroup = 0;                   ///< pins with the same letter are all constants or all memory (KS-MEM-08); 0 none
    bool risingEdge = false;              ///< the instruction acts on the rising edge of this pin
    std::optional<double> minimum, maximum; ///< legal range of the value, checked where it is a constant
    unsigned elementBytes = 0;            ///< Block: size of one element in bytes
    std::string countPin;                 ///< Block: the pin that says how many elements; empty: `fixedCount`
    unsigned fixedCount = 0;              ///< Block: number of elements where no pin says so
    bool isPrivate = false;               ///< Block: a work area; no other work area or block may overlap it
    bool bcd = false;                     ///< the value is BCD-coded in memory
    std::string unit;                     ///< "ms", "mm|degree" (linear|rotary axis), "" none
    Text help;

    bool operator==(const Pin&) const = default;
};

/// An operand in use: the pin, where it starts, and how many elements it has there (blocks).
struct OperandSpan {
    const Pin* pin = nullptr;
    Address start;
    std::uint64_t count = 1;

    std::uint64_t bytes() const;
};

/// Whether two operands stand in each other's way: they share memory and one of them is a private work area.
bool collide(const OperandSpan& a, const OperandSpan& b);

/// Where the knowledge of an instruction comes from (CONTRACTS 9, 31).
enum class Basis : std::uint8_t {
    Manual,     ///< printed in the family's manual
    CommonForm, ///< named or missing there; takes the form common in the trade
    Ours,       ///< our own extension
};

/// What an instruction does to the current result (power flow) after it.
enum class CrEffect : std::uint8_t {
    Keeps,    ///< unchanged
    Loads,    ///< starts a new result
    Combines, ///< result = result op operand
    Replaces, ///< result becomes the instruction's own output
    Stacks,   ///< pushes, reads or pops stored results, opens or closes a branch
};

enum class Executes : std::uint8_t {
    OnFlow, ///< while the current result is 1
    OnEdge, ///< on the rising edge of the current result
    Always, ///< whatever the current result is; it may be an input (contacts, coils, timers, EN of the motion blocks)
};

/// What a model must have so that an instruction may be used on it.
enum class Capability : std::uint8_t { None, PulseOutputs, MotionAxes };

struct Instruction {
    InstructionId id{};
    std::string mnemonic;
    std::string group;                    ///< stable key: "bit", "timer", "motion" …; its name is Catalogue::groupName
    std::vector<Pin> pins;
    Basis basis = Basis::Manual;
    CrEffect crEffect = CrEffect::Keeps;
    Executes executes = Executes::OnFlow;
    Capability needs = Capability::None;
    unsigned maxPerProject = 0;           ///< 0: no limit of its own
    unsigned maxPerAxis = 0;              ///< 0: no limit
    bool isMotion = false;                ///< counts towards ControllerModel::motionInstructionsMax
    bool simulated = true;                ///< false: compiles, the virtual controller refuses to run it
    Text whyNotSimulated;                 ///< complete where `simulated` is false
    Text help;                            ///< one or a few sentences
    std::string sources;                  ///< feature IDs of the reference sheets, blank-separated: "KS-MC-19"

    const Pin* findPin(std::string_view name) const;
    unsigned requiredPins() const;        ///< operands that must be written (optional ones at the end may be left out)
    bool operator==(const Instruction&) const = default;
};

/// All instructions of a family. Immutable; made once from the embedded data.
class Catalogue {
public:
    int formatVersion() const { return CatalogueFormatVersion; }
    /// Over what a compiler uses (instructions and pins), not over help texts. The same on every machine and run.
    const Hash& hash() const { return m_hash; }
    const std::vector<Instruction>& instructions() const { return m_instructions; }
    const Instruction* find(std::string_view mnemonic) const; ///< upper or lower case; null if unknown
    const Instruction* find(InstructionId id) const;
    Text groupName(std::string_view group) const;
    /// The known mnemonic nearest to a misspelt one, for "did you mean"; empty if none is near.
    std::string nearest(std::string_view mnemonic) const;

private:
    friend class CatalogueReader;
    std::vector<Instruction> m_instructions;
    std::map<std::string, std::size_t, std::less<>> m_byMnemonic;
    std::map<InstructionId, std::size_t> m_byId;
    std::map<std::string, Text, std::less<>> m_groups;
    Hash m_hash;
};

} // namespace camwright
