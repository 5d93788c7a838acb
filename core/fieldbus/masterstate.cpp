#include "core/fieldbus/canopenmaster.h"

#include "core/fieldbus/framebytes.h"

// The master's state in bytes and back.

namespace camwright {

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
