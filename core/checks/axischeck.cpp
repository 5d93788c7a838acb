#include "core/checks/fieldcheck.h"
#include "core/checks/projectcheck.h"
#include "core/fieldbus/busload.h"
#include "core/model/fieldlist.h"

#include <fmt/format.h>

#include <algorithm>

namespace camwright {

namespace {

/// Only of an axis without diagnostics; out-of-range numbers never get further than the check.
ValidAxis validAxis(const std::string& name, const Axis& axis)
{
    ValidAxis out;
    out.name = name;
    out.number = static_cast<std::uint8_t>(axis.number.value());
    out.type = axis.type.value();
    out.encoderResolution = axis.encoderResolution.value();
    out.mechanicalEquivalent = axis.mechanicalEquivalent.value();
    out.guardTimeMs = static_cast<std::uint16_t>(axis.guardTimeMs.value());
    out.lifeFactor = static_cast<std::uint8_t>(axis.lifeFactor.value());
    out.inhibitTimeMs = static_cast<std::uint16_t>(axis.inhibitTimeMs.value());
    out.eventTimerMs = static_cast<std::uint16_t>(axis.eventTimerMs.value());
    out.homeSwitch = axis.simulation.homeSwitch.value();
    out.lowerLimitSwitch = axis.simulation.lowerLimitSwitch.value();
    out.upperLimitSwitch = axis.simulation.upperLimitSwitch.value();
    out.startPosition = axis.simulation.startPosition.value();
    out.inertiaRatio = axis.simulation.inertiaRatio.value();
    return out;
}

} // namespace

void ProjectCheck::checkAxes()
{
    const std::vector<ObjectPtr> axes = m_project.objects(ObjectKind::Axis);
    for (const ObjectPtr& object : axes) {
        const auto& axis = std::get<Axis>(object->content);
        const std::size_t before = m_out.size();
        visitFields(axis, FieldCheck(object->key, m_out));
        const auto lower = axis.simulation.lowerLimitSwitch, upper = axis.simulation.upperLimitSwitch;
        if (lower.isValid() && upper.isValid() && !(lower.value() < upper.value()))
            report(Code::SwitchesSwapped, {numberText(lower.value()), numberText(upper.value())},
                   Place{object->key, "simulation.lower_limit_switch", {}, {}});
        if (m_out.size() == before)
            m_valid.m_axes.push_back(validAxis(object->key.name, axis));
    }
    std::sort(m_valid.m_axes.begin(), m_valid.m_axes.end(), [](const ValidAxis& a, const ValidAxis& b) { return a.number < b.number; });
    checkAxisNumbers();
    checkAxisLimit(axes.size());
}

/// Contiguous from 1 (KS-MCN-06).
void ProjectCheck::checkAxisNumbers()
{
    std::map<std::int64_t, ObjectKey> byNumber;
    for (const ObjectPtr& object : m_project.objects(ObjectKind::Axis)) {
        const Field<std::int64_t>& number = std::get<Axis>(object->content).number;
        if (!number.isValid())
            continue;
        const Place place{object->key, "number", {}, {}};
        const auto [first, added] = byNumber.emplace(number.value(), object->key);
        if (!added)
            report(Code::AxisNumberTwice, {std::to_string(number.value()), first->second.name, object->key.name}, place,
                   Place{first->second, "number", {}, {}});
    }
    std::int64_t expected = 1;
    for (const auto& [number, key] : byNumber) {
        if (number < 1)
            continue; // out of range, said before
        if (number != expected)
            report(Code::AxisNumberGap, {std::to_string(expected)}, Place{key, "number", {}, {}});
        expected = number + 1;
    }
}

void ProjectCheck::checkAxisLimit(std::size_t count)
{
    if (!m_valid.m_model || count == 0)
        return;
    const Place place{controllerKey(), "model", {}, {}};
    if (m_valid.m_model->axesMax == 0)
        report(Code::NoMotionNetwork, {m_valid.m_model->name}, place);
    else if (count > m_valid.m_model->axesMax) // KS-MCN-10
        report(Code::TooManyAxes, {std::to_string(count), m_valid.m_model->name, std::to_string(m_valid.m_model->axesMax)}, place);
}

void ProjectCheck::checkNetworks()
{
    const std::vector<ObjectPtr> networks = m_project.objects(ObjectKind::Network);
    const bool hasAxes = !m_project.objects(ObjectKind::Axis).empty();
    if (networks.empty()) {
        if (hasAxes)
            report(Code::NetworkMissing, {}, Place{projectKey(), {}, {}, {}});
        return;
    }
    if (m_valid.m_model && m_valid.m_model->axesMax == 0 && !hasAxes)
        report(Code::NoMotionNetwork, {m_valid.m_model->name}, Place{controllerKey(), "model", {}, {}});
    for (std::size_t n = 1; n < networks.size(); ++n)
        report(Code::SecondNetwork, {networks[n]->key.name}, Place{networks[n]->key, {}, {}, {}}, Place{networks[0]->key, {}, {}, {}});
    for (const ObjectPtr& object : networks) {
        const auto& network = std::get<Network>(object->content);
        visitFields(network, FieldCheck(object->key, m_out));
        const auto rates = offeredBaudrates();
        if (!network.baudrate.isValid() || std::find(rates.begin(), rates.end(), network.baudrate.value()) != rates.end())
            continue;
        std::string offered;
        for (const std::int64_t rate : rates)
            offered += (offered.empty() ? "" : ", ") + std::to_string(rate);
        report(Code::BaudrateNotOffered, {std::to_string(network.baudrate.value()), offered}, Place{object->key, "baudrate", {}, {}});
    }
    const auto& first = std::get<Network>(networks.front()->content);
    if (first.baudrate.isValid() && first.sdoTimeoutMs.isValid())
        m_valid.m_network = ValidNetwork{networks.front()->key.name, static_cast<std::uint32_t>(first.baudrate.value()),
                                         std::chrono::milliseconds(std::clamp<std::int64_t>(first.sdoTimeoutMs.value(), 1, 60'000))};
}

/// KS-CAN-04: more than the wire can carry is allowed, and never works as it should.
void ProjectCheck::checkBusLoad()
{
    if (!m_valid.m_network || m_valid.m_network->baudrate == 0)
        return;
    std::vector<Time> inhibitTimes;
    for (const ValidAxis& axis : m_valid.m_axes)
        inhibitTimes.push_back(std::chrono::milliseconds(axis.inhibitTimeMs));
    const double load = axisBusLoad(inhibitTimes, m_valid.m_network->baudrate);
    if (load > 1)
        report(Code::BusOverloaded,
               {std::to_string(inhibitTimes.size()), fmt::format("{:.2f}", load * 100), std::to_string(m_valid.m_network->baudrate)},
               Place{{ObjectKind::Network, m_valid.m_network->name}, "baudrate", {}, {}});
}

} // namespace camwright
