#include "core/fieldbus/canopenslave.h"

#include "core/fieldbus/framebytes.h"

// The slave's communication objects and what CiA 301 allows to be written to them.

namespace camwright {

namespace {

constexpr std::uint32_t kNotValid = 0x80000000U;

ObjectInfo object(std::uint16_t index, std::uint8_t sub, DataType type, ObjectAccess access, std::int64_t initial)
{
    ObjectInfo info;
    info.id = {index, sub};
    info.type = type;
    info.access = access;
    info.initial = initial;
    return info;
}

ObjectInfo text(std::uint16_t index, const char* value)
{
    ObjectInfo info = object(index, 0, DataType::Byte, ObjectAccess::Constant, 0);
    info.text = value;
    return info;
}

void addPdo(ObjectDictionary& dictionary, bool transmit, unsigned number, std::uint8_t node)
{
    const std::uint16_t communication = static_cast<std::uint16_t>((transmit ? 0x1800 : 0x1400) + number);
    const std::uint16_t mapping = static_cast<std::uint16_t>((transmit ? 0x1A00 : 0x1600) + number);
    const std::uint32_t id = number >= 4 ? 0 : transmit ? transmitPdoId(number + 1, node) : receivePdoId(number + 1, node);
    const auto rw = ObjectAccess::ReadWrite;
    dictionary.add(object(communication, 0, DataType::Usint, ObjectAccess::Constant, transmit ? 5 : 2));
    dictionary.add(object(communication, 1, DataType::Udint, rw, kNotValid | id));
    dictionary.add(object(communication, 2, DataType::Usint, rw, 255));
    if (transmit) {
        dictionary.add(object(communication, 3, DataType::Uint, rw, 0)); // inhibit time, 100 µs
        dictionary.add(object(communication, 5, DataType::Uint, rw, 0)); // event timer, ms
    }
    dictionary.add(object(mapping, 0, DataType::Usint, rw, 0));
    for (unsigned sub = 1; sub <= CanopenSlave::kMaximumMapped; ++sub)
        dictionary.add(object(mapping, static_cast<std::uint8_t>(sub), DataType::Udint, rw, 0));
}

bool isPdoObject(std::uint16_t index) { return index >= 0x1400 && index <= 0x1BFF; }

struct Mapped {
    ObjectId id;
    unsigned bits = 0;
};

Mapped mappedOf(std::int64_t entry)
{
    const auto raw = static_cast<std::uint32_t>(entry);
    return {{static_cast<std::uint16_t>(raw >> 16), static_cast<std::uint8_t>(raw >> 8)}, raw & 0xFFU};
}

} // namespace

void CanopenSlave::addCommunicationObjects()
{
    const auto ro = ObjectAccess::ReadOnly;
    const auto rw = ObjectAccess::ReadWrite;
    const auto constant = ObjectAccess::Constant;
    m_dictionary.add(object(0x1000, 0, DataType::Udint, constant, 0x00020192)); // servo drive, CiA 402
    ObjectInfo errorRegister = object(0x1001, 0, DataType::Usint, ro, 0);
    errorRegister.mappable = true;
    m_dictionary.add(errorRegister);
    ObjectInfo errorCount = object(0x1003, 0, DataType::Usint, rw, 0);
    errorCount.maximum = 0; // writing 0 clears the list
    m_dictionary.add(errorCount);
    for (std::uint8_t sub = 1; sub <= 4; ++sub)
        m_dictionary.add(object(0x1003, sub, DataType::Udint, ro, 0));
    m_dictionary.add(object(0x1005, 0, DataType::Udint, constant, kSyncId));
    m_dictionary.add(text(0x1008, "Camwright simulated drive"));
    m_dictionary.add(text(0x1009, "1.0"));
    m_dictionary.add(text(0x100A, "1.0"));
    m_dictionary.add(object(0x100C, 0, DataType::Uint, rw, 0));  // guard time, ms
    m_dictionary.add(object(0x100D, 0, DataType::Usint, rw, 0)); // life time factor
    m_dictionary.add(object(0x1014, 0, DataType::Udint, constant, kEmergencyId + m_node));
    m_dictionary.add(object(0x1017, 0, DataType::Uint, rw, 0));  // heartbeat, ms
    m_dictionary.add(object(0x1018, 0, DataType::Usint, constant, 4));
    for (std::uint8_t sub = 1; sub <= 4; ++sub)
        m_dictionary.add(object(0x1018, sub, DataType::Udint, constant, sub == 4 ? m_node : 0));
    m_dictionary.add(object(0x1200, 0, DataType::Usint, constant, 2));
    m_dictionary.add(object(0x1200, 1, DataType::Udint, constant, kSdoClientToServer + m_node));
    m_dictionary.add(object(0x1200, 2, DataType::Udint, constant, kSdoServerToClient + m_node));
    for (unsigned number = 0; number < m_pdoCount; ++number) {
        addPdo(m_dictionary, false, number, m_node);
        addPdo(m_dictionary, true, number, m_node);
    }
}

void CanopenSlave::findSlots()
{
    m_guardTimeSlot = m_dictionary.find({0x100C, 0});
    m_lifeFactorSlot = m_dictionary.find({0x100D, 0});
    m_heartbeatSlot = m_dictionary.find({0x1017, 0});
}

void CanopenSlave::loadAllPdos()
{
    for (unsigned number = 0; number < m_pdoCount; ++number) {
        m_receive[number] = {};
        m_transmit[number] = {};
        loadPdo(false, number);
        loadPdo(true, number);
    }
}

void CanopenSlave::loadPdo(bool transmit, unsigned number)
{
    const std::uint16_t communication = static_cast<std::uint16_t>((transmit ? 0x1800 : 0x1400) + number);
    const std::uint16_t mapping = static_cast<std::uint16_t>((transmit ? 0x1A00 : 0x1600) + number);
    Pdo& pdo = transmit ? m_transmit[number] : m_receive[number];
    const bool wasValid = pdo.valid();
    pdo.cobId = static_cast<std::uint32_t>(m_dictionary.number({communication, 1}));
    pdo.type = static_cast<std::uint8_t>(m_dictionary.number({communication, 2}));
    if (transmit) {
        pdo.inhibit = std::chrono::microseconds(100 * m_dictionary.number({communication, 3}));
        pdo.eventTimer = std::chrono::milliseconds(m_dictionary.number({communication, 5}));
    }
    pdo.count = static_cast<std::uint8_t>(m_dictionary.number({mapping, 0}));
    pdo.length = 0;
    for (std::uint8_t i = 0; i < pdo.count; ++i) {
        const Mapped mapped = mappedOf(m_dictionary.number({mapping, static_cast<std::uint8_t>(i + 1)}));
        pdo.slots[i] = m_dictionary.find(mapped.id);
        pdo.length = static_cast<std::uint8_t>(pdo.length + mapped.bits / 8);
    }
    if (!wasValid && pdo.valid())
        pdo.everSent = false;
}

SdoAbort CanopenSlave::checkPdoCobId(const Pdo& pdo, std::int64_t value) const
{
    const auto wanted = static_cast<std::uint32_t>(value);
    const std::uint32_t id = wanted & 0x7FFU;
    const bool valid = (wanted & kNotValid) == 0;
    // Bit 30 (no remote request) may be set and means nothing here; extended identifiers are not supported.
    if ((wanted & 0x3FFFF800U) != 0)
        return SdoAbort::ValueRange;
    if (valid && pdo.valid() && (pdo.cobId & 0x7FFU) != id)
        return SdoAbort::ParameterIncompatible; // not changed while the PDO exists
    if (valid && (id <= 0x080 || (id >= 0x580 && id <= 0x67F) || id >= 0x6E0))
        return SdoAbort::ValueRange; // reserved for NMT, SYNC, SDO and error control
    return SdoAbort::None;
}

SdoAbort CanopenSlave::checkPdoWrite(ObjectId id, std::int64_t value) const
{
    const bool transmit = (id.index & 0x0800) != 0;
    const unsigned number = id.index & 0x01FF;
    const Pdo& pdo = transmit ? m_transmit[number] : m_receive[number];
    if ((id.index & 0x0200) != 0) {
        if (pdo.valid())
            return SdoAbort::UnsupportedAccess; // the mapping changes only while the PDO is off
        return id.sub == 0 ? checkMappingCount(id, value) : checkMappingEntry(id, value);
    }
    switch (id.sub) {
    case 1: return checkPdoCobId(pdo, value);
    case 2: return value <= 240 || value >= 254 ? SdoAbort::None : SdoAbort::ValueRange;
    case 3: return pdo.valid() ? SdoAbort::ParameterIncompatible : SdoAbort::None;
    default: return SdoAbort::None;
    }
}

SdoAbort CanopenSlave::checkMappingCount(ObjectId id, std::int64_t count) const
{
    if (count > kMaximumMapped)
        return SdoAbort::PdoTooLong;
    unsigned bits = 0;
    for (std::int64_t i = 1; i <= count; ++i) {
        const Mapped mapped = mappedOf(m_dictionary.number({id.index, static_cast<std::uint8_t>(i)}));
        if (mapped.id.index == 0)
            return SdoAbort::NoSuchObject;
        bits += mapped.bits;
    }
    return bits > 64 ? SdoAbort::PdoTooLong : SdoAbort::None;
}

SdoAbort CanopenSlave::checkMappingEntry(ObjectId id, std::int64_t value) const
{
    if (m_dictionary.number({id.index, 0}) != 0)
        return SdoAbort::UnsupportedAccess; // entries change only while their count is 0
    const Mapped mapped = mappedOf(value);
    const ObjectDictionary::Slot slot = m_dictionary.find(mapped.id);
    if (slot == ObjectDictionary::kNone)
        return SdoAbort::NoSuchObject;
    const ObjectInfo& info = m_dictionary.info(slot);
    const bool transmit = (id.index & 0x0800) != 0;
    const bool direction = transmit ? info.access != ObjectAccess::WriteOnly
                                    : info.access == ObjectAccess::ReadWrite || info.access == ObjectAccess::WriteOnly;
    if (!info.mappable || !direction)
        return SdoAbort::NotMappable;
    return mapped.bits == 8 * m_dictionary.byteSize(slot) ? SdoAbort::None : SdoAbort::NotMappable;
}

SdoAbort CanopenSlave::store(ObjectId id, ByteSpan data)
{
    ObjectDictionary::Slot slot = ObjectDictionary::kNone;
    std::int64_t value = 0;
    SdoAbort abort = m_dictionary.checkWrite(id, data, slot, value);
    if (abort != SdoAbort::None)
        return abort;
    abort = isPdoObject(id.index) ? checkPdoWrite(id, value) : m_application.checkWrite(id, value);
    if (abort != SdoAbort::None)
        return abort;
    m_dictionary.setNumber(slot, value);
    if (isPdoObject(id.index))
        communicationWritten(id);
    else
        m_application.written(id, value);
    return SdoAbort::None;
}

void CanopenSlave::communicationWritten(ObjectId id)
{
    loadPdo((id.index & 0x0800) != 0, id.index & 0x01FF);
}

} // namespace camwright
