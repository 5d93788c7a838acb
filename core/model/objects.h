#pragma once

#include "core/base/datatype.h"
#include "core/base/place.h"
#include "core/model/field.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <variant>
#include <vector>

namespace camwright {

/// Keys a reader did not know: dotted path as TOML writes it, and the value's canonical text. Kept so that a newer tool's
/// file survives an older one.
using UnknownKeys = std::map<std::string, std::string>;

/// What the project says of itself. Its key is `projectKey()`.
struct ProjectSettings {
    std::string name;
    std::string comment;

    bool operator==(const ProjectSettings&) const = default;
};

/// Which controller the project is for, and how its program is run.
struct ControllerSettings {
    std::string family;                    ///< "kinco", "invt"
    std::string model;                     ///< "KS101M-04DX", "TS635"
    Field<std::int64_t> scanPeriodUs{0};   ///< 0: free-running
    Field<std::int64_t> watchdogMs{500};
    std::string comment;
    Field<bool> strictKinco{false};        ///< Kinco: refuse AND( and OR(, which the vendor's tool is not known to take (CONTRACTS 32)

    bool operator==(const ControllerSettings&) const = default;
};

enum class AxisType : std::uint8_t { Linear, Rotary };

/// The plant behind an axis on the virtual controller. User units: mm or degree; nothing of it reaches a real machine.
struct AxisSimulation {
    Field<double> homeSwitch{0.0};         ///< position of the home switch
    Field<double> lowerLimitSwitch{-1e6};
    Field<double> upperLimitSwitch{1e6};
    Field<double> startPosition{0.0};
    Field<double> inertiaRatio{1.0};       ///< load to motor; larger lags more

    bool operator==(const AxisSimulation&) const = default;
};

/// An axis of the Kinco motion network: every field of KS-MCN.
struct Axis {
    Field<std::int64_t> number{1};                  ///< CANopen address, contiguous from 1 (KS-MCN-06)
    Field<AxisType> type{AxisType::Linear};
    Field<std::int64_t> encoderResolution{10000};   ///< pulses per motor turn
    Field<double> mechanicalEquivalent{1.0};        ///< mm or degree per motor turn
    Field<std::int64_t> guardTimeMs{1000};
    Field<std::int64_t> lifeFactor{3};
    Field<std::int64_t> inhibitTimeMs{10};
    Field<std::int64_t> eventTimerMs{0};
    AxisSimulation simulation;
    std::string comment;

    bool operator==(const Axis&) const = default;
};

/// The CANopen motion network: the master's fields of KS-MCN.
struct Network {
    Field<std::int64_t> baudrate{1000000};          ///< bit/s
    Field<std::int64_t> sdoTimeoutMs{100};

    bool operator==(const Network&) const = default;
};

enum class ProgramRole : std::uint8_t { Main, Subroutine, Interrupt };
enum class ProgramLanguage : std::uint8_t { InstructionList, StructuredText };

/// A program organisation unit, kept as its source text.
struct Program {
    ProgramRole role = ProgramRole::Main;
    ProgramLanguage language = ProgramLanguage::InstructionList;
    std::string source;                             ///< UTF-8, lines ended by \n

    bool operator==(const Program&) const = default;
};

/// One variable. `address` may be empty where the family allows unbound variables.
struct Variable {
    std::string name;
    Field<DataType> type{DataType::Bool};
    std::string address;                            ///< "%M0.0", "D100"
    std::string initial;                            ///< as typed, empty for the type's default
    bool retain = false;
    std::string comment;

    bool operator==(const Variable&) const = default;
};

/// A table of global variables. Large tables share unchanged chunks between snapshots. No chunk is empty; where rows are
/// cut into chunks means nothing and does not count in comparisons.
struct VariableTable {
    using Chunk = std::shared_ptr<const std::vector<Variable>>;
    std::vector<Chunk> chunks;

    static VariableTable of(const std::vector<Variable>& rows);

    std::size_t rowCount() const;
    const Variable& row(std::size_t index) const; ///< index < rowCount()
    std::vector<Variable> rows() const;           ///< all, copied
    /// Rows [first, first + removed) replaced by `inserted`; chunks that no changed row lies in are shared.
    VariableTable replaced(std::size_t first, std::size_t removed, const std::vector<Variable>& inserted) const;

    bool operator==(const VariableTable&) const;
};

struct WatchRow {
    std::string expression;                         ///< address, variable or axis value
    std::string format;                             ///< "", "hex", "bin", "oct"
    UnknownKeys unknown{};

    bool operator==(const WatchRow&) const = default;
};

struct WatchTable {
    std::vector<WatchRow> rows;
    bool operator==(const WatchTable&) const = default;
};

using ObjectContent = std::variant<ControllerSettings, Axis, Network, Program, VariableTable, WatchTable, ProjectSettings>;

/// The kind whose objects hold this content.
ObjectKind kindOf(const ObjectContent& content);

/// What has a file of its own: identity, order in its list, content.
struct Object {
    ObjectKey key;
    std::int64_t order = 0;
    ObjectContent content;
    UnknownKeys unknown;

    bool operator==(const Object&) const = default;
};

using ObjectPtr = std::shared_ptr<const Object>;

} // namespace camwright
