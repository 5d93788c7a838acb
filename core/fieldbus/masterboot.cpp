#include "core/fieldbus/canopenmaster.h"

#include "core/fieldbus/drivepdos.h"

#include <algorithm>

// How the master brings a node up: KS-MC-21.

namespace camwright {

std::vector<CanopenMaster::BootWrite> CanopenMaster::bootListFor(const MasterNodeConfig& config)
{
    std::vector<BootWrite> list;
    const auto milliseconds = [](Time time) { return static_cast<std::uint32_t>(time / 1ms); };
    list.push_back({BootStep::Guarding, {0x100C, 0}, milliseconds(config.guardTime), 2});
    list.push_back({BootStep::Guarding, {0x100D, 0}, config.lifeFactor, 1});
    for (const DrivePdo& pdo : drivePdos()) {
        const auto communication = static_cast<std::uint16_t>((pdo.transmit ? 0x1800 : 0x1400) + pdo.number - 1);
        const auto mapping = static_cast<std::uint16_t>((pdo.transmit ? 0x1A00 : 0x1600) + pdo.number - 1);
        list.push_back({BootStep::Mapping, {communication, 1}, 0x80000000U | pdo.id(config.node), 4});
        list.push_back({BootStep::Mapping, {mapping, 0}, 0, 1});
        std::uint8_t sub = 0;
        for (const std::uint32_t entry : pdo.entries()) {
            ++sub;
            list.push_back({BootStep::Mapping, {mapping, sub}, entry, 4});
        }
        list.push_back({BootStep::Mapping, {mapping, 0}, sub, 1});
    }
    for (const DrivePdo& pdo : drivePdos()) {
        const auto communication = static_cast<std::uint16_t>((pdo.transmit ? 0x1800 : 0x1400) + pdo.number - 1);
        list.push_back({BootStep::Communication, {communication, 2}, 255, 1});
        if (pdo.transmit) {
            const auto inhibit = static_cast<std::uint32_t>(config.inhibitTime / 100us);
            list.push_back({BootStep::Communication, {communication, 3}, inhibit, 2});
            list.push_back({BootStep::Communication, {communication, 5}, milliseconds(config.eventTimer), 2});
        }
        list.push_back({BootStep::Communication, {communication, 1}, pdo.id(config.node), 4});
    }
    return list;
}

void CanopenMaster::beginBoot(Node& node, Time timeout, Time now)
{
    dropTransfer(node);
    node.state = NodeState::Booting;
    node.boot = {};
    node.boot.running = true;
    node.boot.step = BootStep::PreOperational;
    node.boot.status = SdoStatus::Pending;
    node.bootIndex = 0;
    node.bootTimeout = timeout;
    node.outputs = {};
    node.everSent = {};
    node.urgent = false;
    node.blocked = false;
    nextBootWrite(node, now);
}

void CanopenMaster::nextBootWrite(Node& node, Time now)
{
    if (node.bootIndex >= node.bootList.size()) {
        node.boot.step = BootStep::Start;
        if (send(nmtFrame(NmtCommand::Start, node.config.node)))
            goOnline(node, now);
        else
            failBoot(node, SdoStatus::BufferFull, SdoAbort::None);
        return;
    }
    const BootWrite& next = node.bootList[node.bootIndex];
    node.boot.step = next.step;
    node.boot.object = next.object;
    Bytes data(next.bytes);
    for (unsigned i = 0; i < next.bytes; ++i)
        data[i] = static_cast<std::uint8_t>(next.value >> (8 * i));
    const CanFrame frame = node.transfer.startWrite(node.config.node, next.object.index, next.object.sub, data);
    if (!send(frame))
        return failBoot(node, SdoStatus::BufferFull, SdoAbort::None);
    node.handle = 0;
    node.transferActive = true;
    node.transferTimeout = node.bootTimeout;
    node.transferDeadline = now + node.bootTimeout;
}

void CanopenMaster::failBoot(Node& node, SdoStatus status, SdoAbort abort)
{
    node.boot.running = false;
    node.boot.status = status;
    node.boot.abort = abort;
    node.state = NodeState::BootFailed;
}

void CanopenMaster::goOnline(Node& node, Time now)
{
    node.boot.running = false;
    node.boot.status = SdoStatus::Done;
    node.boot.object = {};
    node.state = NodeState::Operational;
    node.everOnline = true;
    node.guardHeard = now;
    node.guardSent = now - node.config.guardTime; // the first question is asked at once: it arms the node's life guarding
    node.guardFirst = true;
}

bool CanopenMaster::restart(std::uint8_t number, Time sdoTimeout, Time now)
{
    Node* node = find(number);
    if (node == nullptr || !m_started || node->boot.running)
        return false;
    const Time timeout = sdoTimeout > Time{0} ? sdoTimeout : m_config.sdoTimeout;
    if (!send(nmtFrame(NmtCommand::EnterPreOperational, number))) {
        dropTransfer(*node);
        node->boot = {};
        node->boot.step = BootStep::PreOperational;
        failBoot(*node, SdoStatus::BufferFull, SdoAbort::None);
        return true;
    }
    beginBoot(*node, timeout, now);
    return true;
}

void CanopenMaster::cancelRestart(std::uint8_t number)
{
    Node* node = find(number);
    if (node == nullptr || !node->boot.running)
        return;
    dropTransfer(*node);
    failBoot(*node, SdoStatus::Cancelled, SdoAbort::None);
}

BootReport CanopenMaster::bootReport(std::uint8_t number) const
{
    const Node* node = find(number);
    return node == nullptr ? BootReport{} : node->boot;
}

} // namespace camwright
