#pragma once

#include "core/base/bytes.h"
#include "core/base/hash.h"
#include "core/base/result.h"
#include "core/base/time.h"
#include "core/base/value.h"
#include "core/online/sampleblock.h"

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace camwright {

enum class RequestId : std::uint64_t {};
enum class SubscriptionId : std::uint32_t {};

/// What a link can do; views show only what works (DESIGN, "Going online").
struct LinkCapabilities {
    bool download = false, runStop = false, write = false, force = false, trace = false, motion = false, terminals = false;
    bool simulated = false;           ///< a virtual controller: the strip is blue
    std::string whyNoMotion;          ///< English reason where motion is false
    bool operator==(const LinkCapabilities&) const = default;
};

enum class RunState : std::uint8_t { Stop, Run, Error };
enum class ControlHolder : std::uint8_t { Nobody, You, Somebody };

/// One axis as the controller knows it in the cycle of the status.
struct AxisStatus {
    std::string name;
    int number = 0;
    int state = 0;                    ///< the family's state number (KS-MC-26)
    std::string stateName;            ///< "Standstill"
    std::uint32_t error = 0;          ///< the family's code, 0 none
    bool enabled = false, homed = false, moving = false, online = false, panelArmed = false;
    bool lowerLimit = false, upperLimit = false, homeSwitch = false;
    double position = 0, setPosition = 0, velocity = 0, followingError = 0, torque = 0; ///< user units, per second; torque in %
    std::string unit;                 ///< "mm", "°"
    std::string lastCause;            ///< English: why the state last changed
    Time lastChange{};
    bool operator==(const AxisStatus&) const = default;
};

/// Pushed several times a second while connected.
struct ControllerStatus {
    std::uint64_t cycle = 0;          ///< newest motion cycle
    Time time{};                      ///< controller time
    RunState state = RunState::Stop;
    std::string family, model, projectName;
    Hash program;                     ///< null: no program
    double scanMs = 0, scanMaxMs = 0;
    double busLoadPercent = 0;
    std::uint32_t forces = 0;
    std::uint64_t lateCycles = 0;
    ControlHolder control = ControlHolder::Nobody;
    std::string controlOwner;         ///< who holds it, as they named themselves
    std::vector<AxisStatus> axes;
    bool operator==(const ControllerStatus&) const = default;
};

struct LogEntry {
    std::uint64_t sequence = 0;
    std::uint64_t cycle = 0;
    Time time{};
    Diagnostic message;
    bool operator==(const LogEntry&) const = default;
};

/// A program ready to be sent: the image's bytes and the hash of what runs.
struct DownloadPackage {
    Bytes image;
    Hash program;
};

struct PlanLine {
    std::string what;                 ///< "program Main", "axis Feed", "retained %VB0"
    std::string effect;               ///< English sentence: "changes", "stops for 0.2 s", "loses its home"
    Diagnostic message;               ///< the same for other languages: code and arguments
    bool operator==(const PlanLine&) const = default;
};

/// What a download would change, stop and lose, told before the first byte moves.
struct DownloadPlan {
    bool sameProgram = false;
    bool mustStop = false;
    std::vector<PlanLine> lines;
    bool operator==(const DownloadPlan&) const = default;
};

enum class AxisCommandKind : std::uint8_t {
    Arm, Disarm, Enable, Disable, Reset, Home, MoveAbsolute, MoveRelative, Velocity, Jog, Stop
};

/// A command of the commissioning panel to one axis. Units: user units, velocity in user units per second.
/// Jog and Velocity run only while heartbeats arrive (CONTRACTS 19); Stop needs no lease and no arming.
struct AxisCommand {
    std::string axis;
    AxisCommandKind kind = AxisCommandKind::Stop;
    double position = 0;              ///< MoveAbsolute target, MoveRelative distance
    double velocity = 0;              ///< signed for Jog and Velocity
    double acceleration = 0;          ///< 0: the drive's own
    bool operator==(const AxisCommand&) const = default;
};

enum class TriggerKind : std::uint8_t { Immediate, RisingEdge, FallingEdge, Above, Below };

struct TraceSetup {
    std::vector<std::string> channels; ///< "axis.Feed.position", "%VD1200", a variable
    std::uint32_t stride = 1;          ///< every n-th motion cycle
    TriggerKind trigger = TriggerKind::Immediate;
    std::string triggerChannel;
    double triggerLevel = 0;
    double preTrigger = 0.2;           ///< fraction of `samples` before the trigger
    std::uint32_t samples = 0;         ///< rows to record in all; 0: without end, live
    bool operator==(const TraceSetup&) const = default;
};

struct MonitoredValue {
    std::string name;
    Value value;
    bool forced = false;
    bool operator==(const MonitoredValue&) const = default;
};

/// Values of one subscription, all from the end of the same scan.
struct MonitorUpdate {
    SubscriptionId subscription{};
    std::uint64_t cycle = 0;
    std::vector<MonitoredValue> values;
};

/// An input or output of the virtual controller, for its panel.
struct TerminalInfo {
    std::string name;                 ///< "%I0.0", "Y2"
    bool isInput = false;
    bool operator==(const TerminalInfo&) const = default;
};

enum class LinkState : std::uint8_t { Offline, Connecting, Online, Lost };

/// What a view may know of a controller. Every call returns at once; its callback is called exactly once, with a result, an
/// error or a time-out, through the link's Executor, and never after cancel() or the link's destruction (CONTRACTS 15).
/// Writes, forces, run/stop, downloads and axis commands other than Stop need control.
class ControllerLink {
public:
    template <class T>
    using Reply = std::function<void(Result<T>)>;

    virtual ~ControllerLink() = default;

    virtual LinkState state() const = 0;
    virtual LinkCapabilities capabilities() const = 0;
    virtual std::string address() const = 0;
    virtual const ControllerStatus& status() const = 0;        ///< the newest one pushed

    virtual RequestId takeControl(Reply<void>) = 0;
    virtual RequestId releaseControl(Reply<void>) = 0;

    virtual RequestId planDownload(DownloadPackage, Reply<DownloadPlan>) = 0;
    /// Stages in pieces, verifies the hash, switches in STOP; `progress` 0 … 1. The controller stands in STOP afterwards.
    virtual RequestId download(DownloadPackage, std::function<void(double)> progress, Reply<void>) = 0;
    virtual RequestId run(Reply<void>) = 0;
    virtual RequestId stop(Reply<void>) = 0;

    /// Reads by name or address. A name the running program does not know is an error that names it.
    virtual RequestId read(std::vector<std::string> names, Reply<std::vector<MonitoredValue>>) = 0;
    virtual RequestId write(std::string name, Value value, Reply<void>) = 0;
    virtual RequestId force(std::string name, Value value, Reply<void>) = 0;
    virtual RequestId release(std::string name, Reply<void>) = 0; ///< empty name: all
    virtual RequestId forced(Reply<std::vector<MonitoredValue>>) = 0;
    /// The terminals of a virtual controller; an input is switched by write().
    virtual RequestId terminals(Reply<std::vector<TerminalInfo>>) = 0;
    /// What type a name has in the running program, so that typed text can be read.
    virtual RequestId describe(std::vector<std::string> names, Reply<std::vector<DataType>>) = 0;

    virtual SubscriptionId subscribe(std::vector<std::string> names, Time period, std::function<void(const MonitorUpdate&)>) = 0;
    virtual void unsubscribe(SubscriptionId) = 0;

    virtual RequestId startTrace(TraceSetup, std::function<void(const SampleBlock&)>, Reply<void>) = 0;
    virtual RequestId stopTrace(Reply<void>) = 0;

    virtual RequestId command(AxisCommand, Reply<void>) = 0;
    /// Stop all axes at once: ahead of everything queued, from anyone.
    virtual RequestId stopAllAxes(Reply<void>) = 0;
    /// The dead-man's beat while a panel is armed: to be called every 20 ms by whoever can be frozen or let go.
    virtual void heartbeat() = 0;

    virtual RequestId log(std::uint64_t fromSequence, Reply<std::vector<LogEntry>>) = 0;
    virtual void cancel(RequestId) = 0;

    /// Listeners; each returns a token for `forget`.
    virtual int onStateChanged(std::function<void(LinkState, const Diagnostic& why)>) = 0;
    virtual int onStatus(std::function<void(const ControllerStatus&)>) = 0;
    virtual int onLog(std::function<void(const LogEntry&)>) = 0;
    virtual void forget(int token) = 0;
};

} // namespace camwright
