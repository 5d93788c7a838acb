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

} // namespace

MemoryLayout memoryLayout(const Family& family, const ControllerModel& model, std::uint32_t variableBytes, std::size_t routines)
{
    MemoryLayout layout;
    for (const MemoryArea& area : family.areas()) {
        const AreaLayout& size = model.area(area.id);
        const std::uint32_t count = area.local ? static_cast<std::uint32_t>(std::max<std::size_t>(routines, 1)) : 1;
        layout.areas.push_back({area.id, area.name, size.bytes * count, size.retainedFirst, size.retainedEnd});
    }
    if (variableBytes > 0)
        layout.areas.push_back({VariablesArea, {}, variableBytes, 0, 0});
    std::ranges::sort(layout.areas, {}, &ImageArea::id);
    layout.instructionErrorFlag = instructionErrorFlag(family, model);
    return layout;
}

} // namespace camwright
