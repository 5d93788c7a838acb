#include "core/fieldbus/canopenmaster.h"

#include <algorithm>
#include <cassert>

// The master's SDO client: one request a node at a time, shared with the node's boot.

namespace camwright {

namespace {

constexpr std::size_t kMaximumKeptResults = 1024; ///< of requests nobody asks for any more

} // namespace

bool SdoResult::number(DataType type, std::int64_t& out) const
{
    out = 0;
    if (status != SdoStatus::Done || data.size() != byteWidth(type))
        return false;
    out = numberFromBytes(type, data.data());
    return true;
}

void CanopenMaster::keepResult(SdoHandle handle, SdoResult result)
{
    if (m_finished.size() == kMaximumKeptResults)
        m_finished.erase(m_finished.begin());
    m_finished.push_back({handle, std::move(result)});
}

CanopenMaster::SdoHandle CanopenMaster::finishAtOnce(SdoStatus status)
{
    SdoResult result;
    result.status = status;
    keepResult(++m_lastHandle, std::move(result));
    return m_lastHandle;
}

CanopenMaster::SdoHandle CanopenMaster::beginSdo(
    std::uint8_t number, ObjectId object, const ByteSpan* data, Time now, Time timeout)
{
    Node* node = find(number);
    if (node == nullptr || !m_started)
        return finishAtOnce(SdoStatus::NoNode);
    if (node->transferActive || node->boot.running)
        return finishAtOnce(SdoStatus::Busy);
    if (data != nullptr && (data->empty() || data->size() > SdoTransfer::kMaximumBytes))
        return finishAtOnce(SdoStatus::Malformed);
    const CanFrame frame = data != nullptr ? node->transfer.startWrite(number, object.index, object.sub, *data)
                                           : node->transfer.startRead(number, object.index, object.sub);
    if (!send(frame))
        return finishAtOnce(SdoStatus::BufferFull);
    node->handle = ++m_lastHandle;
    node->transferActive = true;
    node->transferTimeout = timeout > Time{0} ? timeout : m_config.sdoTimeout;
    node->transferDeadline = now + node->transferTimeout;
    return node->handle;
}

CanopenMaster::SdoHandle CanopenMaster::readSdo(std::uint8_t node, ObjectId object, Time now, Time timeout)
{
    return beginSdo(node, object, nullptr, now, timeout);
}

CanopenMaster::SdoHandle CanopenMaster::writeSdo(std::uint8_t node, ObjectId object, ByteSpan data, Time now, Time timeout)
{
    return beginSdo(node, object, &data, now, timeout);
}

CanopenMaster::SdoHandle CanopenMaster::writeSdo(
    std::uint8_t node, ObjectId object, std::int64_t value, unsigned bytes, Time now, Time timeout)
{
    assert(bytes >= 1 && bytes <= 8);
    std::array<std::uint8_t, 8> data{};
    for (unsigned i = 0; i < bytes; ++i)
        data[i] = static_cast<std::uint8_t>(static_cast<std::uint64_t>(value) >> (8 * i));
    return writeSdo(node, object, ByteSpan(data).first(bytes), now, timeout);
}

bool CanopenMaster::sdoBusy(std::uint8_t number) const
{
    const Node* node = find(number);
    return node != nullptr && (node->transferActive || node->boot.running);
}

SdoResult CanopenMaster::takeSdo(SdoHandle handle)
{
    const auto place = std::find_if(
        m_finished.begin(), m_finished.end(), [handle](const Finished& finished) { return finished.handle == handle; });
    if (place != m_finished.end()) {
        SdoResult result = std::move(place->result);
        m_finished.erase(place);
        return result;
    }
    SdoResult result;
    const bool pending = handle != 0
        && std::any_of(m_nodes.begin(), m_nodes.end(), [handle](const Node& node) { return node.transferActive && node.handle == handle; });
    result.status = pending ? SdoStatus::Pending : SdoStatus::Cancelled;
    return result;
}

void CanopenMaster::cancelSdo(SdoHandle handle)
{
    for (Node& node : m_nodes) {
        if (handle != 0 && node.transferActive && node.handle == handle) {
            node.transferActive = false;
            send(node.transfer.timeOut());
        }
    }
    std::erase_if(m_finished, [handle](const Finished& finished) { return finished.handle == handle; });
}

/// Ends a user's transfer, if there is one, because the node's boot or a stop needs the channel.
void CanopenMaster::dropTransfer(Node& node)
{
    if (!node.transferActive)
        return;
    node.transferActive = false;
    if (node.handle != 0) {
        SdoResult result;
        result.status = SdoStatus::Cancelled;
        keepResult(node.handle, std::move(result));
    }
}

void CanopenMaster::receiveSdo(Node& node, const CanFrame& frame, Time now)
{
    if (!node.transferActive)
        return;
    CanFrame reply;
    const bool answer = node.transfer.receive(frame, reply);
    node.transferDeadline = now + node.transferTimeout;
    if (answer && !send(reply) && node.transfer.status() == SdoStatus::Pending) {
        node.transferActive = false;
        if (node.handle == 0)
            return failBoot(node, SdoStatus::BufferFull, SdoAbort::None);
        SdoResult result;
        result.status = SdoStatus::BufferFull;
        return keepResult(node.handle, std::move(result));
    }
    if (node.transfer.status() != SdoStatus::Pending)
        endTransfer(node, now);
}

void CanopenMaster::stepTransfer(Node& node, Time now)
{
    if (!node.transferActive || now < node.transferDeadline)
        return;
    send(node.transfer.timeOut());
    endTransfer(node, now);
}

void CanopenMaster::endTransfer(Node& node, Time now)
{
    node.transferActive = false;
    const SdoStatus status = node.transfer.status();
    if (node.handle != 0) {
        SdoResult result;
        result.status = status;
        result.abort = node.transfer.abort();
        if (status == SdoStatus::Done)
            result.data = node.transfer.data();
        keepResult(node.handle, std::move(result));
        return;
    }
    if (status != SdoStatus::Done)
        return failBoot(node, status, node.transfer.abort());
    ++node.bootIndex;
    nextBootWrite(node, now);
}

} // namespace camwright
