#include "core/checks/checkproject.h"

#include <algorithm>
#include <array>

namespace camwright {

namespace {

/// No ranges are printed in the manual (KS-MCN). Ours follow from the CANopen objects behind the fields: node addresses,
/// guard time 0x100C (16 bits), life factor 0x100D (8 bits), inhibit time 0x1800:3 (16 bits of 100 us), event timer
/// 0x1800:5 (16 bits). Switch and start positions are wide enough for any machine and safe in pulse counts.
struct RangeRow {
    ObjectKind kind;
    std::string_view field;
    FieldRange range;
};

constexpr RangeRow Ranges[] = {
    {ObjectKind::Controller, "scan_period_us", {0, 1'000'000}},
    {ObjectKind::Controller, "watchdog_ms", {1, 60'000}},
    {ObjectKind::Axis, "number", {1, 127}},
    {ObjectKind::Axis, "encoder_resolution", {1, 2'147'483'647}},
    {ObjectKind::Axis, "mechanical_equivalent", {1e-6, 1e6}},
    {ObjectKind::Axis, "guard_time_ms", {0, 65'535}},
    {ObjectKind::Axis, "life_factor", {0, 255}},
    {ObjectKind::Axis, "inhibit_time_ms", {0, 6'553}},
    {ObjectKind::Axis, "event_timer_ms", {0, 65'535}},
    {ObjectKind::Axis, "simulation.home_switch", {-1e9, 1e9}},
    {ObjectKind::Axis, "simulation.lower_limit_switch", {-1e9, 1e9}},
    {ObjectKind::Axis, "simulation.upper_limit_switch", {-1e9, 1e9}},
    {ObjectKind::Axis, "simulation.start_position", {-1e9, 1e9}},
    {ObjectKind::Axis, "simulation.inertia_ratio", {0, 1000}},
    {ObjectKind::Network, "sdo_timeout_ms", {1, 60'000}},
};

struct BaudrateRow {
    std::int64_t baudrate;
    std::int64_t sdoTimeoutMs;
};

/// An SDO takes two frames of at most 135 bits; the proposals leave a slow drive some 50 ms, and stay within the 100 ms
/// of KS-COM-04 where the rate allows.
constexpr BaudrateRow Baudrates[] = {{10'000, 500}, {20'000, 300}, {50'000, 200}, {125'000, 100}, {250'000, 100}, {500'000, 100}, {800'000, 100}, {1'000'000, 100}};

} // namespace

std::span<const std::int64_t> offeredBaudrates()
{
    static constexpr auto Rates = [] {
        std::array<std::int64_t, std::size(Baudrates)> out{};
        for (std::size_t n = 0; n < out.size(); ++n)
            out[n] = Baudrates[n].baudrate;
        return out;
    }();
    return Rates;
}

std::int64_t proposedSdoTimeoutMs(std::int64_t baudrate)
{
    const auto row = std::find_if(std::begin(Baudrates), std::end(Baudrates), [&](const BaudrateRow& r) { return r.baudrate >= baudrate; });
    return row == std::end(Baudrates) ? 100 : row->sdoTimeoutMs;
}

std::optional<FieldRange> fieldRange(ObjectKind kind, std::string_view field)
{
    for (const RangeRow& row : Ranges) {
        if (row.kind == kind && row.field == field)
            return row.range;
    }
    return std::nullopt;
}

} // namespace camwright
