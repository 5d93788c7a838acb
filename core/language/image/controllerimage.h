#pragma once

#include "core/base/bytes.h"
#include "core/base/hash.h"
#include "core/base/place.h"
#include "core/base/time.h"
#include "core/base/value.h"
#include "core/family/address.h"
#include "core/language/ir/ir.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace camwright {

/// What an image was built for. A controller refuses an image for another family, model or catalogue.
struct ImageTarget {
    std::string family;             ///< "kinco"
    std::string model;              ///< "KS101M-04DX"
    Hash catalogue;

    bool operator==(const ImageTarget&) const = default;
};

/// One memory area of the family, or VariablesArea.
struct ImageArea {
    AreaId id = 0;
    std::string name;               ///< "V"; of VariablesArea empty
    std::uint32_t bytes = 0;
    std::uint32_t retainedFrom = 0; ///< bytes [retainedFrom, retainedTo) survive power-off
    std::uint32_t retainedTo = 0;

    bool operator==(const ImageArea&) const = default;
};

struct InitialValue {
    Address address;
    Value value;

    bool operator==(const InitialValue&) const = default;
};

struct MemoryLayout {
    std::vector<ImageArea> areas;                     ///< by id, each at most once; areas of zero bytes may be left out
    std::vector<InitialValue> initialValues;          ///< written at power-on and after a download, retained data first kept
    std::optional<Address> instructionErrorFlag;      ///< BOOL set by a failed instruction (TS600: SM22), cleared each scan

    bool operator==(const MemoryLayout&) const = default;
};

/// An axis of the motion network with everything the master and the simulated drive need. Units: mm or degree.
struct AxisConfiguration {
    std::string name;
    std::uint8_t number = 1;        ///< CANopen node, 1 … 127
    bool rotary = false;
    std::uint32_t encoderResolution = 10000; ///< counts per motor turn
    double mechanicalEquivalent = 1.0;       ///< mm or degree per motor turn
    std::uint16_t guardTimeMs = 1000;
    std::uint8_t lifeFactor = 3;
    std::uint16_t inhibitTimeMs = 10;
    std::uint16_t eventTimerMs = 0;
    double homeSwitch = 0.0;        ///< simulated plant: positions of the switches, start, load to motor inertia
    double lowerLimitSwitch = -1e6;
    double upperLimitSwitch = 1e6;
    double startPosition = 0.0;
    double inertiaRatio = 1.0;

    bool operator==(const AxisConfiguration&) const = default;
};

struct NetworkConfiguration {
    bool present = false;           ///< false: no CANopen motion network
    std::uint32_t baudrate = 1000000;
    std::uint32_t sdoTimeoutMs = 100;

    bool operator==(const NetworkConfiguration&) const = default;
};

/// What starts an interrupt routine.
enum class InterruptCause : std::uint8_t { Timed = 0, Rising = 1, Falling = 2 };

/// The event of an interrupt routine that the project gives it (TS-INT-01). Kinco programs attach theirs while they run.
struct InterruptSource {
    std::uint32_t routine = 0;      ///< index into the program's routines
    InterruptCause cause = InterruptCause::Timed;
    Address input;                  ///< Rising, Falling: a bit
    Time period{};                  ///< Timed

    bool operator==(const InterruptSource&) const = default;
};

struct Configuration {
    Time scanPeriod{};              ///< zero: free-running
    Time watchdog{};
    NetworkConfiguration network;
    std::vector<AxisConfiguration> axes; ///< by number
    std::vector<InterruptSource> interrupts{};

    bool operator==(const Configuration&) const = default;
};

/// A variable by name. Unbound variables lie in VariablesArea.
struct Symbol {
    std::string name;
    Address address;
    bool retain = false;

    bool operator==(const Symbol&) const = default;
};

/// Where instructions come from: an object of the project and a stretch of its text.
struct SourcePlace {
    std::uint32_t object = 0;       ///< index into DebugMap::objects
    std::uint32_t rung = 0;         ///< network of the program, from 0
    TextRange range;

    bool operator==(const SourcePlace&) const = default;
};

/// Instructions to source; not part of the program's hash.
struct DebugMap {
    std::string projectName;
    std::vector<ObjectKey> objects;
    std::vector<SourcePlace> sources; ///< what IrInstruction::source points to

    bool operator==(const DebugMap&) const = default;
};

/// One file of the project the image was built from; not part of the program's hash.
struct ArchivedFile {
    std::string path;
    std::string text;

    bool operator==(const ArchivedFile&) const = default;
};

/// What is downloaded and run (CONTRACTS 7). A value: compile() makes one, write() and readImage() carry it as bytes.
struct ControllerImage {
    ImageTarget target;
    IrProgram program;
    MemoryLayout layout;
    Configuration configuration;
    std::vector<Symbol> symbols;    ///< by name
    DebugMap debug;
    std::vector<ArchivedFile> source;

    bool operator==(const ControllerImage&) const = default;
};

/// The container: magic, version, sections, each with its hash (docs/image.md). The same image gives the same bytes.
Bytes write(const ControllerImage& image);

/// Reads and verifies everything: hashes, operations, registers, jump targets, addresses inside their areas, calls without
/// cycles. Any bytes give an image that is safe to run, or the reason why not (CW40xx).
Result<ControllerImage> readImage(ByteSpan bytes);

/// What readImage checks of an image's meaning; for images that did not come from bytes.
Result<void> verify(const ControllerImage& image);

/// Names what runs: all sections but debug map and source. Two projects that differ only in comments share it.
Hash programHash(const ControllerImage& image);

/// Null if the image has no variable of that name; upper and lower case are told apart.
const Symbol* findSymbol(const ControllerImage& image, std::string_view name);

/// The place in the project an instruction comes from; an empty place if the debug map does not know it.
Place sourceOf(const ControllerImage& image, std::uint32_t routine, std::uint32_t instruction);

} // namespace camwright
