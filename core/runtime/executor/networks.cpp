#include "core/runtime/executor/access.h"
#include "core/runtime/executor/handlers.h"

namespace camwright {

namespace {

/// result := result op contact. One expression without a branch: contacts change from scan to scan, so the processor could
/// not foretell them.
inline unsigned joined(const Frame& frame, const Contact& contact, unsigned result)
{
    const unsigned flags = contact.flags;
    const unsigned isOr = flags & Contact::Or;
    const unsigned bit = ((frame.bytes[contact.offset] & contact.mask) != 0 ? 1u : 0u) ^ ((flags & Contact::Negated) >> 1);
    result = (result & (bit | isOr)) | (bit & isOr);
    return result ^ ((flags & Contact::InvertResult) >> 3);
}

/// A network of Size contacts; 0: of any size. A size known beforehand saves the branch at the loop's end.
template <unsigned Size>
inline bool evaluate(const Frame& frame, std::uint32_t first)
{
    const Contact* contact = frame.contacts + first;
    unsigned result = 0;
    if constexpr (Size > 0) {
        for (unsigned i = 0; i < Size; ++i)
            result = joined(frame, contact[i], result);
        return result != 0;
    } else {
        for (;; ++contact) {
            result = joined(frame, *contact, result);
            if (contact->flags & Contact::Last)
                return result != 0;
        }
    }
}

const Step* jumpTo(Frame& frame, const Step* step)
{
    if (step->extra > step->b)
        frame.count(step->b);
    else if (!frame.countAndCheck(step->b))
        return nullptr;
    frame.segment = step->extra;
    return frame.code->steps.data() + step->dest;
}

} // namespace

namespace {

template <unsigned Size>
struct ToByte {
    static const Step* run(Frame& frame, const Step* step)
    {
        frame.bytes[step->dest] = evaluate<Size>(frame, step->a) ? 1 : 0;
        return step + 1;
    }
};

template <unsigned Size>
struct ToBit {
    static const Step* run(Frame& frame, const Step* step)
    {
        const bool value = evaluate<Size>(frame, step->a);
        const std::uint8_t byte = frame.bytes[step->dest];
        const unsigned mask = step->extra;
        frame.bytes[step->dest] = static_cast<std::uint8_t>((byte & ~mask) | (value ? mask : 0u));
        return step + 1;
    }
};

template <unsigned Size>
struct JumpIf {
    static const Step* run(Frame& frame, const Step* step)
    {
        return evaluate<Size>(frame, step->a) ? jumpTo(frame, step) : step + 1;
    }
};

template <unsigned Size>
struct JumpIfNot {
    static const Step* run(Frame& frame, const Step* step)
    {
        return evaluate<Size>(frame, step->a) ? step + 1 : jumpTo(frame, step);
    }
};

template <template <unsigned> class Ending>
Handler ofSize(std::size_t contacts)
{
    switch (contacts) {
    case 1: return Ending<1>::run;
    case 2: return Ending<2>::run;
    case 3: return Ending<3>::run;
    case 4: return Ending<4>::run;
    case 5: return Ending<5>::run;
    case 6: return Ending<6>::run;
    case 7: return Ending<7>::run;
    case 8: return Ending<8>::run;
    default: return Ending<0>::run;
    }
}

} // namespace

Handler networkHandler(NetworkEnding ending, std::size_t contacts)
{
    switch (ending) {
    case NetworkEnding::Byte: return ofSize<ToByte>(contacts);
    case NetworkEnding::Bit: return ofSize<ToBit>(contacts);
    case NetworkEnding::JumpIf: return ofSize<JumpIf>(contacts);
    case NetworkEnding::JumpIfNot: return ofSize<JumpIfNot>(contacts);
    }
    return nullptr;
}

const Step* jump(Frame& frame, const Step* step)
{
    return jumpTo(frame, step);
}

const Step* callRoutine(Frame& frame, const Step* step)
{
    return enterRoutine(frame, step, frame.instance);
}

const Step* enterRoutine(Frame& frame, const Step* step, std::uint32_t instance)
{
    if (!frame.countAndCheck(step->b))
        return nullptr;
    frame.returns[frame.depth++] = {step + 1, step->b + 1, frame.routine, frame.instance};
    frame.segment = 0;
    frame.routine = step->dest;
    frame.instance = instance;
    return frame.code->steps.data() + frame.code->entries[step->dest];
}

const Step* returnFromRoutine(Frame& frame, const Step* step)
{
    if (!frame.countAndCheck(step->b) || frame.depth == 0)
        return nullptr;
    const Frame::Return& back = frame.returns[--frame.depth];
    frame.segment = back.segment;
    frame.routine = back.routine;
    frame.instance = back.instance;
    return back.next;
}

const Step* callBlock(Frame& frame, const Step* step)
{
    if (frame.host) {
        const IrBlock& block = frame.program->blocks[step->extra];
        PinValues pins(*frame.memory, block);
        const BlockInstance instance{block.instance, frame.bytes[step->a] != 0, frame.now};
        frame.host->call(static_cast<InstructionId>(block.instruction), instance, pins);
    }
    return step + 1;
}

const Step* risingEdge(Frame& frame, const Step* step)
{
    const bool now = frame.bytes[step->a] != 0;
    const bool before = frame.bytes[step->extra] != 0;
    frame.bytes[step->extra] = now ? 1 : 0;
    frame.bytes[step->dest] = now && !before ? 1 : 0;
    return step + 1;
}

const Step* fallingEdge(Frame& frame, const Step* step)
{
    const bool now = frame.bytes[step->a] != 0;
    const bool before = frame.bytes[step->extra] != 0;
    frame.bytes[step->extra] = now ? 1 : 0;
    frame.bytes[step->dest] = !now && before ? 1 : 0;
    return step + 1;
}

bool Frame::countAndCheck(std::uint32_t instruction)
{
    count(instruction);
    if (operations <= budget)
        return true;
    outOfOperations = true;
    stopRoutine = routine;
    stopInstruction = instruction;
    return false;
}

void Frame::fault(std::uint32_t instruction)
{
    if (faults++ == 0) {
        stopRoutine = routine;
        stopInstruction = instruction;
    }
    if (code->hasErrorFlag)
        storeBit(*this, code->errorFlag, code->errorFlagMask, true);
}

} // namespace camwright
