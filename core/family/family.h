#pragma once

#include "core/base/result.h"
#include "core/base/time.h"
#include "core/family/address.h"
#include "core/family/catalogue.h"
#include "core/family/text.h"

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace camwright {

/// How an area is numbered and what one number of it is.
enum class AreaKind : std::uint8_t {
    Bytes,         ///< byte array with bit, byte, word and double-word access (Kinco)
    Bits,          ///< elements that are a bit, one byte each, 0 or 1 (TS600 X Y M LM S SM)
    Words,         ///< 16-bit elements, two in a row for 32-bit types, low word first (TS600 D R V Z)
    TimerBits,     ///< one byte each
    TimerValues,
    CounterBits,   ///< one byte each
    CounterValues,
};

struct MemoryArea {
    AreaId id = 0;
    std::string name;                  ///< as written in addresses: "V", "SM", "X", "T"
    AreaKind kind = AreaKind::Bytes;
    unsigned elementBytes = 1;         ///< bytes from one number to the next
    std::string sizeLetters;           ///< Bytes: the forms allowed, of "XBWDR" (X = bit)
    bool octal = false;                ///< numbers are octal (TS600 X and Y, all of Koyo)
    bool readable = true, writable = true; ///< by the user's program; where only a part is writable see Family::isWritable
    std::uint32_t writableFirst = 0, writableLast = 0xFFFFFFFF; ///< elements the program may write, where `writable`
    bool local = false;                ///< belongs to the program block that is running (L; LM and V)
    bool isInput = false, isOutput = false; ///< terminals: set by the panel of inputs, driven to the outputs
    Text meaning;

    /// Elements that are a bit, eight in a byte, numbered through in octal (Koyo X17 is bit 7 of byte 1).
    bool isPacked() const { return octal && sizeLetters == "X"; }
};

/// Size of an area on one model.
struct AreaLayout {
    std::uint32_t bytes = 0;
    std::uint32_t retainedFirst = 0, retainedEnd = 0; ///< bytes [first, end) survive power-off; equal: none
};

struct ControllerModel {
    std::string name;                  ///< "KS101M-04DX", "TS635"
    std::string series;                ///< "KS"
    bool selectable = true;            ///< false: named in the manual for its limits only
    unsigned digitalInputs = 0, digitalOutputs = 0; ///< on the unit itself
    unsigned analogInputs = 0, analogOutputs = 0;
    unsigned expansionModulesMax = 0;
    unsigned ethernetPorts = 0, canPorts = 0, pulseOutputs = 0, highSpeedCounters = 0;
    unsigned axesMax = 0;              ///< axes of the motion network
    unsigned motionInstructionsMax = 0; ///< 0: no motion instructions on this model
    unsigned restartInstructionsMax = 0;
    unsigned programInstructionsMax = 0; ///< contacts, coils and blocks (Kinco) or steps (TS600)
    std::vector<AreaLayout> areas;     ///< by AreaId

    bool has(Capability capability) const;
    const AreaLayout& area(AreaId id) const { return areas[id]; }
};

/// One of the numbered parameters that MC_RPARAS and MC_WPARAS transfer.
struct DriveParameter {
    unsigned number = 0;               ///< 0 … 44
    std::string symbol;                ///< the vendor's short name
    std::uint16_t index = 0;           ///< CANopen object
    std::uint8_t subindex = 0;
    std::uint8_t objectBits = 32;      ///< size of the object in the drive
    bool isReal = false;               ///< the 4-byte cell holds an IEEE float, else an integer
    bool isSigned = false;
    std::uint8_t processBits = 32;     ///< width the manual gives for the value in the program
    std::string unitLinear, unitRotary; ///< "mm/s^2", "1/s^2", "mm/min", "Hz", "%", "" raw
    std::int64_t minimum = 0, maximum = 0; ///< range of the drive's object, in drive units
    std::optional<std::uint32_t> onlyValue; ///< the only value accepted ("save", "load")
    Text name;
    std::string sources;
};

/// What a code or a bit of an error field means.
struct ErrorText {
    enum class Kind : std::uint8_t { Code, Bit };
    enum class Level : std::uint8_t { Unspecified, Warning, General, Serious };

    std::string scope;                 ///< Kinco: the mnemonic. TS600: the main code, "0x0011"
    std::string field;                 ///< "ERRID", "RES"; empty on TS600
    Kind kind = Kind::Code;
    std::uint32_t code = 0;            ///< or the bit number
    Level level = Level::Unspecified;
    std::string category;              ///< TS600: "Fieldbus / CAN-related / CANopen"
    std::string instruction;           ///< TS600: the motion instruction the manual ties it to
    Text text, cause, remedy;          ///< cause and remedy may be empty
    bool fromManual = true;            ///< false: ours where the manual is silent
    std::string sources;
};

/// A row of the main-code classification of the TS600.
struct ErrorCategory {
    std::uint16_t first = 0, last = 0; ///< main codes
    bool reserved = false;
    std::string device, type;          ///< English
    Text module;
};

struct AxisState {
    int number = 0;
    std::string id;                    ///< "Discrete_Motion", as the manual spells it
    Text name;
    std::string sources;
};

/// How strictly an address is read.
enum class AddressMode : std::uint8_t {
    Program, ///< as the controller's own language wants it: Kinco addresses begin with %
    Typed,   ///< as people type it into a table: a missing % is forgiven, case too
};

class AddressSyntax;
struct FamilyData;

/// A controller family: everything that differs between vendors and is data. Immutable and shared by all threads.
class Family {
public:
    explicit Family(std::unique_ptr<const FamilyData> data);
    ~Family();
    Family(const Family&) = delete;
    Family& operator=(const Family&) = delete;

    const std::string& id() const;             ///< "kinco", "invt"
    const std::string& displayName() const;    ///< "Kinco KS"
    std::span<const ControllerModel> models() const;
    const ControllerModel* findModel(std::string_view name) const; ///< exact name; null if unknown
    const ControllerModel& defaultModel() const;

    std::span<const MemoryArea> areas() const; ///< index is the AreaId
    const MemoryArea& area(AreaId id) const;
    const MemoryArea* findArea(std::string_view name) const; ///< of two with one name (T, C) the bits

    /// Reads an address as the family writes it. The error says what is wrong and what is legal; its place has the columns
    /// within `text` (line 1).
    Result<Address> parseAddress(std::string_view text, const ControllerModel& model, AddressMode mode = AddressMode::Program) const;
    /// The one canonical text: "%VW304", "D100", "X17", "T5" (bit and value of a timer alike).
    std::string formatAddress(const Address& address) const;
    /// The same place taken as another type: %VW304 as WORD, D100 as REAL, T5 as INT. An error where it cannot be.
    Result<Address> withType(const Address& address, DataType type, const ControllerModel& model) const;
    /// Value of the timer or counter whose bit `address` is; nothing for other places.
    std::optional<Address> valueOf(const Address& address) const;
    /// Bit of the timer or counter whose value `address` is.
    std::optional<Address> bitOf(const Address& address) const;
    /// Number as people count it: 304 for %VW304, 100 for D100, 15 for X17 (octal), 5 for T5.
    std::uint32_t elementNumber(const Address& address) const;
    /// What a place is for: of a system flag its own meaning, else that of its area. For tool tips.
    const Text& meaningOf(const Address& address) const;
    /// Whether the user's program may write the place: not an input, not a system flag that only the controller sets.
    bool isWritable(const Address& address) const;
    /// Whether a row of `bytes` bytes from the start of `address` lies inside its area.
    bool blockFits(const Address& address, std::uint64_t bytes, const ControllerModel& model) const;

    Time timerBase(std::uint32_t timer) const; ///< resolution of a timer element
    bool counterIs32Bit(std::uint32_t counter) const;
    /// What a free-running scan lasts in the simulation (CONTRACTS 10).
    Time modelledScanTime() const;

    const Catalogue& catalogue() const;
    std::span<const DriveParameter> driveParameters() const; ///< index is the number; empty on TS600
    std::span<const AxisState> axisStates() const;
    const AxisState* findAxisState(int number) const;

    std::span<const ErrorText> errors() const;
    std::span<const ErrorCategory> errorCategories() const;
    const ErrorText* findError(std::string_view scope, std::uint32_t code) const;
    /// A sentence for a code; for bit masks one sentence a set bit. Empty if the code is not known.
    std::string errorText(std::string_view scope, std::uint32_t code, TextLanguage language) const;

private:
    std::unique_ptr<const FamilyData> m_data;
};

const Family* findFamily(std::string_view id); ///< null if unknown
std::span<const Family* const> families();     ///< in a fixed order

} // namespace camwright
