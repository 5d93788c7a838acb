#include "core/runtime/plant/simulatedbus.h"

#include "core/fieldbus/canopenmaster.h"

namespace camwright {

SimulatedBus::SimulatedBus(std::uint32_t baudrate, unsigned masterQueue) : m_wire(baudrate) { m_wire.addNode(masterQueue); }

SimulatedDrive& SimulatedBus::addDrive(const SimulatedDriveConfig& config)
{
    const unsigned node = m_wire.addNode();
    m_drives.push_back(std::make_unique<SimulatedDrive>(config, m_wire.port(node)));
    return *m_drives.back();
}

void SimulatedBus::powerOn(Time now)
{
    for (const auto& drive : m_drives)
        drive->powerOn(now);
}

void SimulatedBus::powerOff()
{
    for (const auto& drive : m_drives)
        drive->powerOff();
}

void SimulatedBus::advance(Time now, CanopenMaster& master)
{
    m_wire.advance(now, [&](unsigned node, const CanFrame& frame, Time at) {
        if (node == 0)
            master.receive(frame, at);
        else
            m_drives[node - 1]->receive(frame, at);
    });
    for (const auto& drive : m_drives)
        drive->step(now);
}

void SimulatedBus::save(ByteWriter& writer) const
{
    m_wire.save(writer);
    for (const auto& drive : m_drives)
        drive->save(writer);
}

void SimulatedBus::restore(ByteReader& reader)
{
    m_wire.restore(reader);
    for (const auto& drive : m_drives)
        drive->restore(reader);
}

} // namespace camwright
