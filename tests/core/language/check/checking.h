#pragma once

#include "core/language/check/checksources.h"
#include "tests/core/language/source/trees.h"

#include <memory>
#include <string>
#include <vector>

namespace camwright::test {

/// A project for the language: family, model, axes 1 and 2, some variables, the programs Main, Init and Tick.
inline LanguageContext contextFor(const std::string& family, const std::string& model, std::vector<Variable> variables = {})
{
    const auto object = [](ObjectKind kind, const std::string& name, ObjectContent content) {
        return std::make_shared<const Object>(Object{{kind, name}, 0, std::move(content), {}});
    };
    Project project;
    const auto add = [&](ObjectPtr made) { project = project.with(made->key, made); };
    ControllerSettings controller;
    controller.family = family;
    controller.model = model;
    add(object(controllerKey().kind, controllerKey().name, controller));
    for (const std::int64_t number : {1, 2}) {
        Axis axis;
        axis.number = number;
        add(object(ObjectKind::Axis, number == 1 ? "Feed" : "Turn", axis));
    }
    add(object(ObjectKind::Program, "Main", Program{ProgramRole::Main, {}, ""}));
    add(object(ObjectKind::Program, "Init", Program{ProgramRole::Subroutine, {}, ""}));
    add(object(ObjectKind::Program, "Tick", Program{ProgramRole::Interrupt, {}, ""}));
    VariableTable table;
    table.chunks.push_back(std::make_shared<const std::vector<Variable>>(std::move(variables)));
    add(object(ObjectKind::VariableTable, "Globals", table));
    return *contextOf(project);
}

inline Variable variable(const std::string& name, DataType type, const std::string& address)
{
    Variable out;
    out.name = name;
    out.type = type;
    out.address = address;
    return out;
}

inline const LanguageContext& ks101m()
{
    static const LanguageContext out = contextFor("kinco", "KS101M-04DX",
        {variable("Start", DataType::Bool, "%M0.0"), variable("Speed", DataType::Real, "%VR100"), variable("Count", DataType::Word, "%VW200")});
    return out;
}

inline const LanguageContext& ks105()
{
    static const LanguageContext out = contextFor("kinco", "KS105C2-16DT");
    return out;
}

inline const LanguageContext& ts635()
{
    static const LanguageContext out = contextFor("invt", std::string(findFamily("invt")->defaultModel().name),
        {variable("Lamp", DataType::Bool, ""), variable("Total", DataType::Dint, ""), variable("电机", DataType::Bool, "Y0")});
    return out;
}

inline CheckedSources check(const LanguageContext& context, const std::string& text)
{
    const ProgramSource source{{ObjectKind::Program, "Main"}, ProgramRole::Main, text};
    return checkSources({&source, 1}, context);
}

/// The operands of a checked statement: "%VB100:BYTE", "16#8:DINT" …
inline std::string show(const CheckedStatement& statement, const Family& family)
{
    std::string out = statement.instruction->mnemonic;
    for (const CheckedOperand& operand : statement.operands) {
        out += ' ';
        if (const auto* memory = std::get_if<AddressOperand>(&operand.value))
            out += (memory->address.area == VariablesArea ? memory->symbol + "@" + std::to_string(memory->address.byte) : family.formatAddress(memory->address))
                + ":" + std::string(name(memory->type));
        else if (const auto* constant = std::get_if<ConstantOperand>(&operand.value))
            out += formatValue(constant->value) + ":" + std::string(name(constant->value.type));
        else if (const auto* block = std::get_if<BlockOperand>(&operand.value))
            out += family.formatAddress(block->start) + "[" + (block->elements ? std::to_string(*block->elements) : "?") + "]:" + std::string(name(block->elementType));
        else if (const auto* program = std::get_if<ProgramOperand>(&operand.value))
            out += program->name;
        else
            out += '-';
    }
    return out;
}

} // namespace camwright::test
