#pragma once

#include "core/storage/filesystem.h"
#include "devices/controller/controllerhost.h"
#include "devices/server/server.h"

#include <QObject>
#include <QTimer>

#include <deque>
#include <functional>
#include <string>

namespace camwright::test {

/// A controller with its server inside the test's own thread: each pass of a timer is one cycle, so that it is exactly as
/// fast as the event loop and no other clock plays a part.
class TestController {
public:
    explicit TestController(FileSystem& files, std::string folder = {}, ServerOptions options = {})
        : host(HostOptions{std::move(folder), 1}, files, background), server(host, std::move(options))
    {
        QObject::connect(&ticker, &QTimer::timeout, &ticker, [this] { cycle(); });
        ticker.start(1);
    }

    void cycle()
    {
        now += std::chrono::milliseconds(1);
        host.runCycle(now);
        background.runAll();
    }
    /// Lets time pass at once; whoever has control keeps it.
    void skip(int cycles)
    {
        for (int i = 0; i < cycles; ++i) {
            host.renewControl(server.holder());
            cycle();
        }
    }
    void pause() { ticker.stop(); }
    void resume() { ticker.start(1); }

    class Tasks final : public Executor {
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

    private:
        std::deque<std::function<void()>> m_tasks;
    };

    Tasks background;
    ControllerHost host;
    Server server;
    std::chrono::nanoseconds now{};
    QTimer ticker;
};

} // namespace camwright::test
