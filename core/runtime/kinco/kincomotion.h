#pragma once

#include "core/language/image/controllerimage.h"
#include "core/runtime/log/controllerlog.h"
#include "core/runtime/kinco/call.h"
#include "core/runtime/kinco/panel.h"
#include "core/runtime/kinco/scanblocks.h"
#include "core/runtime/motionsystem.h"
#include "core/runtime/plant/simulatedbus.h"

#include <deque>
#include <memory>
#include <optional>
#include <vector>

namespace camwright::kinco {

/// Kinco Motion Control: the CANopen master with one simulated drive for each axis of the image, the axes, the MC_* calls of
/// the program and the panel. In a motion cycle: what came over the bus, events, panels, calls in program order, power and
/// commands of the axes, then the master sends.
class KincoMotion final : public MotionSystem {
public:
    KincoMotion(std::shared_ptr<const ControllerImage> image, std::uint64_t seed, ControllerLog& log, Time now);

    BlockHost& blocks() override { return m_blocks; }
    void beginScan() override { m_blocks.take(m_reports); }
    void endScan() override { m_commands = m_blocks.commands(); }
    void startProgram() override;
    void stopProgram() override;
    bool isReleased() const override;
    bool isReady() const override;
    void cycle(std::uint64_t cycle, Time now) override;
    void powerCycle(Time now) override;

    std::size_t axisCount() const override { return m_axes.size(); }
    std::string axisName(std::size_t axis) const override { return m_axes[axis].configuration().name; }
    std::string axisUnit(std::size_t axis) const override { return m_axes[axis].configuration().rotary ? "°" : "mm"; }
    AxisStatus axisStatus(std::size_t axis) const override;
    double read(std::size_t axis, AxisField field) const override;
    double readPlant(std::size_t axis, AxisField field) const override;
    double busLoadPercent() const override { return m_bus.wire().load() * 100; }

    Result<void> panel(const input::Panel& command) override;
    void heartbeat(const input::Heartbeat& beat) override;
    void stopAllAxes() override;
    Result<void> inject(const input::InjectFault& fault) override;

    void save(ByteWriter& writer) const override;
    void restore(ByteReader& reader) override;

private:
    MasterConfig masterConfig() const;
    void start(Time now);
    bool isStartingUp() const;
    void logEvents(const Axis& axis);
    void report();
    Result<void> checkAxis(std::size_t axis) const;

    std::shared_ptr<const ControllerImage> m_image;
    ControllerLog& m_log;
    CallSites m_sites;
    ScanBlocks m_blocks;
    SimulatedBus m_bus;
    std::optional<CanopenMaster> m_master;
    Axes m_axes;
    std::deque<Panel> m_panels;
    std::vector<std::unique_ptr<Call>> m_calls; ///< by block instance; null where there is nothing to do in motion
    ScanCommands m_commands;                    ///< the two exchange buffers
    MotionReports m_reports;
    bool m_programRuns = false;
    Time m_now{}, m_startedAt{};
};

} // namespace camwright::kinco
