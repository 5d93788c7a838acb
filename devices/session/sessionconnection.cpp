// How a session comes to be online, stays so, and finds out that it is not any more.
#include "devices/session/sessionimpl.h"

namespace camwright {

namespace {
constexpr int TickMs = 50;
constexpr Time PingPeriod = 500ms;
constexpr Time LongestDelay = 2s;
} // namespace

OnlineSession::Impl::Impl(std::unique_ptr<Connector> c, Executor& e, SessionOptions o)
    : connector(std::move(c)), executor(e), options(std::move(o)), calls(e), reconnectDelay(options.reconnectDelay)
{
    connect(&ticker, &QTimer::timeout, this, [this] { tick(); });
    connect(&renewer, &QTimer::timeout, this, [this] { send(message::RenewControl{}); });
    ticker.start(TickMs);
    renewer.setInterval(static_cast<int>(options.renewPeriod / 1ms));
    renewer.setTimerType(Qt::PreciseTimer);
}

OnlineSession::Impl::~Impl()
{
    alive.reset();
    closeChannel();
}

void OnlineSession::Impl::start()
{
    stage = SessionStage::Opening;
    connector->open([this](Result<std::unique_ptr<ByteStream>> stream) { opened(std::move(stream)); });
}

void OnlineSession::Impl::opened(Result<std::unique_ptr<ByteStream>> stream)
{
    if (stage != SessionStage::Opening)
        return;
    if (!stream)
        return lose(stream.error(), everOnline);
    channel = std::make_unique<MessageChannel>(std::move(*stream), MessageChannel::Listener{
        [this](const Envelope& envelope) { receive(envelope); },
        [this](const std::string& reason, bool broken) {
            if (broken)
                lose(diagnostic(Code::ProtocolBroken, {connector->address(), reason}), false);
            else if (everOnline)
                lose(diagnostic(Code::LinkLost, {connector->address(), reason}), true);
            else
                lose(diagnostic(Code::CannotConnect, {connector->address(), reason}), false);
        }, {}}, message::MaximumFrame);
    stage = SessionStage::Greeting;
    silent = {};
    message::Hello hello;
    hello.client = options.client;
    ask("hello", hello, options.requestTimeout, [this](Result<Message> reply) { welcome(reply); });
}

void OnlineSession::Impl::welcome(const Result<Message>& reply)
{
    const auto* welcome = reply ? std::get_if<message::Welcome>(&*reply) : nullptr;
    if (welcome == nullptr)
        return lose(reply ? diagnostic(Code::ProtocolBroken, {connector->address(), CW_TEXT("Arguments", "no welcome")}) : reply.error(), false);
    if (welcome->major != message::ProtocolMajor)
        return lose(diagnostic(Code::ProtocolVersion, {std::to_string(welcome->major), std::to_string(message::ProtocolMajor)}), false);
    stage = SessionStage::Authenticating;
    ask("authenticate", message::Authenticate{}, options.requestTimeout, [this](Result<Message> answer) { authenticated(answer); });
}

void OnlineSession::Impl::authenticated(const Result<Message>& reply)
{
    const auto* done = reply ? std::get_if<message::Authenticated>(&*reply) : nullptr;
    if (done == nullptr)
        return lose(reply ? diagnostic(Code::ProtocolBroken, {connector->address(), CW_TEXT("Arguments", "no authentication")}) : reply.error(), false);
    capabilities = done->capabilities;
    stage = SessionStage::Syncing; // the first status makes it online
}

void OnlineSession::Impl::becomeOnline()
{
    stage = SessionStage::Online;
    everOnline = true;
    hasControl = false; // never taken again by itself
    reconnectDelay = options.reconnectDelay;
    setState(LinkState::Online, {});
}

void OnlineSession::Impl::setState(LinkState next, const Diagnostic& why)
{
    if (state == next)
        return;
    state = next;
    tell(&Impl::stateListeners, next, why);
}

void OnlineSession::Impl::closeChannel()
{
    if (!channel)
        return;
    channel->close();
    channel.release()->deleteLater(); // it may be the caller
}

void OnlineSession::Impl::lose(const Diagnostic& why, bool retry)
{
    if (stage == SessionStage::Offline || stage == SessionStage::Waiting)
        return;
    closeChannel();
    renewer.stop();
    hasControl = false;
    traceReceiver = nullptr;
    for (auto& [id, subscription] : subscriptions)
        subscription.program = {};
    const bool again = retry && options.reconnect;
    stage = again ? SessionStage::Waiting : SessionStage::Offline;
    untilReconnect = reconnectDelay;
    reconnectDelay = std::min(2 * reconnectDelay, LongestDelay);
    std::map<std::uint32_t, Pending> dropped;
    dropped.swap(pending);
    calls.failAll(why);
    setState(again ? LinkState::Lost : LinkState::Offline, why);
}

void OnlineSession::Impl::tick()
{
    // Counted in ticks, not by the clock: after this thread stood still, what has arrived meanwhile is heard first.
    constexpr Time passed = std::chrono::milliseconds(TickMs);
    if (stage == SessionStage::Waiting) {
        untilReconnect -= passed;
        if (untilReconnect <= Time{})
            start();
        return;
    }
    if (!channel)
        return;
    silent += passed;
    if (stage == SessionStage::Online && silent > options.silenceTimeout)
        return lose(diagnostic(Code::LinkLost, {connector->address(), englishText(diagnostic(Code::ReadSilent,
                        {std::to_string(options.silenceTimeout / 1s)}))}), true);
    if (stage == SessionStage::Syncing && silent > options.requestTimeout)
        return lose(diagnostic(Code::RequestTimedOut, {"status", std::to_string(options.requestTimeout / 1s)}), everOnline);
    std::vector<Pending> late;
    for (auto it = pending.begin(); it != pending.end();) {
        it->second.left -= passed;
        if (it->second.left > Time{}) {
            ++it;
            continue;
        }
        late.push_back(std::move(it->second));
        it = pending.erase(it);
    }
    const std::weak_ptr<bool> guard(alive);
    for (const Pending& request : late) {
        request.then(diagnostic(Code::RequestTimedOut, {request.what, std::to_string(request.timeout / 1s)}));
        if (guard.expired())
            return;
    }
    sincePing += passed;
    if (stage == SessionStage::Online && sincePing >= PingPeriod) {
        sincePing = {};
        send(message::Ping{});
    }
}

void OnlineSession::Impl::ask(const char* what, Message message, Time timeout, Then then)
{
    if (!channel)
        return then(diagnostic(Code::NotConnected));
    const std::uint32_t number = ++lastRequest == 0 ? ++lastRequest : lastRequest;
    pending[number] = {what, timeout, timeout, std::move(then)};
    if (channel->send({number, std::move(message)}))
        return;
    const Then refused = std::move(pending[number].then);
    pending.erase(number);
    refused(diagnostic(Code::TooMuchAsked, {what, CW_TEXT("Arguments", "more than a message"), std::to_string(message::MaximumFrame)}));
}

void OnlineSession::Impl::receive(const Envelope& envelope)
{
    silent = {};
    if (envelope.request == 0)
        return push(envelope.message);
    const auto found = pending.find(envelope.request);
    if (found == pending.end())
        return; // answered too late, or cancelled
    const Then then = std::move(found->second.then);
    pending.erase(found);
    if (const auto* failed = std::get_if<message::Failed>(&envelope.message))
        then(failed->reason);
    else
        then(envelope.message);
}

void OnlineSession::Impl::push(const Message& message)
{
    if (const auto* pushed = std::get_if<message::Status>(&message)) {
        const bool otherProgram = status.program != pushed->status.program;
        status = pushed->status;
        seeCycle(status.cycle);
        if (stage == SessionStage::Syncing)
            becomeOnline();
        if (hasControl && status.control != ControlHolder::You) {
            hasControl = false;
            renewer.stop();
        }
        if (otherProgram)
            for (auto& [id, subscription] : subscriptions)
                subscription.program = {};
        subscribeAll();
        tell(&Impl::statusListeners, status);
    } else if (const auto* update = std::get_if<message::Update>(&message)) {
        takeUpdate(*update);
    } else if (const auto* block = std::get_if<message::TraceBlock>(&message)) {
        send(message::TraceBlockTaken{block->block.channelSet, block->block.sequence});
        takeBlock(block->block);
    } else if (const auto* beat = std::get_if<message::Beat>(&message)) {
        seeCycle(beat->cycle);
    } else if (const auto* logged = std::get_if<message::Logged>(&message)) {
        tell(&Impl::logListeners, logged->entry);
    } else if (const auto* failed = std::get_if<message::Failed>(&message)) {
        lose(failed->reason, false); // the controller closes and says why
    }
}

} // namespace camwright
