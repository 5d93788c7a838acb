#pragma once

#include "devices/controller/controllerhost.h"
#include "devices/controller/imagestore.h"
#include "devices/controller/retainedstore.h"

#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <utility>

namespace camwright {

/// One subscription, resolved against the program that runs.
struct Subscription {
    struct Item {
        std::uint32_t index; ///< of the names asked for
        ValueRef ref;
    };
    std::vector<Item> items;
    std::uint64_t period = 1; ///< motion cycles
    std::uint64_t next = 0;   ///< cycle of the next update
};

/// A download between its verification and its end.
struct PendingSwitch {
    Bytes image;
    Hash program;
    Manifest manifest;
    std::string owner;
    std::uint64_t deadline = 0; ///< cycle; axes that do not come to rest must not hold it for ever
    bool loading = false;       ///< the engine has accepted it
    std::uint32_t before = 0;   ///< imageNumber() when it was accepted
    ControllerHost::Done done;
};

struct ControllerHost::Impl {
    Impl(HostOptions options, FileSystem& files, Executor& background);

    // --- the loop's thread only ---
    using Work = std::function<void()>;
    struct Command {
        Work work;
        unsigned cost = 1; ///< about how many names it resolves
    };
    void runCommands();
    void afterCycle();
    void checkLease(Time now);
    void letGo();               ///< stops and disarms what a panel holds, now
    void letGoAfterDeadMan();   ///< the same, but leaves stopping to the motion task, which logs both cycles
    void watchLetGo();
    void advanceSwitch();
    void endSwitch(Result<void> result);
    void publish();
    void publishStatus();
    void collectLog();
    void collectUpdates();
    void collectSamples();
    void saveRetained(bool always);
    Result<void> checkProgram(const Hash& program) const;
    Result<void> checkControl(ClientId client, const char* what) const;
    Result<ValueRef> resolve(const std::string& name) const;
    Result<void> apply(const EngineInputContent& content) { return engine.apply(content); }
    Result<std::uint16_t> axisIndex(const std::string& name) const;
    Result<void> applyAxis(ClientId client, const AxisCommand& command);
    void imageChanged();
    void addLog(Diagnostic message);

    HostOptions options;
    FileSystem& files;
    Executor& background;
    ControllerEngine engine;
    ControlLease lease;
    Time now{};
    Hash program;                  ///< of the image that is loaded
    std::vector<std::string> axisNames;
    std::uint32_t imageNumber = 0;
    std::map<std::pair<ClientId, std::uint32_t>, Subscription> subscriptions;
    ClientId tracer = 0;
    std::string tracerName;
    std::unique_ptr<PendingSwitch> pending;
    std::uint64_t nextEngineLog = 0;
    std::uint64_t letGoAt = 0;     ///< cycle; 0: nothing is to be let go
    bool statusDue = true;
    Bytes lastRetained;

    // --- any thread, under the mutex ---
    void post(Command command, bool urgent = false);
    void answer(Work work);       ///< to be done in deliver()
    template <class T>
    void reply(const Reply<T>& to, Result<T> result)
    {
        answer([to, result = std::move(result)]() mutable { to(std::move(result)); });
    }
    void wake();

    mutable std::mutex mutex;
    std::deque<Command> urgent, ordinary;
    std::vector<Work> outbox;
    std::function<void()> wakeUp;
    HostListener* listener = nullptr; ///< the server's thread only
    Manifest manifest;             ///< of the program that is loaded
    ControllerStatus status;       ///< newest published
    std::deque<LogEntry> entries;
    std::uint64_t nextSequence = 1;
    bool committing = false;

    // --- the background thread only, once the host runs ---
    ImageStore images;
    RetainedStore retained;
    void prepare(std::shared_ptr<PendingSwitch> next);
    void restore();
};

} // namespace camwright
