#include "core/runtime/kinco/kincomotion.h"

#include "core/family/family.h"
#include "core/runtime/kinco/exchangestate.h"

#include <fmt/format.h>

namespace camwright::kinco {

namespace {

/// What a plain alarm injected into a drive is: motor over-temperature (CiA 402).
constexpr std::uint16_t kInjectedAlarm = 0x4310;

/// Drives may take this long from power-on until their node answers; a program starts no sooner than the nodes are up or
/// this has passed (ours).
constexpr Time kStartUpTime = 1s;

std::uint32_t baudrateOf(const ControllerImage& image)
{
    const NetworkConfiguration& network = image.configuration.network;
    return network.present && network.baudrate ? network.baudrate : 1000000;
}

SimulatedDriveConfig driveConfig(const AxisConfiguration& axis, std::uint64_t seed)
{
    const AxisScale scale{static_cast<double>(axis.encoderResolution), axis.mechanicalEquivalent};
    SimulatedDriveConfig out;
    out.node = axis.number;
    out.countsPerTurn = scale.countsPerTurn;
    out.startPosition = scale.toCounts(axis.startPosition);
    out.inertiaRatio = axis.inertiaRatio;
    out.lowerLimitSwitch = scale.toCounts(axis.lowerLimitSwitch);
    out.upperLimitSwitch = scale.toCounts(axis.upperLimitSwitch);
    out.homeSwitch = scale.toCounts(axis.homeSwitch);
    out.seed = seed + axis.number;
    return out;
}

} // namespace

KincoMotion::KincoMotion(std::shared_ptr<const ControllerImage> image, std::uint64_t seed, ControllerLog& log, Time now)
    : m_image(std::move(image))
    , m_log(log)
    , m_sites(callSitesOf(m_image->program))
    , m_blocks(m_sites, m_image->configuration.axes.size())
    , m_bus(baudrateOf(*m_image))
{
    for (const AxisConfiguration& axis : m_image->configuration.axes)
        m_bus.addDrive(driveConfig(axis, seed));
    start(now);
}

MasterConfig KincoMotion::masterConfig() const
{
    MasterConfig out;
    out.sdoTimeout = std::chrono::milliseconds(m_image->configuration.network.sdoTimeoutMs);
    for (const AxisConfiguration& axis : m_image->configuration.axes) {
        MasterNodeConfig node;
        node.node = axis.number;
        node.guardTime = std::chrono::milliseconds(axis.guardTimeMs);
        node.lifeFactor = axis.lifeFactor;
        node.inhibitTime = std::chrono::milliseconds(axis.inhibitTimeMs);
        node.eventTimer = std::chrono::milliseconds(axis.eventTimerMs);
        out.nodes.push_back(node);
    }
    return out;
}

/// Master, axes, panels and calls as after power-on.
void KincoMotion::start(Time now)
{
    m_calls.clear();
    m_panels.clear();
    m_axes.clear();
    m_master.emplace(masterConfig(), m_bus.masterPort());
    for (const AxisConfiguration& axis : m_image->configuration.axes) {
        m_axes.emplace_back(axis, *m_master);
        m_panels.emplace_back(m_axes.back(), m_log);
    }
    for (std::size_t i = 0; i < m_sites.sites.size(); ++i)
        m_calls.push_back(makeCall(m_sites.sites[i], static_cast<Axis::Owner>(i)));
    m_commands = m_blocks.commands();
    m_reports = {};
    m_reports.calls.resize(m_sites.sites.size());
    m_reports.lists.resize(m_sites.lists);
    m_reports.axes.resize(m_axes.size());
    for (std::size_t i = 0; i < m_calls.size(); ++i) {
        if (m_calls[i])
            m_calls[i]->abandon(m_commands.calls[i].execution);
    }
    m_now = m_startedAt = now;
    m_bus.powerOn(now);
    m_master->start(now);
}

void KincoMotion::powerCycle(Time now)
{
    m_bus.powerOff();
    for (unsigned node = 0; node < m_bus.wire().nodeCount(); ++node)
        m_bus.wire().clearQueue(node);
    m_programRuns = false;
    m_blocks.startProgram();
    start(now);
}

void KincoMotion::startProgram()
{
    m_blocks.startProgram();
    for (Panel& panel : m_panels)
        panel.letGo();
    m_programRuns = true;
}

void KincoMotion::stopProgram()
{
    m_commands = m_blocks.commands();
    for (std::size_t i = 0; i < m_calls.size(); ++i) {
        if (m_calls[i])
            m_calls[i]->abandon(m_commands.calls[i].execution);
    }
    for (std::size_t i = 0; i < m_axes.size(); ++i) {
        m_panels[i].letGo();
        m_axes[i].stopAndRelease();
    }
    m_programRuns = false;
}

bool KincoMotion::isReleased() const
{
    for (const Axis& axis : m_axes) {
        if (!axis.isReleased())
            return false;
    }
    return true;
}

bool KincoMotion::isStartingUp() const
{
    return m_now - m_startedAt < kStartUpTime;
}

bool KincoMotion::isReady() const
{
    for (const Axis& axis : m_axes) {
        const NodeState state = m_master->nodeState(axis.node());
        if (state == NodeState::Idle || state == NodeState::Booting || (state == NodeState::BootFailed && isStartingUp()))
            return false;
    }
    return true;
}

void KincoMotion::cycle(std::uint64_t cycle, Time now)
{
    m_now = now;
    m_bus.advance(now, *m_master);
    for (std::size_t i = 0; i < m_axes.size(); ++i) {
        m_axes[i].observe(now, isStartingUp());
        logEvents(m_axes[i]);
        m_panels[i].cycle(cycle, now);
    }
    for (std::size_t i = 0; m_programRuns && i < m_calls.size(); ++i) {
        if (!m_calls[i])
            continue;
        const bool lists = m_sites.sites[i].pins->ids != PinTable::None;
        const std::uint32_t list = m_sites.sites[i].list;
        CallContext context{m_commands.calls[i], lists ? &m_commands.lists[list] : nullptr, lists ? &m_reports.lists[list] : nullptr,
            m_axes, now};
        m_calls[i]->cycle(context);
    }
    for (Axis& axis : m_axes)
        axis.act(now);
    m_master->step(now);
    for (Panel& panel : m_panels)
        panel.afterSending();
    report();
}

void KincoMotion::logEvents(const Axis& axis)
{
    const std::string& name = axis.configuration().name;
    if (axis.justFaulted())
        m_log.add(Code::AxisAlarm, {name, fmt::format("16#{:04X}", axis.errorCode())});
    if (axis.justLost() && m_master->nodeState(axis.node()) == NodeState::BootFailed)
        m_log.add(Code::AxisNotStarted, {name});
    else if (axis.justLost())
        m_log.add(Code::AxisLost, {name});
}

void KincoMotion::report()
{
    for (std::size_t i = 0; i < m_calls.size(); ++i) {
        if (m_calls[i])
            m_reports.calls[i] = m_calls[i]->result();
    }
    for (std::size_t i = 0; i < m_axes.size(); ++i)
        m_reports.axes[i] = m_axes[i].view();
}

AxisStatus KincoMotion::axisStatus(std::size_t index) const
{
    const Axis& axis = m_axes[index];
    const DriveInputs& inputs = axis.inputs();
    AxisStatus out;
    out.name = axis.configuration().name;
    out.number = axis.configuration().number;
    out.state = static_cast<int>(axis.state());
    if (const camwright::AxisState* state = findFamily("kinco")->findAxisState(out.state))
        out.stateName = state->id;
    out.error = axis.errorCode();
    out.enabled = axis.motion().isEnabled();
    out.homed = axis.isHomed();
    out.moving = axis.isMoving();
    out.online = axis.isOnline();
    out.panelArmed = axis.isPanelArmed();
    out.lowerLimit = inputs.digitalInputs & 1u;
    out.upperLimit = inputs.digitalInputs & 2u;
    out.homeSwitch = inputs.digitalInputs & 4u;
    out.position = read(index, AxisField::Position);
    out.setPosition = read(index, AxisField::SetPosition);
    out.velocity = read(index, AxisField::Velocity);
    out.followingError = read(index, AxisField::FollowingError);
    out.torque = read(index, AxisField::Torque);
    out.unit = axisUnit(index);
    out.lastCause = causeText(axis.cause());
    out.lastChange = axis.lastChange();
    return out;
}

double KincoMotion::read(std::size_t index, AxisField field) const
{
    const Axis& axis = m_axes[index];
    const DriveInputs& inputs = axis.inputs();
    switch (field) {
    case AxisField::Position: return axis.scale().toUnits(inputs.position);
    case AxisField::SetPosition: return axis.scale().toUnits(inputs.demandPosition);
    case AxisField::Velocity: return axis.scale().toUnits(inputs.velocity);
    case AxisField::FollowingError: return axis.scale().toUnits(static_cast<double>(inputs.demandPosition) - inputs.position);
    case AxisField::Torque: return inputs.torque / 10.0;
    case AxisField::State: return static_cast<double>(axis.state());
    case AxisField::Error: return axis.errorCode();
    }
    return 0;
}

double KincoMotion::readPlant(std::size_t index, AxisField field) const
{
    const AxisScale& scale = m_axes[index].scale();
    const SimulatedDrive& drive = m_bus.drive(index);
    switch (field) {
    case AxisField::Position: return scale.toUnits(drive.plantPosition());
    case AxisField::Velocity: return scale.toUnits(drive.plantVelocity());
    case AxisField::Torque: return drive.plantTorque() * 100;
    default: return 0;
    }
}

Result<void> KincoMotion::checkAxis(std::size_t axis) const
{
    if (axis < m_axes.size())
        return {};
    return diagnostic(Code::NoSuchAxis, {std::to_string(axis + 1), std::to_string(m_axes.size())});
}

Result<void> KincoMotion::panel(const input::Panel& command)
{
    if (auto known = checkAxis(command.axis); !known)
        return known;
    return m_panels[command.axis].command(command);
}

void KincoMotion::heartbeat(const input::Heartbeat& beat)
{
    for (Panel& panel : m_panels)
        panel.heartbeat(beat.seenCycle);
}

void KincoMotion::stopAllAxes()
{
    for (Axis& axis : m_axes)
        axis.stopFromOutside(AxisCause::StoppedByCommand);
    m_log.add(Code::AllAxesStopped);
}

Result<void> KincoMotion::inject(const input::InjectFault& fault)
{
    if (auto known = checkAxis(fault.axis); !known)
        return known;
    m_bus.setConnected(fault.axis, fault.fault != input::InjectedFault::NodeLoss);
    if (fault.fault == input::InjectedFault::DriveAlarm)
        m_bus.drive(fault.axis).injectFault(kInjectedAlarm, m_bus.wire().now());
    return {};
}

void KincoMotion::save(ByteWriter& writer) const
{
    m_bus.save(writer);
    m_master->save(writer);
    for (const Axis& axis : m_axes)
        axis.save(writer);
    for (const Panel& panel : m_panels)
        panel.save(writer);
    for (const auto& call : m_calls) {
        if (call)
            call->save(writer);
    }
    m_blocks.save(writer);
    saveCommands(writer, m_commands);
    saveReports(writer, m_reports);
    writer.put(m_programRuns);
    writer.put(m_now.count());
    writer.put(m_startedAt.count());
}

void KincoMotion::restore(ByteReader& reader)
{
    m_bus.restore(reader);
    m_master->restore(reader);
    for (Axis& axis : m_axes)
        axis.restore(reader);
    for (Panel& panel : m_panels)
        panel.restore(reader);
    for (const auto& call : m_calls) {
        if (call)
            call->restore(reader, m_axes);
    }
    m_blocks.restore(reader);
    restoreCommands(reader, m_commands);
    restoreReports(reader, m_reports);
    m_programRuns = reader.getBool();
    m_now = Time(reader.get<std::int64_t>());
    m_startedAt = Time(reader.get<std::int64_t>());
}

} // namespace camwright::kinco
