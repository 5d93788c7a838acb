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

bool CanopenMaster::commandPending(std::uint8_t number) const
{
    const Node* node = find(number);
    return node != nullptr && (!node->everSent[0] || node->sent[0] != packOutputs(node->outputs, 1, number));
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
    noteSent(node, index, frame, now);
    return true;
}

void CanopenMaster::noteSent(Node& node, unsigned index, const CanFrame& frame, Time now)
{
    node.sent[index] = frame;
    node.sentAt[index] = now;
    node.everSent[index] = true;
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
    if (node.urgent && commandDue) {
        if (m_port.sendFirst(command)) {
            noteSent(node, 0, command, now);
            node.urgent = false; // the speeds of a stop may follow as usual
        }
        return;
    }
    // The control word and the mode are the first three bytes.
    const bool atOnce = node.urgent || !node.everSent[0] || !std::equal(command.data.begin(), command.data.begin() + 3, node.sent[0].data.begin());
    const auto mayGo = [&](unsigned index) { return atOnce || now - node.sentAt[index] >= node.config.inhibitTime; };
    if (speedsDue && (mayGo(1) || !node.everSent[1]) && !sendOutput(node, 1, speeds, now))
        return;
    if (commandDue && mayGo(0) && !sendOutput(node, 0, command, now))
        return;
    node.urgent = false;
}

} // namespace camwright
