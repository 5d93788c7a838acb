#include "core/runtime/native/registerallocator.h"

#include <bit>

namespace camwright::native {

namespace {

constexpr std::uint32_t unitsOf(Bank bank)
{
    return bank == Bank::General ? GeneralUnits : FloatUnits;
}

/// Loads waiting to be used are looked at one by one before a store, so there are only a few.
constexpr std::size_t GreatestPending = 24;

constexpr bool isNarrow(DataType type)
{
    return type == DataType::Byte || type == DataType::Usint || type == DataType::Sint || type == DataType::Word
        || type == DataType::Uint || type == DataType::Int;
}

} // namespace

Bank bankOf(DataType type)
{
    return isFloat(type) ? Bank::Float : Bank::General;
}

void RegisterAllocator::beginRoutine(const IrRoutine& routine)
{
    m_values.assign(routine.registers, Value{});
    m_pending.clear();
    m_registers.fill({});
    m_free = GeneralUnits | FloatUnits;
    m_held = m_cached = 0;
    for (const IrInstruction& i : routine.code) {
        const IrShape& shape = shapeOf(i.op);
        if (shape.a)
            ++m_values[i.a].uses;
        if (shape.b)
            ++m_values[i.b].uses;
        if (shape.index == IrShape::Index::Register)
            ++m_values[i.index].uses;
    }
}

void RegisterAllocator::endInstruction()
{
    for (std::uint32_t held = m_held; held != 0; held &= held - 1) {
        const auto unit = static_cast<Unit>(std::countr_zero(held));
        if (m_registers[unit].isEmpty())
            m_free |= bitOf(unit);
    }
    m_held = 0;
    m_slots.settle();
    ++m_clock;
}

Unit RegisterAllocator::take(Bank bank)
{
    const std::uint32_t free = m_free & unitsOf(bank) & ~m_held;
    const Unit unit = free != 0 ? static_cast<Unit>(std::countr_zero(free)) : evictOne(unitsOf(bank) & ~m_held);
    hold(unit);
    return unit;
}

void RegisterAllocator::takeFixed(Unit unit)
{
    if ((m_free & bitOf(unit)) == 0 && !m_registers[unit].isEmpty())
        evict(unit);
    hold(unit);
}

/// The one that costs least, and of those the one untouched longest.
Unit RegisterAllocator::evictOne(std::uint32_t candidates)
{
    Unit best = NoUnit;
    std::uint64_t bestCost = UINT64_MAX;
    for (; candidates != 0; candidates &= candidates - 1) {
        const auto unit = static_cast<Unit>(std::countr_zero(candidates));
        const Register& r = m_registers[unit];
        const std::uint64_t age = m_clock - r.touched;
        const std::uint64_t cost = (std::uint64_t{r.first != NoRegister || r.dirty} << 32) + (0xFFFFFFFF - age);
        if (cost < bestCost) {
            bestCost = cost;
            best = unit;
        }
    }
    evict(best);
    return best;
}

void RegisterAllocator::evict(Unit unit)
{
    writeBack(unit);
    const Register held = m_registers[unit];
    m_registers[unit] = {};
    m_cached &= ~bitOf(unit);
    for (IrRegister number = held.first; number != NoRegister;) {
        const IrRegister next = m_values[number].next;
        // Spilling reads the register, which still has its bits.
        evictValue(number, held);
        number = next;
    }
    m_free |= bitOf(unit);
}

/// A value that memory still holds is read from there again.
void RegisterAllocator::evictValue(IrRegister number, const Register& from)
{
    Value& value = m_values[number];
    const bool isInMemory = value.type == DataType::Bool ? value.bit < 8 * from.memory.bytes : byteWidth(value.type) <= from.memory.bytes;
    if (m_mayGoBack && value.slot == Value::NoSlot && isInMemory && m_pending.size() < GreatestPending) {
        value.where = Value::Where::Memory;
        value.content = from.memory.offset;
        value.keep = from.keep;
        if (value.type == DataType::Bool) {
            value.content += value.bit / 8u;
            value.bit %= 8;
        }
        m_pending.push_back(number);
        return;
    }
    spill(number);
    value.where = Value::Where::Slot;
}

void RegisterAllocator::spill(IrRegister number)
{
    Value& value = m_values[number];
    if (value.slot != Value::NoSlot)
        return;
    value.slot = m_slots.take();
    if (value.unit >= FirstFloat)
        m_asm.emit(value.type == DataType::Real ? x86::Inst::kIdMovss : x86::Inst::kIdMovsd, at(value.slot, 0), floatRegister(value.unit));
    else if (byteWidth(value.type) == 8)
        m_asm.mov(at(value.slot, 8), x86::gpq(value.unit));
    else
        m_asm.mov(at(value.slot, 4), x86::gpd(value.unit));
}

void RegisterAllocator::writeBack(Unit unit)
{
    Register& r = m_registers[unit];
    if (!r.dirty)
        return;
    m_asm.mov(at(r.memory.offset, 1), x86::gpb(unit));
    r.dirty = false;
}

void RegisterAllocator::hold(Unit unit)
{
    m_held |= bitOf(unit);
    m_free &= ~bitOf(unit);
    m_registers[unit].touched = m_clock;
}

void RegisterAllocator::release(Unit unit)
{
    if (m_registers[unit].isEmpty() && (m_held & bitOf(unit)) == 0)
        m_free |= bitOf(unit) & (GeneralUnits | FloatUnits);
}

void RegisterAllocator::consume(IrRegister number)
{
    Value& value = m_values[number];
    if (--value.uses > 0)
        return;
    if (value.where == Value::Where::Register)
        unlink(number);
    if (value.slot != Value::NoSlot)
        m_slots.giveBack(value.slot);
    value.where = Value::Where::Nowhere;
}

void RegisterAllocator::use(IrRegister number)
{
    consume(number);
}

void RegisterAllocator::link(IrRegister number, Unit unit)
{
    Value& value = m_values[number];
    value.where = Value::Where::Register;
    value.unit = static_cast<std::uint8_t>(unit);
    value.next = m_registers[unit].first;
    m_registers[unit].first = number;
    m_registers[unit].touched = m_clock;
    m_free &= ~bitOf(unit);
}

void RegisterAllocator::unlink(IrRegister number)
{
    const Value& value = m_values[number];
    IrRegister* at = &m_registers[value.unit].first;
    while (*at != number)
        at = &m_values[*at].next;
    *at = value.next;
    release(value.unit);
}

void RegisterAllocator::setMemory(Unit unit, const Range& range, bool keep)
{
    Register& r = m_registers[unit];
    r.memory = range;
    r.keep = keep;
    m_cached |= bitOf(unit);
    m_free &= ~bitOf(unit);
}

void RegisterAllocator::dropMemory(Unit unit)
{
    Register& r = m_registers[unit];
    r.memory = {};
    r.dirty = r.keep = false;
    m_cached &= ~bitOf(unit);
    release(unit);
}

Unit RegisterAllocator::find(const Range& range, Bank bank) const
{
    for (std::uint32_t cached = m_cached & unitsOf(bank); cached != 0; cached &= cached - 1) {
        const auto unit = static_cast<Unit>(std::countr_zero(cached));
        if (m_registers[unit].memory == range)
            return unit;
    }
    return NoUnit;
}

// --- operands -------------------------------------------------------------------------------------------------------

/// Brings a value into a machine register and holds it there. A constant is not linked to it: it is cheap to make again.
Unit RegisterAllocator::bring(IrRegister number)
{
    Value& value = m_values[number];
    if (value.where == Value::Where::Register) {
        hold(value.unit);
        return value.unit;
    }
    if (value.where == Value::Where::Memory && value.bit != Value::WholeByte) {
        const Range range{static_cast<std::uint32_t>(value.content), byteWidth(value.type)};
        if (const Unit unit = find(range, bankOf(value.type)); unit != NoUnit) {
            value.extended = false;
            link(number, unit);
            hold(unit);
            return unit;
        }
    }
    const Unit unit = take(bankOf(value.type));
    switch (value.where) {
    case Value::Where::Constant: bringConstant(value, unit); return unit;
    case Value::Where::Memory: bringLoad(number, unit); break;
    default:
        if (unit >= FirstFloat)
            m_asm.emit(value.type == DataType::Real ? x86::Inst::kIdMovss : x86::Inst::kIdMovsd, floatRegister(unit), at(value.slot, 0));
        else if (byteWidth(value.type) == 8)
            m_asm.mov(x86::gpq(unit), at(value.slot, 8));
        else
            m_asm.mov(x86::gpd(unit), at(value.slot, 4));
        break;
    }
    link(number, unit);
    return unit;
}

void RegisterAllocator::bringConstant(const Value& value, Unit unit)
{
    if (unit >= FirstFloat) {
        const x86::Mem constant = at(m_constants.offsetOf(value.content), 0);
        m_asm.emit(value.type == DataType::Real ? x86::Inst::kIdMovss : x86::Inst::kIdMovsd, floatRegister(unit), constant);
        return;
    }
    std::uint64_t bits = value.content;
    if (isSigned(value.type) && byteWidth(value.type) < 4) // as extended as a register that was loaded
        bits = static_cast<std::uint32_t>(byteWidth(value.type) == 1 ? static_cast<std::int8_t>(bits) : static_cast<std::int16_t>(bits));
    if (bits == 0)
        m_asm.xor_(x86::gpd(unit), x86::gpd(unit));
    else if (bits <= 0xFFFFFFFF)
        m_asm.mov(x86::gpd(unit), static_cast<std::uint32_t>(bits));
    else
        m_asm.mov(x86::gpq(unit), bits);
}

void RegisterAllocator::bringLoad(IrRegister number, Unit unit)
{
    Value& value = m_values[number];
    const Range range{static_cast<std::uint32_t>(value.content), byteWidth(value.type)};
    const bool isWholeByte = value.type == DataType::Bool && value.bit == Value::WholeByte;
    const Value loaded = loadInto(unit, value.type, at(range.offset, range.bytes), isWholeByte);
    value.extended = loaded.extended;
    if (isWholeByte)
        value.bit = loaded.bit;
    else if (value.keep)
        setMemory(unit, range, true);
}

Value RegisterAllocator::loadInto(Unit unit, DataType type, const x86::Mem& source, bool isWholeByte)
{
    Value out;
    if (type == DataType::Real) {
        m_asm.movss(floatRegister(unit), source);
    } else if (type == DataType::Lreal) {
        m_asm.movsd(floatRegister(unit), source);
    } else if (byteWidth(type) < 4) {
        m_asm.emit(isSigned(type) ? x86::Inst::kIdMovsx : x86::Inst::kIdMovzx, x86::gpd(unit), source);
        out.extended = true;
    } else {
        m_asm.mov(generalRegister(unit, byteWidth(type)), source);
    }
    if (isWholeByte) { // any number but 0 is TRUE: negated, it has bits 8 to 31 set
        m_asm.neg(x86::gpd(unit));
        out.bit = 8;
    }
    return out;
}

void RegisterAllocator::extend(Unit from, Unit to, DataType type)
{
    m_asm.emit(isSigned(type) ? x86::Inst::kIdMovsx : x86::Inst::kIdMovzx, x86::gpd(to), generalRegister(from, byteWidth(type)));
}

void RegisterAllocator::copy(Unit from, Unit to)
{
    if (from >= FirstFloat)
        m_asm.movaps(floatRegister(to), floatRegister(from));
    else
        m_asm.mov(x86::gpq(to), x86::gpq(from));
}

x86::Gp RegisterAllocator::general(IrRegister number, Width width)
{
    Unit unit = bring(number);
    Value& value = m_values[number];
    const bool isConstant = value.where == Value::Where::Constant;
    if (width == Width::Extended && isNarrow(value.type) && !value.extended && !isConstant) {
        const bool isAlone = m_registers[unit].first == number && value.next == NoRegister && value.slot == Value::NoSlot;
        const Unit to = isAlone ? unit : take(Bank::General);
        extend(unit, to, value.type);
        value.extended = isAlone;
        unit = to;
    }
    const unsigned bytes = byteWidth(value.type) == 8 ? 8 : 4;
    consume(number);
    return generalRegister(unit, bytes);
}

x86::Xmm RegisterAllocator::floating(IrRegister number)
{
    const Unit unit = bring(number);
    consume(number);
    return floatRegister(unit);
}

bool RegisterAllocator::mayTakeOver(Unit unit) const
{
    const Register& r = m_registers[unit];
    return r.first == NoRegister && (r.memory.bytes == 0 || (!r.dirty && !r.keep));
}

Unit RegisterAllocator::takeOver(Unit unit)
{
    if (mayTakeOver(unit)) {
        dropMemory(unit);
        return unit;
    }
    const Unit to = take(unit >= FirstFloat ? Bank::Float : Bank::General);
    copy(unit, to);
    return to;
}

Unit RegisterAllocator::freeGeneral(Unit unit, DataType type, bool mustExtend)
{
    if (!mustExtend)
        return takeOver(unit);
    Unit to = unit;
    if (mayTakeOver(unit))
        dropMemory(unit);
    else
        to = take(Bank::General);
    extend(unit, to, type);
    return to;
}

x86::Gp RegisterAllocator::ownGeneral(IrRegister number, Width width)
{
    const Unit unit = bring(number);
    const Value& value = m_values[number];
    const bool isConstant = value.where == Value::Where::Constant;
    const bool mustExtend = width == Width::Extended && isNarrow(value.type) && !value.extended && !isConstant;
    const DataType type = value.type;
    consume(number);
    return generalRegister(freeGeneral(unit, type, mustExtend), byteWidth(type) == 8 ? 8 : 4);
}

x86::Xmm RegisterAllocator::ownFloating(IrRegister number)
{
    const Unit unit = bring(number);
    consume(number);
    return floatRegister(takeOver(unit));
}

bool RegisterAllocator::isOwnable(IrRegister number) const
{
    const Value& value = m_values[number];
    if (value.where != Value::Where::Register || value.uses != 1)
        return false;
    const Register& r = m_registers[value.unit];
    return r.first == number && value.next == NoRegister && (r.memory.bytes == 0 || (!r.dirty && !r.keep));
}

asmjit::Operand RegisterAllocator::source(IrRegister number)
{
    const Value& value = m_values[number];
    const unsigned bytes = byteWidth(value.type);
    if (value.where == Value::Where::Constant) {
        const auto number64 = static_cast<std::int64_t>(value.content << (64 - 8 * bytes)) >> (64 - 8 * bytes);
        if (number64 == static_cast<std::int32_t>(number64)) {
            consume(number);
            return asmjit::imm(number64);
        }
    }
    const bool fromMemory = value.where == Value::Where::Memory && !value.keep && value.type != DataType::Bool;
    if (fromMemory || value.where == Value::Where::Slot) {
        const x86::Mem memory = at(fromMemory ? static_cast<std::uint32_t>(value.content) : value.slot, bytes);
        consume(number);
        return memory;
    }
    const Unit unit = bring(number);
    consume(number);
    return generalRegister(unit, bytes);
}

asmjit::Operand RegisterAllocator::floatSource(IrRegister number)
{
    const Value& value = m_values[number];
    const unsigned bytes = byteWidth(value.type);
    std::uint32_t offset = value.slot;
    if (value.where == Value::Where::Constant)
        offset = m_constants.offsetOf(value.content);
    else if (value.where == Value::Where::Memory && !value.keep)
        offset = static_cast<std::uint32_t>(value.content);
    else if (value.where != Value::Where::Slot)
        return floating(number);
    consume(number);
    return at(offset, bytes);
}

Unit RegisterAllocator::bringBool(IrRegister number)
{
    return bring(number);
}

// --- results --------------------------------------------------------------------------------------------------------

void RegisterAllocator::define(IrRegister number, DataType type, Unit unit, bool extended, bool clean)
{
    Value& value = m_values[number];
    value.type = type;
    value.extended = extended;
    value.clean = clean;
    if (value.uses > 0)
        link(number, unit);
}

void RegisterAllocator::defineBool(IrRegister number, Unit unit, unsigned bit, bool inverted, bool clean)
{
    Value& value = m_values[number];
    value.bit = static_cast<std::uint8_t>(bit);
    value.inverted = inverted;
    define(number, DataType::Bool, unit, false, clean);
}

void RegisterAllocator::defineConstant(IrRegister number, DataType type, std::uint64_t bits)
{
    Value& value = m_values[number];
    value.type = type;
    value.where = Value::Where::Constant;
    value.content = bits;
}

void RegisterAllocator::defineAlias(IrRegister number, IrRegister other, bool invert)
{
    if (m_values[other].where == Value::Where::Constant) {
        defineConstant(number, DataType::Bool, m_values[other].content ^ (invert ? 1u : 0u));
        return;
    }
    const Unit unit = bring(other);
    const Value from = m_values[other];
    defineBool(number, unit, from.bit, from.inverted != invert, from.clean);
}

void RegisterAllocator::defineLoad(IrRegister number, DataType type, std::uint32_t offset, unsigned bit, bool keep)
{
    Value& value = m_values[number];
    value.type = type;
    if (value.uses == 0)
        return;
    value.bit = static_cast<std::uint8_t>(bit);
    value.content = offset;
    value.keep = keep;
    value.where = Value::Where::Memory;
    const Range range{offset, byteWidth(type)};
    const Unit unit = bit == Value::WholeByte ? NoUnit : find(range, bankOf(type));
    if (unit != NoUnit) {
        m_registers[unit].keep = keep || m_registers[unit].dirty;
        link(number, unit);
        return;
    }
    beforeLoad(range);
    addPending(number);
}

void RegisterAllocator::addPending(IrRegister number)
{
    m_pending.push_back(number);
    if (m_pending.size() <= GreatestPending)
        return;
    std::erase_if(m_pending, [this](IrRegister n) { return m_values[n].where != Value::Where::Memory; });
    if (m_pending.size() <= GreatestPending)
        return;
    bringPending(m_pending.front());
}

/// Outside an instruction's operands: the register is not held, and nothing goes back to memory to make room for it.
void RegisterAllocator::bringPending(IrRegister number)
{
    const std::uint32_t held = m_held;
    m_mayGoBack = false;
    bring(number);
    m_mayGoBack = true;
    m_held = held;
}

} // namespace camwright::native
