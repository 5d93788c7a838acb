#include "core/fieldbus/canopenmaster.h"

#include "core/fieldbus/drivepdos.h"
#include "core/fieldbus/framebytes.h"

#include <algorithm>
#include <cassert>

namespace camwright {

CanopenMaster::CanopenMaster(MasterConfig config, CanPort& port) : m_config(std::move(config)), m_port(port)
{
    m_slots.fill(-1);
    for (const MasterNodeConfig& nodeConfig : m_config.nodes) {
        assert(nodeConfig.node >= 1 && nodeConfig.node <= 127 && m_slots[nodeConfig.node] < 0);
        m_slots[nodeConfig.node] = static_cast<std::int8_t>(m_nodes.size());
        Node node;
        node.config = nodeConfig;
        node.bootList = bootListFor(nodeConfig);
        m_nodes.push_back(std::move(node));
    }
}

CanopenMaster::Node* CanopenMaster::find(std::uint8_t number)
{
    const int slot = number <= 127 ? slotOf(number) : -1;
    return slot < 0 ? nullptr : &m_nodes[static_cast<std::size_t>(slot)];
}

const CanopenMaster::Node* CanopenMaster::find(std::uint8_t number) const
{
    const int slot = number <= 127 ? slotOf(number) : -1;
    return slot < 0 ? nullptr : &m_nodes[static_cast<std::size_t>(slot)];
}

bool CanopenMaster::send(const CanFrame& frame)
{
    const bool sent = m_port.send(frame);
    if (!sent)
        ++m_bufferFull;
    return sent;
}

void CanopenMaster::start(Time now)
{
    m_started = true;
    m_lastSync = now;
    send(nmtFrame(NmtCommand::EnterPreOperational, 0));
    for (Node& node : m_nodes) {
        node.everOnline = false;
        beginBoot(node, m_config.sdoTimeout, now);
    }
}

void CanopenMaster::stop(Time)
{
    if (!m_started)
        return;
    m_started = false;
    send(nmtFrame(NmtCommand::EnterPreOperational, 0));
    for (Node& node : m_nodes) {
        dropTransfer(node);
        node.state = NodeState::Idle;
        node.boot = {};
    }
}

NodeState CanopenMaster::nodeState(std::uint8_t number) const
{
    const Node* node = find(number);
    return node == nullptr ? NodeState::Idle : node->state;
}

const DriveInputs& CanopenMaster::inputs(std::uint8_t number) const
{
    const Node* node = find(number);
    assert(node != nullptr);
    return node->inputs;
}

const DriveOutputs& CanopenMaster::outputs(std::uint8_t number) const
{
    const Node* node = find(number);
    assert(node != nullptr);
    return node->outputs;
}

void CanopenMaster::setOutputs(std::uint8_t number, const DriveOutputs& outputs, bool urgent)
{
    if (Node* node = find(number)) {
        node->outputs = outputs;
        node->urgent = node->urgent || urgent;
    }
}

bool CanopenMaster::outputsPending(std::uint8_t number) const
{
    const Node* node = find(number);
    if (node == nullptr)
        return false;
    for (unsigned i = 0; i < kReceivePdos; ++i) {
        if (!node->everSent[i] || node->sent[i] != packOutputs(node->outputs, i + 1, number))
            return true;
    }
    return false;
}

bool CanopenMaster::sendBlocked(std::uint8_t number) const
{
    const Node* node = find(number);
    return node != nullptr && node->blocked;
}

void CanopenMaster::sendNmt(NmtCommand command, std::uint8_t node) { send(nmtFrame(command, node)); }

void CanopenMaster::receive(const CanFrame& frame, Time now)
{
    if (!m_started || frame.extended || frame.remote)
        return;
    Node* node = find(frame.id & 0x7F);
    if (node == nullptr)
        return;
    switch (frame.id & 0x780) {
    case kEmergencyId: return receiveEmergency(*node, frame, now);
    case 0x180: return receivePdo(*node, 1, frame);
    case 0x280: return receivePdo(*node, 2, frame);
    case 0x380: return receivePdo(*node, 3, frame);
    case kSdoServerToClient: return receiveSdo(*node, frame, now);
    case kErrorControlId: return receiveErrorControl(*node, frame, now);
    default: return;
    }
}

void CanopenMaster::receivePdo(Node& node, unsigned number, const CanFrame& frame)
{
    if (node.state == NodeState::Operational)
        unpackInputs(frame, number, node.inputs);
}

void CanopenMaster::receiveErrorControl(Node& node, const CanFrame& frame, Time now)
{
    if (frame.length != 1)
        return;
    if (frame.data[0] == 0) { // boot-up: the node has just been switched on or has reset itself
        if (node.state == NodeState::Operational)
            node.state = NodeState::Lost;
        else if (node.state == NodeState::Booting || (node.state == NodeState::BootFailed && !node.everOnline))
            beginBoot(node, m_config.sdoTimeout, now);
        return;
    }
    if (node.state != NodeState::Operational)
        return;
    const bool toggle = (frame.data[0] & 0x80) != 0;
    if (!node.guardFirst && toggle == node.guardToggle)
        return; // an answer repeated: it counts as none
    if (static_cast<NmtState>(frame.data[0] & 0x7F) != NmtState::Operational) {
        // A question asked before the start command reached the node may be answered with its old state.
        if (!node.guardFirst)
            node.state = NodeState::Lost;
        node.guardToggle = toggle;
        return;
    }
    node.guardFirst = false;
    node.guardToggle = toggle;
    node.guardHeard = now;
}

void CanopenMaster::receiveEmergency(Node& node, const CanFrame& frame, Time now)
{
    if (frame.length != 8)
        return;
    Emergency emergency;
    emergency.at = now;
    emergency.node = node.config.node;
    emergency.errorCode = static_cast<std::uint16_t>(getLittle(&frame.data[0], 2));
    emergency.errorRegister = frame.data[2];
    std::copy_n(frame.data.begin() + 3, 5, emergency.vendor.begin());
    if (m_emergencies.size() == kEmergencyHistory)
        m_emergencies.erase(m_emergencies.begin());
    m_emergencies.push_back(emergency);
    ++m_emergencyCount;
}

void CanopenMaster::step(Time now)
{
    if (!m_started)
        return;
    if (m_config.syncPeriod > Time{0} && now - m_lastSync >= m_config.syncPeriod && send(syncFrame()))
        m_lastSync = now;
    for (Node& node : m_nodes) {
        stepOutputs(node, now);
        stepTransfer(node, now);
        stepGuard(node, now);
    }
}

void CanopenMaster::stepGuard(Node& node, Time now)
{
    if (node.state != NodeState::Operational || node.config.guardTime <= Time{0} || node.config.lifeFactor == 0)
        return;
    if (now - node.guardHeard >= node.config.guardTime * node.config.lifeFactor) {
        node.state = NodeState::Lost;
        return;
    }
    if (now - node.guardSent >= node.config.guardTime && send(guardRequest(node.config.node)))
        node.guardSent = now;
}

bool CanopenMaster::sendOutput(Node& node, unsigned index, const CanFrame& frame, Time now)
{
    if (!send(frame)) {
        node.blocked = true;
        return false;
    }
    node.sent[index] = frame;
    node.sentAt[index] = now;
    node.everSent[index] = true;
    return true;
}

void CanopenMaster::stepOutputs(Node& node, Time now)
{
    if (node.state != NodeState::Operational)
        return;
    node.blocked = false;
    const CanFrame command = packOutputs(node.outputs, 1, node.config.node);
    const CanFrame speeds = packOutputs(node.outputs, 2, node.config.node);
    const bool commandDue = !node.everSent[0] || command != node.sent[0];
    const bool speedsDue = !node.everSent[1] || speeds != node.sent[1];
    // The control word and the mode are the first three bytes.
    const bool atOnce = node.urgent || !node.everSent[0] || !std::equal(command.data.begin(), command.data.begin() + 3, node.sent[0].data.begin());
    const auto mayGo = [&](unsigned index) { return atOnce || now - node.sentAt[index] >= node.config.inhibitTime; };
    if (speedsDue && (mayGo(1) || !node.everSent[1]) && !sendOutput(node, 1, speeds, now))
        return;
    if (commandDue && mayGo(0) && !sendOutput(node, 0, command, now))
        return;
    node.urgent = false;
}

void CanopenMaster::saveNode(ByteWriter& writer, const Node& node) const
{
    writer.put(node.state);
    const DriveInputs& in = node.inputs;
    writer.put(in.statusWord);
    writer.put(in.mode);
    writer.put(in.position);
    writer.put(in.velocity);
    writer.put(in.demandPosition);
    writer.put(in.torque);
    writer.put(in.digitalInputs);
    writer.put(in.errorCode);
    const DriveOutputs& out = node.outputs;
    writer.put(out.controlWord);
    writer.put(out.mode);
    writer.put(out.targetPosition);
    writer.put(out.profileVelocity);
    writer.put(out.targetVelocity);
    for (unsigned i = 0; i < kReceivePdos; ++i) {
        write(writer, node.sent[i]);
        writer.put(node.sentAt[i].count());
        writer.put(node.everSent[i]);
    }
    writer.put(node.urgent);
    writer.put(node.blocked);
    writer.put(node.boot.running);
    writer.put(node.boot.step);
    writer.put(node.boot.status);
    writer.put(node.boot.abort);
    writer.put(node.boot.object.index);
    writer.put(node.boot.object.sub);
    writer.put(node.bootIndex);
    writer.put(node.bootTimeout.count());
    writer.put(node.everOnline);
    node.transfer.save(writer);
    writer.put(node.handle);
    writer.put(node.transferActive);
    writer.put(node.transferDeadline.count());
    writer.put(node.transferTimeout.count());
    writer.put(node.guardSent.count());
    writer.put(node.guardHeard.count());
    writer.put(node.guardToggle);
    writer.put(node.guardFirst);
}

void CanopenMaster::restoreNode(ByteReader& reader, Node& node)
{
    const auto time = [&reader] { return Time(reader.get<std::int64_t>()); };
    node.state = reader.get<NodeState>();
    DriveInputs& in = node.inputs;
    in.statusWord = reader.get<std::uint16_t>();
    in.mode = reader.get<std::int8_t>();
    in.position = reader.get<std::int32_t>();
    in.velocity = reader.get<std::int32_t>();
    in.demandPosition = reader.get<std::int32_t>();
    in.torque = reader.get<std::int16_t>();
    in.digitalInputs = reader.get<std::uint32_t>();
    in.errorCode = reader.get<std::uint16_t>();
    DriveOutputs& out = node.outputs;
    out.controlWord = reader.get<std::uint16_t>();
    out.mode = reader.get<std::int8_t>();
    out.targetPosition = reader.get<std::int32_t>();
    out.profileVelocity = reader.get<std::uint32_t>();
    out.targetVelocity = reader.get<std::int32_t>();
    for (unsigned i = 0; i < kReceivePdos; ++i) {
        node.sent[i] = readCanFrame(reader);
        node.sentAt[i] = time();
        node.everSent[i] = reader.getBool();
    }
    node.urgent = reader.getBool();
    node.blocked = reader.getBool();
    node.boot.running = reader.getBool();
    node.boot.step = reader.get<BootStep>();
    node.boot.status = reader.get<SdoStatus>();
    node.boot.abort = reader.get<SdoAbort>();
    node.boot.object.index = reader.get<std::uint16_t>();
    node.boot.object.sub = reader.get<std::uint8_t>();
    node.bootIndex = reader.get<std::uint16_t>();
    node.bootTimeout = time();
    node.everOnline = reader.getBool();
    node.transfer.restore(reader);
    node.handle = reader.get<SdoHandle>();
    node.transferActive = reader.getBool();
    node.transferDeadline = time();
    node.transferTimeout = time();
    node.guardSent = time();
    node.guardHeard = time();
    node.guardToggle = reader.getBool();
    node.guardFirst = reader.getBool();
}

void CanopenMaster::save(ByteWriter& writer) const
{
    writer.put(static_cast<std::uint32_t>(m_nodes.size()));
    for (const Node& node : m_nodes)
        saveNode(writer, node);
    writer.put(static_cast<std::uint32_t>(m_finished.size()));
    for (const Finished& finished : m_finished) {
        writer.put(finished.handle);
        writer.put(finished.result.status);
        writer.put(finished.result.abort);
        writer.putBlob(finished.result.data);
    }
    writer.put(m_lastHandle);
    writer.put(static_cast<std::uint32_t>(m_emergencies.size()));
    for (const Emergency& emergency : m_emergencies) {
        writer.put(emergency.at.count());
        writer.put(emergency.node);
        writer.put(emergency.errorCode);
        writer.put(emergency.errorRegister);
        writer.putBytes(emergency.vendor);
    }
    writer.put(m_emergencyCount);
    writer.put(m_bufferFull);
    writer.put(m_started);
    writer.put(m_lastSync.count());
}

void CanopenMaster::restore(ByteReader& reader)
{
    if (reader.get<std::uint32_t>() != m_nodes.size())
        return reader.fail();
    for (Node& node : m_nodes)
        restoreNode(reader, node);
    m_finished.clear();
    const auto finished = reader.get<std::uint32_t>();
    for (std::uint32_t i = 0; i < finished && reader.ok(); ++i) {
        Finished entry;
        entry.handle = reader.get<SdoHandle>();
        entry.result.status = reader.get<SdoStatus>();
        entry.result.abort = reader.get<SdoAbort>();
        const ByteSpan data = reader.getBlob();
        entry.result.data.assign(data.begin(), data.end());
        m_finished.push_back(std::move(entry));
    }
    m_lastHandle = reader.get<SdoHandle>();
    m_emergencies.clear();
    const auto emergencies = reader.get<std::uint32_t>();
    for (std::uint32_t i = 0; i < emergencies && reader.ok(); ++i) {
        Emergency emergency;
        emergency.at = Time(reader.get<std::int64_t>());
        emergency.node = reader.get<std::uint8_t>();
        emergency.errorCode = reader.get<std::uint16_t>();
        emergency.errorRegister = reader.get<std::uint8_t>();
        for (std::uint8_t& byte : emergency.vendor)
            byte = reader.get<std::uint8_t>();
        m_emergencies.push_back(emergency);
    }
    m_emergencyCount = reader.get<std::uint64_t>();
    m_bufferFull = reader.get<std::uint64_t>();
    m_started = reader.getBool();
    m_lastSync = Time(reader.get<std::int64_t>());
}

} // namespace camwright
