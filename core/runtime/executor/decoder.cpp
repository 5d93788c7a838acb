#include "core/runtime/executor/decoder.h"

#include "core/runtime/executor/routinedecoder.h"
#include "core/runtime/executor/scratch.h"

namespace camwright {

namespace {

std::uint8_t maskOf(const IrAddress& address)
{
    return address.bit == IrAddress::WholeByte ? std::uint8_t{0xFF} : static_cast<std::uint8_t>(1u << address.bit);
}

ConstantPool constantsOf(const IrProgram& program, std::uint32_t offset)
{
    ConstantPool pool(offset);
    for (const IrRoutine& routine : program.routines) {
        for (const IrInstruction& i : routine.code) {
            if (i.op == IrOp::Const)
                pool.add(i.constant);
        }
    }
    return pool;
}

void decodeElements(const IrProgram& program, const Memory& memory, Bytecode& out)
{
    const auto at = [&](const IrAddress& address) { return memory.offsetOf(address.area, address.byte); };
    for (const IrTimer& timer : program.timers) {
        out.timers.push_back({timer.kind, at(timer.value), at(timer.bit), maskOf(timer.bit),
                              memory.stateOffset() + timer.state, timer.baseNs});
    }
    for (const IrCounter& counter : program.counters) {
        out.counters.push_back({counter.kind, counter.type == DataType::Dint, at(counter.value), at(counter.bit),
                                maskOf(counter.bit), memory.stateOffset() + counter.state});
    }
}

} // namespace

Bytecode decodeTables(const ControllerImage& image, const Memory& memory)
{
    Bytecode out;
    decodeElements(image.program, memory, out);
    if (const auto& flag = image.layout.instructionErrorFlag) {
        out.hasErrorFlag = true;
        out.errorFlag = memory.offsetOf(flag->area, flag->byte);
        out.errorFlagMask = static_cast<std::uint8_t>(1u << flag->bit);
    }
    return out;
}

void decodeSteps(const ControllerImage& image, const Memory& memory, Bytecode& out)
{
    const ConstantPool constants = constantsOf(image.program, memory.scratchOffset());
    SlotAllocator slots(constants.end());
    for (const IrRoutine& routine : image.program.routines) {
        out.entries.push_back(static_cast<std::uint32_t>(out.steps.size()));
        RoutineDecoder(routine, memory, constants, slots, out).run();
    }
    out.constants = constants.bits();
    out.constantsOffset = memory.scratchOffset();
    out.scratchBytes = slots.end() - memory.scratchOffset();
}

} // namespace camwright
