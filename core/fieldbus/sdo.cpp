#include "core/fieldbus/sdo.h"

#include "core/base/codes.h"
#include "core/fieldbus/framebytes.h"

#include <algorithm>

namespace camwright {

std::string_view sdoAbortText(SdoAbort abort)
{
    switch (abort) {
    case SdoAbort::None: return CW_TEXT("Arguments", "no abort");
    case SdoAbort::ToggleNotAlternated: return CW_TEXT("Arguments", "toggle bit not alternated");
    case SdoAbort::TimedOut: return CW_TEXT("Arguments", "SDO protocol timed out");
    case SdoAbort::UnknownCommand: return CW_TEXT("Arguments", "command specifier not valid or unknown");
    case SdoAbort::OutOfMemory: return CW_TEXT("Arguments", "out of memory");
    case SdoAbort::UnsupportedAccess: return CW_TEXT("Arguments", "unsupported access to an object");
    case SdoAbort::WriteOnly: return CW_TEXT("Arguments", "attempt to read a write-only object");
    case SdoAbort::ReadOnly: return CW_TEXT("Arguments", "attempt to write a read-only object");
    case SdoAbort::NoSuchObject: return CW_TEXT("Arguments", "object does not exist in the object dictionary");
    case SdoAbort::NotMappable: return CW_TEXT("Arguments", "object cannot be mapped to the PDO");
    case SdoAbort::PdoTooLong: return CW_TEXT("Arguments", "number and length of the mapped objects exceed the PDO");
    case SdoAbort::ParameterIncompatible: return CW_TEXT("Arguments", "general parameter incompatibility");
    case SdoAbort::HardwareError: return CW_TEXT("Arguments", "access failed due to a hardware error");
    case SdoAbort::LengthMismatch: return CW_TEXT("Arguments", "length of the parameter does not match");
    case SdoAbort::TooLong: return CW_TEXT("Arguments", "parameter is too long");
    case SdoAbort::TooShort: return CW_TEXT("Arguments", "parameter is too short");
    case SdoAbort::NoSuchSubindex: return CW_TEXT("Arguments", "sub-index does not exist");
    case SdoAbort::ValueRange: return CW_TEXT("Arguments", "value outside the permitted range");
    case SdoAbort::ValueTooHigh: return CW_TEXT("Arguments", "value too high");
    case SdoAbort::ValueTooLow: return CW_TEXT("Arguments", "value too low");
    case SdoAbort::MaximumBelowMinimum: return CW_TEXT("Arguments", "maximum is less than minimum");
    case SdoAbort::General: return CW_TEXT("Arguments", "general error");
    case SdoAbort::CannotTransfer: return CW_TEXT("Arguments", "data cannot be transferred or stored");
    case SdoAbort::LocalControl: return CW_TEXT("Arguments", "data cannot be stored because of local control");
    case SdoAbort::DeviceState: return CW_TEXT("Arguments", "data cannot be stored in the present device state");
    }
    return CW_TEXT("Arguments", "unknown reason");
}

CanFrame sdoAbortFrame(std::uint32_t cobId, std::uint16_t index, std::uint8_t sub, SdoAbort abort)
{
    CanFrame frame;
    frame.id = cobId;
    frame.length = 8;
    frame.data[0] = 0x80;
    putLittle(&frame.data[1], index, 2);
    frame.data[3] = sub;
    putLittle(&frame.data[4], static_cast<std::uint32_t>(abort), 4);
    return frame;
}

void SdoTransfer::begin(Step step, std::uint8_t node, std::uint16_t index, std::uint8_t sub)
{
    *this = {};
    m_step = step;
    m_node = node;
    m_index = index;
    m_sub = sub;
    m_status = SdoStatus::Pending;
}

CanFrame SdoTransfer::request() const
{
    CanFrame frame;
    frame.id = kSdoClientToServer + m_node;
    frame.length = 8;
    putLittle(&frame.data[1], m_index, 2);
    frame.data[3] = m_sub;
    return frame;
}

CanFrame SdoTransfer::startRead(std::uint8_t node, std::uint16_t index, std::uint8_t sub)
{
    begin(Step::ReadStart, node, index, sub);
    CanFrame frame = request();
    frame.data[0] = 0x40;
    return frame;
}

CanFrame SdoTransfer::startWrite(std::uint8_t node, std::uint16_t index, std::uint8_t sub, ByteSpan data)
{
    begin(Step::WriteStart, node, index, sub);
    m_data.assign(data.begin(), data.end());
    CanFrame frame = request();
    if (data.size() <= 4) {
        frame.data[0] = static_cast<std::uint8_t>(0x23 | ((4 - data.size()) << 2));
        std::copy(data.begin(), data.end(), frame.data.begin() + 4);
    } else {
        frame.data[0] = 0x21;
        putLittle(&frame.data[4], data.size(), 4);
    }
    return frame;
}

bool SdoTransfer::end(SdoStatus status, SdoAbort abort)
{
    m_step = Step::Ended;
    m_status = status;
    m_abort = abort;
    return false;
}

bool SdoTransfer::fail(SdoStatus status, SdoAbort abort, CanFrame& reply)
{
    end(status, abort);
    reply = sdoAbortFrame(kSdoClientToServer + m_node, m_index, m_sub, abort);
    return true;
}

CanFrame SdoTransfer::timeOut()
{
    end(SdoStatus::TimedOut, SdoAbort::TimedOut);
    return sdoAbortFrame(kSdoClientToServer + m_node, m_index, m_sub, SdoAbort::TimedOut);
}

bool SdoTransfer::receive(const CanFrame& frame, CanFrame& reply)
{
    if (m_status != SdoStatus::Pending)
        return false;
    if (frame.remote || frame.length != 8)
        return fail(SdoStatus::Malformed, SdoAbort::General, reply);
    const bool forUs = getLittle(&frame.data[1], 2) == m_index && frame.data[3] == m_sub;
    const bool starting = m_step == Step::ReadStart || m_step == Step::WriteStart;
    if (frame.data[0] == 0x80) {
        if (!forUs)
            return false; // the late abort of a request given up before
        return end(SdoStatus::Aborted, static_cast<SdoAbort>(getLittle(&frame.data[4], 4)));
    }
    if (starting && !forUs)
        return false; // the late answer of a request given up before
    switch (m_step) {
    case Step::ReadStart: return takeUploadStart(frame, reply);
    case Step::ReadSegment: return takeUploadSegment(frame, reply);
    default: return takeDownloadAnswer(frame, reply);
    }
}

bool SdoTransfer::takeUploadStart(const CanFrame& frame, CanFrame& reply)
{
    const std::uint8_t command = frame.data[0];
    if ((command & 0xE0) != 0x40)
        return fail(SdoStatus::Malformed, SdoAbort::UnknownCommand, reply);
    if ((command & 0x02) != 0) {
        const unsigned size = (command & 0x01) != 0 ? 4 - ((command >> 2) & 3U) : 4;
        m_data.assign(frame.data.begin() + 4, frame.data.begin() + 4 + size);
        return end(SdoStatus::Done, SdoAbort::None);
    }
    m_sizeKnown = (command & 0x01) != 0;
    m_size = static_cast<std::uint32_t>(getLittle(&frame.data[4], 4));
    if (m_sizeKnown && m_size > kMaximumBytes)
        return fail(SdoStatus::Malformed, SdoAbort::OutOfMemory, reply);
    m_step = Step::ReadSegment;
    reply = CanFrame{};
    reply.id = kSdoClientToServer + m_node;
    reply.length = 8;
    reply.data[0] = 0x60;
    return true;
}

bool SdoTransfer::takeUploadSegment(const CanFrame& frame, CanFrame& reply)
{
    const std::uint8_t command = frame.data[0];
    if ((command & 0xE0) != 0)
        return fail(SdoStatus::Malformed, SdoAbort::UnknownCommand, reply);
    if (((command & 0x10) != 0) != m_toggle)
        return fail(SdoStatus::Malformed, SdoAbort::ToggleNotAlternated, reply);
    const unsigned size = 7 - ((command >> 1) & 7U);
    if (m_data.size() + size > kMaximumBytes)
        return fail(SdoStatus::Malformed, SdoAbort::OutOfMemory, reply);
    m_data.insert(m_data.end(), frame.data.begin() + 1, frame.data.begin() + 1 + size);
    if ((command & 0x01) != 0) {
        if (m_sizeKnown && m_data.size() != m_size)
            return end(SdoStatus::Malformed, SdoAbort::LengthMismatch);
        return end(SdoStatus::Done, SdoAbort::None);
    }
    m_toggle = !m_toggle;
    reply = CanFrame{};
    reply.id = kSdoClientToServer + m_node;
    reply.length = 8;
    reply.data[0] = static_cast<std::uint8_t>(0x60 | (m_toggle ? 0x10 : 0));
    return true;
}

CanFrame SdoTransfer::nextDownloadSegment()
{
    CanFrame frame;
    frame.id = kSdoClientToServer + m_node;
    frame.length = 8;
    const std::size_t size = std::min<std::size_t>(7, m_data.size() - m_position);
    const bool last = m_position + size == m_data.size();
    frame.data[0] = static_cast<std::uint8_t>((m_toggle ? 0x10 : 0) | ((7 - size) << 1) | (last ? 1 : 0));
    std::copy_n(m_data.begin() + m_position, size, frame.data.begin() + 1);
    m_position += static_cast<std::uint32_t>(size);
    return frame;
}

bool SdoTransfer::takeDownloadAnswer(const CanFrame& frame, CanFrame& reply)
{
    const std::uint8_t command = frame.data[0];
    if (m_step == Step::WriteStart) {
        if (command != 0x60)
            return fail(SdoStatus::Malformed, SdoAbort::UnknownCommand, reply);
        if (m_data.size() <= 4)
            return end(SdoStatus::Done, SdoAbort::None);
        m_step = Step::WriteSegment;
        reply = nextDownloadSegment();
        return true;
    }
    if ((command & 0xE0) != 0x20)
        return fail(SdoStatus::Malformed, SdoAbort::UnknownCommand, reply);
    if (((command & 0x10) != 0) != m_toggle)
        return fail(SdoStatus::Malformed, SdoAbort::ToggleNotAlternated, reply);
    if (m_position == m_data.size())
        return end(SdoStatus::Done, SdoAbort::None);
    m_toggle = !m_toggle;
    reply = nextDownloadSegment();
    return true;
}

void SdoTransfer::save(ByteWriter& writer) const
{
    writer.putBlob(m_data);
    writer.put(m_position);
    writer.put(m_abort);
    writer.put(m_index);
    writer.put(m_sub);
    writer.put(m_node);
    writer.put(m_step);
    writer.put(m_status);
    writer.put(m_toggle);
    writer.put(m_sizeKnown);
    writer.put(m_size);
}

void SdoTransfer::restore(ByteReader& reader)
{
    const ByteSpan data = reader.getBlob();
    m_data.assign(data.begin(), data.end());
    m_position = reader.get<std::uint32_t>();
    m_abort = reader.get<SdoAbort>();
    m_index = reader.get<std::uint16_t>();
    m_sub = reader.get<std::uint8_t>();
    m_node = reader.get<std::uint8_t>();
    m_step = reader.get<Step>();
    m_status = reader.get<SdoStatus>();
    m_toggle = reader.getBool();
    m_sizeKnown = reader.getBool();
    m_size = reader.get<std::uint32_t>();
    if (m_position > m_data.size() || m_step > Step::Ended || m_status > SdoStatus::Cancelled)
        reader.fail();
}

} // namespace camwright
