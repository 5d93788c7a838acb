#pragma once

#include "core/base/result.h"
#include "core/storage/filesystem.h"
#include "devices/controller/controllerhost.h"
#include "devices/controller/realtimeloop.h"
#include "devices/controller/taskthread.h"
#include "devices/server/server.h"

#include <QTimer>

#include <memory>
#include <string>

namespace camwright {

struct RuntimeOptions {
    std::string listen;        ///< "127.0.0.1:17402"; empty: no TCP
    std::string local;         ///< a socket file; empty: none
    std::string data;          ///< a folder, made if it is not there; empty: nothing is kept
    std::uint64_t seed = 1;
    std::chrono::seconds idle = std::chrono::minutes(10); ///< a local controller without clients ends after this
};

/// The controller as a process: engine, loop, disk and server put together.
class Runtime {
public:
    explicit Runtime(RuntimeOptions options) : m_options(std::move(options)) {}
    ~Runtime();

    /// Takes the data folder, loads what is stored there, listens and starts the loop.
    Result<void> start();
    std::uint16_t port() const { return m_server->port(); }
    /// Stops everything that moves, stores retained data, closes the connections.
    void stop();

private:
    Result<void> takeFolder();
    void watchIdle();

    RuntimeOptions m_options;
    PosixFileSystem m_files;
    std::unique_ptr<FileLock> m_lock;
    std::unique_ptr<TaskThread> m_background;
    std::unique_ptr<ControllerHost> m_host;
    SteadyClock m_clock;
    std::unique_ptr<RealTimeLoop> m_loop;
    std::unique_ptr<Server> m_server;
    QTimer m_idle;
};

} // namespace camwright
