#pragma once

#include "core/language/check/context.h"

#include <string>
#include <vector>

namespace camwright::test {

struct NamedProgram {
    std::string name, source;
    ProgramRole role = ProgramRole::Subroutine;
};

inline Variable row(const std::string& name, DataType type, const std::string& address)
{
    Variable out;
    out.name = name;
    out.type = type;
    out.address = address;
    return out;
}

/// A project with the program Main, axes Feed and Turn, and what else is given.
inline Project assistProject(const std::string& family, const std::string& main, const std::vector<Variable>& variables = {},
    const std::vector<NamedProgram>& others = {})
{
    ControllerSettings controller;
    controller.family = family;
    controller.model = family == "kinco" ? "KS101M-04DX" : std::string(findFamily(family)->defaultModel().name);
    Project out = Project().withContent(controllerKey(), controller);
    for (const std::int64_t number : {1, 2}) {
        Axis axis;
        axis.number = number;
        out = out.withContent({ObjectKind::Axis, number == 1 ? "Feed" : "Turn"}, axis);
    }
    out = out.withContent({ObjectKind::Program, "Main"}, Program{ProgramRole::Main, {}, main});
    for (const NamedProgram& other : others)
        out = out.withContent({ObjectKind::Program, other.name}, Program{other.role, {}, other.source});
    if (!variables.empty())
        out = out.withContent({ObjectKind::VariableTable, "Globals"}, VariableTable::of(variables));
    return out;
}

inline Project strictProject(const std::string& main)
{
    Project out = assistProject("kinco", main);
    ControllerSettings controller = out.controller();
    controller.strictKinco = true;
    return out.withContent(controllerKey(), controller);
}

} // namespace camwright::test
