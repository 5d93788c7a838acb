#include "devices/controller/hoststate.h"

namespace camwright {

ControllerHost::ControllerHost(HostOptions options, FileSystem& files, Executor& background)
    : m_impl(std::make_unique<Impl>(std::move(options), files, background))
{
}

ControllerHost::~ControllerHost() = default;

// --- for the loop ---

void ControllerHost::runCycle(Time now)
{
    m_impl->now = now;
    m_impl->runCommands();
    m_impl->checkLease(now);
    m_impl->engine.step(kMotionCycle);
    m_impl->afterCycle();
}

void ControllerHost::countLateCycles(std::uint64_t count)
{
    m_impl->engine.countLateCycles(count);
}

// --- for the server ---

void ControllerHost::setListener(HostListener* listener)
{
    m_impl->listener = listener;
}

void ControllerHost::setWake(std::function<void()> wake)
{
    const std::lock_guard lock(m_impl->mutex);
    m_impl->wakeUp = std::move(wake);
}

void ControllerHost::deliver()
{
    std::vector<Impl::Work> work;
    {
        const std::lock_guard lock(m_impl->mutex);
        work.swap(m_impl->outbox);
    }
    for (const Impl::Work& each : work)
        each();
}

void ControllerHost::takeControl(ClientId client, std::string owner, Done done)
{
    m_impl->post({[impl = m_impl.get(), client, owner = std::move(owner), done = std::move(done)] {
        Result<void> result;
        if (!impl->lease.take(client, owner, impl->now))
            result = diagnostic(Code::ControlHeld, {impl->lease.owner()});
        else if (impl->letGoAt != 0)
            impl->letGo(); // heartbeats of the new holder must not keep alive what the old one moved
        impl->statusDue = true;
        impl->reply(done, std::move(result));
    }});
}

void ControllerHost::renewControl(ClientId client)
{
    m_impl->post({[impl = m_impl.get(), client] { impl->lease.renew(client, impl->now); }}, true);
}

void ControllerHost::releaseControl(ClientId client, Done done)
{
    m_impl->post({[impl = m_impl.get(), client, done = std::move(done)] {
        if (impl->lease.isHeldBy(client)) {
            impl->lease.release(client);
            impl->letGo();
        }
        impl->reply(done, Result<void>());
    }});
}

void ControllerHost::clientGone(ClientId client)
{
    m_impl->post({[impl = m_impl.get(), client] {
        std::erase_if(impl->subscriptions, [client](const auto& entry) { return entry.first.first == client; });
        if (impl->tracer == client) {
            impl->engine.stopTrace();
            impl->tracer = 0;
        }
        if (impl->lease.isHeldBy(client)) {
            impl->lease.release(client);
            impl->letGoAfterDeadMan();
        }
    }}, true);
}

DownloadPlan ControllerHost::plan(const Manifest& next) const
{
    const std::lock_guard lock(m_impl->mutex);
    return planDownload(m_impl->manifest, next, m_impl->status);
}

void ControllerHost::run(ClientId client, Done done)
{
    m_impl->post({[impl = m_impl.get(), client, done = std::move(done)] {
        Result<void> result = impl->checkControl(client, "run");
        if (result && impl->pending)
            result = diagnostic(Code::DownloadBusy);
        if (result)
            result = impl->apply(input::Run{});
        impl->statusDue = true;
        impl->reply(done, std::move(result));
    }});
}

void ControllerHost::stop(ClientId client, Done done)
{
    m_impl->post({[impl = m_impl.get(), client, done = std::move(done)] {
        Result<void> result = impl->checkControl(client, "stop");
        if (result)
            result = impl->apply(input::Stop{});
        impl->statusDue = true;
        impl->reply(done, std::move(result));
    }});
}

void ControllerHost::axis(ClientId client, AxisCommand command, Done done)
{
    const bool urgent = command.kind == AxisCommandKind::Stop;
    m_impl->post({[impl = m_impl.get(), client, command = std::move(command), done = std::move(done)] {
        impl->reply(done, impl->applyAxis(client, command));
        impl->statusDue = true;
    }}, urgent);
}

void ControllerHost::heartbeat(ClientId client, std::uint64_t seenCycle)
{
    m_impl->post({[impl = m_impl.get(), client, seenCycle] {
        if (!impl->lease.isHeldBy(client))
            return;
        (void)impl->apply(input::Heartbeat{seenCycle});
        impl->answer([impl, client, cycle = impl->engine.cycle()] {
            if (impl->listener)
                impl->listener->onBeat(client, cycle);
        });
    }}, true);
}

void ControllerHost::stopAll(Done done)
{
    m_impl->post({[impl = m_impl.get(), done = std::move(done)] {
        impl->reply(done, impl->apply(input::StopAllAxes{}));
        impl->statusDue = true;
    }}, true);
}

void ControllerHost::note(Diagnostic message)
{
    m_impl->post({[impl = m_impl.get(), message = std::move(message)] { impl->addLog(message); }});
}

message::LogEntries ControllerHost::log(std::uint64_t from) const
{
    const std::lock_guard lock(m_impl->mutex);
    message::LogEntries out;
    for (const LogEntry& entry : m_impl->entries) {
        if (entry.sequence < from)
            continue;
        if (out.entries.size() == message::LogPage) {
            out.more = true;
            break;
        }
        out.entries.push_back(entry);
    }
    return out;
}

void ControllerHost::shutDown()
{
    m_impl->runCommands();
    (void)m_impl->apply(input::StopAllAxes{});
    (void)m_impl->apply(input::Stop{});
    // Virtual time costs nothing: the drives come to rest before their process ends.
    for (int i = 0; i < 5000 && !m_impl->engine.isQuiet(); ++i)
        m_impl->engine.step(kMotionCycle);
    m_impl->saveRetained(true);
}

} // namespace camwright
