#pragma once

#include "core/online/piecesizer.h"
#include "devices/session/onlinesession.h"
#include "devices/session/sessioncalls.h"
#include "devices/transport/messagechannel.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include <map>
#include <memory>
#include <optional>

namespace camwright {

/// Where a session stands on its way to Online.
enum class SessionStage : std::uint8_t { Offline, Opening, Greeting, Authenticating, Syncing, Online, Waiting };

class OnlineSession::Impl final : public QObject {
public:
    Impl(std::unique_ptr<Connector> connector, Executor& executor, SessionOptions options);
    ~Impl() override;

    // --- connection ---
    void start();
    void opened(Result<std::unique_ptr<ByteStream>> stream);
    void receive(const Envelope& envelope);
    void push(const Message& message);
    void welcome(const Result<Message>& reply);
    void authenticated(const Result<Message>& reply);
    void becomeOnline();
    void lose(const Diagnostic& why, bool retry);
    void closeChannel();
    void setState(LinkState next, const Diagnostic& why);
    void tick();

    // --- requests on the wire ---
    using Then = std::function<void(Result<Message>)>;
    void ask(const char* what, Message message, Time timeout, Then then);
    /// Asks when online and ends the call with `take(answer)`; fails it otherwise.
    template <class Answer, class T, class Take>
    RequestId request(Message message, ControllerLink::Reply<T> reply, Take take);
    RequestId requestDone(Message message, ControllerLink::Reply<void> reply);
    void send(Message message) { if (channel) channel->send({0, std::move(message)}); }
    void seeCycle(std::uint64_t cycle) { newestCycle = std::max(newestCycle, cycle); }

    // --- download ---
    struct Download;
    void nextPieces(const std::shared_ptr<Download>& download);
    void pieceTaken(const std::shared_ptr<Download>& download, const Result<Message>& reply);
    void commit(const std::shared_ptr<Download>& download);

    // --- subscriptions, trace ---
    struct Subscription {
        std::vector<std::string> names;
        Time period{};
        std::function<void(const MonitorUpdate&)> receive;
        Hash program;          ///< it was asked for against this one; null: not asked yet
    };
    void subscribeAll();
    void sendSubscription(SubscriptionId id, Subscription& subscription);
    void takeUpdate(const message::Update& update);
    void takeBlock(const SampleBlock& block);

    template <class Listeners, class... Arguments>
    void tell(Listeners Impl::*listeners, Arguments... arguments);

    std::unique_ptr<Connector> connector;
    Executor& executor;
    SessionOptions options;
    SessionCalls calls;
    std::unique_ptr<MessageChannel> channel;
    SessionStage stage = SessionStage::Offline;
    LinkState state = LinkState::Connecting;
    bool everOnline = false;
    Time reconnectDelay{};
    Time untilReconnect{};
    QTimer ticker, renewer;

    struct Pending {
        const char* what;
        Time left;
        Time timeout;
        Then then;
    };
    std::map<std::uint32_t, Pending> pending;
    std::uint32_t lastRequest = 0;
    Time silent{};
    Time sincePing{};

    LinkCapabilities capabilities;
    ControllerStatus status;
    std::uint64_t newestCycle = 0;
    bool hasControl = false;

    std::map<SubscriptionId, Subscription> subscriptions;
    std::uint32_t lastSubscription = 0;
    std::function<void(const SampleBlock&)> traceReceiver;
    std::optional<std::uint32_t> traceSet;  ///< known from the first block on
    std::uint32_t traceNumber = 0;

    std::map<int, std::function<void(LinkState, const Diagnostic&)>> stateListeners;
    std::map<int, std::function<void(const ControllerStatus&)>> statusListeners;
    std::map<int, std::function<void(const LogEntry&)>> logListeners;
    int lastToken = 0;
    std::shared_ptr<bool> alive = std::make_shared<bool>(true);
};

struct OnlineSession::Impl::Download {
    DownloadPackage package;
    std::function<void(double)> progress;
    std::function<void(Result<void>)> finish;
    RequestId call{};
    std::uint32_t transfer = 0;
    std::size_t sent = 0, taken = 0;
    std::size_t inFlight = 0, lastSize = 0;
    PieceSizer sizer;
    QElapsedTimer gap; ///< since the first acknowledgement of a pair
};

template <class Answer, class T, class Take>
RequestId OnlineSession::Impl::request(Message message, ControllerLink::Reply<T> reply, Take take)
{
    auto [id, finish] = calls.open<T>(std::move(reply));
    if (stage != SessionStage::Online) {
        finish(diagnostic(Code::NotConnected));
        return id;
    }
    const char* what = ruleOf(message).name;
    ask(what, std::move(message), options.requestTimeout, [this, what, finish = std::move(finish), take](Result<Message> answer) {
        if (!answer)
            return finish(answer.error());
        if (auto* expected = std::get_if<Answer>(&*answer))
            return finish(take(std::move(*expected)));
        const Diagnostic why = diagnostic(Code::ProtocolBroken, {connector->address(), std::string("a wrong answer to ") + what});
        finish(why);
        lose(why, false);
    });
    return id;
}

template <class Listeners, class... Arguments>
void OnlineSession::Impl::tell(Listeners Impl::*listeners, Arguments... arguments)
{
    executor.post([this, listeners, guard = std::weak_ptr(alive), arguments...] {
        if (guard.expired())
            return;
        const Listeners now = this->*listeners; // a listener may add or forget some, or end the session
        for (const auto& [token, listener] : now) {
            if (guard.expired())
                return;
            if ((this->*listeners).contains(token))
                listener(arguments...);
        }
    });
}

} // namespace camwright
