#include "core/runtime/native/registerallocator.h"

#include <bit>

namespace camwright::native {

// The part of the allocator that looks at memory and at control flow.

/// Brings every value that waits in memory and for which the function says so.
template <class Function>
void RegisterAllocator::forPending(Function function)
{
    for (std::size_t k = 0; k < m_pending.size();) {
        const IrRegister number = m_pending[k];
        if (m_values[number].where == Value::Where::Memory && m_values[number].uses > 0 && function(m_values[number]))
            bringPending(number);
        if (m_values[number].where == Value::Where::Memory && m_values[number].uses > 0) {
            ++k;
        } else {
            m_pending[k] = m_pending.back();
            m_pending.pop_back();
        }
    }
}

/// An instance lies somewhere among the variables.
bool RegisterAllocator::mayOverlap(const Range& a, const Range& b) const
{
    const bool isInstanceA = a.offset >= InstanceOffset;
    const bool isInstanceB = b.offset >= InstanceOffset;
    if (isInstanceA == isInstanceB)
        return a.overlaps(b);
    return m_variables.overlaps(isInstanceA ? b : a);
}

void RegisterAllocator::beforeStore(const Range& range)
{
    forPending([&](const Value& value) {
        return mayOverlap(range, {static_cast<std::uint32_t>(value.content), byteWidth(value.type)});
    });
    for (std::uint32_t cached = m_cached; cached != 0; cached &= cached - 1) {
        const auto unit = static_cast<Unit>(std::countr_zero(cached));
        const Range& memory = m_registers[unit].memory;
        if (!mayOverlap(memory, range))
            continue;
        if (!memory.overlaps(range)) // perhaps not overwritten
            writeBack(unit);
        dropMemory(unit);
    }
}

void RegisterAllocator::beforeAccess(const Range& range)
{
    beforeLoad(range);
    beforeStore(range);
}

void RegisterAllocator::beforeLoad(const Range& range)
{
    for (std::uint32_t cached = m_cached & GeneralUnits; cached != 0; cached &= cached - 1) {
        const auto unit = static_cast<Unit>(std::countr_zero(cached));
        if (m_registers[unit].dirty && mayOverlap(m_registers[unit].memory, range))
            writeBack(unit);
    }
}

void RegisterAllocator::remember(Unit unit, const Range& range)
{
    if (m_registers[unit].memory.bytes == 0)
        setMemory(unit, range, true);
}

Unit RegisterAllocator::byteForBits(std::uint32_t offset, bool mustHave)
{
    const Range range{offset, 1};
    forPending([&](const Value& value) {
        return mayOverlap(range, {static_cast<std::uint32_t>(value.content), byteWidth(value.type)});
    });
    for (std::uint32_t cached = m_cached; cached != 0; cached &= cached - 1) {
        const auto other = static_cast<Unit>(std::countr_zero(cached));
        if (mayOverlap(m_registers[other].memory, range) && m_registers[other].memory != range)
            dropMemory(other); // no byte for bits: those of the instance have none
    }
    Unit unit = find(range, Bank::General);
    if (unit == NoUnit) {
        if (!mustHave)
            return NoUnit;
        unit = take(Bank::General);
        m_asm.movzx(x86::gpd(unit), at(offset, 1));
        setMemory(unit, range, true);
    }
    hold(unit);
    detachValues(unit);
    m_registers[unit].dirty = m_registers[unit].keep = true;
    return unit;
}

/// Values that are bits of the register as it is now get a copy.
void RegisterAllocator::detachValues(Unit unit)
{
    if (m_registers[unit].first == NoRegister)
        return;
    const Unit to = take(Bank::General);
    copy(unit, to);
    for (IrRegister number = m_registers[unit].first; number != NoRegister; number = m_values[number].next)
        m_values[number].unit = static_cast<std::uint8_t>(to);
    m_registers[to].first = m_registers[unit].first;
    m_registers[unit].first = NoRegister;
}

void RegisterAllocator::settle()
{
    for (std::uint32_t cached = m_cached; cached != 0; cached &= cached - 1)
        writeBack(static_cast<Unit>(std::countr_zero(cached)));
    forPending([](const Value&) { return true; });
    for (const Register& r : m_registers) {
        for (IrRegister number = r.first; number != NoRegister; number = m_values[number].next)
            spill(number);
    }
}

void RegisterAllocator::forget()
{
    restrictTo({});
}

Snapshot RegisterAllocator::snapshot() const
{
    Snapshot out;
    for (Unit unit = 0; unit < m_registers.size(); ++unit)
        out.memory[unit] = m_registers[unit].memory;
    return out;
}

void RegisterAllocator::restrictTo(const Snapshot& snapshot)
{
    settle();
    for (Unit unit = 0; unit < m_registers.size(); ++unit) {
        Register& r = m_registers[unit];
        for (IrRegister number = r.first; number != NoRegister; number = m_values[number].next)
            m_values[number].where = Value::Where::Slot;
        r.first = NoRegister;
        if (r.memory.bytes != 0 && r.memory != snapshot.memory[unit])
            dropMemory(unit);
        release(unit);
    }
}

void RegisterAllocator::restore(const Snapshot& snapshot)
{
    for (Unit unit = 0; unit < m_registers.size(); ++unit) {
        m_registers[unit] = {};
        if (snapshot.memory[unit].bytes != 0)
            setMemory(unit, snapshot.memory[unit], true);
    }
}

} // namespace camwright::native
