#pragma once

#include "core/base/bytes.h"
#include "core/fieldbus/canframe.h"

#include <cstdint>
#include <string_view>

namespace camwright {

/// Abort codes of the SDO protocol (CiA 301, 7.2.4.3.17). `None` is no abort. A foreign device may send numbers that have
/// no name here.
enum class SdoAbort : std::uint32_t {
    None = 0,
    ToggleNotAlternated = 0x05030000,
    TimedOut = 0x05040000,
    UnknownCommand = 0x05040001,
    OutOfMemory = 0x05040005,
    UnsupportedAccess = 0x06010000,
    WriteOnly = 0x06010001,
    ReadOnly = 0x06010002,
    NoSuchObject = 0x06020000,
    NotMappable = 0x06040041,
    PdoTooLong = 0x06040042,
    ParameterIncompatible = 0x06040043,
    HardwareError = 0x06060000,
    LengthMismatch = 0x06070010,
    TooLong = 0x06070012,
    TooShort = 0x06070013,
    NoSuchSubindex = 0x06090011,
    ValueRange = 0x06090030,
    ValueTooHigh = 0x06090031,
    ValueTooLow = 0x06090032,
    MaximumBelowMinimum = 0x06090036,
    General = 0x08000000,
    CannotTransfer = 0x08000020,
    LocalControl = 0x08000021,
    DeviceState = 0x08000022,
};

/// English name of an abort code as CiA 301 has it; "unknown reason" for numbers without one.
std::string_view sdoAbortText(SdoAbort abort);

inline constexpr std::uint32_t kSdoServerToClient = 0x580; ///< + node: the answer
inline constexpr std::uint32_t kSdoClientToServer = 0x600; ///< + node: the request

CanFrame sdoAbortFrame(std::uint32_t cobId, std::uint16_t index, std::uint8_t sub, SdoAbort abort);

/// How an SDO request of the master ended.
enum class SdoStatus : std::uint8_t {
    Pending,
    Done,
    Aborted,    ///< the node sent an abort, its code is in the result
    TimedOut,
    Malformed,  ///< an answer that does not fit the request
    BufferFull, ///< the request could not be queued (KS-MC-10, ERRID 4)
    Busy,       ///< the node has a request outstanding; nothing was sent
    NoNode,     ///< not a node of this network
    Cancelled,  ///< by cancelSdo, a restart of the node, or a stop of the master
};

/// Client side of one transfer: makes the requests and takes the answers, expedited up to 4 bytes, segmented above.
/// Knows no time; whoever owns it counts the time-out from the last frame.
class SdoTransfer {
public:
    enum class Step : std::uint8_t { Idle, WriteStart, WriteSegment, ReadStart, ReadSegment, Ended };
    static constexpr std::size_t kMaximumBytes = 4096; ///< of one object; longer ones are aborted with OutOfMemory

    /// The first frame of a read.
    CanFrame startRead(std::uint8_t node, std::uint16_t index, std::uint8_t sub);
    /// The first frame of a write. `data` has 1 to kMaximumBytes bytes.
    CanFrame startWrite(std::uint8_t node, std::uint16_t index, std::uint8_t sub, ByteSpan data);

    /// Takes an answer frame of this node. True: `reply` holds the next frame to send (a segment, or our abort).
    bool receive(const CanFrame& frame, CanFrame& reply);
    /// Ends the transfer after a time-out; the frame tells the node.
    CanFrame timeOut();

    SdoStatus status() const { return m_status; }
    SdoAbort abort() const { return m_abort; }
    const Bytes& data() const { return m_data; } ///< what was read
    void save(ByteWriter& writer) const;
    void restore(ByteReader& reader);

private:
    void begin(Step step, std::uint8_t node, std::uint16_t index, std::uint8_t sub);
    bool takeUploadStart(const CanFrame& frame, CanFrame& reply);
    bool takeUploadSegment(const CanFrame& frame, CanFrame& reply);
    bool takeDownloadAnswer(const CanFrame& frame, CanFrame& reply);
    bool fail(SdoStatus status, SdoAbort abort, CanFrame& reply);
    bool end(SdoStatus status, SdoAbort abort);
    CanFrame request() const;
    CanFrame nextDownloadSegment();

    Bytes m_data;
    std::uint32_t m_position = 0;
    SdoAbort m_abort = SdoAbort::None;
    std::uint16_t m_index = 0;
    std::uint8_t m_sub = 0;
    std::uint8_t m_node = 0;
    Step m_step = Step::Idle;
    SdoStatus m_status = SdoStatus::Done;
    bool m_toggle = false;
    bool m_sizeKnown = false;
    std::uint32_t m_size = 0;
};

} // namespace camwright
