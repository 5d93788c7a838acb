#pragma once

#include "core/online/controllerlink.h"

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace camwright {

/// A link that writes down what is asked of it. Answers come when the test says so, in order, or at once with `autoAnswer`.
class FakeLink : public ControllerLink {
public:
    FakeLink()
    {
        m_can.motion = m_can.simulated = true;
        status_.family = "kinco";
        status_.model = "KS101M-04DX";
        status_.control = ControlHolder::You;
        AxisStatus axis;
        axis.name = "Feed";
        axis.number = 1;
        axis.state = 2;
        axis.enabled = axis.homed = axis.online = true;
        axis.unit = "mm";
        status_.axes = {axis};
    }

    // --- the test's side
    std::vector<std::string> said;         ///< "jog Feed 5", "stop Feed", "stopAll", "takeControl"
    int beats = 0;
    bool autoAnswer = true;
    LinkCapabilities m_can;
    ControllerStatus status_;
    std::vector<Reply<void>> waiting;

    AxisStatus& axis() { return status_.axes[0]; }
    void push()
    {
        ++status_.cycle;
        for (auto& [token, listener] : m_statusListeners)
            listener(status_);
    }
    void setState(LinkState state)
    {
        m_state = state;
        for (auto& [token, listener] : m_stateListeners)
            listener(state, Diagnostic());
    }
    void answer(Result<void> result = {})
    {
        const auto reply = waiting.front();
        waiting.erase(waiting.begin());
        reply(std::move(result));
    }
    std::vector<std::string> take()
    {
        return std::exchange(said, {});
    }

    // --- ControllerLink
    LinkState state() const override { return m_state; }
    LinkCapabilities capabilities() const override { return m_can; }
    std::string address() const override { return "fake"; }
    const ControllerStatus& status() const override { return status_; }
    RequestId takeControl(Reply<void> reply) override { return say("takeControl", reply); }
    RequestId releaseControl(Reply<void> reply) override { return say("releaseControl", reply); }
    RequestId planDownload(DownloadPackage, Reply<DownloadPlan>) override { return {}; }
    RequestId download(DownloadPackage, std::function<void(double)>, Reply<void>) override { return {}; }
    RequestId run(Reply<void>) override { return {}; }
    RequestId stop(Reply<void>) override { return {}; }
    RequestId read(std::vector<std::string>, Reply<std::vector<MonitoredValue>>) override { return {}; }
    RequestId write(std::string, Value, Reply<void>) override { return {}; }
    RequestId force(std::string, Value, Reply<void>) override { return {}; }
    RequestId release(std::string, Reply<void>) override { return {}; }
    RequestId forced(Reply<std::vector<MonitoredValue>>) override { return {}; }
    RequestId terminals(Reply<std::vector<TerminalInfo>>) override { return {}; }
    RequestId describe(std::vector<std::string>, Reply<std::vector<DataType>>) override { return {}; }
    SubscriptionId subscribe(std::vector<std::string>, Time, std::function<void(const MonitorUpdate&)>) override { return {}; }
    void unsubscribe(SubscriptionId) override {}
    RequestId startTrace(TraceSetup, std::function<void(const SampleBlock&)>, Reply<void>) override { return {}; }
    RequestId stopTrace(Reply<void>) override { return {}; }
    RequestId command(AxisCommand order, Reply<void> reply) override
    {
        static const std::map<AxisCommandKind, std::string> names{{AxisCommandKind::Arm, "arm"}, {AxisCommandKind::Disarm, "disarm"},
            {AxisCommandKind::Enable, "enable"}, {AxisCommandKind::Disable, "disable"}, {AxisCommandKind::Reset, "reset"},
            {AxisCommandKind::Home, "home"}, {AxisCommandKind::MoveAbsolute, "moveTo"}, {AxisCommandKind::MoveRelative, "moveBy"},
            {AxisCommandKind::Velocity, "velocity"}, {AxisCommandKind::Jog, "jog"}, {AxisCommandKind::Stop, "stop"}};
        std::string line = names.at(order.kind) + " " + order.axis;
        if (order.kind == AxisCommandKind::MoveAbsolute || order.kind == AxisCommandKind::MoveRelative)
            line += " " + number(order.position);
        if (order.velocity != 0)
            line += " " + number(order.velocity);
        if (order.acceleration != 0)
            line += " acc " + number(order.acceleration);
        if (order.kind == AxisCommandKind::Arm)
            axis().panelArmed = true;
        return say(line, reply);
    }
    RequestId stopAllAxes(Reply<void> reply) override { return say("stopAll", reply); }
    void heartbeat() override { ++beats; }
    RequestId log(std::uint64_t, Reply<std::vector<LogEntry>>) override { return {}; }
    void cancel(RequestId) override {}
    int onStateChanged(std::function<void(LinkState, const Diagnostic&)> listener) override
    {
        m_stateListeners[++m_token] = std::move(listener);
        return m_token;
    }
    int onStatus(std::function<void(const ControllerStatus&)> listener) override
    {
        m_statusListeners[++m_token] = std::move(listener);
        return m_token;
    }
    int onLog(std::function<void(const LogEntry&)>) override { return ++m_token; }
    void forget(int token) override
    {
        m_stateListeners.erase(token);
        m_statusListeners.erase(token);
    }

protected:
    static std::string number(double value)
    {
        std::string text = std::to_string(value);
        while (text.back() == '0')
            text.pop_back();
        if (text.back() == '.')
            text.pop_back();
        return text;
    }
    RequestId say(const std::string& line, const Reply<void>& reply)
    {
        said.push_back(line);
        waiting.push_back(reply);
        if (autoAnswer)
            answer();
        return RequestId(said.size());
    }

private:
    LinkState m_state = LinkState::Online;
    int m_token = 0;
    std::map<int, std::function<void(LinkState, const Diagnostic&)>> m_stateListeners;
    std::map<int, std::function<void(const ControllerStatus&)>> m_statusListeners;
};

} // namespace camwright
