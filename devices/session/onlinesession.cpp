#include "devices/session/onlinesession.h"

#include "devices/session/sessionimpl.h"

namespace camwright {

OnlineSession::OnlineSession(std::unique_ptr<Connector> connector, Executor& executor, SessionOptions options)
    : m_impl(std::make_unique<Impl>(std::move(connector), executor, std::move(options)))
{
    m_impl->start();
}

OnlineSession::~OnlineSession() = default;

void OnlineSession::disconnect()
{
    m_impl->lose(diagnostic(Code::NotConnected), false);
    m_impl->stage = SessionStage::Offline;
    m_impl->setState(LinkState::Offline, diagnostic(Code::NotConnected));
}

LinkState OnlineSession::state() const { return m_impl->state; }
LinkCapabilities OnlineSession::capabilities() const { return m_impl->capabilities; }
std::string OnlineSession::address() const { return m_impl->connector->address(); }
const ControllerStatus& OnlineSession::status() const { return m_impl->status; }

RequestId OnlineSession::Impl::requestDone(Message message, ControllerLink::Reply<void> reply)
{
    return request<message::Done, void>(std::move(message), std::move(reply), [](message::Done&&) { return Result<void>(); });
}

// --- control, run, stop ---

RequestId OnlineSession::takeControl(Reply<void> reply)
{
    return m_impl->request<message::Done, void>(message::TakeControl{}, std::move(reply), [impl = m_impl.get()](message::Done&&) {
        impl->hasControl = true;
        impl->renewer.start();
        return Result<void>();
    });
}

RequestId OnlineSession::releaseControl(Reply<void> reply)
{
    m_impl->hasControl = false;
    m_impl->renewer.stop();
    return m_impl->requestDone(message::ReleaseControl{}, std::move(reply));
}

RequestId OnlineSession::exitController(Reply<void> reply) { return m_impl->requestDone(message::Exit{}, std::move(reply)); }
RequestId OnlineSession::run(Reply<void> reply) { return m_impl->requestDone(message::Run{}, std::move(reply)); }
RequestId OnlineSession::stop(Reply<void> reply) { return m_impl->requestDone(message::Stop{}, std::move(reply)); }

// --- values ---

RequestId OnlineSession::read(std::vector<std::string> names, Reply<std::vector<MonitoredValue>> reply)
{
    using Found = std::vector<MonitoredValue>;
    message::Read message{m_impl->status.program, names};
    return m_impl->request<message::Values, Found>(std::move(message), std::move(reply),
        [names = std::move(names), address = address()](message::Values&& answer) -> Result<Found> {
            Found out;
            for (const message::IndexedValue& value : answer.values) {
                if (value.index >= names.size())
                    return diagnostic(Code::ProtocolBroken, {address, CW_TEXT("Arguments", "a value nobody asked for")});
                out.push_back({names[value.index], value.value, value.forced});
            }
            if (out.size() != names.size())
                return diagnostic(Code::ProtocolBroken, {address, CW_TEXT("Arguments", "fewer values than were asked for")});
            return out;
        });
}

RequestId OnlineSession::write(std::string name, Value value, Reply<void> reply)
{
    return m_impl->requestDone(message::Write{m_impl->status.program, std::move(name), value}, std::move(reply));
}

RequestId OnlineSession::force(std::string name, Value value, Reply<void> reply)
{
    return m_impl->requestDone(message::Force{m_impl->status.program, std::move(name), value}, std::move(reply));
}

RequestId OnlineSession::release(std::string name, Reply<void> reply)
{
    return m_impl->requestDone(message::Release{m_impl->status.program, std::move(name)}, std::move(reply));
}

RequestId OnlineSession::forced(Reply<std::vector<MonitoredValue>> reply)
{
    using Found = std::vector<MonitoredValue>;
    return m_impl->request<message::Forces, Found>(message::ReadForces{}, std::move(reply),
        [](message::Forces&& answer) { return Result<Found>(std::move(answer.values)); });
}

RequestId OnlineSession::terminals(Reply<std::vector<TerminalInfo>> reply)
{
    using Found = std::vector<TerminalInfo>;
    return m_impl->request<message::Terminals, Found>(message::ReadTerminals{}, std::move(reply),
        [](message::Terminals&& answer) { return Result<Found>(std::move(answer.terminals)); });
}

RequestId OnlineSession::describe(std::vector<std::string> names, Reply<std::vector<DataType>> reply)
{
    using Found = std::vector<DataType>;
    const std::size_t count = names.size();
    return m_impl->request<message::Types, Found>(message::Describe{m_impl->status.program, std::move(names)}, std::move(reply),
        [count, address = address()](message::Types&& answer) -> Result<Found> {
            if (answer.types.size() != count)
                return diagnostic(Code::ProtocolBroken, {address, CW_TEXT("Arguments", "another number of types than was asked for")});
            return std::move(answer.types);
        });
}

// --- subscriptions ---

SubscriptionId OnlineSession::subscribe(std::vector<std::string> names, Time period, std::function<void(const MonitorUpdate&)> receive)
{
    const SubscriptionId id{++m_impl->lastSubscription};
    m_impl->subscriptions[id] = {std::move(names), period, std::move(receive), {}};
    m_impl->subscribeAll();
    return id;
}

void OnlineSession::unsubscribe(SubscriptionId id)
{
    if (m_impl->subscriptions.erase(id) != 0 && m_impl->stage == SessionStage::Online)
        m_impl->send(message::Unsubscribe{static_cast<std::uint32_t>(id)});
}

void OnlineSession::Impl::subscribeAll()
{
    if (stage != SessionStage::Online || status.program.isNull())
        return;
    for (auto& [id, subscription] : subscriptions)
        if (subscription.program != status.program)
            sendSubscription(id, subscription);
}

void OnlineSession::Impl::sendSubscription(SubscriptionId id, Subscription& subscription)
{
    subscription.program = status.program;
    message::Subscribe wanted{status.program, static_cast<std::uint32_t>(id), subscription.names, subscription.period};
    ask("subscribe", std::move(wanted), options.requestTimeout, [this, id](Result<Message> answer) {
        const auto found = subscriptions.find(id);
        // The program has changed meanwhile, or the answer was lost: the next status asks again.
        const bool again = !answer && (answer.error().code == Code::OtherProgram || answer.error().code == Code::RequestTimedOut);
        if (found != subscriptions.end() && again)
            found->second.program = {};
    });
}

void OnlineSession::Impl::takeUpdate(const message::Update& update)
{
    seeCycle(update.cycle);
    const SubscriptionId id{update.subscription};
    const auto found = subscriptions.find(id);
    if (found == subscriptions.end() || update.program != found->second.program)
        return;
    MonitorUpdate out;
    out.subscription = id;
    out.cycle = update.cycle;
    for (const message::IndexedValue& value : update.values)
        if (value.index < found->second.names.size())
            out.values.push_back({found->second.names[value.index], value.value, value.forced});
    executor.post([this, guard = std::weak_ptr(alive), out = std::move(out)] {
        if (guard.expired())
            return;
        const auto still = subscriptions.find(out.subscription);
        if (still != subscriptions.end()) {
            const auto receive = still->second.receive; // it may unsubscribe
            receive(out);
        }
    });
}

// --- trace ---

RequestId OnlineSession::startTrace(TraceSetup setup, std::function<void(const SampleBlock&)> receive, Reply<void> reply)
{
    return m_impl->request<message::Done, void>(message::StartTrace{m_impl->status.program, std::move(setup)}, std::move(reply),
        [impl = m_impl.get(), receive = std::move(receive)](message::Done&&) {
            impl->traceReceiver = receive;
            impl->traceSet.reset();
            ++impl->traceNumber;
            return Result<void>();
        });
}

RequestId OnlineSession::stopTrace(Reply<void> reply) { return m_impl->requestDone(message::StopTrace{}, std::move(reply)); }

void OnlineSession::Impl::takeBlock(const SampleBlock& block)
{
    if (!traceReceiver)
        return;
    if (!traceSet && !block.channels.empty())
        traceSet = block.channelSet;
    if (traceSet != block.channelSet)
        return; // the rest of an earlier trace
    executor.post([this, guard = std::weak_ptr(alive), block, number = traceNumber] {
        if (guard.expired() || number != traceNumber || !traceReceiver)
            return;
        const auto receive = traceReceiver;
        receive(block);
    });
}

// --- motion ---

RequestId OnlineSession::command(AxisCommand command, Reply<void> reply)
{
    return m_impl->requestDone(message::Axis{std::move(command)}, std::move(reply));
}

RequestId OnlineSession::stopAllAxes(Reply<void> reply)
{
    if (m_impl->stage != SessionStage::Online)
        m_impl->send(message::StopAll{}); // accepted at any time, even before the handshake is done
    return m_impl->requestDone(message::StopAll{}, std::move(reply));
}

void OnlineSession::heartbeat()
{
    if (m_impl->stage == SessionStage::Online)
        m_impl->send(message::Heartbeat{m_impl->newestCycle});
}

// --- log, listeners ---

RequestId OnlineSession::log(std::uint64_t fromSequence, Reply<std::vector<LogEntry>> reply)
{
    using Found = std::vector<LogEntry>;
    return m_impl->request<message::LogEntries, Found>(message::ReadLog{fromSequence}, std::move(reply),
        [](message::LogEntries&& answer) { return Result<Found>(std::move(answer.entries)); });
}

void OnlineSession::cancel(RequestId id) { m_impl->calls.cancel(id); }

int OnlineSession::onStateChanged(std::function<void(LinkState, const Diagnostic& why)> listener)
{
    m_impl->stateListeners[++m_impl->lastToken] = std::move(listener);
    return m_impl->lastToken;
}

int OnlineSession::onStatus(std::function<void(const ControllerStatus&)> listener)
{
    m_impl->statusListeners[++m_impl->lastToken] = std::move(listener);
    return m_impl->lastToken;
}

int OnlineSession::onLog(std::function<void(const LogEntry&)> listener)
{
    m_impl->logListeners[++m_impl->lastToken] = std::move(listener);
    return m_impl->lastToken;
}

void OnlineSession::forget(int token)
{
    m_impl->stateListeners.erase(token);
    m_impl->statusListeners.erase(token);
    m_impl->logListeners.erase(token);
}

} // namespace camwright
