#include "core/runtime/terminallist.h"

#include "core/runtime/valuenames.h"

namespace camwright {

namespace {

bool hasBits(const MemoryArea& area)
{
    return area.kind == AreaKind::Bits || area.sizeLetters.find('X') != std::string::npos;
}

Address point(const MemoryArea& area, unsigned number)
{
    if (!hasBits(area))
        return valueAddress(area.id, number * 2, DataType::Word);
    if (area.kind == AreaKind::Bits)
        return bitAddress(area.id, number);
    return bitAddress(area.id, number / 8, number % 8);
}

void add(const Family& family, const MemoryArea& area, unsigned count, std::vector<Terminal>& out)
{
    for (unsigned i = 0; i < count; ++i) {
        const Address address = point(area, i);
        out.push_back({family.formatAddress(address), area.isInput, refOf(address)});
    }
}

} // namespace

std::vector<Terminal> terminalsOf(const Family& family, const ControllerModel& model)
{
    std::vector<Terminal> out;
    for (const bool bits : {true, false}) {
        for (const MemoryArea& area : family.areas()) {
            if (hasBits(area) != bits || (!area.isInput && !area.isOutput))
                continue;
            const unsigned digital = area.isInput ? model.digitalInputs : model.digitalOutputs;
            const unsigned analog = area.isInput ? model.analogInputs : model.analogOutputs;
            add(family, area, bits ? digital : analog, out);
        }
    }
    return out;
}

} // namespace camwright
