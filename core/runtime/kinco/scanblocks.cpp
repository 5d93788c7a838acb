#include "core/runtime/kinco/scanblocks.h"

#include "core/runtime/kinco/exchangestate.h"

#include <algorithm>

namespace camwright::kinco {

namespace {

/// Operands of MC_STATE.
enum StatePin : std::size_t { Axis, Pos, Home, Cw, Ccw, Run, Fault, Input, Limit, ErrCode, APos, AVel, Online };

float realOf(PinValues& pins, std::int8_t pin)
{
    return static_cast<float>(pins.read(static_cast<std::uint8_t>(pin)).asDouble());
}

template <class T>
T integerOf(PinValues& pins, std::int8_t pin)
{
    return static_cast<T>(pins.read(static_cast<std::size_t>(pin)).asInteger());
}

void writeInteger(PinValues& pins, std::int8_t pin, std::uint32_t value)
{
    const std::size_t index = static_cast<std::uint8_t>(pin);
    pins.write(index, Value::ofInteger(pins.block().pins[index].type, value));
}

} // namespace

ScanBlocks::ScanBlocks(const CallSites& sites, std::size_t axes) : m_sites(sites), m_memory(sites.sites.size())
{
    m_commands.calls.resize(sites.sites.size());
    m_commands.lists.resize(sites.lists);
    m_reports.calls.resize(sites.sites.size());
    m_reports.lists.resize(sites.lists);
    m_reports.axes.resize(axes);
}

void ScanBlocks::startProgram()
{
    for (Memory& memory : m_memory)
        memory = {};
    for (CallInputs& call : m_commands.calls) {
        call.enabled = false;
        call.exec = false;
    }
}

void ScanBlocks::call(InstructionId instruction, const BlockInstance& instance, PinValues& pins)
{
    if (instruction == InstructionId::KincoMcState) {
        if (instance.enabled)
            showState(pins);
        return;
    }
    const CallSite& site = m_sites.sites[instance.number];
    if (!site.pins)
        return;
    CallInputs& inputs = m_commands.calls[instance.number];
    inputs.enabled = instance.enabled;
    if (instance.enabled)
        collect(site, instance.number, pins);
    if (instance.enabled || !m_memory[instance.number].shown)
        show(site, instance.number, pins);
}

void ScanBlocks::collect(const CallSite& site, std::uint32_t number, PinValues& pins)
{
    const PinTable& at = *site.pins;
    CallInputs& inputs = m_commands.calls[number];
    const bool exec = pins.read(static_cast<std::size_t>(at.exec)).asBool();
    const bool rose = exec && !m_memory[number].exec;
    const bool fell = !exec && m_memory[number].exec;
    m_memory[number].exec = exec;
    inputs.exec = exec;
    if (at.position != PinTable::None)
        inputs.position = realOf(pins, at.position);
    if (at.velocity != PinTable::None)
        inputs.velocity = realOf(pins, at.velocity);
    if (rose || (fell && site.instruction == InstructionId::KincoMcPower))
        start(site, number, pins);
}

void ScanBlocks::start(const CallSite& site, std::uint32_t number, PinValues& pins)
{
    const PinTable& at = *site.pins;
    CallInputs& inputs = m_commands.calls[number];
    ++inputs.execution;
    inputs.axis = integerOf<std::int16_t>(pins, at.axis);
    if (at.mode != PinTable::None)
        inputs.mode = integerOf<std::int16_t>(pins, at.mode);
    if (at.time != PinTable::None)
        inputs.timeMs = integerOf<std::uint32_t>(pins, at.time);
    if (at.count != PinTable::None)
        inputs.count = integerOf<std::int16_t>(pins, at.count);
    if (at.ids != PinTable::None)
        readList(site, number, pins);
    m_memory[number].shown = false;
    m_memory[number].written = 0;
}

/// A list that would leave its area makes the count illegal, so that nothing is executed.
void ScanBlocks::readList(const CallSite& site, std::uint32_t number, PinValues& pins)
{
    const PinTable& at = *site.pins;
    CallInputs& inputs = m_commands.calls[number];
    ParameterList& list = m_commands.lists[site.list];
    const auto count = static_cast<std::uint32_t>(std::clamp<int>(inputs.count, 0, kMaxParameters));
    for (std::uint32_t i = 0; i < count; ++i) {
        const auto id = pins.element(static_cast<std::size_t>(at.ids), i);
        const auto cell = pins.element(static_cast<std::size_t>(at.cells), i);
        if (!id || !cell) {
            inputs.count = 0;
            return;
        }
        list.numbers[i] = static_cast<std::uint8_t>(pins.memory().read(*id).bits);
        list.values[i] = static_cast<std::uint32_t>(pins.memory().read(*cell).bits);
    }
}

void ScanBlocks::show(const CallSite& site, std::uint32_t number, PinValues& pins)
{
    const PinTable& at = *site.pins;
    const std::uint32_t execution = m_commands.calls[number].execution;
    if (execution == 0)
        return; // never started: the outputs are the program's
    static const CallResult none;
    const CallResult& reported = m_reports.calls[number];
    const CallResult& result = reported.execution == execution ? reported : none;
    pins.write(static_cast<std::size_t>(at.done), result.done);
    pins.write(static_cast<std::size_t>(at.error), result.error);
    writeInteger(pins, at.errorId, result.errorId);
    if (at.active != PinTable::None)
        pins.write(static_cast<std::size_t>(at.active), result.active);
    if (site.instruction == InstructionId::KincoMcRparas && result.valid != m_memory[number].written)
        showCells(site, number, pins);
    m_memory[number].shown = result.done && !result.active;
}

void ScanBlocks::showCells(const CallSite& site, std::uint32_t number, PinValues& pins)
{
    const std::uint32_t fresh = m_reports.calls[number].valid & ~m_memory[number].written;
    for (std::uint32_t i = 0; i < kMaxParameters; ++i) {
        if (!(fresh >> i & 1u))
            continue;
        const auto cell = pins.element(static_cast<std::size_t>(site.pins->cells), i);
        if (cell)
            pins.memory().write(*cell, Value{cell->type, m_reports.lists[site.list].values[i]});
    }
    m_memory[number].written |= fresh;
}

void ScanBlocks::showState(PinValues& pins) const
{
    const std::int64_t number = pins.read(Axis).asInteger();
    static const AxisView absent;
    const bool known = number >= 1 && number <= static_cast<std::int64_t>(m_reports.axes.size());
    const AxisView& view = known ? m_reports.axes[static_cast<std::size_t>(number - 1)] : absent;
    pins.write(Pos, view.reached);
    pins.write(Home, view.homed);
    pins.write(Cw, view.forward);
    pins.write(Ccw, view.backward);
    pins.write(Run, view.running);
    pins.write(Fault, view.fault);
    writeInteger(pins, Input, view.inputs);
    pins.write(Limit, view.limit);
    writeInteger(pins, ErrCode, view.errorCode);
    pins.write(APos, Value::ofReal(view.position));
    pins.write(AVel, Value::ofReal(view.velocity));
    writeInteger(pins, Online, view.online ? 0 : 1);
}

void ScanBlocks::save(ByteWriter& writer) const
{
    for (const Memory& memory : m_memory) {
        writer.put(memory.exec);
        writer.put(memory.shown);
        writer.put(memory.written);
    }
    saveCommands(writer, m_commands);
    saveReports(writer, m_reports);
}

void ScanBlocks::restore(ByteReader& reader)
{
    for (Memory& memory : m_memory) {
        memory.exec = reader.getBool();
        memory.shown = reader.getBool();
        memory.written = reader.get<std::uint32_t>();
    }
    restoreCommands(reader, m_commands);
    restoreReports(reader, m_reports);
}

} // namespace camwright::kinco
