#pragma once

#include "core/fieldbus/canopenmaster.h"
#include "core/runtime/plant/simulatedbus.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace camwright {

/// A master and simulated drives on one wire, stepped in motion cycles of a millisecond. Everything goes by CAN frames.
class Network {
public:
    explicit Network(unsigned axes, std::uint32_t baudrate = 1'000'000, SimulatedDriveConfig drive = {}, MasterNodeConfig node = {})
        : bus(baudrate)
    {
        MasterConfig config;
        for (unsigned i = 1; i <= axes; ++i) {
            drive.node = static_cast<std::uint8_t>(i);
            node.node = static_cast<std::uint8_t>(i);
            bus.addDrive(drive);
            config.nodes.push_back(node);
        }
        master = std::make_unique<CanopenMaster>(config, bus.masterPort());
        outputs.resize(axes);
    }

    void powerOn()
    {
        bus.powerOn(now);
        master->start(now);
    }
    void cycle()
    {
        now += 1ms;
        bus.advance(now, *master);
        for (std::size_t i = 0; i < outputs.size(); ++i)
            master->setOutputs(static_cast<std::uint8_t>(i + 1), outputs[i]);
        master->step(now);
    }
    void run(Time span)
    {
        for (const Time end = now + span; now < end;)
            cycle();
    }
    /// True when the condition came true within the time.
    bool until(const std::function<bool()>& condition, Time limit)
    {
        for (const Time end = now + limit; now < end;) {
            if (condition())
                return true;
            cycle();
        }
        return condition();
    }
    bool boot()
    {
        powerOn();
        return until([this] { return allOnline(); }, 1s);
    }
    bool allOnline() const
    {
        for (const MasterNodeConfig& node : master->config().nodes) {
            if (!master->isOnline(node.node))
                return false;
        }
        return true;
    }
    DriveOutputs& out(unsigned axis) { return outputs[axis - 1]; }
    const DriveInputs& in(unsigned axis) const { return master->inputs(static_cast<std::uint8_t>(axis)); }
    SimulatedDrive& drive(unsigned axis) { return bus.drive(axis - 1); }
    bool status(unsigned axis, unsigned mask, unsigned value) const { return (in(axis).statusWord & mask) == value; }

    bool enable(unsigned axis, std::int8_t mode)
    {
        out(axis).mode = mode;
        for (const std::uint16_t word : {0x06, 0x07, 0x0F}) {
            out(axis).controlWord = word;
            const unsigned wanted = word == 0x06 ? 0x21 : word == 0x07 ? 0x23 : 0x27;
            if (!until([&] { return status(axis, 0x6F, wanted); }, 200ms))
                return false;
        }
        return until([&] { return in(axis).mode == mode; }, 200ms);
    }
    /// The set-point handshake. `bits` may add 5 (change immediately) and 6 (relative).
    bool setPoint(unsigned axis, std::int32_t target, std::uint32_t velocity, std::uint16_t bits = 0)
    {
        out(axis).targetPosition = target;
        out(axis).profileVelocity = velocity;
        out(axis).controlWord = static_cast<std::uint16_t>(0x1F | bits);
        if (!until([&] { return status(axis, 0x1000, 0x1000); }, 200ms))
            return false;
        out(axis).controlWord = 0x0F;
        return until([&] { return status(axis, 0x1000, 0); }, 200ms);
    }
    bool reached(unsigned axis) const { return status(axis, 0x0400, 0x0400); }

    SdoResult write(unsigned axis, ObjectId object, std::int64_t value, unsigned bytes)
    {
        return await(master->writeSdo(static_cast<std::uint8_t>(axis), object, value, bytes, now));
    }
    SdoResult read(unsigned axis, ObjectId object) { return await(master->readSdo(static_cast<std::uint8_t>(axis), object, now)); }
    std::int64_t readNumber(unsigned axis, ObjectId object, DataType type)
    {
        std::int64_t value = 0;
        read(axis, object).number(type, value);
        return value;
    }
    SdoResult await(CanopenMaster::SdoHandle handle)
    {
        for (;;) {
            SdoResult result = master->takeSdo(handle);
            if (result.status != SdoStatus::Pending)
                return result;
            cycle();
        }
    }
    Bytes save() const
    {
        ByteWriter writer;
        bus.save(writer);
        master->save(writer);
        return writer.take();
    }
    bool restore(const Bytes& bytes)
    {
        ByteReader reader(bytes);
        bus.restore(reader);
        master->restore(reader);
        now = bus.wire().now();
        return reader.ok() && reader.atEnd();
    }

    SimulatedBus bus;
    std::unique_ptr<CanopenMaster> master;
    std::vector<DriveOutputs> outputs;
    Time now{0};
};

} // namespace camwright
