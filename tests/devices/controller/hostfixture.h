#pragma once

#include "devices/controller/controllerhost.h"
#include "tests/core/storage/memoryfilesystem.h"
#include "tests/support/feederimage.h"

#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <vector>

namespace camwright::test {

/// Tasks that run when the test says so.
class ManualExecutor final : public Executor {
public:
    void post(std::function<void()> task) override { m_tasks.push_back(std::move(task)); }
    void runAll()
    {
        while (!m_tasks.empty()) {
            const auto task = std::move(m_tasks.front());
            m_tasks.pop_front();
            task();
        }
    }
    bool isIdle() const { return m_tasks.empty(); }

private:
    std::deque<std::function<void()>> m_tasks;
};

/// A host whose three threads are one, and whose time is the test's.
class HostFixture : private HostListener {
public:
    explicit HostFixture(std::shared_ptr<MemoryFileSystem> disk = std::make_shared<MemoryFileSystem>(), std::string folder = "")
        : files(std::move(disk)), host(HostOptions{std::move(folder), 1}, *files, background)
    {
        host.setListener(this);
    }
    ~HostFixture() override { host.setListener(nullptr); }

    void cycles(int count)
    {
        for (int i = 0; i < count; ++i) {
            now += 1ms;
            host.runCycle(now);
            if (runBackground)
                background.runAll();
            host.deliver();
        }
    }
    /// Cycles until the condition holds; false if it never does.
    template <class Condition>
    bool until(Condition condition, int limit = 20'000)
    {
        for (int i = 0; i < limit && !condition(); ++i)
            cycles(1);
        return condition();
    }
    /// A callback that keeps its result.
    template <class T>
    std::function<void(Result<T>)> keep(std::optional<Result<T>>& result)
    {
        return [&result](Result<T> r) { result.emplace(std::move(r)); };
    }
    Result<void> wait(std::function<void(ControllerHost::Done)> ask)
    {
        std::optional<Result<void>> result;
        ask(keep<void>(result));
        until([&] { return result.has_value(); });
        return result ? *result : Result<void>(diagnostic(Code::InternalError, {"no answer"}));
    }
    Result<void> take(ClientId client) { return wait([&](auto done) { host.takeControl(client, "client " + std::to_string(client), done); }); }
    Result<void> download(ClientId client, const ControllerImage& image)
    {
        return wait([&](auto done) { host.commit(client, "tester", write(image), programHash(image), done); });
    }
    Result<void> axis(ClientId client, AxisCommand command) { return wait([&](auto done) { host.axis(client, command, done); }); }
    Result<std::vector<MonitoredValue>> read(const Hash& program, std::vector<std::string> names)
    {
        std::optional<Result<ControllerHost::Values>> result;
        host.read(program, std::move(names), keep<ControllerHost::Values>(result));
        until([&] { return result.has_value(); });
        if (!*result)
            return result->error();
        return (*result)->values;
    }
    const LogEntry* find(Code code) const
    {
        for (const LogEntry& entry : log)
            if (entry.message.code == code)
                return &entry;
        return nullptr;
    }
    const AxisStatus& feed() const { return status.axes.at(0); }

    std::shared_ptr<MemoryFileSystem> files;
    ManualExecutor background;
    bool runBackground = true;
    ControllerHost host;
    camwright::Time now{};
    ControllerStatus status;
    ClientId holder = 0;
    std::vector<message::Update> updates;
    std::vector<SampleBlock> samples;
    std::vector<LogEntry> log;
    std::uint64_t beat = 0;

private:
    void onStatus(const ControllerStatus& s, ClientId h) override { status = s; holder = h; }
    void onUpdate(ClientId, const message::Update& update) override { updates.push_back(update); }
    void onSamples(ClientId, SampleBlock block) override { samples.push_back(std::move(block)); }
    void onBeat(ClientId, std::uint64_t cycle) override { beat = cycle; }
    void onLog(const LogEntry& entry) override { log.push_back(entry); }
};

} // namespace camwright::test
