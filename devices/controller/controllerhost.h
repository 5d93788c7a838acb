#pragma once

#include "core/online/executor.h"
#include "core/online/manifest.h"
#include "core/online/messages.h"
#include "core/runtime/engine.h"
#include "core/storage/filesystem.h"
#include "devices/controller/controllease.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace camwright {

struct HostOptions {
    std::string folder;       ///< for images and retained data; must exist; empty: nothing is kept
    std::uint64_t seed = 1;   ///< of the engine
};

/// What the host tells its server. Called from ControllerHost::deliver(), on the thread that calls that.
class HostListener {
public:
    virtual ~HostListener() = default;
    /// About 20 times a second and at once when control or the program changes. `control` and `controlOwner` of the status
    /// are left to the receiver: `holder` is who has control, 0 for nobody.
    virtual void onStatus(const ControllerStatus& status, ClientId holder) = 0;
    virtual void onUpdate(ClientId client, const message::Update& update) = 0;
    virtual void onSamples(ClientId client, SampleBlock block) = 0;
    virtual void onBeat(ClientId client, std::uint64_t cycle) = 0;
    virtual void onLog(const LogEntry& entry) = 0;
};

/// The controller around the engine: what clients ask for, monitoring, control, the program and retained data on disk. No
/// Qt, no clock, no thread of its own. Three threads meet here:
///  - the loop's, which calls runCycle() once a motion cycle and is never made to wait for a disk or a client;
///  - the server's, which calls everything under "for the server" and gets every answer in deliver();
///  - the background executor's, for verifying and storing.
/// Requests are done in the order given, between two cycles; stop, heartbeat and renewal before all others.
class ControllerHost {
public:
    template <class T>
    using Reply = std::function<void(Result<T>)>;
    using Done = Reply<void>;

    /// Loads the stored program and retained data. `background` must run its tasks one after the other and outlive them.
    ControllerHost(HostOptions options, FileSystem& files, Executor& background);
    ~ControllerHost();

    // --- for the loop ---
    /// One motion cycle. `now` is the clock's time, for the lease; it never goes back.
    void runCycle(Time now);
    /// The clock's owner came late by so many whole cycles; time has slipped by them.
    void countLateCycles(std::uint64_t count);

    // --- for the server ---
    void setListener(HostListener* listener);
    /// `wake` is called on the loop's or the background thread when deliver() has something to do; it must not block.
    void setWake(std::function<void()> wake);
    void deliver();

    void takeControl(ClientId client, std::string owner, Done done);
    void renewControl(ClientId client);
    void releaseControl(ClientId client, Done done);
    /// Forgets subscriptions, trace and control of a client that is gone; what it moved is stopped.
    void clientGone(ClientId client);

    /// Compared with the program that is loaded now; answered at once.
    DownloadPlan plan(const Manifest& next) const;
    /// Verifies and stores the image, stops the program and every axis, switches. Whatever fails leaves the old program.
    void commit(ClientId client, std::string owner, Bytes image, Hash program, Done done);

    void run(ClientId client, Done done);
    void stop(ClientId client, Done done);

    struct Values {
        std::uint64_t cycle = 0;
        std::vector<MonitoredValue> values;
    };
    void read(Hash program, std::vector<std::string> names, Reply<Values> reply);
    void describe(Hash program, std::vector<std::string> names, Reply<std::vector<DataType>> reply);
    void write(ClientId client, Hash program, std::string name, Value value, Done done);
    void force(ClientId client, Hash program, std::string name, Value value, Done done);
    void release(ClientId client, Hash program, std::string name, Done done); ///< empty name: every force
    void forced(Reply<std::vector<MonitoredValue>> reply);
    void terminals(Reply<std::vector<TerminalInfo>> reply);

    /// Answers with the indices of names that are not known; the others are told every `period`, from one scan each time.
    void subscribe(ClientId client, message::Subscribe subscription, Reply<std::vector<std::uint32_t>> reply);
    void unsubscribe(ClientId client, std::uint32_t subscription);

    void startTrace(ClientId client, std::string owner, Hash program, TraceSetup setup, Done done);
    void stopTrace(ClientId client, Done done);

    void axis(ClientId client, AxisCommand command, Done done); ///< Stop from anyone, the others from who has control
    void heartbeat(ClientId client, std::uint64_t seenCycle);
    void stopAll(Done done);

    /// Puts an entry of the server's own into the log.
    void note(Diagnostic message);
    message::LogEntries log(std::uint64_t from) const;
    /// Stops the program and every axis and stores retained data, as far as time permits. The loop must have ended.
    void shutDown();

private:
    struct Impl;
    std::unique_ptr<Impl> m_impl;
};

} // namespace camwright
