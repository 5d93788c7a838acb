#pragma once

#include "core/model/project.h"

namespace camwright {

inline Object sampleObject(ObjectKind kind, const char* name, std::int64_t order, ObjectContent content)
{
    return {ObjectKey{kind, name}, order, std::move(content), {}};
}

/// Two axes, a network, a main program, variables and a watch list.
inline Project sampleProject()
{
    Project out;
    const auto add = [&out](Object object) {
        const ObjectKey key = object.key;
        out = out.with(key, std::make_shared<const Object>(std::move(object)));
    };
    out = out.withName("sample");
    ControllerSettings controller;
    controller.family = "kinco";
    controller.model = "KS101M-04DX";
    out = out.withContent(controllerKey(), controller);
    Axis feed;
    feed.mechanicalEquivalent = 100.0;
    Axis turn;
    turn.number = 2;
    turn.type = AxisType::Rotary;
    turn.mechanicalEquivalent = 45.0;
    add(sampleObject(ObjectKind::Axis, "Feed", 1, feed));
    add(sampleObject(ObjectKind::Axis, "Turn", 2, turn));
    add(sampleObject(ObjectKind::Network, "CANopen", 1, Network{}));
    add(sampleObject(ObjectKind::Program, "Main", 1, Program{ProgramRole::Main, ProgramLanguage::InstructionList, "LD %I0.0\nST %M0.0\n"}));
    add(sampleObject(ObjectKind::VariableTable, "Globals", 1, VariableTable::of({{"Start", DataType::Bool, "%I0.0", "", false, "Start button"},
        {"Run", DataType::Bool, "%M0.0", "", false, ""}})));
    add(sampleObject(ObjectKind::WatchTable, "Feed move", 1, WatchTable{{{"axis.Feed.position", "", {}}}}));
    return out;
}

} // namespace camwright
