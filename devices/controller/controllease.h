#pragma once

#include "core/base/time.h"

#include <cstdint>
#include <optional>
#include <string>

namespace camwright {

/// A connection to the controller, numbered from 1 by whoever accepts connections.
using ClientId = std::uint32_t;

/// The right to write, force, run, stop and move: one client has it, and only as long as it renews it (CONTRACTS 19).
/// Time is passed in and never goes back.
class ControlLease {
public:
    static constexpr Time Length = 500ms;

    /// True if the client has control now; false if somebody else has.
    bool take(ClientId client, const std::string& owner, Time now)
    {
        if (m_holder != 0 && m_holder != client)
            return false;
        m_holder = client;
        m_owner = owner;
        m_until = now + Length;
        return true;
    }
    /// False if the client has no control (any more); a lapsed lease is not revived.
    bool renew(ClientId client, Time now)
    {
        if (!isHeldBy(client))
            return false;
        m_until = now + Length;
        return true;
    }
    void release(ClientId client)
    {
        if (isHeldBy(client))
            clear();
    }
    /// Ends the lease if its time is over and tells whose it was, once.
    std::optional<std::string> lapse(Time now)
    {
        if (m_holder == 0 || now < m_until)
            return std::nullopt;
        std::string owner = m_owner;
        clear();
        return owner;
    }

    bool isHeldBy(ClientId client) const { return client != 0 && m_holder == client; }
    ClientId holder() const { return m_holder; } ///< 0: nobody
    const std::string& owner() const { return m_owner; }

private:
    void clear()
    {
        m_holder = 0;
        m_owner.clear();
    }

    ClientId m_holder = 0;
    std::string m_owner;
    Time m_until{};
};

} // namespace camwright
