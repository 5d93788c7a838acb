#pragma once

#include <array>
#include <cstdint>

namespace camwright {

/// A classical CAN frame as it stands on the wire, standard (11-bit) or extended (29-bit) identifier.
struct CanFrame {
    std::uint32_t id = 0;
    bool extended = false;
    bool remote = false;
    std::uint8_t length = 0; ///< 0 … 8
    std::array<std::uint8_t, 8> data{};

    bool operator==(const CanFrame&) const = default;
};

/// Where a protocol engine puts its frames: the simulated wire, or an adapter to a real port.
class CanPort {
public:
    virtual ~CanPort() = default;
    /// False when the send buffer is full (KS-MC-10, ERRID 4); the frame is not queued then.
    virtual bool send(const CanFrame& frame) = 0;
    /// For a frame that must not wait (a stop): it goes before everything that waits and takes the place of waiting frames
    /// with its identifier. A full buffer does not refuse it. Ports that cannot do so queue it.
    virtual bool sendFirst(const CanFrame& frame) { return send(frame); }
};

} // namespace camwright
