#include "core/language/lowering/memorylayout.h"

#include <algorithm>

namespace camwright {

namespace {

/// SM22 of the TS600 is on when an instruction failed (TS-MEM-09). Kinco names no such bit.
std::optional<Address> instructionErrorFlag(const Family& family, const ControllerModel& model)
{
    if (family.id() != "invt")
        return std::nullopt;
    const Result<Address> flag = family.parseAddress("SM22", model);
    return flag ? std::optional(*flag) : std::nullopt;
}

class VariablePlacer {
public:
    VariablePlacer(const Family& family, const ControllerModel& model) : m_family(family), m_model(model) {}

    void place(const DeclaredVariable& variable)
    {
        const Address address = variable.address ? boundTo(*variable.address, variable.type) : nextPlace(variable.type);
        m_out.symbols.push_back({variable.name, address, variable.retain});
        if (variable.initial)
            m_out.initialValues.push_back({address, *variable.initial});
    }

    void endOfRetained() { m_out.retainedBytes = m_out.bytes; }

    PlacedVariables take()
    {
        std::ranges::sort(m_out.symbols, {}, &Symbol::name);
        return std::move(m_out);
    }

private:
    Address boundTo(const Address& address, DataType type) const
    {
        const Result<Address> typed = m_family.withType(address, type, m_model);
        return typed ? *typed : address;
    }

    Address nextPlace(DataType type)
    {
        const std::uint32_t alignment = std::min(4u, byteWidth(type));
        m_out.bytes = (m_out.bytes + alignment - 1) / alignment * alignment;
        const std::uint32_t byte = m_out.bytes;
        m_out.bytes += byteWidth(type);
        return type == DataType::Bool ? bitAddress(VariablesArea, byte) : valueAddress(VariablesArea, byte, type);
    }

    const Family& m_family;
    const ControllerModel& m_model;
    PlacedVariables m_out;
};

} // namespace

PlacedVariables placeVariables(std::span<const DeclaredVariable> variables, const Family& family, const ControllerModel& model)
{
    VariablePlacer placer(family, model);
    for (const bool retained : {true, false}) {
        for (const DeclaredVariable& variable : variables) {
            if (variable.retain == retained)
                placer.place(variable);
        }
        if (retained)
            placer.endOfRetained();
    }
    return placer.take();
}

MemoryLayout memoryLayout(const Family& family, const ControllerModel& model, const PlacedVariables& variables, std::size_t routines)
{
    MemoryLayout layout;
    for (const MemoryArea& area : family.areas()) {
        const AreaLayout& size = model.area(area.id);
        const std::uint32_t count = area.local ? static_cast<std::uint32_t>(std::max<std::size_t>(routines, 1)) : 1;
        layout.areas.push_back({area.id, area.name, size.bytes * count, size.retainedFirst, size.retainedEnd});
    }
    if (variables.bytes > 0)
        layout.areas.push_back({VariablesArea, {}, variables.bytes, 0, variables.retainedBytes});
    std::ranges::sort(layout.areas, {}, &ImageArea::id);
    layout.initialValues = variables.initialValues;
    layout.instructionErrorFlag = instructionErrorFlag(family, model);
    return layout;
}

} // namespace camwright
