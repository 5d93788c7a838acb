#pragma once

#include "tests/editors/commissioning/fakelink.h"

#include <optional>

namespace camwright {

/// A link with values, terminals, a log and traces as the test gives them. As on a real link no answer comes inside the call
/// that asked for it: questions wait for deliver(). Orders are written down and answered as FakeLink does.
class ValueLink : public FakeLink {
public:
    struct Subscription {
        std::vector<std::string> names;
        Time period{};
        std::function<void(const MonitorUpdate&)> listener;
        bool operator==(const std::vector<std::string>& other) const { return names == other; }
    };

    // --- the test's side
    std::map<std::string, DataType> types;              ///< what describe() knows
    std::vector<TerminalInfo> terminalList;
    std::vector<LogEntry> entries;                      ///< what log() answers from
    std::map<SubscriptionId, Subscription> subscriptions;
    std::optional<TraceSetup> trace;                    ///< the newest start
    std::function<void(const SampleBlock&)> onBlock;
    std::size_t logListeners() const { return m_logListeners.size(); }

    /// Answers what was asked until now, and what these answers lead to.
    void deliver()
    {
        while (!m_pending.empty()) {
            const auto pending = std::exchange(m_pending, {});
            for (const auto& answerOne : pending)
                answerOne();
        }
    }
    /// A new value to whoever subscribed to it.
    void publish(const std::string& name, const Value& value, bool forced = false)
    {
        const auto copies = subscriptions;
        for (const auto& [id, subscription] : copies) {
            for (const std::string& wanted : subscription.names) {
                if (wanted == name)
                    subscription.listener(MonitorUpdate{id, status_.cycle, {{name, value, forced}}});
            }
        }
    }
    void logs(const LogEntry& entry)
    {
        entries.push_back(entry);
        for (const auto& [token, listener] : m_logListeners)
            listener(entry);
    }

    // --- ControllerLink
    RequestId write(std::string name, Value value, Reply<void> reply) override { return say("write " + name + " " + formatValue(value), reply); }
    RequestId force(std::string name, Value value, Reply<void> reply) override { return say("force " + name + " " + formatValue(value), reply); }
    RequestId release(std::string name, Reply<void> reply) override { return say("release " + name, reply); }
    RequestId describe(std::vector<std::string> names, Reply<std::vector<DataType>> reply) override
    {
        m_pending.push_back([this, names = std::move(names), reply = std::move(reply)] {
            std::vector<DataType> out;
            for (const std::string& name : names) {
                if (!types.contains(name))
                    return reply(diagnostic(Code::NameUnknown, {name}));
                out.push_back(types.at(name));
            }
            reply(out);
        });
        return {};
    }
    RequestId terminals(Reply<std::vector<TerminalInfo>> reply) override
    {
        m_pending.push_back([list = terminalList, reply = std::move(reply)] { reply(list); });
        return {};
    }
    SubscriptionId subscribe(std::vector<std::string> names, Time period, std::function<void(const MonitorUpdate&)> listener) override
    {
        const SubscriptionId id{++m_subscription};
        subscriptions[id] = {std::move(names), period, std::move(listener)};
        return id;
    }
    void unsubscribe(SubscriptionId id) override { subscriptions.erase(id); }
    RequestId startTrace(TraceSetup setup, std::function<void(const SampleBlock&)> listener, Reply<void> reply) override
    {
        trace = std::move(setup);
        onBlock = std::move(listener);
        return say("startTrace", reply);
    }
    RequestId stopTrace(Reply<void> reply) override { return say("stopTrace", reply); }
    RequestId log(std::uint64_t from, Reply<std::vector<LogEntry>> reply) override
    {
        std::vector<LogEntry> out;
        for (const LogEntry& entry : entries) {
            if (entry.sequence >= from)
                out.push_back(entry);
        }
        m_pending.push_back([out = std::move(out), reply = std::move(reply)] { reply(out); });
        return {};
    }
    int onLog(std::function<void(const LogEntry&)> listener) override
    {
        m_logListeners[--m_logToken] = std::move(listener);
        return m_logToken;
    }
    void forget(int token) override
    {
        m_logListeners.erase(token);
        FakeLink::forget(token);
    }

private:
    std::vector<std::function<void()>> m_pending;
    std::map<int, std::function<void(const LogEntry&)>> m_logListeners;
    std::uint32_t m_subscription = 0;
    int m_logToken = 0; ///< counts down: FakeLink counts up
};

} // namespace camwright
