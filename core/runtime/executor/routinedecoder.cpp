#include "core/runtime/executor/routinedecoder.h"

#include "core/runtime/executor/handlers.h"

#include <algorithm>

namespace camwright {

namespace {

std::uint8_t maskOf(const IrAddress& address)
{
    return address.bit == IrAddress::WholeByte ? std::uint8_t{0xFF} : static_cast<std::uint8_t>(1u << address.bit);
}

bool mayJump(IrOp op)
{
    return shapeOf(op).index == IrShape::Index::Target;
}

/// Nothing but a value comes of it, so it is left out when nobody uses that.
bool isPure(IrOp op)
{
    return op != IrOp::Div && op != IrOp::Mod && op != IrOp::Sqrt;
}

void invert(std::vector<Contact>& chain)
{
    chain.back().flags ^= chain.size() == 1 ? Contact::Negated : Contact::InvertResult;
}

} // namespace

void RoutineDecoder::run()
{
    m_firstGuard = m_out.guards.size();
    countUses();
    findLabels();
    for (m_at = 0; m_at < m_routine.code.size(); ++m_at) {
        if (m_isLabel[m_at])
            flush();
        m_stepOf[m_at] = static_cast<std::uint32_t>(m_out.steps.size());
        decode(m_routine.code[m_at]);
    }
    flush();
    m_stepOf[m_at] = static_cast<std::uint32_t>(m_out.steps.size());
    emit(returnFromRoutine, 0, 0, m_at);
    for (const std::uint32_t at : m_jumps)
        m_out.steps[at].dest = m_stepOf[m_out.steps[at].dest];
    for (std::size_t at = m_firstGuard; at < m_out.guards.size(); ++at)
        m_out.guards[at].elseStep = m_stepOf[m_out.guards[at].elseInstruction];
}

void RoutineDecoder::countUses()
{
    m_registers.resize(m_routine.registers);
    for (const IrInstruction& i : m_routine.code) {
        const IrShape& shape = shapeOf(i.op);
        if (shape.a)
            ++m_registers[i.a].uses;
        if (shape.b)
            ++m_registers[i.b].uses;
        if (shape.index == IrShape::Index::Register)
            ++m_registers[i.index].uses;
    }
}

void RoutineDecoder::findLabels()
{
    m_isLabel.assign(m_routine.code.size() + 1, false);
    m_stepOf.assign(m_routine.code.size() + 1, 0);
    bool goesBack = false;
    for (std::uint32_t at = 0; at < m_routine.code.size(); ++at) {
        if (!mayJump(m_routine.code[at].op))
            continue;
        m_isLabel[m_routine.code[at].index] = true;
        goesBack |= m_routine.code[at].index <= at;
    }
    m_slots.beginRoutine(!goesBack);
}

void RoutineDecoder::decode(const IrInstruction& i)
{
    switch (i.op) {
    case IrOp::Nop: return;
    case IrOp::Jump:
    case IrOp::JumpIf:
    case IrOp::JumpIfNot: return decodeJump(i);
    case IrOp::Call:
        flush();
        return emit(callRoutine, i.index, 0, m_at);
    case IrOp::Return:
        flush();
        return emit(returnFromRoutine, 0, 0, m_at);
    case IrOp::Const:
        m_registers[i.dest].state = Operand::State::Constant;
        m_registers[i.dest].type = i.type;
        m_registers[i.dest].offset = m_constants.offsetOf(i.constant);
        return;
    case IrOp::Load: return decodeLoad(i);
    case IrOp::Store: return decodeStore(i);
    case IrOp::RisingEdge:
    case IrOp::FallingEdge: return decodeEdge(i);
    case IrOp::Timer:
    case IrOp::TimerReset:
    case IrOp::Counter:
    case IrOp::CounterArm:
    case IrOp::CounterReset:
    case IrOp::Block: return decodeElement(i);
    default: break;
    }
    if (decodePlace(i))
        return;
    if (!isPure(i.op) && m_out.hasErrorFlag)
        flush(); // a failure writes the flag, which pending operands may read
    const bool isContactLogic = i.op == IrOp::Not || i.op == IrOp::And || i.op == IrOp::Or;
    if (isContactLogic && i.type == DataType::Bool)
        decodeBool(i);
    else
        decodeComputing(i);
}

void RoutineDecoder::decodeLoad(const IrInstruction& i)
{
    Operand& operand = m_registers[i.dest];
    if (i.address.area == InstanceArea) {
        if (operand.uses > 0)
            emit(loadInstanceHandler(i.type), defineSlot(i.dest, i.type), memoryOffset(i.address));
        return;
    }
    operand.state = Operand::State::Memory;
    operand.type = i.type;
    operand.offset = memoryOffset(i.address);
    operand.mask = maskOf(i.address);
    if (operand.uses > 0)
        m_pending.push_back(i.dest);
}

void RoutineDecoder::decodeBool(const IrInstruction& i)
{
    if (i.op == IrOp::Not) {
        std::vector<Contact> chain = chainOf(i.a);
        invert(chain);
        return define(i.dest, DataType::Bool, std::move(chain));
    }
    // The operand that is but one contact goes to the end of the other one's chain.
    const bool keepOrder = isSingleContact(i.b) || !isSingleContact(i.a);
    const IrRegister first = keepOrder ? i.a : i.b;
    const IrRegister second = keepOrder ? i.b : i.a;
    if (!isSingleContact(second))
        writeDown(m_registers[second]);
    std::vector<Contact> chain = chainOf(first);
    Contact last = chainOf(second).front();
    last.flags = static_cast<std::uint8_t>((last.flags & Contact::Negated) | (i.op == IrOp::Or ? Contact::Or : 0));
    chain.push_back(last);
    define(i.dest, DataType::Bool, std::move(chain));
}

void RoutineDecoder::decodeComputing(const IrInstruction& i)
{
    const IrShape& shape = shapeOf(i.op);
    const std::uint32_t a = offsetOf(i.a);
    const std::uint32_t b = shape.b ? offsetOf(i.b) : 0;
    if (isPure(i.op) && m_registers[i.dest].uses == 0)
        return;
    const Handler handler = computingHandler(i.op, i.type, i.from);
    const DataType type = resultType(i.op, i.type);
    const std::uint32_t at = m_at;
    if (type != DataType::Bool && isStoreOf(m_at + 1, i.dest, type)) {
        flush();
        ++m_at;
        m_stepOf[m_at] = static_cast<std::uint32_t>(m_out.steps.size());
        return emit(handler, memoryOffset(m_routine.code[m_at].address), a, b, at);
    }
    emit(handler, defineSlot(i.dest, type), a, b, at);
}

void RoutineDecoder::decodeStore(const IrInstruction& i)
{
    const std::uint32_t dest = memoryOffset(i.address);
    if (i.address.area == InstanceArea) {
        const std::uint32_t source = offsetOf(i.a);
        flush();
        return emit(storeInstanceHandler(i.type), dest, source);
    }
    if (i.type != DataType::Bool) {
        const std::uint32_t source = offsetOf(i.a);
        flush();
        return emit(copyHandler(i.type), dest, source);
    }
    const std::vector<Contact> chain = chainOf(i.a);
    flush();
    if (i.address.bit == IrAddress::WholeByte)
        emit(networkHandler(NetworkEnding::Byte, chain.size()), dest, emitContacts(chain));
    else
        emit(networkHandler(NetworkEnding::Bit, chain.size()), dest, emitContacts(chain), 0, maskOf(i.address));
}

void RoutineDecoder::decodeJump(const IrInstruction& i)
{
    if (i.op == IrOp::Jump) {
        flush();
        m_jumps.push_back(static_cast<std::uint32_t>(m_out.steps.size()));
        return emit(jump, i.index, 0, m_at, i.index);
    }
    const std::vector<Contact> chain = chainOf(i.a);
    flush();
    m_jumps.push_back(static_cast<std::uint32_t>(m_out.steps.size()));
    const NetworkEnding ending = i.op == IrOp::JumpIf ? NetworkEnding::JumpIf : NetworkEnding::JumpIfNot;
    emit(networkHandler(ending, chain.size()), i.index, emitContacts(chain), m_at, i.index);
}

void RoutineDecoder::decodeEdge(const IrInstruction& i)
{
    const std::uint32_t input = offsetOf(i.a);
    emit(i.op == IrOp::RisingEdge ? risingEdge : fallingEdge, defineSlot(i.dest, DataType::Bool), input, 0,
         m_memory.stateOffset() + i.index);
}

void RoutineDecoder::decodeElement(const IrInstruction& i)
{
    const IrShape& shape = shapeOf(i.op);
    const std::uint32_t a = offsetOf(i.a);
    const std::uint32_t b = shape.b ? offsetOf(i.b) : 0;
    flush();
    const std::uint32_t dest = shape.dest ? defineSlot(i.dest, DataType::Bool) : 0;
    switch (i.op) {
    case IrOp::Timer: return emit(timerHandler(m_out.timers[i.index].kind), dest, a, b, i.index);
    case IrOp::TimerReset: return emit(resetTimer, dest, a, b, i.index);
    case IrOp::Counter: return emit(counterHandler(m_out.counters[i.index].isWide), dest, a, b, i.index);
    case IrOp::CounterArm: return emit(armCounter, dest, a, b, i.index);
    case IrOp::CounterReset: return emit(resetCounter, dest, a, b, i.index);
    default: return emit(callBlock, dest, a, b, i.index);
    }
}

std::uint32_t RoutineDecoder::offsetOf(IrRegister number)
{
    Operand& operand = m_registers[number];
    // A BOOL in memory may be a bit of a byte, or a byte that is neither 0 nor 1.
    const bool isBoolInMemory = operand.state == Operand::State::Memory && operand.type == DataType::Bool;
    if (operand.state == Operand::State::Network || isBoolInMemory)
        writeDown(operand);
    used(operand);
    return operand.offset;
}

std::vector<Contact> RoutineDecoder::chainOf(IrRegister number)
{
    Operand& operand = m_registers[number];
    used(operand);
    if (operand.state == Operand::State::Network)
        return std::move(operand.contacts);
    const bool isMemory = operand.state == Operand::State::Memory;
    return {{operand.offset, isMemory ? operand.mask : std::uint8_t{0xFF}, Contact::Or}};
}

bool RoutineDecoder::isSingleContact(IrRegister number) const
{
    const Operand& operand = m_registers[number];
    return operand.state != Operand::State::Network || operand.contacts.size() == 1;
}

void RoutineDecoder::used(Operand& operand)
{
    if (--operand.uses == 0 && operand.state == Operand::State::Slot)
        m_slots.giveBack(operand.offset);
}

/// A chain that several instructions use is written once, one that a single one uses becomes part of it.
void RoutineDecoder::define(IrRegister number, DataType type, std::vector<Contact> chain)
{
    Operand& operand = m_registers[number];
    operand.type = type;
    if (operand.uses == 0)
        return;
    operand.state = Operand::State::Network;
    operand.contacts = std::move(chain);
    if (operand.uses > 1)
        writeDown(operand);
    else
        m_pending.push_back(number);
}

std::uint32_t RoutineDecoder::defineSlot(IrRegister number, DataType type)
{
    Operand& operand = m_registers[number];
    operand.state = Operand::State::Slot;
    operand.type = type;
    operand.offset = m_slots.take();
    if (operand.uses == 0)
        m_slots.giveBack(operand.offset);
    return operand.offset;
}

/// Computes a pending operand now, into a slot of its own.
void RoutineDecoder::writeDown(Operand& operand)
{
    const std::uint32_t slot = m_slots.take();
    if (operand.type != DataType::Bool) {
        emit(copyHandler(operand.type), slot, operand.offset);
    } else {
        if (operand.state != Operand::State::Network)
            operand.contacts = {{operand.offset, operand.mask, Contact::Or}};
        emit(networkHandler(NetworkEnding::Byte, operand.contacts.size()), slot, emitContacts(operand.contacts));
        operand.contacts.clear();
    }
    operand.state = Operand::State::Slot;
    operand.offset = slot;
}

void RoutineDecoder::flush()
{
    for (const IrRegister number : m_pending) {
        Operand& operand = m_registers[number];
        if (operand.uses > 0 && operand.state != Operand::State::Slot)
            writeDown(operand);
    }
    m_pending.clear();
    m_slots.settle();
}

void RoutineDecoder::emit(Handler run, std::uint32_t dest, std::uint32_t a, std::uint32_t b, std::uint32_t extra)
{
    m_out.steps.push_back({run, dest, a, b, extra});
}

std::uint32_t RoutineDecoder::emitContacts(const std::vector<Contact>& chain)
{
    const auto first = static_cast<std::uint32_t>(m_out.contacts.size());
    m_out.contacts.insert(m_out.contacts.end(), chain.begin(), chain.end());
    m_out.contacts.back().flags |= Contact::Last;
    return first;
}

bool RoutineDecoder::isStoreOf(std::size_t at, IrRegister number, DataType type) const
{
    if (at >= m_routine.code.size() || m_isLabel[at] || m_registers[number].uses != 1)
        return false;
    const IrInstruction& next = m_routine.code[at];
    return next.op == IrOp::Store && next.address.area != InstanceArea && next.a == number && next.type == type;
}

} // namespace camwright
