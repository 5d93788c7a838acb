#pragma once

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/base/value.h"
#include "core/online/controllerlink.h"
#include "core/runtime/valueref.h"

#include <cstdint>
#include <variant>

namespace camwright {

/// Everything that can enter the engine (CONTRACTS 11). Replaying the same inputs at the same cycles from the same saved
/// state gives the same bytes.
namespace input {

struct Run {
    bool operator==(const Run&) const = default;
};
/// The program stops at once, outputs take their STOP values, then every axis is stopped and after that released.
struct Stop {
    bool operator==(const Stop&) const = default;
};
/// The RUN/STOP switch of the virtual front panel (KS-CPU-06); RUN at the start.
struct RunSwitch {
    bool run = true;
    bool operator==(const RunSwitch&) const = default;
};
/// Writes memory once, at the start of the next scan (at once in STOP). For an input of the virtual controller: sets its
/// terminal, which stays until set again (CONTRACTS 23).
struct Write {
    ValueRef target;
    Value value;
    bool operator==(const Write&) const = default;
};
/// Holds a memory value at the start and at the end of every scan until released.
struct Force {
    ValueRef target;
    Value value;
    bool operator==(const Force&) const = default;
};
struct Release {
    ValueRef target;
    bool operator==(const Release&) const = default;
};
struct ReleaseAll {
    bool operator==(const ReleaseAll&) const = default;
};
/// A panel's command to one axis; units as in AxisCommand. Stop is always accepted; the others but Arm, Disarm, Enable,
/// Disable and Reset need the axis armed.
struct Panel {
    std::uint16_t axis = 0;   ///< index into ControllerStatus::axes
    AxisCommandKind kind = AxisCommandKind::Stop;
    double position = 0;
    double velocity = 0;
    double acceleration = 0;
    bool operator==(const Panel&) const = default;
};
/// The dead-man's beat for every armed axis (CONTRACTS 19).
struct Heartbeat {
    std::uint64_t seenCycle = 0; ///< newest controller cycle the sender has seen
    bool operator==(const Heartbeat&) const = default;
};
/// Stops every axis now, whoever moves it. Power stays on. Accepted from anyone at any time.
struct StopAllAxes {
    bool operator==(const StopAllAxes&) const = default;
};
/// Verifies and takes an image; only in STOP. If axes are still enabled they are stopped and released first and the switch
/// happens after that. Forces are dropped, retained data whose key did not change is kept.
struct LoadImage {
    Bytes image;
    bool operator==(const LoadImage&) const = default;
};
/// Supply off and on: retained data, terminals, the switch and the last RUN/STOP command stay, forces are dropped.
struct PowerCycle {
    bool operator==(const PowerCycle&) const = default;
};
/// Faults that can be put into a simulated drive.
enum class InjectedFault : std::uint8_t { None = 0, NodeLoss = 1, DriveAlarm = 2 };
struct InjectFault {
    std::uint16_t axis = 0;
    InjectedFault fault = InjectedFault::None;
    bool operator==(const InjectFault&) const = default;
};

} // namespace input

using EngineInputContent = std::variant<input::Run, input::Stop, input::RunSwitch, input::Write, input::Force, input::Release,
    input::ReleaseAll, input::Panel, input::Heartbeat, input::StopAllAxes, input::LoadImage, input::PowerCycle, input::InjectFault>;

/// One input and the motion cycle before whose work it takes effect. Inputs of one cycle take effect in the order posted.
struct EngineInput {
    std::uint64_t cycle = 0; ///< 0, or not after the present one: the next cycle
    EngineInputContent content;
    bool operator==(const EngineInput&) const = default;
};

void write(ByteWriter& writer, const EngineInput& input);
/// Sets the reader's failure state on bytes that are no input.
EngineInput readEngineInput(ByteReader& reader);

} // namespace camwright
