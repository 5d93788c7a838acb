#pragma once

#include "app/cli/verb.h"
#include "core/online/controllerlink.h"
#include "core/online/executor.h"
#include "devices/session/onlinesession.h"

#include <QEventLoop>
#include <QTimer>

#include <functional>
#include <memory>
#include <optional>

namespace camwright::cli {

/// Adds --at and --project, which every verb that speaks to a controller has.
void addConnectionOptions(QCommandLineParser& options);

/// A link to a controller for the length of one verb. Calls of the link become questions that wait for their answer.
class Connection {
public:
    ~Connection();

    /// Connects to --at ADDRESS (default "local", the virtual controller of --project) and waits until online.
    static Result<std::unique_ptr<Connection>> open(Invocation& call, const QString& project = {});

    ControllerLink& link();

    /// Calls the link and waits for the one answer; the link itself ends every request in time.
    template <class T>
    Result<T> ask(const std::function<void(ControllerLink::Reply<T>)>& call)
    {
        std::optional<Result<T>> answer;
        QEventLoop loop;
        call([&](Result<T> result) {
            answer.emplace(std::move(result));
            loop.quit();
        });
        if (!answer)
            loop.exec();
        return std::move(*answer);
    }

    Result<void> takeControl();
    /// Ends the virtual controller's process.
    Result<void> endController();
    /// Runs the event loop for `span`, for ever if negative, until the link is lost or the user presses Ctrl+C.
    /// False when the link was lost.
    bool wait(std::chrono::milliseconds span, const std::function<bool()>& until = {});
    const Diagnostic& whyLost() const { return m_whyLost; }

private:
    Connection();
    void stateChanged(LinkState state, const Diagnostic& why);

    std::unique_ptr<Executor> m_executor;
    std::unique_ptr<OnlineSession> m_session;
    Diagnostic m_whyLost;
    bool m_lost = false;
    bool m_hasStatus = false;
    int m_statusToken = 0;
    QEventLoop* m_waiting = nullptr;
    std::function<void()> m_check = [] {};
};

/// 4 when nobody answered, else 5; the diagnostic is printed.
int refused(Invocation& call, const Diagnostic& why);

/// True once the user has pressed Ctrl+C; the first press ends a waiting verb in good order.
bool interrupted();

} // namespace camwright::cli
