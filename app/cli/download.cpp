#include "app/cli/connection.h"
#include "app/cli/exitcode.h"
#include "app/cli/projects.h"
#include "app/cli/quantities.h"
#include "app/cli/verbs.h"
#include "editors/words/words.h"

namespace camwright::cli {

namespace {

using Order = RequestId (ControllerLink::*)(ControllerLink::Reply<void>);

/// Gives an order and waits until the status tells that it has been carried out, so that what is called next sees it.
Result<void> give(Connection& connection, Order order, RunState wanted)
{
    if (const auto control = connection.takeControl(); !control)
        return control.error();
    const auto done = connection.ask<void>([&](auto reply) { (connection.link().*order)(reply); });
    if (!done)
        return done.error();
    const bool alive = connection.wait(std::chrono::seconds(5), [&] { return connection.link().status().state == wanted; });
    return alive ? Result<void>() : Result<void>(connection.whyLost());
}

void showPlan(Invocation& call, const DownloadPlan& plan)
{
    if (call.out.asJson()) {
        Json& json = call.out.json()["plan"];
        json = {{"sameProgram", plan.sameProgram}, {"mustStop", plan.mustStop}, {"lines", Json::array()}};
        for (const PlanLine& line : plan.lines)
            json["lines"].push_back({{"what", line.what}, {"effect", words::sentence(line.message).toStdString()}});
        return;
    }
    if (plan.sameProgram)
        call.out.line("The controller has this program already.");
    for (const PlanLine& line : plan.lines)
        call.out.line(words::sentence(line.message));
}

} // namespace

int runDownload(Invocation& call)
{
    const auto built = buildProject(call, call.words[0]);
    if (!built)
        return built.status;
    auto opened = Connection::open(call, call.words[0]);
    if (!opened)
        return refused(call, opened.error());
    Connection& connection = **opened;
    ControllerLink& link = connection.link();
    const DownloadPackage package{built.image, built.program};

    const auto plan = connection.ask<DownloadPlan>([&](auto reply) { link.planDownload(package, reply); });
    if (!plan)
        return refused(call, plan.error());
    showPlan(call, *plan);
    if (call.has("plan"))
        return Done;
    if (plan->mustStop && !call.has("stop")) {
        call.out.progress(QStringLiteral("The controller is in RUN; nothing was sent. Add --stop to stop it for the download."));
        return ControllerRefuses;
    }
    if (plan->mustStop) {
        if (const auto stopped = give(connection, &ControllerLink::stop, RunState::Stop); !stopped)
            return refused(call, stopped.error());
    } else if (const auto control = connection.takeControl(); !control) {
        return refused(call, control.error());
    }
    const auto done = connection.ask<void>([&](auto reply) {
        link.download(package, [&](double fraction) { call.out.progress(QStringLiteral("%1 %").arg(fraction * 100, 0, 'f', 0)); }, reply);
    });
    if (!done)
        return refused(call, done.error());
    if (call.has("start")) {
        if (const auto running = give(connection, &ControllerLink::run, RunState::Run); !running)
            return refused(call, running.error());
    }
    call.out.line(call.has("start") ? "Downloaded and started." : "Downloaded. The controller stands in STOP; 'camwright-cli start' runs it.");
    call.out.json()["program"] = toHex(built.program);
    return Done;
}

void addDownloadOptions(QCommandLineParser& options)
{
    addConnectionOptions(options);
    options.addOption({QStringLiteral("plan"), QStringLiteral("Only tell what would change, stop and be lost.")});
    options.addOption({QStringLiteral("stop"), QStringLiteral("Stop a running controller for the download.")});
    options.addOption({QStringLiteral("start"), QStringLiteral("Start the program afterwards.")});
}

int runStart(Invocation& call)
{
    auto connection = Connection::open(call);
    if (!connection)
        return refused(call, connection.error());
    const auto done = give(**connection, &ControllerLink::run, RunState::Run);
    return done ? int(Done) : refused(call, done.error());
}

int runStop(Invocation& call)
{
    auto connection = Connection::open(call);
    if (!connection)
        return refused(call, connection.error());
    if (const auto done = give(**connection, &ControllerLink::stop, RunState::Stop); !done)
        return refused(call, done.error());
    if (!call.has("exit"))
        return Done;
    const auto ended = (*connection)->endController();
    return ended ? int(Done) : refused(call, ended.error());
}

void addStopOptions(QCommandLineParser& options)
{
    addConnectionOptions(options);
    options.addOption({QStringLiteral("exit"), QStringLiteral("End the virtual controller's process too.")});
}

int runLog(Invocation& call)
{
    auto connection = Connection::open(call);
    if (!connection)
        return refused(call, connection.error());
    const auto entries = (*connection)->ask<std::vector<LogEntry>>([&](auto reply) { (*connection)->link().log(0, reply); });
    if (!entries)
        return refused(call, entries.error());
    for (const LogEntry& entry : *entries) {
        if (call.out.asJson()) {
            Json row = toJson(entry.message);
            row["sequence"] = entry.sequence;
            row["cycle"] = entry.cycle;
            row["time_s"] = seconds(entry.time);
            call.out.json()["log"].push_back(std::move(row));
        } else {
            call.out.line(QStringLiteral("%1  cycle %2  %3 s  %4").arg(entry.sequence).arg(entry.cycle)
                .arg(seconds(entry.time), 0, 'f', 3).arg(lineOf(entry.message)));
        }
    }
    return Done;
}

void addLogOptions(QCommandLineParser& options)
{
    addConnectionOptions(options);
}

} // namespace camwright::cli
