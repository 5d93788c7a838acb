#pragma once

#include "core/model/project.h"

namespace camwright {

inline ObjectKey key(ObjectKind kind, const char* name) { return {kind, name}; }

/// A project whose every field differs from its default, with a value that is no legal one in each place that can hold it.
inline Project sampleProject()
{
    Axis feed;
    feed.number = 3;
    feed.type = AxisType::Rotary;
    feed.encoderResolution = 65536;
    feed.mechanicalEquivalent = 0.1;
    feed.guardTimeMs = 200;
    feed.lifeFactor = 4;
    feed.inhibitTimeMs = 11;
    feed.eventTimerMs = 12;
    feed.simulation = {1.5, -2.25, 1e300, -0.0625, 3.0};
    feed.comment = "von links, \"schnell\"\nзвено 进给 \\ *)";
    Axis odd;
    odd.number = Field<std::int64_t>::typed("three");
    odd.type = Field<AxisType>::typed("diagonal");
    odd.mechanicalEquivalent = Field<double>::typed("1,0 mm");
    odd.simulation.homeSwitch = Field<double>::typed("");

    Variable start{"Start", DataType::Bool, "%M0.0", "TRUE", false, "begins \\n the cycle // now"};
    Variable speed{"Скорость", DataType::Real, "%VR100", "6000.0", true, ""};
    Variable hostile{"END_VAR", Field<DataType>::typed("STRING[3]"), "no address; (*", "\"a;b\" // c", true, " *) \"x\" \n y "};
    Variable nameless{"", Field<DataType>::typed("BOOL"), "", "", false, ""};
    WatchTable watch{{{"axis.\"Axis 1 name\".position", "", {}}, {"%VD6", "hex", {{"width", "12"}}}}};

    Project out;
    out = out.with(projectKey(), std::make_shared<const Object>(
        Object{projectKey(), 0, ProjectSettings{"Presse 3", "für Halle 2"}, {{"vendor.tool", "\"x\""}, {"zz", "[1, 2]"}}}));
    out = out.withContent(controllerKey(), ControllerSettings{"kinco", "KS105C1-16DT", 2000, Field<std::int64_t>::typed("half a second"), "cabinet 4", true});
    out = out.withContent(key(ObjectKind::Axis, "Feed"), feed).withContent(key(ObjectKind::Axis, "feed"), odd);
    out = out.withContent(key(ObjectKind::Network, "CANopen"), Network{500000, 250});
    out = out.withContent(key(ObjectKind::Program, "Main"), Program{ProgramRole::Main, ProgramLanguage::InstructionList, "(* Network 0 *)\nLD %SM0.0\n"});
    out = out.withContent(key(ObjectKind::Program, "Подпрограмма"), Program{ProgramRole::Subroutine, ProgramLanguage::InstructionList, "no newline at the end"});
    out = out.withContent(key(ObjectKind::Program, "INT_0"), Program{ProgramRole::Interrupt, ProgramLanguage::InstructionList, ""});
    out = out.withContent(key(ObjectKind::VariableTable, "Globals"), VariableTable::of({start, speed, hostile, nameless}));
    out = out.withContent(key(ObjectKind::VariableTable, "Empty"), VariableTable{});
    return out.withContent(key(ObjectKind::WatchTable, "Watch"), watch).withContent(key(ObjectKind::WatchTable, "None"), WatchTable{});
}

} // namespace camwright
