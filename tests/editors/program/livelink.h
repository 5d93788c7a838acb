#pragma once

#include "tests/editors/commissioning/fakelink.h"

#include <map>

namespace camwright {

/// A link whose values come when the test pushes them.
class LiveLink : public FakeLink {
public:
    struct Subscription {
        std::vector<std::string> names;
        std::function<void(const MonitorUpdate&)> update;
    };
    std::map<std::uint32_t, Subscription> subscriptions;
    std::map<std::string, Value> values;
    std::vector<std::string> forcedNames;

    SubscriptionId subscribe(std::vector<std::string> names, Time, std::function<void(const MonitorUpdate&)> update) override
    {
        subscriptions[++m_last] = {std::move(names), std::move(update)};
        return SubscriptionId(m_last);
    }
    void unsubscribe(SubscriptionId id) override { subscriptions.erase(static_cast<std::uint32_t>(id)); }

    /// What is subscribed to, of all subscriptions, blank-separated.
    std::string asked() const
    {
        std::string out;
        for (const auto& [id, subscription] : subscriptions)
            for (const std::string& name : subscription.names)
                out += (out.empty() ? "" : " ") + name;
        return out;
    }
    void pushValues()
    {
        for (const auto& [id, subscription] : std::map(subscriptions)) {
            MonitorUpdate update;
            update.subscription = SubscriptionId(id);
            for (const std::string& name : subscription.names)
                if (const auto found = values.find(name); found != values.end())
                    update.values.push_back({name, found->second, std::find(forcedNames.begin(), forcedNames.end(), name) != forcedNames.end()});
            subscription.update(update);
        }
    }

private:
    std::uint32_t m_last = 0;
};

} // namespace camwright
