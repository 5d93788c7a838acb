#include "core/runtime/kinco/callsite.h"

#include <algorithm>
#include <array>

namespace camwright::kinco {

namespace {

constexpr std::array<PinTable, 9> kTables{{
    {.instruction = InstructionId::KincoMcRparas, .exec = 0, .axis = 1, .count = 3, .ids = 2, .cells = 7, .done = 4,
        .error = 5, .errorId = 6},
    {.instruction = InstructionId::KincoMcWparas, .exec = 0, .axis = 1, .count = 4, .ids = 2, .cells = 3, .done = 5,
        .error = 6, .errorId = 7},
    {.instruction = InstructionId::KincoMcPower, .exec = 0, .axis = 1, .done = 2, .error = 3, .errorId = 4},
    {.instruction = InstructionId::KincoMcReset, .exec = 0, .axis = 1, .done = 2, .error = 3, .errorId = 4},
    {.instruction = InstructionId::KincoMcHome, .exec = 0, .axis = 1, .position = 2, .time = 3, .done = 4, .error = 5, .errorId = 6},
    {.instruction = InstructionId::KincoMcMabs, .exec = 0, .axis = 1, .position = 2, .velocity = 3, .mode = 5, .done = 6, .error = 7,
        .errorId = 8, .active = 9},
    {.instruction = InstructionId::KincoMcMrel, .exec = 0, .axis = 1, .position = 2, .velocity = 3, .done = 4, .error = 5, .errorId = 6,
        .active = 7},
    {.instruction = InstructionId::KincoMcJog, .exec = 0, .axis = 1, .velocity = 2, .done = 4, .error = 5, .errorId = 6, .active = 7},
    {.instruction = InstructionId::KincoMcRestart, .exec = 0, .axis = 1, .count = 2, .done = 3, .error = 4, .errorId = 5},
}};

} // namespace

const PinTable* pinsOf(InstructionId instruction)
{
    const auto found = std::find_if(kTables.begin(), kTables.end(), [&](const PinTable& t) { return t.instruction == instruction; });
    return found == kTables.end() ? nullptr : &*found;
}

CallSites callSitesOf(const IrProgram& program)
{
    CallSites out;
    for (const IrBlock& block : program.blocks) {
        if (out.sites.size() <= block.instance)
            out.sites.resize(block.instance + 1);
        CallSite& site = out.sites[block.instance];
        site.instruction = static_cast<InstructionId>(block.instruction);
        site.pins = pinsOf(site.instruction);
        if (site.pins && site.pins->ids != PinTable::None)
            site.list = out.lists++;
    }
    return out;
}

} // namespace camwright::kinco
