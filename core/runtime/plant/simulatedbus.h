#pragma once

#include "core/runtime/plant/canwire.h"
#include "core/runtime/plant/simulateddrive.h"

#include <memory>
#include <vector>

namespace camwright {

class CanopenMaster;

/// A master's connector, a wire and the drives on it. In a motion cycle at time t: advance(t, master), then the motion task,
/// then master.step(t); what is sent then reaches the drives within the next cycle.
class SimulatedBus {
public:
    explicit SimulatedBus(std::uint32_t baudrate, unsigned masterQueue = 64);

    CanPort& masterPort() { return m_wire.port(0); }
    SimulatedDrive& addDrive(const SimulatedDriveConfig& config);
    std::size_t driveCount() const { return m_drives.size(); }
    SimulatedDrive& drive(std::size_t index) { return *m_drives[index]; }
    const SimulatedDrive& drive(std::size_t index) const { return *m_drives[index]; }
    CanWire& wire() { return m_wire; }
    const CanWire& wire() const { return m_wire; }

    void powerOn(Time now);
    void powerOff();
    /// Delivers the frames that end up to `now`, then steps every drive. Call each millisecond.
    void advance(Time now, CanopenMaster& master);
    /// The cable of one drive.
    void setConnected(std::size_t drive, bool connected) { m_wire.setConnected(static_cast<unsigned>(drive) + 1, connected); }

    void save(ByteWriter& writer) const;
    /// Into a bus with the same drives.
    void restore(ByteReader& reader);

private:
    CanWire m_wire;
    std::vector<std::unique_ptr<SimulatedDrive>> m_drives;
};

} // namespace camwright
