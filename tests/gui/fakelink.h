#pragma once

#include "core/online/controllerlink.h"

#include <cmath>

namespace camwright {

/// A controller that answers everything at once with plausible values, for pictures: Feed is moving, Turn stands.
class FakeLink final : public ControllerLink {
public:
    FakeLink()
    {
        m_status.state = RunState::Run;
        m_status.family = "kinco";
        m_status.model = "KS101M-04DX";
        m_status.projectName = "kinco-feeder";
        m_status.scanMs = 0.21;
        m_status.scanMaxMs = 0.4;
        m_status.busLoadPercent = 7;
        m_status.forces = 1;
        m_status.control = ControlHolder::You;
        m_status.program = hash;
        m_status.cycle = 72000;
        m_status.time = Time(72'000'000'000);
        AxisStatus feed;
        feed.name = "Feed";
        feed.number = 1;
        feed.state = 2;
        feed.stateName = "Discrete_Motion";
        feed.enabled = feed.homed = feed.moving = feed.online = true;
        feed.position = 187.432;
        feed.setPosition = 187.9;
        feed.velocity = 100;
        feed.followingError = 0.468;
        feed.torque = 12.5;
        feed.unit = "mm";
        feed.lastCause = "MC_MABS from the program";
        AxisStatus turn = feed;
        turn.name = "Turn";
        turn.number = 2;
        turn.state = 1;
        turn.stateName = "Standstill";
        turn.moving = false;
        turn.position = turn.setPosition = 0;
        turn.velocity = turn.followingError = turn.torque = 0;
        turn.unit = "°";
        m_status.axes = {feed, turn};
    }

    static inline Hash hash = [] {
        Hash out{};
        out.bytes[0] = 7;
        return out;
    }();

    LinkState state() const override { return LinkState::Online; }
    LinkCapabilities capabilities() const override
    {
        LinkCapabilities out;
        out.download = out.runStop = out.write = out.force = out.trace = out.motion = out.terminals = out.simulated = true;
        return out;
    }
    std::string address() const override { return "local"; }
    const ControllerStatus& status() const override { return m_status; }
    RequestId takeControl(Reply<void> reply) override { return done(reply); }
    RequestId releaseControl(Reply<void> reply) override { return done(reply); }
    RequestId planDownload(DownloadPackage, Reply<DownloadPlan> reply) override
    {
        DownloadPlan plan;
        plan.mustStop = true;
        plan.lines = {{"program Main", "changes", {}}, {"axis Feed", "loses its home", {}}};
        reply(plan);
        return {};
    }
    RequestId download(DownloadPackage, std::function<void(double)> progress, Reply<void> reply) override
    {
        progress(1);
        return done(reply);
    }
    RequestId run(Reply<void> reply) override { return done(reply); }
    RequestId stop(Reply<void> reply) override { return done(reply); }
    RequestId read(std::vector<std::string> names, Reply<std::vector<MonitoredValue>> reply) override
    {
        std::vector<MonitoredValue> out;
        for (const std::string& name : names)
            out.push_back({name, Value::ofBool(true), false});
        reply(out);
        return {};
    }
    RequestId write(std::string, Value, Reply<void> reply) override { return done(reply); }
    RequestId force(std::string, Value, Reply<void> reply) override { return done(reply); }
    RequestId release(std::string, Reply<void> reply) override { return done(reply); }
    RequestId forced(Reply<std::vector<MonitoredValue>> reply) override
    {
        reply(std::vector<MonitoredValue>{{"%I0.3", Value::ofBool(true), true}});
        return {};
    }
    RequestId terminals(Reply<std::vector<TerminalInfo>> reply) override
    {
        std::vector<TerminalInfo> out;
        for (int i = 0; i < 8; ++i)
            out.push_back({"%I0." + std::to_string(i), true});
        for (int i = 0; i < 6; ++i)
            out.push_back({"%Q0." + std::to_string(i), false});
        reply(out);
        return {};
    }
    RequestId describe(std::vector<std::string> names, Reply<std::vector<DataType>> reply) override
    {
        std::vector<DataType> out;
        for (const std::string& name : names)
            out.push_back(name.starts_with("axis.") ? DataType::Lreal : DataType::Bool);
        reply(out);
        return {};
    }
    SubscriptionId subscribe(std::vector<std::string> names, Time, std::function<void(const MonitorUpdate&)> update) override
    {
        MonitorUpdate out;
        out.subscription = SubscriptionId(++m_subscriptions);
        out.cycle = m_status.cycle;
        for (const std::string& name : names)
            out.values.push_back({name, name.starts_with("axis.") ? Value::ofLreal(187.432) : Value::ofBool(true), name == "%I0.3"});
        update(out);
        return out.subscription;
    }
    void unsubscribe(SubscriptionId) override {}
    RequestId startTrace(TraceSetup setup, std::function<void(const SampleBlock&)> block, Reply<void> reply) override
    {
        SampleBlock out;
        out.firstCycle = 1000;
        out.last = false;
        for (std::size_t c = 0; c < setup.channels.size(); ++c) {
            const bool state = setup.channels[c].ends_with(".state"), bit = setup.channels[c].starts_with("%");
            out.channels.push_back({setup.channels[c], state ? DataType::Usint : bit ? DataType::Bool : DataType::Lreal, state || bit ? "" : "mm"});
            static constexpr double States[] = {0, 2, 5, 2, 3, 3, 2, 4, 1, 1};
            std::vector<double> column;
            for (int i = 0; i < 2000; ++i)
                column.push_back(state ? States[i / 200] : bit ? double(i / 300 % 2) : 100 * std::sin(i * 0.005 + double(c)));
            out.columns.push_back(column);
        }
        done(reply);
        block(out);
        return {};
    }
    RequestId stopTrace(Reply<void> reply) override { return done(reply); }
    RequestId command(AxisCommand, Reply<void> reply) override { return done(reply); }
    RequestId stopAllAxes(Reply<void> reply) override { return done(reply); }
    void heartbeat() override {}
    RequestId log(std::uint64_t, Reply<std::vector<LogEntry>> reply) override
    {
        reply(std::vector<LogEntry>{{1, 0, Time(0), diagnostic(Code::Cancelled)}});
        return {};
    }
    void cancel(RequestId) override {}
    int onStateChanged(std::function<void(LinkState, const Diagnostic&)>) override { return 1; }
    int onStatus(std::function<void(const ControllerStatus&)>) override { return 2; }
    int onLog(std::function<void(const LogEntry&)>) override { return 3; }
    void forget(int) override {}

private:
    static RequestId done(const Reply<void>& reply)
    {
        reply(Result<void>());
        return {};
    }

    ControllerStatus m_status;
    std::uint32_t m_subscriptions = 0;
};

} // namespace camwright
