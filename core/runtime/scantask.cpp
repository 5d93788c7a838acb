#include "core/runtime/scantask.h"

#include "core/runtime/systembits.h"

#include <algorithm>

namespace camwright {

namespace {

bool isLess(const Force& a, const Force& b)
{
    return a.address < b.address;
}

} // namespace

ScanTask::ScanTask(const Family& family, ScanExecutor executor)
    : m_family(family)
    , m_executor(std::move(executor))
    , m_scanTime(family.modelledScanTime())
    , m_period(image().configuration.scanPeriod)
    , m_watchdog(image().configuration.watchdog > Time{0} ? image().configuration.watchdog : kDefaultWatchdog)
{
    for (const MemoryArea& area : family.areas()) {
        if (area.isInput)
            m_inputs.push_back({area.id, std::vector<std::uint8_t>(memory().area(area.id).size())});
    }
}

void ScanTask::powerOn()
{
    memory().powerOn(image().layout);
    m_firstAfterPowerOn = true;
    m_running = m_inScan = false;
    takeInputs();
}

void ScanTask::start(Time now)
{
    std::fill(memory().data() + memory().stateOffset(), memory().data() + memory().scratchOffset(), std::uint8_t{0});
    m_running = true;
    m_inScan = false;
    m_firstScan = true;
    m_error = false;
    m_nextStart = now;
}

void ScanTask::stop()
{
    m_running = m_inScan = false;
    for (const MemoryArea& area : m_family.areas()) {
        if (!area.isOutput)
            continue;
        const std::span<std::uint8_t> bytes = memory().area(area.id);
        std::fill(bytes.begin(), bytes.end(), std::uint8_t{0});
    }
    applyForces(memory(), m_forces);
    prepare({});
}

bool ScanTask::endsAt(Time now)
{
    if (!m_inScan || now < m_end)
        return false;
    m_inScan = false;
    return true;
}

void ScanTask::takeInputs()
{
    for (const Terminals& terminals : m_inputs) {
        const std::span<std::uint8_t> bytes = memory().area(terminals.area);
        std::copy(terminals.bytes.begin(), terminals.bytes.end(), bytes.begin());
    }
}

void ScanTask::prepare(Time now)
{
    writeSystemBits(m_family.id(), memory(), {now, m_running, m_firstScan, m_firstAfterPowerOn, m_toggle, m_error});
}

ScanReport ScanTask::run(Time now, BlockHost& host)
{
    takeInputs();
    prepare(now);
    ScanInput input;
    input.now = now;
    input.operations = static_cast<std::uint64_t>(m_watchdog / 1ms) * kWatchdogOperationsPerMs;
    input.host = &host;
    input.forces = m_forces;
    const ScanReport report = m_executor.scan(input);
    m_inScan = true;
    m_end = now + m_scanTime;
    m_nextStart = std::max(m_end, (m_firstScan ? now : m_nextStart) + m_period);
    m_firstScan = m_firstAfterPowerOn = false;
    m_toggle = !m_toggle;
    m_error = m_error || report.faults > 0;
    return report;
}

ScanReport ScanTask::runInterrupt(std::uint32_t routine, Time now, BlockHost& host)
{
    ScanInput input;
    input.now = now;
    input.operations = static_cast<std::uint64_t>(m_watchdog / 1ms) * kWatchdogOperationsPerMs;
    input.host = &host;
    applyForces(memory(), m_forces);
    const ScanReport report = m_executor.run(routine, input);
    applyForces(memory(), m_forces);
    m_error = m_error || report.faults > 0;
    return report;
}

bool ScanTask::inputLevel(const Address& address) const
{
    if (!isForced(address)) {
        for (const Terminals& terminals : m_inputs)
            if (terminals.area == address.area && address.byte < terminals.bytes.size())
                return (terminals.bytes[address.byte] >> address.bit & 1) != 0;
    }
    return memory().read(address).asBool();
}

bool ScanTask::write(const Address& address, const Value& value)
{
    if (!memory().write(address, value))
        return false;
    for (Terminals& terminals : m_inputs) {
        if (terminals.area == address.area)
            setTerminal(terminals, address, value);
    }
    applyForces(memory(), m_forces);
    return true;
}

void ScanTask::setTerminal(Terminals& terminals, const Address& address, const Value& value)
{
    if (address.isBit && m_family.area(address.area).kind == AreaKind::Bytes) {
        const auto mask = static_cast<std::uint8_t>(1u << address.bit);
        std::uint8_t& byte = terminals.bytes[address.byte];
        byte = static_cast<std::uint8_t>(value.asBool() ? byte | mask : byte & ~mask);
        return;
    }
    const std::uint64_t bits = address.isBit ? value.asBool() : value.bits;
    for (unsigned i = 0; i < byteWidth(address.type); ++i)
        terminals.bytes[address.byte + i] = static_cast<std::uint8_t>(bits >> (8 * i));
}

void ScanTask::force(const Address& address, const Value& value)
{
    const Force force{address, value};
    const auto at = std::lower_bound(m_forces.begin(), m_forces.end(), force, isLess);
    if (at != m_forces.end() && at->address == address)
        at->value = value;
    else
        m_forces.insert(at, force);
    applyForces(memory(), m_forces);
}

bool ScanTask::release(const Address& address)
{
    return std::erase_if(m_forces, [&](const Force& force) { return force.address == address; }) > 0;
}

bool ScanTask::isForced(const Address& address) const
{
    return std::any_of(m_forces.begin(), m_forces.end(), [&](const Force& force) { return force.address == address; });
}

void ScanTask::takeTerminals(const ScanTask& other)
{
    for (Terminals& mine : m_inputs) {
        for (const Terminals& theirs : other.m_inputs) {
            if (mine.area == theirs.area)
                std::copy_n(theirs.bytes.begin(), std::min(mine.bytes.size(), theirs.bytes.size()), mine.bytes.begin());
        }
    }
    takeInputs();
}

void ScanTask::save(ByteWriter& writer) const
{
    m_executor.save(writer);
    for (const Terminals& terminals : m_inputs)
        writer.putBlob(terminals.bytes);
    writer.put(static_cast<std::uint32_t>(m_forces.size()));
    for (const Force& force : m_forces) {
        writer.put(force.address.area);
        writer.put(force.address.bit);
        writer.put(force.address.isBit);
        writer.put(force.address.type);
        writer.put(force.address.byte);
        writer.put(force.value.type);
        writer.put(force.value.bits);
    }
    for (const bool flag : {m_running, m_inScan, m_firstScan, m_firstAfterPowerOn, m_toggle, m_error})
        writer.put(flag);
    writer.put(m_nextStart.count());
    writer.put(m_end.count());
}

bool ScanTask::restore(ByteReader& reader)
{
    if (!m_executor.restore(reader))
        return false;
    for (Terminals& terminals : m_inputs) {
        const ByteSpan bytes = reader.getBlob();
        if (bytes.size() != terminals.bytes.size())
            return false;
        std::copy(bytes.begin(), bytes.end(), terminals.bytes.begin());
    }
    m_forces.clear();
    const auto forces = reader.get<std::uint32_t>();
    for (std::uint32_t i = 0; i < forces && reader.ok(); ++i) {
        Force force;
        force.address.area = reader.get<AreaId>();
        force.address.bit = reader.get<std::uint8_t>();
        force.address.isBit = reader.getBool();
        force.address.type = reader.get<DataType>();
        force.address.byte = reader.get<std::uint32_t>();
        force.value.type = reader.get<DataType>();
        force.value.bits = reader.get<std::uint64_t>();
        if (!memory().contains(force.address))
            return false;
        m_forces.push_back(force);
    }
    for (bool* flag : {&m_running, &m_inScan, &m_firstScan, &m_firstAfterPowerOn, &m_toggle, &m_error})
        *flag = reader.getBool();
    m_nextStart = Time(reader.get<std::int64_t>());
    m_end = Time(reader.get<std::int64_t>());
    return reader.ok();
}

} // namespace camwright
