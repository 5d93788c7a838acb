#include "core/runtime/native/routineoutline.h"

#include "core/runtime/native/registerallocator.h"

#include <array>

namespace camwright::native {

namespace {

bool mayJump(IrOp op)
{
    return shapeOf(op).index == IrShape::Index::Target;
}

/// After these no register holds what it held before.
bool endsLine(const IrInstruction& i)
{
    return isCall(i.op) || i.op == IrOp::Move || i.op == IrOp::Return || i.op == IrOp::Jump || (i.op >= IrOp::Timer && i.op <= IrOp::Block);
}

/// A register kept for longer is likely to be wanted for something else.
constexpr std::uint32_t SoonInstructions = 64;

/// The last look at some bytes, found by their offset; a newer one with the same hash wins, which costs a load at most.
struct Look {
    std::uint32_t offset = 0xFFFFFFFF;
    std::uint32_t at = 0;
    std::uint32_t line = 0;
    std::uint8_t bytes = 0;
};

} // namespace

RoutineOutline::RoutineOutline(const IrRoutine& routine, const Memory& memory)
    : m_labels(routine.code.size() + 1, NoLabel), m_again(routine.code.size(), false)
{
    findLabels(routine);
    findRepeats(routine, memory);
}

void RoutineOutline::findLabels(const IrRoutine& routine)
{
    for (std::uint32_t at = 0; at < routine.code.size(); ++at) {
        const IrInstruction& i = routine.code[at];
        if (!mayJump(i.op))
            continue;
        std::uint32_t& label = m_labels[i.index];
        if (label == NoLabel) {
            label = ++m_labelCount;
            m_isLoop.push_back(false);
        }
        if (i.index <= at)
            m_isLoop[label] = m_hasLoops = true;
    }
}

void RoutineOutline::findRepeats(const IrRoutine& routine, const Memory& memory)
{
    constexpr std::size_t Looks = 1024;
    std::array<Look, Looks> looks{};
    std::uint32_t line = 0;
    for (auto at = static_cast<std::uint32_t>(routine.code.size()); at-- > 0;) {
        const IrInstruction& i = routine.code[at];
        if (endsLine(i) || (m_labels[at + 1] != NoLabel && m_isLoop[m_labels[at + 1]]))
            ++line;
        if (i.op != IrOp::Load && i.op != IrOp::Store)
            continue;
        const bool isOfInstance = i.address.area == InstanceArea;
        const std::uint32_t offset = isOfInstance ? InstanceOffset + i.address.byte : memory.offsetOf(i.address.area, i.address.byte);
        const auto bytes = static_cast<std::uint8_t>(byteWidth(i.type));
        Look& look = looks[(offset ^ offset >> 10) % Looks];
        m_again[at] = look.offset == offset && look.bytes == bytes && look.line == line && look.at - at < SoonInstructions;
        const bool isBit = i.type == DataType::Bool && i.address.bit != IrAddress::WholeByte;
        if (i.op == IrOp::Load || isBit)
            look = {offset, at, line, bytes};
        else if (look.offset == offset)
            look = {}; // the store makes the old contents worthless
    }
}

} // namespace camwright::native
