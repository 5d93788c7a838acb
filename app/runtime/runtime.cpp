#include "app/runtime/runtime.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>

namespace camwright {

Runtime::~Runtime()
{
    stop();
}

Result<void> Runtime::takeFolder()
{
    if (m_options.data.empty())
        return {};
    if (!QDir().mkpath(QString::fromStdString(m_options.data)))
        return diagnostic(Code::StoreFailed, {m_options.data, "the folder cannot be made"});
    auto lock = m_files.lock(m_options.data + "/lock", LockWait::No);
    if (!lock)
        return lock.error().code == Code::LockHeld ? diagnostic(Code::DataInUse, {m_options.data}) : lock.error();
    m_lock = std::move(*lock);
    return {};
}

Result<void> Runtime::start()
{
    if (auto taken = takeFolder(); !taken)
        return taken;
    m_background = std::make_unique<TaskThread>();
    m_host = std::make_unique<ControllerHost>(HostOptions{m_options.data, m_options.seed}, m_files, *m_background);
    ServerOptions server;
    server.name = "camwright-runtime " + QCoreApplication::applicationVersion().toStdString();
    server.mayExit = !m_options.local.empty();
    m_server = std::make_unique<Server>(*m_host, server);
    QObject::connect(m_server.get(), &Server::exitRequested, qApp, &QCoreApplication::quit, Qt::QueuedConnection);
    if (!m_options.listen.empty())
        if (auto listening = m_server->listen(m_options.listen); !listening)
            return listening;
    if (!m_options.local.empty()) {
        if (auto listening = m_server->listenLocally(m_options.local); !listening)
            return listening;
        watchIdle();
    }
    m_loop = std::make_unique<RealTimeLoop>(*m_host, m_clock);
    m_loop->start();
    return {};
}

void Runtime::watchIdle()
{
    m_idle.setSingleShot(true);
    m_idle.setInterval(m_options.idle);
    QObject::connect(&m_idle, &QTimer::timeout, qApp, &QCoreApplication::quit);
    QObject::connect(m_server.get(), &Server::clientsChanged, &m_idle, [this] {
        if (m_server->clientCount() == 0)
            m_idle.start();
        else
            m_idle.stop();
    });
    m_idle.start();
}

void Runtime::stop()
{
    if (m_loop)
        m_loop->stop();
    if (m_server)
        m_server->closeAll();
    if (m_host && m_loop)
        m_host->shutDown();
    m_loop.reset();
    m_background.reset(); // waits for what is still being stored
    m_server.reset();
    m_host.reset();
    m_lock.reset();
}

} // namespace camwright
