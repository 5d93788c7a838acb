#include "core/language/lowering/elementtables.h"

namespace camwright {

namespace {

bool hasByteEach(const Family& family, AreaId id)
{
    if (id == VariablesArea)
        return true;
    const AreaKind kind = family.area(id).kind;
    return kind == AreaKind::Bits || ((kind == AreaKind::TimerBits || kind == AreaKind::CounterBits) && !family.area(id).isPacked());
}

/// With Koyo the instruction decides the base, else the number of the timer.
Time baseOf(const Family& family, TimerKind kind, std::uint32_t number)
{
    if (kind == TimerKind::KoyoTmrf || kind == TimerKind::KoyoTmraf)
        return 10ms;
    return kind == TimerKind::KoyoTmr || kind == TimerKind::KoyoTmra ? 100ms : family.timerBase(number);
}

} // namespace

IrAddress irAddress(const Family& family, const Address& address)
{
    const bool hasBit = address.isBit && !hasByteEach(family, address.area);
    return {address.area, hasBit ? address.bit : IrAddress::WholeByte, address.byte};
}

IrAddress ElementTables::place(const Address& address) const
{
    return irAddress(m_family, address);
}

ElementTables::Element ElementTables::elementAt(const Address& address) const
{
    const Address value = m_family.valueOf(address).value_or(address);
    const Address bit = m_family.bitOf(address).value_or(address);
    return {place(value), place(bit), m_family.elementNumber(address)};
}

std::uint32_t ElementTables::stateOf(std::map<std::uint32_t, std::uint32_t>& states, std::uint32_t number, std::uint32_t bytes)
{
    const auto [entry, isNew] = states.try_emplace(number, m_program.stateBytes);
    if (isNew)
        m_program.stateBytes += bytes;
    return entry->second;
}

std::uint32_t ElementTables::timer(TimerKind kind, const Address& element)
{
    const Element e = elementAt(element);
    const auto [entry, isNew] = m_timers.try_emplace({e.number, kind}, static_cast<std::uint32_t>(m_program.timers.size()));
    if (isNew) {
        const std::uint32_t state = stateOf(m_timerStates, e.number, TimerStateBytes);
        m_program.timers.push_back({kind, e.value, e.bit, state, baseOf(m_family, kind, e.number).count()});
    }
    return entry->second;
}

std::uint32_t ElementTables::counter(CounterKind kind, const Address& element)
{
    const Element e = elementAt(element);
    const auto [entry, isNew] = m_counters.try_emplace({e.number, kind}, static_cast<std::uint32_t>(m_program.counters.size()));
    if (isNew) {
        const std::uint32_t state = stateOf(m_counterStates, e.number, CounterStateBytes);
        const bool isWide = kind == CounterKind::KoyoUdc || m_family.counterIs32Bit(e.number);
        const DataType type = isWide ? DataType::Dint : DataType::Int;
        m_program.counters.push_back({kind, type, e.value, e.bit, state});
    }
    return entry->second;
}

IrAddress ElementTables::work(DataType type)
{
    const std::uint32_t width = byteWidth(type);
    const std::uint32_t at = (m_variableBytes + width - 1) / width * width;
    m_variableBytes = at + width;
    return {VariablesArea, IrAddress::WholeByte, at};
}

std::uint32_t ElementTables::edge()
{
    return m_program.stateBytes++;
}

std::uint32_t ElementTables::block(InstructionId instruction, std::vector<IrPin> pins)
{
    const auto number = static_cast<std::uint32_t>(m_program.blocks.size());
    m_program.blocks.push_back({static_cast<std::uint16_t>(instruction), number, std::move(pins)});
    return number;
}

} // namespace camwright
