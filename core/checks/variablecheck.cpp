#include "core/checks/projectcheck.h"

#include <algorithm>
#include <tuple>

namespace camwright {

namespace {

std::string foldedName(std::string_view name)
{
    std::string out(name);
    std::transform(out.begin(), out.end(), out.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return out;
}

/// KS-MEM-05 and TS-VAR-01.
std::span<const DataType> offeredTypes(const Family& family)
{
    static constexpr DataType Kinco[] = {DataType::Bool, DataType::Byte, DataType::Int, DataType::Word, DataType::Dint, DataType::Dword, DataType::Real};
    static constexpr DataType Invt[] = {DataType::Bool, DataType::Int, DataType::Dint, DataType::Word, DataType::Dword, DataType::Real};
    static constexpr DataType Koyo[] = {DataType::Bool, DataType::Word, DataType::Dword, DataType::Int, DataType::Dint, DataType::Real};
    return family.id() == "kinco" ? std::span<const DataType>(Kinco) : family.id() == "koyo" ? std::span<const DataType>(Koyo) : std::span<const DataType>(Invt);
}

/// TS-VAR-05.
bool hasArrays(const Family& family)
{
    return family.id() == "invt";
}

/// A Kinco or Koyo variable is a name for an address (KS-MEM-06); TS600 places variables itself (TS-VAR-04).
bool needsAddresses(const Family& family)
{
    return family.id() != "invt";
}

std::string typeNames(std::span<const DataType> types)
{
    std::string out;
    for (const DataType type : types)
        out += (out.empty() ? "" : ", ") + std::string(name(type));
    return out;
}

Place member(const Place& row, const char* field)
{
    Place out = row;
    out.field += field;
    return out;
}

/// The bits a variable takes, in one line of numbers per area.
struct Extent {
    AreaId area;
    std::uint64_t begin;
    std::uint64_t end;
    const ValidVariable* variable;
};

Extent extentOf(const ValidVariable& variable)
{
    const Address& a = *variable.address;
    const std::uint64_t begin = std::uint64_t{a.byte} * 8 + (a.isBit ? a.bit : 0);
    return {a.area, begin, begin + (a.isBit ? 1 : byteWidth(a.type) * 8), &variable};
}

} // namespace

void ProjectCheck::checkVariables()
{
    for (const ObjectPtr& object : m_project.objects(ObjectKind::VariableTable)) {
        std::size_t number = 0;
        for (const VariableTable::Chunk& chunk : std::get<VariableTable>(object->content).chunks) {
            for (const Variable& variable : *chunk)
                checkVariable(Place{object->key, "rows[" + std::to_string(number++) + ']', {}, {}}, variable);
        }
    }
    checkSharedMemory();
}

void ProjectCheck::checkVariable(const Place& row, const Variable& variable)
{
    checkVariableName(member(row, ".name"), variable.name);
    if (!m_valid.m_model)
        return;
    const Family& family = *m_valid.m_family;
    const std::span<const DataType> types = offeredTypes(family);
    if (const auto array = arrayTypeOf(variable.type); array && hasArrays(family) && std::find(types.begin(), types.end(), array->element) != types.end()) {
        checkArray(row, variable, *array);
        return;
    }
    if (!variable.type.isValid()) {
        report(Code::FieldNotOneOf, {variable.type.text(), "type", typeNames(types)}, member(row, ".type"));
        return;
    }
    const DataType type = variable.type.value();
    if (std::find(types.begin(), types.end(), type) == types.end()) {
        report(Code::TypeNotOffered, {std::string(name(type)), family.displayName(), typeNames(types)}, member(row, ".type"));
        return;
    }
    ValidVariable valid{variable.name, type, checkAddress(member(row, ".address"), variable), std::nullopt, variable.retain, row};
    checkInitial(member(row, ".initial"), variable, valid);
    m_valid.m_variables.push_back(std::move(valid));
}

void ProjectCheck::checkInitial(const Place& place, const Variable& variable, ValidVariable& valid)
{
    if (variable.initial.empty())
        return;
    auto initial = parseValue(valid.type, variable.initial);
    if (initial) {
        valid.initial = *initial;
        return;
    }
    Diagnostic error = initial.error();
    error.place = place;
    m_out.push_back(std::move(error));
}

/// TS-VAR-05, TS-VAR-10. An initial value is that of every element (ours).
void ProjectCheck::checkArray(const Place& row, const Variable& variable, const ArrayType& array)
{
    ValidVariable valid{variable.name, array.element, checkArrayAddress(member(row, ".address"), variable, array), std::nullopt, variable.retain, row};
    checkInitial(member(row, ".initial"), variable, valid);
    m_valid.m_variables.push_back(std::move(valid));
}

/// Bits bind to bit elements only, words to words, and all elements must be there.
std::optional<Address> ProjectCheck::checkArrayAddress(const Place& place, const Variable& variable, const ArrayType& array)
{
    if (variable.address.empty())
        return std::nullopt;
    const Family& family = *m_valid.m_family;
    auto address = family.parseAddress(variable.address, *m_valid.m_model);
    if (address)
        address = family.withType(*address, array.element, *m_valid.m_model);
    if (!address) {
        Diagnostic error = address.error();
        error.place = place;
        m_out.push_back(std::move(error));
        return std::nullopt;
    }
    if (array.element == DataType::Bool && family.area(address->area).kind == AreaKind::Words) {
        report(Code::FieldNotOneOf, {variable.address, "address", "X, Y, M, S"}, place);
        return std::nullopt;
    }
    const std::uint64_t bytes = std::uint64_t{array.length} * byteWidth(array.element);
    if (family.blockFits(*address, bytes, *m_valid.m_model))
        return *address;
    const std::uint32_t left = m_valid.m_model->area(address->area).bytes - address->byte;
    report(Code::BlockOutsideArea, {std::to_string(array.length), variable.address, std::to_string(bytes), std::to_string(left)}, place);
    return std::nullopt;
}

void ProjectCheck::checkVariableName(const Place& place, const std::string& name)
{
    if (name.empty()) {
        report(Code::NameEmpty, {}, place);
        return;
    }
    if (m_valid.m_model && !isIdentifier(name))
        report(Code::NameNotIdentifier, {name}, place);
    checkAlphabet(place, name);
    const auto [first, added] = m_variableNames.emplace(foldedName(name), place);
    if (!added)
        report(Code::NameTwice, {name}, place, first->second);
}

std::optional<Address> ProjectCheck::checkAddress(const Place& place, const Variable& variable)
{
    const Family& family = *m_valid.m_family;
    if (variable.address.empty()) {
        if (needsAddresses(family))
            report(Code::AddressMissing, {variable.name}, place);
        return std::nullopt;
    }
    auto address = family.parseAddress(variable.address, *m_valid.m_model);
    if (address)
        address = family.withType(*address, variable.type.value(), *m_valid.m_model);
    if (!address) {
        Diagnostic error = address.error();
        error.place = place;
        m_out.push_back(std::move(error));
        return std::nullopt;
    }
    const AreaLayout& layout = m_valid.m_model->area(address->area);
    if (variable.retain && (address->byte < layout.retainedFirst || address->byte >= layout.retainedEnd)) // TS-VAR-09, KS-CPU-16
        report(Code::RetainWithoutEffect, {variable.name, variable.address}, place);
    return *address;
}

/// Two names for one place are legal, and often meant; a warning each is enough.
void ProjectCheck::checkSharedMemory()
{
    std::vector<Extent> extents;
    for (const ValidVariable& variable : m_valid.m_variables) {
        if (variable.address)
            extents.push_back(extentOf(variable));
    }
    std::sort(extents.begin(), extents.end(), [](const Extent& a, const Extent& b) {
        return std::tie(a.area, a.begin, a.variable->place) < std::tie(b.area, b.begin, b.variable->place);
    });
    const Extent* widest = nullptr; // of those before, the one that reaches furthest
    for (const Extent& extent : extents) {
        if (widest && widest->area == extent.area && widest->end > extent.begin)
            report(Code::AddressShared,
                   {extent.variable->name, widest->variable->name, m_valid.m_family->formatAddress(*extent.variable->address)},
                   member(extent.variable->place, ".address"), member(widest->variable->place, ".address"));
        if (!widest || widest->area != extent.area || extent.end > widest->end)
            widest = &extent;
    }
}

} // namespace camwright
