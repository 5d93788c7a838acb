#include "devices/controller/hoststate.h"

#include "core/online/imagemanifest.h"

namespace camwright {

namespace {
constexpr unsigned CycleBudget = 512;          // cost of ordinary commands done in one cycle
constexpr std::uint64_t DeadManCycles = 102;   // 100 ms, the cycle in which it is found, and the one that sends the stop
constexpr std::uint64_t SwitchPatience = 20'000; // cycles for axes to come to rest before a download is given up
} // namespace

ControllerHost::Impl::Impl(HostOptions o, FileSystem& f, Executor& b)
    : options(std::move(o)), files(f), background(b), engine(EngineOptions{options.seed}), images(f, options.folder),
      retained(f, options.folder)
{
    if (!options.folder.empty())
        restore();
    imageChanged();
    publishStatus();
    collectLog();
}

/// The engine is the judge of what can be started: nothing on disk is believed before it has taken it.
void ControllerHost::Impl::restore()
{
    const ImageStore::Stored stored = images.load();
    std::string trouble = stored.trouble;
    bool loaded = false;
    for (const Bytes* image : {&stored.image, &stored.previous}) {
        if (image->empty() || loaded)
            continue;
        if (const auto done = engine.load(*image)) {
            loaded = true;
            manifest = manifestOf(*image);
            if (image == &stored.previous)
                addLog(diagnostic(Code::StoredProgramUnusable, {trouble, CW_TEXT("Arguments", "the program before it")}));
        } else {
            trouble = englishText(done.error());
        }
    }
    if (!loaded && !trouble.empty())
        addLog(diagnostic(Code::StoredProgramUnusable, {trouble, CW_TEXT("Arguments", "no program")}));
    const RetainedStore::Stored data = retained.load();
    if (data.damaged)
        addLog(diagnostic(Code::RetainedDropped, {CW_TEXT("Arguments", "both stored sets are damaged")}));
    if (!loaded || data.data.empty())
        return;
    if (const auto done = engine.restoreRetained(data.data); !done)
        addLog(diagnostic(Code::RetainedDropped, {englishText(done.error())}));
    lastRetained = data.data;
}

void ControllerHost::Impl::post(Command command, bool isUrgent)
{
    const std::lock_guard lock(mutex);
    (isUrgent ? urgent : ordinary).push_back(std::move(command));
}

void ControllerHost::Impl::answer(Work work)
{
    const std::lock_guard lock(mutex);
    outbox.push_back(std::move(work));
}

void ControllerHost::Impl::wake()
{
    std::function<void()> call;
    {
        const std::lock_guard lock(mutex);
        if (!outbox.empty())
            call = wakeUp;
    }
    if (call)
        call();
}

void ControllerHost::Impl::runCommands()
{
    std::deque<Command> now;
    {
        const std::lock_guard lock(mutex);
        now.swap(urgent);
    }
    for (const Command& command : now)
        command.work();
    // The rest as far as the cycle's budget goes; whoever asks for much waits, not the scan.
    for (unsigned spent = 0; spent < CycleBudget;) {
        Command next;
        {
            const std::lock_guard lock(mutex);
            if (ordinary.empty())
                return;
            next = std::move(ordinary.front());
            ordinary.pop_front();
        }
        spent += next.cost;
        next.work();
    }
}

void ControllerHost::Impl::checkLease(Time time)
{
    if (const auto owner = lease.lapse(time)) {
        addLog(diagnostic(Code::ControlLapsed, {*owner}));
        letGoAfterDeadMan();
    }
}

/// Nobody holds the panel any more: what it moves stops, power stays on (CONTRACTS 19).
void ControllerHost::Impl::letGo()
{
    letGoAt = 0;
    const ControllerStatus current = engine.status();
    for (std::size_t i = 0; i < current.axes.size(); ++i) {
        if (!current.axes[i].panelArmed)
            continue;
        const auto axis = static_cast<std::uint16_t>(i);
        (void)apply(input::Panel{axis, AxisCommandKind::Stop, 0, 0, 0});
        (void)apply(input::Panel{axis, AxisCommandKind::Disarm, 0, 0, 0});
    }
    statusDue = true;
}

/// Whoever held the panel is gone, and with them the heartbeats: the dead-man in the motion task stops the axes by its own
/// rule and says so in the log. Afterwards the axes are disarmed, so that the program has them again.
void ControllerHost::Impl::letGoAfterDeadMan()
{
    letGoAt = engine.cycle() + DeadManCycles;
    statusDue = true;
}

void ControllerHost::Impl::watchLetGo()
{
    if (letGoAt != 0 && engine.cycle() >= letGoAt)
        letGo();
}

Result<std::uint16_t> ControllerHost::Impl::axisIndex(const std::string& name) const
{
    for (std::size_t i = 0; i < axisNames.size(); ++i)
        if (axisNames[i] == name || name == std::to_string(i + 1))
            return static_cast<std::uint16_t>(i);
    return diagnostic(Code::AxisUnknown, {name});
}

Result<void> ControllerHost::Impl::applyAxis(ClientId client, const AxisCommand& command)
{
    if (command.kind != AxisCommandKind::Stop)
        if (auto checked = checkControl(client, "axis"); !checked)
            return checked;
    const auto axis = axisIndex(command.axis);
    if (!axis)
        return axis.error();
    return apply(input::Panel{*axis, command.kind, command.position, command.velocity, command.acceleration});
}

// --- download ---

void ControllerHost::commit(ClientId client, std::string owner, Bytes image, Hash program, Done done)
{
    m_impl->post({[impl = m_impl.get(), client, owner = std::move(owner), image = std::move(image), program, done = std::move(done)] {
        Result<void> may = impl->checkControl(client, "commitDownload");
        if (may && (impl->pending || impl->committing))
            may = diagnostic(Code::DownloadBusy);
        if (!may)
            return impl->reply(done, std::move(may));
        impl->committing = true;
        auto next = std::make_shared<PendingSwitch>();
        next->image = image;
        next->program = program;
        next->owner = owner;
        next->done = done;
        impl->background.post([impl, next] { impl->prepare(next); });
    }});
}

/// On the background thread: everything slow and everything that may fail, before the running program is touched.
void ControllerHost::Impl::prepare(std::shared_ptr<PendingSwitch> next)
{
    const auto verify = [&]() -> Result<void> {
        ControllerEngine scratch(EngineOptions{options.seed});
        if (auto loaded = scratch.load(next->image); !loaded)
            return loaded;
        const Hash found = scratch.status().program;
        if (found != next->program)
            return diagnostic(Code::ImageDamaged, {shortHex(found), shortHex(next->program)});
        next->manifest = manifestOf(next->image);
        return options.folder.empty() ? Result<void>() : images.replace(next->image);
    };
    auto result = verify();
    post({[this, next, result = std::move(result)]() mutable {
        committing = false;
        if (!result)
            return reply(next->done, std::move(result));
        pending = std::make_unique<PendingSwitch>(std::move(*next));
        pending->deadline = engine.cycle() + SwitchPatience;
        pending->before = engine.imageNumber();
        (void)apply(input::Stop{});
    }});
}

void ControllerHost::Impl::advanceSwitch()
{
    if (!pending->loading) {
        const auto loaded = apply(input::LoadImage{pending->image});
        if (loaded)
            pending->loading = true;
        else if (engine.cycle() >= pending->deadline)
            return endSwitch(loaded.error());
        return; // the program's last scan may still be running: try again in the next cycle
    }
    if (engine.imageNumber() != pending->before && !engine.switchPending())
        endSwitch({});
    else if (engine.cycle() >= pending->deadline)
        endSwitch(diagnostic(Code::DownloadBusy));
}

void ControllerHost::Impl::endSwitch(Result<void> result)
{
    const std::unique_ptr<PendingSwitch> finished = std::move(pending);
    if (result) {
        if (engine.imageNumber() != imageNumber)
            imageChanged();
        {
            const std::lock_guard lock(mutex);
            manifest = finished->manifest;
        }
        addLog(diagnostic(Code::ProgramTaken, {shortHex(program), finished->owner}));
        saveRetained(true);
        publishStatus(); // so that the client knows the new program before it hears that the download is done
    } else if (!options.folder.empty()) {
        background.post([this] { (void)images.goBack(); });
    }
    reply(finished->done, std::move(result));
}

} // namespace camwright
