#include "core/language/check/operandtypes.h"

#include <algorithm>

namespace camwright {

MemoryTypes typesOf(const ResolvedMemory& memory, const LanguageContext& context)
{
    if (memory.variable)
        return {TypeSet{memory.variable->type}, nullptr};
    TypeSet out;
    for (unsigned i = static_cast<unsigned>(DataType::Bool); i <= static_cast<unsigned>(DataType::Lword); ++i) {
        const auto type = static_cast<DataType>(i);
        if (context.family->withType(memory.address, type, *context.model))
            out.insert(type);
    }
    if (const KnownVariable* variable = context.variableAt(memory.address))
        if (!out.contains(variable->type) || out.list().size() > 1)
            return {intersection(out, TypeSet{variable->type}), variable};
    return {out, nullptr};
}

TypeSet intersection(const TypeSet& a, const TypeSet& b)
{
    TypeSet out;
    for (const DataType type : a.list())
        if (b.contains(type))
            out.insert(type);
    return out;
}

std::string typeNames(const TypeSet& types)
{
    std::string out;
    for (const DataType type : types.list())
        out += (out.empty() ? "" : "/") + std::string(name(type));
    return out;
}

DataType preferredType(const TypeSet& types)
{
    using enum DataType;
    for (const DataType type : {Bool, Int, Dint, Real, Byte, Word, Dword})
        if (types.contains(type))
            return type;
    return types.isEmpty() ? Int : types.list().front();
}

std::string areaNames(const Pin& pin, const Family& family)
{
    std::vector<std::string_view> names;
    std::string out;
    for (const AreaId id : pin.areas) {
        const std::string& area = family.area(id).name;
        if (std::find(names.begin(), names.end(), area) != names.end())
            continue;
        names.push_back(area);
        out += (out.empty() ? "" : ", ") + area;
    }
    return out;
}

bool areaAllowed(const Pin& pin, const Address& address, const Family& family)
{
    if (address.area == VariablesArea)
        return true;
    const std::string& area = family.area(address.area).name;
    return std::any_of(pin.areas.begin(), pin.areas.end(), [&](AreaId id) { return family.area(id).name == area; });
}

} // namespace camwright
