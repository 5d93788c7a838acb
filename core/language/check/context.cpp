#include "core/language/check/context.h"

#include "core/language/source/koyodialect.h"
#include "core/model/arraytype.h"

#include <algorithm>

namespace camwright {

namespace {

std::uint64_t placeOf(const Address& address)
{
    return std::uint64_t{address.byte} * 8 + (address.isBit ? address.bit : 0);
}

/// Kinco's manual knows symbols for addresses only; TS600 variables may live without one (TS-VAR-04).
bool hasUnboundVariables(const Family& family)
{
    return family.id() == "invt";
}

Address allocate(LanguageContext& context, DataType type, std::uint32_t elements)
{
    std::uint32_t& end = context.variableBytes;
    const std::uint32_t width = byteWidth(type);
    if (width > 1)
        end += end % 2;
    const Address out = type == DataType::Bool ? bitAddress(VariablesArea, end) : valueAddress(VariablesArea, end, type);
    end += width * elements;
    return out;
}

void addVariable(LanguageContext& context, const Variable& variable, Place place)
{
    const auto array = hasUnboundVariables(*context.family) ? arrayTypeOf(variable.type) : std::nullopt;
    if (variable.name.empty() || (!variable.type.isValid() && !array))
        return;
    const DataType type = array ? array->element : variable.type.value();
    KnownVariable out{variable.name, type, std::nullopt, !variable.address.empty(), variable.retain, array ? array->length : 0, std::move(place)};
    if (out.isBound) {
        if (const auto address = context.family->parseAddress(variable.address, *context.model, AddressMode::Typed))
            if (const auto typed = context.family->withType(*address, out.type, *context.model))
                out.address = *typed;
    } else if (hasUnboundVariables(*context.family)) {
        out.address = allocate(context, out.type, std::max(out.elements, 1u));
    }
    context.variables.push_back(std::move(out));
}

void addVariables(LanguageContext& context, const Project& project)
{
    for (const ObjectPtr& object : project.objects(ObjectKind::VariableTable)) {
        const auto* table = std::get_if<VariableTable>(&object->content);
        std::size_t row = 0;
        if (!table)
            continue;
        for (const auto& chunk : table->chunks)
            for (const Variable& variable : *chunk)
                addVariable(context, variable, Place{object->key, "rows[" + std::to_string(row++) + "]", {}, {}});
    }
}

constexpr std::uint32_t MaximumLocals = 16; // of each kind, TS-SBR-02

PinDirection directionOf(ParameterKind kind)
{
    if (kind == ParameterKind::Out)
        return PinDirection::Out;
    return kind == ParameterKind::InOut ? PinDirection::InOut : PinDirection::In;
}

Pin pinOf(const Parameter& parameter, const Pin& arguments)
{
    Pin out = arguments;
    out.name = parameter.name;
    out.kind = PinKind::Value;
    out.direction = directionOf(parameter.kind);
    out.types = TypeSet{parameter.type};
    out.mainType = parameter.type;
    out.constantAllowed = parameter.kind == ParameterKind::In;
    out.optional = false;
    return out;
}

} // namespace

ParameterTable layOut(const Declarations& declarations, const Family& family, const ControllerModel& model)
{
    ParameterTable out;
    const Instruction* call = family.catalogue().find("CALL");
    const Pin* arguments = call ? call->findPin("ARGUMENTS") : nullptr;
    std::uint32_t bits = 0, words = 0, bitCount = 0, wordCount = 0;
    for (const Parameter& parameter : declarations.parameters) {
        const bool isBit = parameter.type == DataType::Bool;
        if (++(isBit ? bitCount : wordCount) > MaximumLocals || !arguments) {
            out.tooMany = out.tooMany ? out.tooMany : parameter;
            continue;
        }
        const std::string place = isBit ? "LM" + std::to_string(bits) : "V" + std::to_string(words);
        if (isBit)
            ++bits;
        else
            words += byteWidth(parameter.type) / 2;
        const auto address = family.parseAddress(place, model);
        const auto typed = address ? family.withType(*address, parameter.type, model) : address;
        if (typed)
            out.parameters.push_back({{parameter.name, parameter.type, *typed, true, false, 0, {}}, parameter.kind, pinOf(parameter, *arguments)});
    }
    return out;
}

const KnownVariable* LanguageContext::findVariable(std::string_view name) const
{
    const auto found = m_byName.find(name);
    return found == m_byName.end() ? nullptr : &variables[found->second];
}

const KnownVariable* LanguageContext::variableAt(const Address& address) const
{
    const auto found = m_byPlace.find({address.area, placeOf(address)});
    if (found == m_byPlace.end())
        return nullptr;
    const KnownVariable& variable = variables[found->second];
    const bool same = variable.address->isBit == address.isBit && byteWidth(variable.type) == byteWidth(address.type);
    return same ? &variable : nullptr;
}

const KnownProgram* LanguageContext::findProgram(std::string_view name) const
{
    for (const KnownProgram& program : programs)
        if (program.name == name)
            return &program;
    return nullptr;
}

const KnownProgram* LanguageContext::findSubroutine(std::string_view number) const
{
    for (const KnownProgram& program : programs)
        if (!program.number.empty() && program.number == number)
            return &program;
    return nullptr;
}

const KnownAxis* LanguageContext::findAxis(std::uint32_t number) const
{
    for (const KnownAxis& axis : axes)
        if (axis.number == number)
            return &axis;
    return nullptr;
}

const KnownAxis* LanguageContext::findAxis(std::string_view name) const
{
    for (const KnownAxis& axis : axes)
        if (axis.name == name)
            return &axis;
    return nullptr;
}

void LanguageContext::index()
{
    m_byName.clear();
    m_byPlace.clear();
    for (std::size_t i = 0; i < variables.size(); ++i) {
        m_byName.emplace(variables[i].name, i);
        if (const auto& address = variables[i].address; address && variables[i].isBound && variables[i].elements == 0)
            m_byPlace.emplace(std::pair(address->area, placeOf(*address)), i);
    }
}

std::optional<LanguageContext> contextOf(const Project& project)
{
    LanguageContext out;
    out.family = findFamily(project.controller().family);
    out.model = out.family ? out.family->findModel(project.controller().model) : nullptr;
    out.dialect = dialectOfFamily(project.controller().family);
    if (!out.model || !out.dialect)
        return std::nullopt;
    out.strictKinco = out.dialect->id == DialectId::KincoIl && project.controller().strictKinco.valueOr(false);
    for (const ObjectPtr& object : project.objects(ObjectKind::Axis)) {
        const auto* axis = std::get_if<Axis>(&object->content);
        if (axis && axis->number.isValid() && axis->number.value() > 0)
            out.axes.push_back({object->key.name, static_cast<std::uint32_t>(axis->number.value())});
    }
    for (const ObjectPtr& object : project.objects(ObjectKind::Program))
        if (const auto* program = std::get_if<Program>(&object->content))
            out.programs.push_back({object->key.name, program->role,
                out.dialect->id == DialectId::KoyoIl && program->role == ProgramRole::Subroutine ? subroutineNumber(program->source) : std::string(),
                program->language == ProgramLanguage::InstructionList
                    ? layOut(declarationsOf(*out.dialect, program->source), *out.family, *out.model).parameters
                    : std::vector<KnownParameter>()});
    addVariables(out, project);
    out.index();
    return out;
}

} // namespace camwright
