// What the host tells of itself: status, monitored values, samples, log.
#include "devices/controller/hoststate.h"

#include <algorithm>

namespace camwright {

namespace {
constexpr std::uint64_t StatusPeriod = 50;        // cycles
constexpr std::uint64_t RetainedPeriod = 100;     // cycles (CONTRACTS 13)
constexpr std::uint64_t ShortestUpdate = 10;      // cycles
constexpr std::size_t MaximumSubscriptions = 64;  // of one client
constexpr std::size_t LogCapacity = 4096;
} // namespace

void ControllerHost::Impl::afterCycle()
{
    if (engine.imageNumber() != imageNumber)
        imageChanged();
    if (pending)
        advanceSwitch();
    watchLetGo();
    collectLog();
    collectUpdates();
    collectSamples();
    const std::uint64_t cycle = engine.cycle();
    if (statusDue || cycle % StatusPeriod == 0)
        publishStatus();
    if (cycle % RetainedPeriod == 0)
        saveRetained(false);
    wake();
}

void ControllerHost::Impl::imageChanged()
{
    collectSamples(); // of a trace that ended with the old program
    tracer = 0;
    imageNumber = engine.imageNumber();
    subscriptions.clear(); // their references are stale; clients ask again against the new program
    const ControllerStatus current = engine.status();
    program = current.program;
    axisNames.clear();
    for (const AxisStatus& axis : current.axes)
        axisNames.push_back(axis.name);
    statusDue = true;
}

void ControllerHost::Impl::publishStatus()
{
    statusDue = false;
    ControllerStatus current = engine.status();
    {
        const std::lock_guard lock(mutex);
        status = current;
    }
    answer([this, current = std::move(current), holder = lease.holder(), owner = lease.owner()]() mutable {
        current.controlOwner = owner;
        if (listener)
            listener->onStatus(current, holder);
    });
}

void ControllerHost::Impl::addLog(Diagnostic message)
{
    LogEntry entry{0, engine.cycle(), engine.now(), std::move(message)};
    {
        const std::lock_guard lock(mutex);
        entry.sequence = nextSequence++;
        entries.push_back(entry);
        if (entries.size() > LogCapacity)
            entries.pop_front();
    }
    answer([this, entry = std::move(entry)] {
        if (listener)
            listener->onLog(entry);
    });
}

void ControllerHost::Impl::collectLog()
{
    if (engine.nextLogSequence() == nextEngineLog)
        return;
    for (LogEntry& entry : engine.logSince(nextEngineLog)) {
        {
            const std::lock_guard lock(mutex);
            entry.sequence = nextSequence++;
            entries.push_back(entry);
            if (entries.size() > LogCapacity)
                entries.pop_front();
        }
        answer([this, entry] {
            if (listener)
                listener->onLog(entry);
        });
    }
    nextEngineLog = engine.nextLogSequence();
}

void ControllerHost::Impl::collectUpdates()
{
    const std::uint64_t cycle = engine.cycle();
    for (auto& [key, subscription] : subscriptions) {
        if (cycle < subscription.next)
            continue;
        subscription.next = cycle + subscription.period;
        message::Update update;
        update.program = program;
        update.subscription = key.second;
        update.cycle = cycle;
        update.values.reserve(subscription.items.size());
        for (const Subscription::Item& item : subscription.items)
            if (const auto value = engine.read(item.ref))
                update.values.push_back({item.index, *value, engine.isForced(item.ref)});
        answer([this, client = key.first, update = std::move(update)] {
            if (listener)
                listener->onUpdate(client, update);
        });
    }
}

void ControllerHost::Impl::collectSamples()
{
    while (auto block = engine.takeSamples()) {
        const bool last = block->last;
        if (tracer != 0)
            answer([this, client = tracer, block = std::move(*block)]() mutable {
                if (listener)
                    listener->onSamples(client, std::move(block));
            });
        if (last)
            tracer = 0;
    }
}

void ControllerHost::Impl::saveRetained(bool always)
{
    if (options.folder.empty() || !engine.hasImage())
        return;
    Bytes data = engine.retained();
    if (!always && data == lastRetained)
        return;
    lastRetained = data;
    background.post([this, data = std::move(data)] {
        if (const auto done = retained.save(data); !done)
            post({[this, why = done.error()] { addLog(why); }});
    });
}

void ControllerHost::subscribe(ClientId client, message::Subscribe wanted, Reply<std::vector<std::uint32_t>> reply)
{
    const unsigned cost = 1 + static_cast<unsigned>(wanted.names.size());
    m_impl->post({[impl = m_impl.get(), client, wanted = std::move(wanted), reply = std::move(reply)] {
        using Indices = std::vector<std::uint32_t>;
        if (const auto checked = impl->checkProgram(wanted.program); !checked)
            return impl->reply<Indices>(reply, checked.error());
        const auto mine = std::count_if(impl->subscriptions.begin(), impl->subscriptions.end(),
            [client](const auto& entry) { return entry.first.first == client; });
        const auto key = std::pair(client, wanted.subscription);
        if (static_cast<std::size_t>(mine) >= MaximumSubscriptions && !impl->subscriptions.contains(key))
            return impl->reply<Indices>(reply, diagnostic(Code::TooMuchAsked, {"subscribe", std::to_string(mine + 1) + " subscriptions",
                                                                               std::to_string(MaximumSubscriptions)}));
        Subscription subscription;
        Indices unknown;
        for (std::uint32_t i = 0; i < wanted.names.size(); ++i) {
            if (const auto ref = impl->engine.resolve(wanted.names[i]))
                subscription.items.push_back({i, *ref});
            else
                unknown.push_back(i);
        }
        const auto cycles = static_cast<std::uint64_t>(std::max<std::int64_t>(wanted.period / kMotionCycle, 1));
        subscription.period = std::max(cycles, ShortestUpdate);
        impl->subscriptions[key] = std::move(subscription);
        impl->reply<Indices>(reply, std::move(unknown));
    }, cost});
}

void ControllerHost::unsubscribe(ClientId client, std::uint32_t subscription)
{
    m_impl->post({[impl = m_impl.get(), client, subscription] { impl->subscriptions.erase({client, subscription}); }});
}

void ControllerHost::startTrace(ClientId client, std::string owner, Hash program, TraceSetup setup, Done done)
{
    const unsigned cost = 2 + static_cast<unsigned>(setup.channels.size());
    m_impl->post({[impl = m_impl.get(), client, owner = std::move(owner), program, setup = std::move(setup), done = std::move(done)] {
        const auto start = [&]() -> Result<void> {
            if (impl->tracer != 0 && impl->tracer != client)
                return diagnostic(Code::TraceBusy, {impl->tracerName});
            if (auto checked = impl->checkProgram(program); !checked)
                return checked;
            impl->collectSamples(); // what an earlier trace of this client still has
            if (auto started = impl->engine.startTrace(setup); !started)
                return started;
            impl->tracer = client;
            impl->tracerName = owner;
            return {};
        };
        impl->reply(done, start());
    }, cost});
}

void ControllerHost::stopTrace(ClientId client, Done done)
{
    m_impl->post({[impl = m_impl.get(), client, done = std::move(done)] {
        if (impl->tracer == client) {
            impl->engine.stopTrace();
            impl->collectSamples();
            impl->tracer = 0;
        }
        impl->reply(done, Result<void>());
    }});
}

} // namespace camwright
