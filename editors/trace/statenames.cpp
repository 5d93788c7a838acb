#include "editors/trace/statenames.h"

#include "core/family/family.h"
#include "editors/words/words.h"

namespace camwright {

bool isAxisState(const std::string& channel)
{
    return channel.starts_with("axis.") && channel.ends_with(".state");
}

StateNames StateNames::of(const ChannelInfo& channel, const std::string& family)
{
    StateNames out;
    out.m_isBool = channel.type == DataType::Bool;
    if (const Family* known = findFamily(family); known && isAxisState(channel.name))
        out.m_states = known->axisStates();
    return out;
}

QString StateNames::name(double value) const
{
    if (m_isBool)
        return value != 0 ? QStringLiteral("TRUE") : QStringLiteral("FALSE");
    for (const AxisState& state : m_states) {
        if (state.number == value)
            return words::pick(state.name.en, state.name.zh, state.name.ru);
    }
    return QString::number(value, 'f', 0);
}

} // namespace camwright
