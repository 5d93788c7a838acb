#include "core/fieldbus/canopenslave.h"

#include "core/fieldbus/framebytes.h"

#include <algorithm>
#include <cassert>

namespace camwright {

namespace {

bool isEventDriven(std::uint8_t type) { return type >= 254; }
bool isCyclicSynchronous(std::uint8_t type) { return type >= 1 && type <= 240; }

} // namespace

CanopenSlave::CanopenSlave(
    std::uint8_t node, ObjectDictionary& dictionary, SlaveApplication& application, CanPort& port, unsigned pdos)
    : m_dictionary(dictionary), m_application(application), m_port(port), m_node(node), m_pdoCount(std::min(pdos, kMaximumPdos))
{
    assert(node >= 1 && node <= 127);
    addCommunicationObjects();
}

void CanopenSlave::start(Time now)
{
    findSlots();
    m_running = true;
    resetCommunication(now);
}

void CanopenSlave::resetCommunication(Time now)
{
    for (std::size_t i = 0; i < m_dictionary.size(); ++i) {
        const auto slot = static_cast<ObjectDictionary::Slot>(i);
        const std::uint16_t index = m_dictionary.info(slot).id.index;
        if (index >= 0x1000 && index <= 0x1FFF)
            m_dictionary.setNumber(slot, m_dictionary.info(slot).initial);
    }
    loadAllPdos();
    m_server = {};
    m_guardToggle = false;
    m_guarded = false;
    m_lastHeartbeat = now;
    if (m_lifeLost) {
        m_lifeLost = false;
        m_application.lifeGuardChanged(false);
    }
    m_state = NmtState::BootUp;
    CanFrame bootUp;
    bootUp.id = kErrorControlId + m_node;
    bootUp.length = 1;
    send(bootUp);
    enter(NmtState::PreOperational, now);
}

bool CanopenSlave::send(const CanFrame& frame)
{
    const bool sent = m_port.send(frame);
    if (!sent)
        ++m_unsent;
    return sent;
}

void CanopenSlave::enter(NmtState state, Time now)
{
    if (state == m_state)
        return;
    m_state = state;
    if (state == NmtState::Operational) {
        for (Pdo& pdo : m_transmit) {
            pdo.everSent = false;
            pdo.syncCount = 0;
            pdo.lastSent = now;
        }
        for (Pdo& pdo : m_receive)
            pdo.waiting = false;
    }
    if (state == NmtState::Stopped)
        m_server = {};
    m_application.nmtChanged(state);
}

void CanopenSlave::receive(const CanFrame& frame, Time now)
{
    if (!m_running || frame.extended)
        return;
    if (frame.id == kErrorControlId + m_node) {
        if (frame.remote)
            receiveGuard(now);
        return;
    }
    if (frame.remote)
        return;
    if (frame.id == kNmtId)
        return receiveNmt(frame, now);
    if (m_state == NmtState::Stopped)
        return;
    if (frame.id == kSyncId)
        return receiveSync(now);
    if (frame.id == kSdoClientToServer + m_node)
        return receiveSdo(frame);
    if (m_state != NmtState::Operational)
        return;
    for (unsigned i = 0; i < m_pdoCount; ++i) {
        if (m_receive[i].valid() && m_receive[i].cobId == frame.id)
            return receivePdo(m_receive[i], frame, now);
    }
}

void CanopenSlave::receiveNmt(const CanFrame& frame, Time now)
{
    if (frame.length != 2 || (frame.data[1] != 0 && frame.data[1] != m_node))
        return;
    switch (static_cast<NmtCommand>(frame.data[0])) {
    case NmtCommand::Start: return enter(NmtState::Operational, now);
    case NmtCommand::Stop: return enter(NmtState::Stopped, now);
    case NmtCommand::EnterPreOperational: return enter(NmtState::PreOperational, now);
    case NmtCommand::ResetNode:
        m_running = false;
        return m_application.resetNode();
    case NmtCommand::ResetCommunication: return resetCommunication(now);
    }
}

void CanopenSlave::receiveGuard(Time now)
{
    CanFrame answer;
    answer.id = kErrorControlId + m_node;
    answer.length = 1;
    answer.data[0] = static_cast<std::uint8_t>(static_cast<std::uint8_t>(m_state) | (m_guardToggle ? 0x80 : 0));
    if (send(answer))
        m_guardToggle = !m_guardToggle;
    m_guarded = true;
    m_lastGuard = now;
    if (m_lifeLost) {
        m_lifeLost = false;
        m_application.lifeGuardChanged(false);
    }
}

void CanopenSlave::receiveSync(Time now)
{
    if (m_state != NmtState::Operational)
        return;
    for (unsigned i = 0; i < m_pdoCount; ++i) {
        Pdo& in = m_receive[i];
        if (in.valid() && in.waiting) {
            in.waiting = false;
            applyPdo(in, in.last);
        }
    }
    for (unsigned i = 0; i < m_pdoCount; ++i) {
        Pdo& out = m_transmit[i];
        if (!out.valid() || out.count == 0 || isEventDriven(out.type))
            continue;
        const CanFrame frame = packPdo(out);
        if (out.type == 0) {
            if (!out.everSent || frame != out.last)
                sendPdo(out, frame, now);
        } else if (++out.syncCount >= out.type) {
            out.syncCount = 0;
            sendPdo(out, frame, now);
        }
    }
}

void CanopenSlave::receivePdo(Pdo& pdo, const CanFrame& frame, Time now)
{
    if (frame.length < pdo.length) {
        sendEmergency(0x8210, 0x10, {}, now); // PDO not processed due to length error
        return;
    }
    if (pdo.type == 0 || isCyclicSynchronous(pdo.type)) {
        pdo.last = frame;
        pdo.waiting = true;
        return;
    }
    applyPdo(pdo, frame);
}

/// All values first, then the application is told: a control word means the targets that came with it.
void CanopenSlave::applyPdo(const Pdo& pdo, const CanFrame& frame)
{
    std::array<bool, kMaximumMapped> stored{};
    unsigned offset = 0;
    for (unsigned i = 0; i < pdo.count; ++i) {
        const ObjectInfo& info = m_dictionary.info(pdo.slots[i]);
        const std::int64_t value = numberFromBytes(info.type, &frame.data[offset]);
        offset += m_dictionary.byteSize(pdo.slots[i]);
        if (value < info.minimum || value > info.maximum || m_application.checkWrite(info.id, value) != SdoAbort::None)
            continue;
        m_dictionary.setNumber(pdo.slots[i], value);
        stored[i] = true;
    }
    for (unsigned i = 0; i < pdo.count; ++i) {
        if (stored[i])
            m_application.written(m_dictionary.info(pdo.slots[i]).id, m_dictionary.number(pdo.slots[i]));
    }
}

CanFrame CanopenSlave::packPdo(const Pdo& pdo) const
{
    CanFrame frame;
    frame.id = pdo.cobId;
    frame.length = pdo.length;
    unsigned offset = 0;
    for (unsigned i = 0; i < pdo.count; ++i) {
        const unsigned size = m_dictionary.byteSize(pdo.slots[i]);
        putLittle(&frame.data[offset], static_cast<std::uint64_t>(m_dictionary.number(pdo.slots[i])), size);
        offset += size;
    }
    return frame;
}

void CanopenSlave::sendPdo(Pdo& pdo, const CanFrame& frame, Time now)
{
    if (!send(frame))
        return;
    pdo.last = frame;
    pdo.lastSent = now;
    pdo.everSent = true;
}

void CanopenSlave::stepPdo(Pdo& pdo, Time now)
{
    if (!pdo.valid() || pdo.count == 0 || !isEventDriven(pdo.type))
        return;
    if (pdo.everSent && now - pdo.lastSent < pdo.inhibit)
        return;
    const CanFrame frame = packPdo(pdo);
    const bool timerDue = pdo.eventTimer > Time{0} && now - pdo.lastSent >= pdo.eventTimer;
    if (!pdo.everSent || timerDue || frame != pdo.last)
        sendPdo(pdo, frame, now);
}

void CanopenSlave::stepLifeGuard(Time now)
{
    if (!m_guarded || m_lifeLost)
        return;
    const Time life = std::chrono::milliseconds(m_dictionary.number(m_guardTimeSlot) * m_dictionary.number(m_lifeFactorSlot));
    if (life == Time{0} || now - m_lastGuard < life)
        return;
    m_lifeLost = true;
    m_application.lifeGuardChanged(true);
    if (m_state == NmtState::Operational)
        enter(NmtState::PreOperational, now);
}

void CanopenSlave::step(Time now)
{
    if (!m_running)
        return;
    stepLifeGuard(now);
    const Time heartbeat = std::chrono::milliseconds(m_dictionary.number(m_heartbeatSlot));
    if (heartbeat > Time{0} && now - m_lastHeartbeat >= heartbeat) {
        CanFrame frame;
        frame.id = kErrorControlId + m_node;
        frame.length = 1;
        frame.data[0] = static_cast<std::uint8_t>(m_state);
        send(frame);
        m_lastHeartbeat = now;
    }
    if (m_state != NmtState::Operational)
        return;
    for (unsigned i = 0; i < m_pdoCount; ++i)
        stepPdo(m_transmit[i], now);
}

void CanopenSlave::sendEmergency(
    std::uint16_t errorCode, std::uint8_t errorRegister, std::array<std::uint8_t, 5> vendor, Time)
{
    m_dictionary.setNumber({0x1001, 0}, errorRegister);
    if (errorCode != 0) {
        const std::int64_t count = m_dictionary.number({0x1003, 0});
        for (std::uint8_t sub = 4; sub > 1; --sub)
            m_dictionary.setNumber({0x1003, sub}, m_dictionary.number({0x1003, static_cast<std::uint8_t>(sub - 1)}));
        m_dictionary.setNumber({0x1003, 1}, errorCode);
        m_dictionary.setNumber({0x1003, 0}, std::min<std::int64_t>(count + 1, 4));
    }
    if (!m_running || m_state == NmtState::Stopped)
        return;
    CanFrame frame;
    frame.id = kEmergencyId + m_node;
    frame.length = 8;
    putLittle(&frame.data[0], errorCode, 2);
    frame.data[2] = errorRegister;
    std::copy(vendor.begin(), vendor.end(), frame.data.begin() + 3);
    send(frame);
}

void CanopenSlave::save(ByteWriter& writer) const
{
    for (const auto* pdos : {&m_transmit, &m_receive}) {
        for (const Pdo& pdo : *pdos) {
            write(writer, pdo.last);
            writer.put(pdo.everSent);
            writer.put(pdo.waiting);
            writer.put(pdo.syncCount);
            writer.put(pdo.lastSent.count());
        }
    }
    writer.putBlob(m_server.data);
    writer.put(m_server.position);
    writer.put(m_server.expected);
    writer.put(m_server.id.index);
    writer.put(m_server.id.sub);
    writer.put(m_server.active);
    writer.put(m_server.writing);
    writer.put(m_server.toggle);
    writer.put(m_state);
    writer.put(m_running);
    writer.put(m_guardToggle);
    writer.put(m_guarded);
    writer.put(m_lifeLost);
    writer.put(m_lastGuard.count());
    writer.put(m_lastHeartbeat.count());
    writer.put(m_unsent);
}

void CanopenSlave::restore(ByteReader& reader)
{
    findSlots();
    loadAllPdos();
    for (auto* pdos : {&m_transmit, &m_receive}) {
        for (Pdo& pdo : *pdos) {
            pdo.last = readCanFrame(reader);
            pdo.everSent = reader.getBool();
            pdo.waiting = reader.getBool();
            pdo.syncCount = reader.get<std::uint8_t>();
            pdo.lastSent = Time(reader.get<std::int64_t>());
        }
    }
    const ByteSpan data = reader.getBlob();
    m_server.data.assign(data.begin(), data.end());
    m_server.position = reader.get<std::uint32_t>();
    m_server.expected = reader.get<std::uint32_t>();
    m_server.id.index = reader.get<std::uint16_t>();
    m_server.id.sub = reader.get<std::uint8_t>();
    m_server.active = reader.getBool();
    m_server.writing = reader.getBool();
    m_server.toggle = reader.getBool();
    m_state = reader.get<NmtState>();
    m_running = reader.getBool();
    m_guardToggle = reader.getBool();
    m_guarded = reader.getBool();
    m_lifeLost = reader.getBool();
    m_lastGuard = Time(reader.get<std::int64_t>());
    m_lastHeartbeat = Time(reader.get<std::int64_t>());
    m_unsent = reader.get<std::uint64_t>();
    if (m_server.position > m_server.data.size())
        reader.fail();
}

} // namespace camwright
