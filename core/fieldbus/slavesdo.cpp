#include "core/fieldbus/canopenslave.h"

#include "core/fieldbus/framebytes.h"

#include <algorithm>

// The slave's SDO server.

namespace camwright {

namespace {

ObjectId objectOf(const CanFrame& frame)
{
    return {static_cast<std::uint16_t>(getLittle(&frame.data[1], 2)), frame.data[3]};
}

void putObject(CanFrame& frame, ObjectId id)
{
    putLittle(&frame.data[1], id.index, 2);
    frame.data[3] = id.sub;
}

} // namespace

void CanopenSlave::receiveSdo(const CanFrame& frame)
{
    if (frame.length != 8)
        return;
    CanFrame reply;
    reply.id = kSdoServerToClient + m_node;
    reply.length = 8;
    switch (frame.data[0] >> 5) {
    case 0: serveDownloadSegment(frame, reply); break;
    case 1: serveDownload(frame, reply); break;
    case 2: serveUpload(frame, reply); break;
    case 3: serveUploadSegment(frame, reply); break;
    case 4: m_server = {}; return; // the client gave up
    default:
        m_server.id = objectOf(frame);
        abortTransfer(SdoAbort::UnknownCommand, reply);
    }
    send(reply);
}

void CanopenSlave::abortTransfer(SdoAbort abort, CanFrame& reply)
{
    reply = sdoAbortFrame(kSdoServerToClient + m_node, m_server.id.index, m_server.id.sub, abort);
    m_server = {};
}

void CanopenSlave::serveUpload(const CanFrame& frame, CanFrame& reply)
{
    m_server = {};
    m_server.id = objectOf(frame);
    const SdoAbort abort = m_dictionary.read(m_server.id, m_server.data);
    if (abort != SdoAbort::None)
        return abortTransfer(abort, reply);
    putObject(reply, m_server.id);
    const std::size_t size = m_server.data.size();
    if (size >= 1 && size <= 4) {
        reply.data[0] = static_cast<std::uint8_t>(0x43 | ((4 - size) << 2));
        std::copy(m_server.data.begin(), m_server.data.end(), reply.data.begin() + 4);
        m_server = {};
        return;
    }
    reply.data[0] = 0x41;
    putLittle(&reply.data[4], size, 4);
    m_server.active = true;
}

void CanopenSlave::serveUploadSegment(const CanFrame& frame, CanFrame& reply)
{
    const bool toggle = (frame.data[0] & 0x10) != 0;
    if (!m_server.active || m_server.writing)
        return abortTransfer(SdoAbort::UnknownCommand, reply);
    if (toggle != m_server.toggle)
        return abortTransfer(SdoAbort::ToggleNotAlternated, reply);
    const std::size_t size = std::min<std::size_t>(7, m_server.data.size() - m_server.position);
    const bool last = m_server.position + size == m_server.data.size();
    reply.data[0] = static_cast<std::uint8_t>((toggle ? 0x10 : 0) | ((7 - size) << 1) | (last ? 1 : 0));
    std::copy_n(m_server.data.begin() + m_server.position, size, reply.data.begin() + 1);
    m_server.position += static_cast<std::uint32_t>(size);
    m_server.toggle = !toggle;
    if (last)
        m_server = {};
}

void CanopenSlave::serveDownload(const CanFrame& frame, CanFrame& reply)
{
    m_server = {};
    m_server.id = objectOf(frame);
    const std::uint8_t command = frame.data[0];
    const bool expedited = (command & 0x02) != 0;
    const bool sized = (command & 0x01) != 0;
    if (!expedited) {
        const std::uint64_t size = sized ? getLittle(&frame.data[4], 4) : 0;
        if (size > SdoTransfer::kMaximumBytes)
            return abortTransfer(SdoAbort::OutOfMemory, reply);
        m_server.expected = static_cast<std::uint32_t>(size);
        m_server.active = true;
        m_server.writing = true;
        reply.data[0] = 0x60;
        putObject(reply, m_server.id);
        return;
    }
    std::size_t size = 4 - ((command >> 2) & 3U);
    if (!sized) {
        // The client does not say how many of the four bytes count: as many as the object has.
        const ObjectDictionary::Slot slot = m_dictionary.find(m_server.id);
        size = slot == ObjectDictionary::kNone ? 4 : std::min<std::size_t>(4, m_dictionary.byteSize(slot));
    }
    const SdoAbort abort = store(m_server.id, ByteSpan(frame.data).subspan(4, size));
    if (abort != SdoAbort::None)
        return abortTransfer(abort, reply);
    reply.data[0] = 0x60;
    putObject(reply, m_server.id);
    m_server = {};
}

void CanopenSlave::serveDownloadSegment(const CanFrame& frame, CanFrame& reply)
{
    const bool toggle = (frame.data[0] & 0x10) != 0;
    if (!m_server.active || !m_server.writing)
        return abortTransfer(SdoAbort::UnknownCommand, reply);
    if (toggle != m_server.toggle)
        return abortTransfer(SdoAbort::ToggleNotAlternated, reply);
    const std::size_t size = 7 - ((frame.data[0] >> 1) & 7U);
    if (m_server.data.size() + size > SdoTransfer::kMaximumBytes)
        return abortTransfer(SdoAbort::OutOfMemory, reply);
    m_server.data.insert(m_server.data.end(), frame.data.begin() + 1, frame.data.begin() + 1 + static_cast<std::ptrdiff_t>(size));
    m_server.toggle = !toggle;
    if ((frame.data[0] & 0x01) != 0) {
        if (m_server.expected != 0 && m_server.data.size() != m_server.expected)
            return abortTransfer(SdoAbort::LengthMismatch, reply);
        const SdoAbort abort = store(m_server.id, m_server.data);
        if (abort != SdoAbort::None)
            return abortTransfer(abort, reply);
        m_server = {};
    }
    reply.data[0] = static_cast<std::uint8_t>(0x20 | (toggle ? 0x10 : 0));
}

} // namespace camwright
