#pragma once

#include "core/family/instructionid.h"
#include "core/language/ir/ir.h"

#include <cstdint>
#include <vector>

namespace camwright::kinco {

/// Where the pins of an MC_* instruction stand in its operand list (KS-MC, data of kinco_mc_instructions.csv).
struct PinTable {
    static constexpr std::int8_t None = -1;
    InstructionId instruction{};
    std::int8_t exec = None, axis = None, position = None, velocity = None, mode = None, time = None, count = None;
    std::int8_t ids = None, cells = None;
    std::int8_t done = None, error = None, errorId = None, active = None;
};

/// Null for an instruction that is not a triggered MC_* one (MC_STATE has no trigger).
const PinTable* pinsOf(InstructionId instruction);

/// One call of an MC_* instruction in the program.
struct CallSite {
    InstructionId instruction{};
    const PinTable* pins = nullptr;     ///< null: MC_STATE, or no Kinco motion instruction
    std::uint32_t list = 0;             ///< index of its ParameterList; only for the two that have one
};

struct CallSites {
    std::vector<CallSite> sites;        ///< by block instance
    std::uint32_t lists = 0;            ///< number of parameter lists
};

CallSites callSitesOf(const IrProgram& program);

} // namespace camwright::kinco
