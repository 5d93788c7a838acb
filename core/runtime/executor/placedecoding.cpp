#include "core/runtime/executor/handlers.h"
#include "core/runtime/executor/routinedecoder.h"

namespace camwright {

// The part of RoutineDecoder for computed places: instances, pointers, indices.

namespace {

bool isRelative(const IrInstruction& i)
{
    return i.address.area == InstanceArea;
}

} // namespace

std::uint32_t RoutineDecoder::memoryOffset(const IrAddress& address) const
{
    return m_memory.offsetOf(address.area == InstanceArea ? VariablesArea : address.area, address.byte);
}

bool RoutineDecoder::decodePlace(const IrInstruction& i)
{
    switch (i.op) {
    case IrOp::CallOn:
    case IrOp::CallAt: decodeCall(i); return true;
    case IrOp::Bound:
    case IrOp::Reach: decodeGuard(i); return true;
    case IrOp::LoadAt:
    case IrOp::LoadElement: decodeLoadAccess(i); return true;
    case IrOp::StoreAt:
    case IrOp::StoreElement: decodeStoreAccess(i); return true;
    case IrOp::Place: emit(placeHandler(isRelative(i)), defineSlot(i.dest, i.type), i.address.byte); return true;
    case IrOp::Now: emit(readClock, defineSlot(i.dest, i.type)); return true;
    case IrOp::Element: {
        const std::uint32_t pointer = offsetOf(i.a);
        const std::uint32_t index = offsetOf(i.b);
        emit(locateElement, defineSlot(i.dest, i.type), pointer, index, irFirst(i.constant));
        return true;
    }
    case IrOp::Select: {
        const std::uint32_t condition = offsetOf(i.a);
        const std::uint32_t first = offsetOf(i.b);
        const std::uint32_t second = offsetOf(i.index);
        emit(selectHandler(i.type), defineSlot(i.dest, i.type), condition, first, second);
        return true;
    }
    case IrOp::Move: {
        const std::uint32_t to = offsetOf(i.a);
        const std::uint32_t from = offsetOf(i.b);
        flush();
        emit(moveBytes, to, from, static_cast<std::uint32_t>(i.constant), m_memory.offsetOf(VariablesArea, 0));
        return true;
    }
    default: return false;
    }
}

void RoutineDecoder::decodeCall(const IrInstruction& i)
{
    if (i.op == IrOp::CallOn) {
        flush();
        return emit(callOnHandler(isRelative(i)), i.index, i.address.byte, m_at);
    }
    const std::uint32_t pointer = offsetOf(i.a);
    flush();
    emit(callAt, i.index, pointer, m_at);
}

std::uint32_t RoutineDecoder::guardOf(const IrInstruction& i)
{
    GuardStep out{irFirst(i.constant), irSecond(i.constant), 0, m_at, i.index};
    if (i.op == IrOp::Reach) {
        const auto bytes = static_cast<std::uint32_t>(m_memory.area(VariablesArea).size());
        out.lower = 0;
        out.count = bytes - static_cast<std::uint32_t>(i.constant) + 1;
    }
    m_out.guards.push_back(out);
    return static_cast<std::uint32_t>(m_out.guards.size() - 1);
}

/// What is pending is written before a guard, because it may leave the straight line.
void RoutineDecoder::decodeGuard(const IrInstruction& i)
{
    const std::uint32_t value = offsetOf(i.a);
    flush();
    emit(camwright::guard, defineSlot(i.dest, DataType::Dword), value, 0, guardOf(i));
}

void RoutineDecoder::decodeLoadAccess(const IrInstruction& i)
{
    if (i.op == IrOp::LoadAt) {
        const std::uint32_t pointer = offsetOf(i.a);
        return emit(loadAtHandler(i.type), defineSlot(i.dest, i.type), pointer, 0, memoryOffset(i.address));
    }
    const std::uint32_t index = offsetOf(i.b);
    emit(loadElementHandler(i.type, isRelative(i)), defineSlot(i.dest, i.type), memoryOffset(i.address), index,
         static_cast<std::uint32_t>(i.constant));
}

void RoutineDecoder::decodeStoreAccess(const IrInstruction& i)
{
    const std::uint32_t value = offsetOf(i.a);
    const std::uint32_t place = offsetOf(i.b);
    flush();
    if (i.op == IrOp::StoreAt)
        return emit(storeAtHandler(i.type), 0, value, place, memoryOffset(i.address));
    emit(storeElementHandler(i.type, isRelative(i)), memoryOffset(i.address), value, place, static_cast<std::uint32_t>(i.constant));
}

} // namespace camwright
