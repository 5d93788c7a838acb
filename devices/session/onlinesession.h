#pragma once

#include "core/online/controllerlink.h"
#include "core/online/executor.h"

#include <functional>
#include <memory>
#include <string>

namespace camwright {

class ByteStream;

/// Opens the byte stream of a link. Calls back exactly once, later, on the same thread, with an open stream or the reason;
/// destroying the connector forbids the call.
class Connector {
public:
    using Opened = std::function<void(Result<std::unique_ptr<ByteStream>>)>;
    virtual ~Connector() = default;
    virtual void open(Opened opened) = 0;
    virtual std::string address() const = 0; ///< as the user wrote it
};

struct SessionOptions {
    std::string client = "camwright";  ///< how this program names itself to other people
    bool reconnect = true;
    Time requestTimeout = 3s;
    Time commitTimeout = 30s;          ///< of the last step of a download: axes may have to come to rest first
    Time silenceTimeout = 2s;          ///< nothing at all came from the controller: the link is lost
    Time renewPeriod = 80ms;           ///< of the lease; it holds for 500 ms
    Time reconnectDelay = 250ms;       ///< doubles up to 2 s
};

/// A session of the online protocol. Lives on one thread that runs a Qt event loop; all callbacks come through the
/// executor, which must run them on the same thread. A lost link fails what was asked, is tried again, and restores its
/// subscriptions; control, traces, armed panels and motion are never restored (RELIABILITY 4).
class OnlineSession final : public ControllerLink {
public:
    OnlineSession(std::unique_ptr<Connector> connector, Executor& executor, SessionOptions options = {});
    ~OnlineSession() override;

    void disconnect(); ///< to Offline, at once; what waits fails with NotConnected
    /// Ends a local virtual controller (CONTRACTS 14); needs control.
    RequestId exitController(Reply<void>);

    LinkState state() const override;
    LinkCapabilities capabilities() const override;
    std::string address() const override;
    const ControllerStatus& status() const override;

    RequestId takeControl(Reply<void>) override;
    RequestId releaseControl(Reply<void>) override;
    RequestId planDownload(DownloadPackage, Reply<DownloadPlan>) override;
    RequestId download(DownloadPackage, std::function<void(double)> progress, Reply<void>) override;
    RequestId run(Reply<void>) override;
    RequestId stop(Reply<void>) override;
    RequestId read(std::vector<std::string> names, Reply<std::vector<MonitoredValue>>) override;
    RequestId write(std::string name, Value value, Reply<void>) override;
    RequestId force(std::string name, Value value, Reply<void>) override;
    RequestId release(std::string name, Reply<void>) override;
    RequestId forced(Reply<std::vector<MonitoredValue>>) override;
    RequestId terminals(Reply<std::vector<TerminalInfo>>) override;
    RequestId describe(std::vector<std::string> names, Reply<std::vector<DataType>>) override;
    SubscriptionId subscribe(std::vector<std::string> names, Time period, std::function<void(const MonitorUpdate&)>) override;
    void unsubscribe(SubscriptionId) override;
    RequestId startTrace(TraceSetup, std::function<void(const SampleBlock&)>, Reply<void>) override;
    RequestId stopTrace(Reply<void>) override;
    RequestId command(AxisCommand, Reply<void>) override;
    RequestId stopAllAxes(Reply<void>) override;
    void heartbeat() override;
    RequestId log(std::uint64_t fromSequence, Reply<std::vector<LogEntry>>) override;
    void cancel(RequestId) override;
    int onStateChanged(std::function<void(LinkState, const Diagnostic& why)>) override;
    int onStatus(std::function<void(const ControllerStatus&)>) override;
    int onLog(std::function<void(const LogEntry&)>) override;
    void forget(int token) override;

private:
    class Impl;
    std::unique_ptr<Impl> m_impl;
};

} // namespace camwright
