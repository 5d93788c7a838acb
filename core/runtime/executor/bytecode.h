#pragma once

#include "core/language/image/controllerimage.h"
#include "core/runtime/executor/blockhost.h"
#include "core/runtime/memory/memory.h"

#include <array>
#include <cstdint>
#include <vector>

namespace camwright {

// What an image becomes when it is loaded. Memory areas, hidden state, registers and constants lie in one array, so every
// operand is an offset into it: a value need not be loaded before it is used, nor stored after it was computed. Contacts
// of a rung are joined into networks, which one step evaluates without a branch per contact.

struct Frame;
struct Step;

/// Does one step and returns the next; null at the end.
using Handler = const Step* (*)(Frame&, const Step*);

struct Step {
    Handler run = nullptr;
    std::uint32_t dest = 0;  ///< offset of the result; jumps: step to go to
    std::uint32_t a = 0;     ///< offset of the operand; networks: first contact
    std::uint32_t b = 0;     ///< offset of the second operand; control: its IR instruction
    std::uint32_t extra = 0; ///< bit mask, table index, IR instruction; see the handlers
};

/// One element of a boolean network: result = result op (memory bit), from left to right, beginning with 0.
struct Contact {
    static constexpr std::uint8_t Or = 1, Negated = 2, Last = 4, InvertResult = 8;
    std::uint32_t offset = 0;
    std::uint8_t mask = 1;
    std::uint8_t flags = Or; ///< without Or: AND
};

struct TimerStep {
    TimerKind kind = TimerKind::Ton;
    std::uint32_t value = 0;
    std::uint32_t bit = 0;
    std::uint8_t bitMask = 1;
    std::uint32_t state = 0;
    std::int64_t baseNs = 1;
};

struct CounterStep {
    CounterKind kind = CounterKind::Up;
    bool isWide = false;
    std::uint32_t value = 0;
    std::uint32_t bit = 0;
    std::uint8_t bitMask = 1;
    std::uint32_t state = 0;
};

/// What a Bound or Reach lets through: value - lower < count. Else it is a fault, and the scan goes on at another step.
struct GuardStep {
    std::uint32_t lower = 0;
    std::uint32_t count = 0;
    std::uint32_t elseStep = 0;        ///< step to go to
    std::uint32_t instruction = 0;     ///< its own number in the IR, and that of the other step
    std::uint32_t elseInstruction = 0;
};

class Bytecode {
public:
    std::vector<Step> steps;
    std::vector<Contact> contacts;
    std::vector<std::uint32_t> entries;    ///< first step of each routine
    std::vector<TimerStep> timers;
    std::vector<CounterStep> counters;
    std::vector<GuardStep> guards;
    std::vector<std::uint64_t> constants;  ///< lie at constantsOffset, 8 bytes each
    std::uint32_t constantsOffset = 0;
    std::uint32_t scratchBytes = 0;
    bool hasErrorFlag = false;
    std::uint32_t errorFlag = 0;
    std::uint8_t errorFlagMask = 1;
};

/// What handlers work on during one scan.
struct Frame {
    struct Return {
        const Step* next = nullptr;
        std::uint32_t segment = 0;
        std::uint32_t routine = 0;
        std::uint32_t instance = 0;
    };

    std::uint8_t* bytes = nullptr;
    const Bytecode* code = nullptr;
    const Contact* contacts = nullptr;
    const IrProgram* program = nullptr;
    Memory* memory = nullptr;
    BlockHost* host = nullptr;
    Time now{};

    std::uint64_t operations = 0;
    std::uint64_t budget = 0;
    std::uint32_t segment = 0;  ///< IR instruction from which `operations` has not counted yet
    std::uint32_t routine = 0;
    std::uint32_t instance = 0; ///< of the running routine of kind Block: where it lies in VariablesArea
    bool outOfOperations = false;
    std::uint32_t faults = 0;
    std::uint32_t stopRoutine = 0;
    std::uint32_t stopInstruction = 0;

    unsigned depth = 0;
    std::array<Return, MaximumCallDepth + 1> returns{};

    /// An instruction failed: counted, its place kept if it is the first, the family's flag set.
    void fault(std::uint32_t instruction);
    /// Counts the instructions up to and including `instruction`.
    void count(std::uint32_t instruction)
    {
        operations += instruction + 1 - segment;
        segment = instruction + 1;
    }
    /// The same; false when the budget is used up. Asked where a routine is called or left and where a jump goes back: what
    /// lies between two such places is at most one pass of a routine.
    bool countAndCheck(std::uint32_t instruction);
};

} // namespace camwright
