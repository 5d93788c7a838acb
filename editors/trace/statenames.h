#pragma once

#include "core/online/sampleblock.h"

#include <QString>

#include <span>

namespace camwright {

struct AxisState;

/// What the numbers of a channel are called: the states of an axis in its family's words, TRUE and FALSE. Most channels are
/// quantities and have no names.
class StateNames {
public:
    StateNames() = default;
    /// `family` is that of the controller that recorded the channel.
    static StateNames of(const ChannelInfo& channel, const std::string& family);

    bool hasNames() const { return m_isBool || !m_states.empty(); }
    bool isBool() const { return m_isBool; }
    /// In the language of the program; the number itself where the family knows no such state.
    QString name(double value) const;

private:
    bool m_isBool = false;
    std::span<const AxisState> m_states;
};

/// Whether a name is that of an axis's state: "axis.Feed.state", "axis."Axis 1".state", "axis.1.state".
bool isAxisState(const std::string& channel);

} // namespace camwright
