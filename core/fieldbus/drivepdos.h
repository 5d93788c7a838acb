#pragma once

#include "core/fieldbus/canframe.h"

#include <array>
#include <cstdint>
#include <span>

namespace camwright {

struct DriveInputs;
struct DriveOutputs;

/// One PDO of our fixed mapping for axis nodes; transmit and receive as the node sees it. The manual does not print its
/// own (KS-MCN-09), so this one is ours (CONTRACTS 18).
struct DrivePdo {
    bool transmit = false;
    std::uint8_t number = 1;                ///< 1 … 4, of the predefined connection set
    std::uint8_t count = 0;
    std::array<std::uint32_t, 3> objects{}; ///< index, sub-index, bits as 0x1600 and 0x1A00 hold them

    std::uint32_t id(std::uint8_t node) const;
    std::span<const std::uint32_t> entries() const { return {objects.data(), count}; }
};

inline constexpr unsigned kDriveReceivePdos = 2;
inline constexpr unsigned kDriveTransmitPdos = 3;

std::span<const DrivePdo> drivePdos();

/// The receive PDO `number` (1, 2) with these outputs.
CanFrame packOutputs(const DriveOutputs& outputs, unsigned number, std::uint8_t node);
/// Takes the transmit PDO `number` (1 … 3). A frame that is too short changes nothing and gives false.
bool unpackInputs(const CanFrame& frame, unsigned number, DriveInputs& inputs);

} // namespace camwright
