#pragma once

#include "core/fieldbus/canframe.h"

#include <cstdint>

namespace camwright {

/// NMT states as they stand in node guarding answers and heartbeats (KS-COM-12).
enum class NmtState : std::uint8_t { BootUp = 0, Stopped = 4, Operational = 5, PreOperational = 127 };

/// NMT commands (KS-COM-11).
enum class NmtCommand : std::uint8_t { Start = 1, Stop = 2, EnterPreOperational = 128, ResetNode = 129, ResetCommunication = 130 };

inline constexpr std::uint32_t kNmtId = 0x000;
inline constexpr std::uint32_t kSyncId = 0x080;
inline constexpr std::uint32_t kEmergencyId = 0x080;     ///< + node
inline constexpr std::uint32_t kErrorControlId = 0x700;  ///< + node

/// The predefined connection set: identifier of the PDO `number` (1 … 4) of a node, seen from the node.
constexpr std::uint32_t transmitPdoId(unsigned number, std::uint8_t node) { return 0x080 + 0x100 * number + node; }
constexpr std::uint32_t receivePdoId(unsigned number, std::uint8_t node) { return 0x100 + 0x100 * number + node; }

/// `node` 0 addresses all.
CanFrame nmtFrame(NmtCommand command, std::uint8_t node);
CanFrame guardRequest(std::uint8_t node);
CanFrame syncFrame();

} // namespace camwright
