#pragma once

#include "core/base/time.h"
#include "core/base/value.h"
#include "core/family/family.h"
#include "core/model/project.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace camwright {

/// An axis whose every field is a legal value. Positions in the axis's own unit: mm (linear) or degree (rotary).
struct ValidAxis {
    std::string name;
    std::uint8_t number = 1;              ///< CANopen address 1 … 127
    AxisType type = AxisType::Linear;
    std::int64_t encoderResolution = 1;   ///< pulses per motor turn, > 0
    double mechanicalEquivalent = 1;      ///< units per motor turn, > 0
    std::uint16_t guardTimeMs = 0;        ///< 0: no node guarding
    std::uint8_t lifeFactor = 0;
    std::uint16_t inhibitTimeMs = 0;      ///< at most 6553: the object counts 100 us in 16 bits
    std::uint16_t eventTimerMs = 0;
    double homeSwitch = 0;
    double lowerLimitSwitch = 0;          ///< below upperLimitSwitch
    double upperLimitSwitch = 0;
    double startPosition = 0;
    double inertiaRatio = 1;              ///< >= 0

    double pulsesPerUnit() const { return static_cast<double>(encoderResolution) / mechanicalEquivalent; }
};

struct ValidNetwork {
    std::string name;
    std::uint32_t baudrate = 0; ///< bit/s, one of offeredBaudrates()
    Time sdoTimeout{};
};

struct ValidProgram {
    ObjectKey key;
    ProgramRole role = ProgramRole::Main;
    ProgramLanguage language = ProgramLanguage::InstructionList;
    std::string_view source; ///< lives as long as the ValidProject or a copy of it

    const std::string& name() const { return key.name; }
};

struct ValidVariable {
    std::string name;
    DataType type = DataType::Bool;
    std::optional<Address> address;
    std::optional<Value> initial;
    bool retain = false;
    Place place;                  ///< of its row: table and "rows[n]"
};

/// A project that can be built: what compiler, engine and download take. Made only by validate() in checkproject.h; holds
/// the snapshot it was made from.
class ValidProject {
public:
    const Project& project() const { return m_project; }
    const std::string& name() const { return m_name; }
    const Family& family() const { return *m_family; }
    const ControllerModel& model() const { return *m_model; }
    Time scanPeriod() const { return m_scanPeriod; } ///< 0: free-running
    Time watchdog() const { return m_watchdog; }
    const std::vector<ValidAxis>& axes() const { return m_axes; }        ///< by number: axes()[n].number == n + 1
    const std::optional<ValidNetwork>& network() const { return m_network; } ///< set when there are axes
    const std::vector<ValidProgram>& programs() const { return m_programs; } ///< the main program first, then by order
    const ValidProgram& mainProgram() const { return m_programs.front(); }
    const std::vector<ValidVariable>& variables() const { return m_variables; } ///< all tables, by order and row

private:
    friend class ProjectCheck;
    ValidProject() = default;

    Project m_project;
    std::string m_name;
    const Family* m_family = nullptr;
    const ControllerModel* m_model = nullptr;
    Time m_scanPeriod{};
    Time m_watchdog{};
    std::vector<ValidAxis> m_axes;
    std::optional<ValidNetwork> m_network;
    std::vector<ValidProgram> m_programs;
    std::vector<ValidVariable> m_variables;
};

} // namespace camwright
