#include "core/runtime/blocks/programblocks.h"

#include "core/runtime/blocks/datablocks.h"

#include <array>

namespace camwright {

namespace {

std::uint64_t bcdOf(unsigned value)
{
    return value / 10 << 4 | value % 10;
}

/// 100, which no part of a date is, for what is no BCD number.
unsigned fromBcd(std::uint64_t bcd)
{
    const auto high = static_cast<unsigned>(bcd >> 4 & 0xF);
    const auto low = static_cast<unsigned>(bcd & 0xF);
    return high > 9 || low > 9 ? 100 : 10 * high + low;
}

/// Kinco counts Monday as 1 and Sunday as 7.
unsigned fromMonday(unsigned weekday)
{
    return weekday == 0 ? 7 : weekday;
}

void readBcd(const CalendarTime& moment, PinValues& pins)
{
    const std::array<unsigned, 8> parts{static_cast<unsigned>(moment.year - 2000), moment.month, moment.day, moment.hour,
                                        moment.minute, moment.second, 0, fromMonday(moment.weekday)};
    for (std::uint32_t i = 0; i < parts.size(); ++i)
        datablocks::setElement(pins, 0, i, bcdOf(parts[i]));
}

CalendarTime bcdMoment(PinValues& pins)
{
    const auto part = [&](std::uint32_t i) { return fromBcd(datablocks::elementBits(pins, 0, i)); };
    return {2000 + static_cast<int>(part(0)), part(1), part(2), part(3), part(4), part(5), 0};
}

std::array<std::int64_t, 7> partsOf(const CalendarTime& moment, unsigned weekday)
{
    return {moment.year, moment.month, moment.day, moment.hour, moment.minute, moment.second, weekday};
}

/// A number outside 0 … 9999 is no part of a date.
CalendarTime momentOf(const std::array<std::int64_t, 6>& parts)
{
    for (const std::int64_t part : parts)
        if (part < 0 || part > 9999)
            return {0, 0, 0, 0, 0, 0, 0};
    const auto number = [&](std::size_t i) { return static_cast<unsigned>(parts[i]); };
    return {static_cast<int>(parts[0]), number(1), number(2), number(3), number(4), number(5), 0};
}

} // namespace

void ProgramBlocks::call(InstructionId instruction, const BlockInstance& instance, PinValues& pins)
{
    if (callInterrupts(instruction, instance, pins) || callClock(instruction, instance, pins) || runDataBlock(instruction, pins))
        return;
    m_motion.call(instruction, instance, pins);
}

bool ProgramBlocks::callInterrupts(InstructionId instruction, const BlockInstance& instance, PinValues& pins)
{
    switch (instruction) {
    case InstructionId::KincoAtch: {
        const auto event = static_cast<std::uint32_t>(pins.read(1).asInteger());
        m_interrupts.attach(event, static_cast<std::uint32_t>(pins.read(0).bits), pins.memory(), instance.now);
        return true;
    }
    case InstructionId::KincoDtch: m_interrupts.detach(static_cast<std::uint32_t>(pins.read(0).asInteger())); return true;
    case InstructionId::KincoEni:
    case InstructionId::InvtEi: m_interrupts.enable(true); return true;
    case InstructionId::KincoDisi:
    case InstructionId::InvtDi: m_interrupts.enable(false); return true;
    default: return false;
    }
}

bool ProgramBlocks::callClock(InstructionId instruction, const BlockInstance& instance, PinValues& pins)
{
    const auto set = [&](const CalendarTime& moment) {
        const bool exists = moment.exists();
        if (exists)
            m_clock.set(moment, instance.now);
        return exists;
    };
    const CalendarTime now = m_clock.read(instance.now);
    switch (instruction) {
    case InstructionId::KincoReadRtc: readBcd(now, pins); return true;
    case InstructionId::KincoSetRtc: set(bcdMoment(pins)); return true;
    case InstructionId::KincoRtcR: {
        const auto parts = partsOf(now, fromMonday(now.weekday));
        for (std::size_t i = 0; i < parts.size(); ++i)
            pins.write(i, Value::ofInteger(DataType::Int, parts[i]));
        return true;
    }
    case InstructionId::KincoRtcW: {
        std::array<std::int64_t, 6> parts{};
        for (std::size_t i = 0; i < parts.size(); ++i)
            parts[i] = pins.read(i).asInteger();
        pins.write(parts.size(), !set(momentOf(parts)));
        return true;
    }
    case InstructionId::InvtTrd: {
        const auto parts = partsOf(now, now.weekday);
        for (std::uint32_t i = 0; i < parts.size(); ++i)
            datablocks::setElement(pins, 0, i, static_cast<std::uint64_t>(parts[i]));
        return true;
    }
    case InstructionId::InvtTwr: {
        std::array<std::int64_t, 6> parts{};
        for (std::uint32_t i = 0; i < parts.size(); ++i)
            parts[i] = static_cast<std::int64_t>(datablocks::elementBits(pins, 0, i));
        if (!set(momentOf(parts)))
            datablocks::reportIllegalParameter(pins);
        return true;
    }
    default: return false;
    }
}

void ProgramBlocks::save(ByteWriter& writer) const
{
    m_interrupts.save(writer);
    m_clock.save(writer);
}

void ProgramBlocks::restore(ByteReader& reader)
{
    m_interrupts.restore(reader);
    m_clock.restore(reader);
}

} // namespace camwright
