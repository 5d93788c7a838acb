#pragma once

#include "core/base/datatype.h"

#include <cstdint>

namespace camwright {

/// What of an axis can be read by name (CONTRACTS 18). Positions in user units (mm or degree), velocities per second,
/// torque in percent of rated. The numbers are permanent: they go into saved state.
enum class AxisField : std::uint8_t {
    Position = 0, SetPosition = 1, Velocity = 2, FollowingError = 3, Torque = 4, State = 5, Error = 6,
};

/// A name after ControllerEngine::resolve(): reading through it searches nothing and allocates nothing. It is good for the
/// image it was resolved against and refused for any other.
struct ValueRef {
    enum class Source : std::uint8_t {
        Memory = 0, ///< an address or a variable
        Axis = 1,   ///< what the controller knows of an axis in this cycle
        Plant = 2,  ///< the simulated truth behind it
    };

    Source source = Source::Memory;
    DataType type = DataType::Bool;
    std::uint32_t image = 0;   ///< ControllerEngine::imageNumber() at resolve()
    // Memory
    std::uint8_t area = 0;
    bool isBit = false;
    std::uint8_t bit = 0;
    std::uint32_t byte = 0;
    // Axis, Plant
    std::uint16_t axis = 0;    ///< index into ControllerStatus::axes
    AxisField field = AxisField::Position;

    bool operator==(const ValueRef&) const = default;
};

} // namespace camwright
