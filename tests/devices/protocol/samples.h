#pragma once

#include "core/online/messages.h"

#include <limits>

namespace camwright::samples {

inline Hash digest(std::uint8_t seed)
{
    Hash out;
    for (std::size_t i = 0; i < out.bytes.size(); ++i)
        out.bytes[i] = static_cast<std::uint8_t>(seed + i);
    return out;
}

inline Diagnostic reason()
{
    Diagnostic out = diagnostic(Code::ControlHeld, {"anna@desk", "50 %"});
    out.place = {{ObjectKind::Program, "Main"}, "source", {3, 1, 3, 9}, "programs/Main.il"};
    return out;
}

inline ControllerStatus status()
{
    AxisStatus axis;
    axis.name = "Feed";
    axis.number = 1;
    axis.state = -3;
    axis.stateName = "Standstill";
    axis.error = 0x8400;
    axis.enabled = axis.moving = axis.upperLimit = true;
    axis.position = -12.625;
    axis.torque = 1e-300;
    axis.unit = "°";
    axis.lastCause = "MC_POWER";
    axis.lastChange = 17ms;
    ControllerStatus out;
    out.cycle = std::numeric_limits<std::uint64_t>::max();
    out.time = -5ns;
    out.state = RunState::Run;
    out.family = "kinco";
    out.model = "KS101M-04DX";
    out.projectName = "进给";
    out.program = digest(1);
    out.scanMs = 1.5;
    out.forces = 3;
    out.control = ControlHolder::Somebody;
    out.controlOwner = "anna";
    out.axes = {axis, {}};
    return out;
}

inline SampleBlock block()
{
    SampleBlock out;
    out.channelSet = 4;
    out.sequence = 9;
    out.firstCycle = 1000;
    out.stride = 2;
    out.lostRows = 5;
    out.triggerCycle = 1001;
    out.last = true;
    out.channels = {{"axis.Feed.position", DataType::Lreal, "mm"}, {"%VD1200", DataType::Dint, ""}};
    out.columns = {{1.5, -2.5, std::numeric_limits<double>::infinity()}, {1, 2, 3}};
    return out;
}

/// One of each message, every field unlike its default.
inline std::vector<Message> all()
{
    using namespace message;
    const Value value = Value::ofReal(1.5f);
    return {
        Hello{2, 3, "camwright"},
        Welcome{2, 3, "camwright-runtime 0.1", Bytes(16, 7), {"none", "password"}, 2'000'000},
        Authenticate{"token"},
        Authenticated{Role::Engineer, {true, false, true, false, true, true, true, true, "none"}},
        Done{},
        Failed{reason()},
        Ping{},
        Pong{7, 8ms},
        Status{status()},
        TakeControl{}, RenewControl{}, ReleaseControl{},
        PlanDownload{{digest(2), "invt", "TS635", {{PartKind::Retained, "D100", digest(3)}}}, true},
        Plan{{true, true, {{"axis Feed", "changes", reason()}}}},
        BeginDownload{123456, digest(4), digest(5)},
        DownloadBegun{6}, Piece{6, 64, Bytes(100, 3)}, PieceTaken{6, 164}, CommitDownload{6}, AbortDownload{6},
        Run{}, Stop{}, Exit{},
        Read{digest(1), {"%M0.0", ""}},
        Values{5, {{1, value, true}}},
        Write{digest(1), "%VD0", Value::ofInteger(DataType::Dint, -1)},
        Force{digest(1), "%Q0.0", Value::ofBool(true)},
        Release{digest(1), "%Q0.0"},
        Describe{digest(1), {"a", "b"}},
        Types{{DataType::Bool, DataType::Lword}},
        Subscribe{digest(1), 3, {"x"}, 50ms},
        Subscribed{3, {0, 7}},
        Unsubscribe{3},
        Update{digest(1), 3, 77, {{0, value, false}, {1, Value::ofLreal(-0.0), true}}},
        ReadForces{},
        Forces{{{"%Q0.0", Value::ofBool(true), true}}},
        ReadTerminals{},
        Terminals{{{"%I0.0", true}}},
        StartTrace{digest(1), {{"axis.1.position"}, 3, TriggerKind::Below, "%M0.0", -0.5, 0.75, 1000}},
        StopTrace{},
        TraceBlock{block()},
        TraceBlockTaken{4, 9},
        Axis{{"Feed", AxisCommandKind::Jog, 1, -2, 3}},
        Heartbeat{99}, Beat{100}, StopAll{},
        ReadLog{12},
        LogEntries{{{12, 13, 14ms, reason()}}, true},
        Logged{{12, 13, 14ms, reason()}},
    };
}

} // namespace camwright::samples
