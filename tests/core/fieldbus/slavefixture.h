#pragma once

#include "core/fieldbus/canopenslave.h"

#include <algorithm>
#include <map>
#include <vector>

namespace camwright {

/// Keeps what was sent; can be full.
class RecordingPort final : public CanPort {
public:
    bool send(const CanFrame& frame) override
    {
        if (full)
            return false;
        frames.push_back(frame);
        return true;
    }
    std::vector<CanFrame> take()
    {
        std::vector<CanFrame> out;
        out.swap(frames);
        return out;
    }
    std::vector<CanFrame> frames;
    bool full = false;
};

inline CanFrame dataFrame(std::uint32_t id, std::vector<std::uint8_t> bytes)
{
    CanFrame frame;
    frame.id = id;
    frame.length = static_cast<std::uint8_t>(bytes.size());
    std::copy(bytes.begin(), bytes.end(), frame.data.begin());
    return frame;
}

/// A device of node 5 with a few objects: 0x6040 and 0x607A to receive, 0x6041 and 0x6064 to send, 0x2000:1 a number of 8
/// bytes for segmented writes.
class TestDevice final : public SlaveApplication {
public:
    static constexpr std::uint8_t kNode = 5;

    TestDevice() : slave(kNode, dictionary, *this, port)
    {
        add({0x6040, 0}, DataType::Uint, ObjectAccess::ReadWrite);
        add({0x607A, 0}, DataType::Dint, ObjectAccess::ReadWrite);
        add({0x6041, 0}, DataType::Uint, ObjectAccess::ReadOnly);
        add({0x6064, 0}, DataType::Dint, ObjectAccess::ReadOnly);
        add({0x2000, 1}, DataType::Ulint, ObjectAccess::ReadWrite, false);
        slave.start(Time{0});
    }
    void add(ObjectId id, DataType type, ObjectAccess access, bool mappable = true)
    {
        ObjectInfo info;
        info.id = id;
        info.type = type;
        info.access = access;
        info.mappable = mappable;
        dictionary.add(info);
    }

    SdoAbort checkWrite(ObjectId id, std::int64_t value) override
    {
        return id.index == 0x6040 && value == 0xBAD ? SdoAbort::LocalControl : SdoAbort::None;
    }
    void written(ObjectId id, std::int64_t value) override
    {
        log.push_back({id, value});
        if (id.index == 0x6040)
            targetAtControlWord = dictionary.number({0x607A, 0});
    }
    void nmtChanged(NmtState state) override { states.push_back(state); }
    void resetNode() override { ++resets; }
    void lifeGuardChanged(bool lost) override { lifeLost = lost; }

    /// One SDO request; the answer's frame.
    CanFrame sdo(std::vector<std::uint8_t> bytes, Time now = Time{0})
    {
        port.take();
        slave.receive(dataFrame(0x600 + kNode, std::move(bytes)), now);
        return port.frames.empty() ? CanFrame{} : port.frames.back();
    }
    /// Expedited write; the abort code, None if it was taken.
    SdoAbort write(ObjectId id, std::int64_t value, unsigned size)
    {
        std::vector<std::uint8_t> bytes{static_cast<std::uint8_t>(0x23 | ((4 - size) << 2)), static_cast<std::uint8_t>(id.index),
            static_cast<std::uint8_t>(id.index >> 8), id.sub};
        for (unsigned i = 0; i < 4; ++i)
            bytes.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
        const CanFrame answer = sdo(bytes);
        return abortOf(answer);
    }
    static SdoAbort abortOf(const CanFrame& answer)
    {
        if (answer.data[0] != 0x80)
            return SdoAbort::None;
        std::uint32_t code = 0;
        for (unsigned i = 0; i < 4; ++i)
            code |= std::uint32_t{answer.data[4 + i]} << (8 * i);
        return static_cast<SdoAbort>(code);
    }
    void nmt(NmtCommand command, Time now = Time{0}) { slave.receive(nmtFrame(command, kNode), now); }
    /// Transmit PDO 1 with 0x6041 and 0x6064, of this type.
    void mapTransmit(std::uint8_t type, unsigned inhibit100us = 0, unsigned eventMs = 0)
    {
        write({0x1A00, 0}, 0, 1);
        write({0x1A00, 1}, 0x60410010, 4);
        write({0x1A00, 2}, 0x60640020, 4);
        write({0x1A00, 0}, 2, 1);
        write({0x1800, 2}, type, 1);
        write({0x1800, 3}, inhibit100us, 2);
        write({0x1800, 5}, eventMs, 2);
        write({0x1800, 1}, 0x180 + kNode, 4);
    }
    void mapReceive(std::uint8_t type)
    {
        write({0x1600, 1}, 0x60400010, 4);
        write({0x1600, 2}, 0x607A0020, 4);
        write({0x1600, 0}, 2, 1);
        write({0x1400, 2}, type, 1);
        write({0x1400, 1}, 0x200 + kNode, 4);
    }
    std::vector<CanFrame> sentPdos()
    {
        std::vector<CanFrame> out = port.take();
        std::erase_if(out, [](const CanFrame& frame) { return frame.id != 0x180 + kNode; });
        return out;
    }

    RecordingPort port;
    ObjectDictionary dictionary;
    CanopenSlave slave;
    std::vector<std::pair<ObjectId, std::int64_t>> log;
    std::vector<NmtState> states;
    std::int64_t targetAtControlWord = 0;
    int resets = 0;
    bool lifeLost = false;
};

} // namespace camwright
