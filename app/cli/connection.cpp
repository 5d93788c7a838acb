#include "app/cli/connection.h"

#include "app/cli/exitcode.h"
#include "devices/session/connect.h"
#include "devices/session/qtexecutor.h"

#include <QDir>

#include <csignal>

namespace camwright::cli {

namespace {

volatile std::sig_atomic_t interruptions = 0;

void noteInterrupt(int)
{
    interruptions = interruptions + 1;
    if (interruptions > 1)
        std::_Exit(130); // the second Ctrl+C does not wait for anybody
}

QString userName()
{
    for (const char* variable : {"USER", "LOGNAME"}) {
        if (const QString name = qEnvironmentVariable(variable); !name.isEmpty())
            return name;
    }
    return QStringLiteral("somebody");
}

bool isSilence(Code code)
{
    return code == Code::CannotConnect || code == Code::RequestTimedOut || code == Code::NotConnected || code == Code::LinkLost
        || code == Code::RuntimeNotFound || code == Code::RuntimeNotReady;
}

} // namespace

bool interrupted()
{
    return interruptions > 0;
}

void addConnectionOptions(QCommandLineParser& options)
{
    options.addOption({QStringLiteral("at"), QStringLiteral("Controller: local, tcp://HOST[:PORT]."), QStringLiteral("ADDRESS"), QStringLiteral("local")});
    options.addOption({QStringLiteral("project"), QStringLiteral("Project whose virtual controller 'local' means."), QStringLiteral("DIR"), QStringLiteral(".")});
}

Connection::Connection() : m_executor(std::make_unique<QtExecutor>()) {}
Connection::~Connection() = default;

Result<std::unique_ptr<Connection>> Connection::open(Invocation& call, const QString& project)
{
    std::signal(SIGINT, noteInterrupt);
    std::signal(SIGTERM, noteInterrupt);
    std::unique_ptr<Connection> out(new Connection);
    ConnectOptions options;
    options.client = "camwright-cli (" + userName().toStdString() + ")";
    options.reconnect = false;
    const QString folder = QDir(project.isEmpty() ? call.value("project") : project).absolutePath();
    auto link = connectTo(call.value("at").toStdString(), folder.toStdString(), *out->m_executor, options);
    if (!link)
        return link.error();
    out->m_session = std::move(*link);
    out->link().onStateChanged([connection = out.get()](LinkState state, const Diagnostic& why) { connection->stateChanged(state, why); });
    const bool online = out->wait(std::chrono::seconds(15), [connection = out.get()] { return connection->m_hasStatus; });
    if (!online)
        return out->m_whyLost;
    if (!out->m_hasStatus)
        return diagnostic(Code::CannotConnect, {call.value("at").toStdString(), "no status came within 15 s"});
    return out;
}

void Connection::stateChanged(LinkState state, const Diagnostic& why)
{
    if (state == LinkState::Online && m_statusToken == 0)
        m_statusToken = link().onStatus([this](const ControllerStatus&) {
            m_hasStatus = true;
            if (m_waiting)
                m_check();
        });
    if (state == LinkState::Offline || state == LinkState::Lost) {
        m_whyLost = why;
        m_lost = true;
        if (m_waiting)
            m_waiting->quit();
    }
}

ControllerLink& Connection::link()
{
    return *m_session;
}

Result<void> Connection::takeControl()
{
    return ask<void>([this](auto reply) { link().takeControl(reply); });
}

Result<void> Connection::endController()
{
    const auto ended = ask<void>([this](auto reply) { m_session->exitController(reply); });
    return ended;
}

bool Connection::wait(std::chrono::milliseconds span, const std::function<bool()>& until)
{
    if (m_lost)
        return false;
    QEventLoop loop;
    m_waiting = &loop;
    m_check = [&] {
        if (interrupted() || (until && until()))
            loop.quit();
    };
    QTimer poll;
    QObject::connect(&poll, &QTimer::timeout, &loop, [&] { m_check(); });
    poll.start(std::chrono::milliseconds(20));
    if (span.count() >= 0)
        QTimer::singleShot(span, &loop, &QEventLoop::quit);
    if (!(until && until()))
        loop.exec();
    m_waiting = nullptr;
    m_check = [] {};
    return !m_lost;
}

int refused(Invocation& call, const Diagnostic& why)
{
    if (call.out.asJson())
        call.out.diagnostic(why);
    else
        call.out.progress(QStringLiteral("camwright-cli: ") + lineOf(why));
    return isSilence(why.code) ? NobodyAnswers : ControllerRefuses;
}

} // namespace camwright::cli
