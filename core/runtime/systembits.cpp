#include "core/runtime/systembits.h"

#include "core/family/invt/invtareas.h"
#include "core/family/kinco/kincoareas.h"
#include "core/family/koyo/koyoareas.h"

#include <array>

namespace camwright {

namespace {

void writeKinco(Memory& memory, const ScanMoment& moment)
{
    memory.write(bitAddress(kinco::SM, 0, kinco::AlwaysOnBit), Value::ofBool(true));
    memory.write(bitAddress(kinco::SM, 0, kinco::FirstScanBit), Value::ofBool(moment.firstScan));
}

struct Clock {
    std::uint32_t flag;
    Time period;
};

constexpr std::array<Clock, 5> kClocks{{{10, 10ms}, {11, 100ms}, {12, 1s}, {13, 60s}, {14, 3600s}}};

void writeInvt(Memory& memory, const ScanMoment& moment)
{
    const auto set = [&](std::uint32_t flag, bool on) { memory.write(bitAddress(invt::SM, flag), Value::ofBool(on)); };
    set(0, moment.running);
    set(1, moment.running && moment.firstScan);
    set(2, moment.running && moment.firstAfterPowerOn);
    set(3, moment.error);
    for (const Clock& clock : kClocks)
        set(clock.flag, moment.running && moment.now % clock.period < clock.period / 2);
    set(15, moment.toggle);
    set(23, false);
    set(24, false);
}

constexpr std::array<Clock, 4> kKoyoClocks{{{koyo::Minute, 60s}, {koyo::Second, 1s}, {koyo::Tenth, 100ms}, {koyo::Twentieth, 50ms}}};

void writeKoyo(Memory& memory, const ScanMoment& moment)
{
    const auto set = [&](std::uint32_t relay, bool on) { memory.write(bitAddress(koyo::SP, relay / 8, relay % 8), Value::ofBool(on)); };
    set(koyo::FirstScan, moment.running && moment.firstScan);
    set(koyo::AlwaysOn, true);
    set(koyo::AlwaysOff, false);
    for (const Clock& clock : kKoyoClocks)
        set(clock.flag, moment.running && moment.now % clock.period < clock.period / 2);
    set(koyo::Alternate, moment.toggle);
}

} // namespace

void writeSystemBits(std::string_view family, Memory& memory, const ScanMoment& moment)
{
    if (family == "kinco")
        writeKinco(memory, moment);
    else if (family == "invt")
        writeInvt(memory, moment);
    else if (family == "koyo")
        writeKoyo(memory, moment);
}

} // namespace camwright
