#pragma once

#include "core/model/objects.h"

#include <type_traits>

namespace camwright {

/// The fields of every object that is stored as keys and values, once: reader, writer, checks and tables of an editor go
/// through these lists. `visit(key, member)` is called in the order of the file. The key is the path in the file and the
/// `Place::field` of a diagnostic; a dot separates a table from its key.
template <class Settings, class Visit>
    requires std::is_same_v<std::remove_const_t<Settings>, ProjectSettings>
void visitFields(Settings& project, Visit&& visit)
{
    visit("name", project.name);
    visit("comment", project.comment);
}

template <class Settings, class Visit>
    requires std::is_same_v<std::remove_const_t<Settings>, ControllerSettings>
void visitFields(Settings& controller, Visit&& visit)
{
    visit("family", controller.family);
    visit("model", controller.model);
    visit("scan_period_us", controller.scanPeriodUs);
    visit("watchdog_ms", controller.watchdogMs);
    visit("strict_kinco", controller.strictKinco);
    visit("comment", controller.comment);
}

template <class A, class Visit>
    requires std::is_same_v<std::remove_const_t<A>, Axis>
void visitFields(A& axis, Visit&& visit)
{
    visit("number", axis.number);
    visit("type", axis.type);
    visit("encoder_resolution", axis.encoderResolution);
    visit("mechanical_equivalent", axis.mechanicalEquivalent);
    visit("guard_time_ms", axis.guardTimeMs);
    visit("life_factor", axis.lifeFactor);
    visit("inhibit_time_ms", axis.inhibitTimeMs);
    visit("event_timer_ms", axis.eventTimerMs);
    visit("comment", axis.comment);
    visit("simulation.home_switch", axis.simulation.homeSwitch);
    visit("simulation.lower_limit_switch", axis.simulation.lowerLimitSwitch);
    visit("simulation.upper_limit_switch", axis.simulation.upperLimitSwitch);
    visit("simulation.start_position", axis.simulation.startPosition);
    visit("simulation.inertia_ratio", axis.simulation.inertiaRatio);
}

template <class N, class Visit>
    requires std::is_same_v<std::remove_const_t<N>, Network>
void visitFields(N& network, Visit&& visit)
{
    visit("baudrate", network.baudrate);
    visit("sdo_timeout_ms", network.sdoTimeoutMs);
}

} // namespace camwright
