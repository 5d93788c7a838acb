#include "core/language/check/operandtypes.h"

#include <algorithm>
#include <map>

namespace camwright {

namespace {

constexpr auto FirstType = static_cast<unsigned>(DataType::Bool);
constexpr auto LastType = static_cast<unsigned>(DataType::Lword);

TypeSet askedTypes(const Family& family, const ControllerModel& model, const Address& address)
{
    TypeSet out;
    for (unsigned i = FirstType; i <= LastType; ++i)
        if (family.withType(address, static_cast<DataType>(i), model))
            out.insert(static_cast<DataType>(i));
    return out;
}

/// Types of each form of address in the areas where they depend on the form alone (not on the number, as with counters).
/// Asking the family costs a sentence for each type that is not one; a program has thousands of operands.
class FormTypes {
public:
    explicit FormTypes(const Family& family)
    {
        for (const MemoryArea& area : family.areas()) {
            if (area.kind != AreaKind::Bytes && area.kind != AreaKind::Bits && area.kind != AreaKind::Words)
                continue;
            for (unsigned i = FirstType; i <= LastType; ++i) {
                const auto type = static_cast<DataType>(i);
                m_types[{area.id, type}] = typesAt(family, area.id, type, 0);
                const std::uint32_t bytes = family.defaultModel().area(area.id).bytes;
                if (m_types[{area.id, type}].isEmpty() && bytes >= WidestForm) // the first words of Koyo's V belong to the timers
                    m_types[{area.id, type}] = typesAt(family, area.id, type, bytes - WidestForm);
            }
        }
    }

    const TypeSet* find(const Address& address) const
    {
        const auto found = m_types.find({address.area, address.type});
        return found == m_types.end() ? nullptr : &found->second;
    }

private:
    static constexpr std::uint32_t WidestForm = 4;

    static TypeSet typesAt(const Family& family, AreaId area, DataType type, std::uint32_t byte)
    {
        return askedTypes(family, family.defaultModel(), type == DataType::Bool ? bitAddress(area, byte) : valueAddress(area, byte, type));
    }

    std::map<std::pair<AreaId, DataType>, TypeSet> m_types;
};

const FormTypes& formTypes(const Family& family)
{
    static const std::map<const Family*, FormTypes> all = [] {
        std::map<const Family*, FormTypes> out;
        for (const Family* known : families())
            out.emplace(known, FormTypes(*known));
        return out;
    }();
    return all.at(&family);
}

TypeSet possibleTypes(const Address& address, const LanguageContext& context)
{
    const TypeSet* form = formTypes(*context.family).find(address);
    if (!form)
        return askedTypes(*context.family, *context.model, address);
    TypeSet out;
    for (const DataType type : form->list()) {
        Address typed = address;
        typed.type = type;
        if (context.family->blockFits(typed, byteWidth(type), *context.model))
            out.insert(type);
    }
    return out;
}

} // namespace

MemoryTypes typesOf(const ResolvedMemory& memory, const LanguageContext& context)
{
    if (memory.variable)
        return {TypeSet{memory.variable->type}, nullptr};
    const TypeSet out = possibleTypes(memory.address, context);
    if (const KnownVariable* variable = context.variableAt(memory.address))
        if (!out.contains(variable->type) || out.list().size() > 1)
            return {intersection(out, TypeSet{variable->type}), variable};
    return {out, nullptr};
}

Address addressAtPin(const ResolvedMemory& memory, const Pin& pin, const LanguageContext& context)
{
    const Address& written = memory.address;
    if (memory.variable || written.isBit || pin.types.isEmpty() || pin.types.contains(written.type))
        return written;
    const TypeSet types = intersection(typesOf(memory, context).possible, pin.types);
    if (types.isEmpty())
        return written;
    const auto typed = context.family->withType(written, preferredType(types), *context.model);
    return typed ? *typed : written;
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
