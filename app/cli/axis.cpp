#include "app/cli/connection.h"
#include "app/cli/exitcode.h"
#include "app/cli/quantities.h"
#include "app/cli/verbs.h"

#include <algorithm>

namespace camwright::cli {

namespace {

constexpr std::chrono::milliseconds HeartbeatPeriod{20}; // CONTRACTS 19
constexpr std::chrono::milliseconds BootTime{5000};

struct Motion {
    AxisCommand command;
    Time span = Time(-1); ///< how long a jog or velocity is held
};

/// Beats while it lives. A killed command line beats no more, and the controller stops the axis.
class Heart {
public:
    explicit Heart(ControllerLink& link)
    {
        m_timer.setTimerType(Qt::PreciseTimer);
        QObject::connect(&m_timer, &QTimer::timeout, [&link] { link.heartbeat(); });
        m_timer.start(HeartbeatPeriod);
        link.heartbeat();
    }

private:
    QTimer m_timer;
};

std::optional<AxisCommandKind> kindOf(const QString& word)
{
    static constexpr struct { const char* word; AxisCommandKind kind; } Words[] = {
        {"enable", AxisCommandKind::Enable}, {"disable", AxisCommandKind::Disable}, {"reset", AxisCommandKind::Reset},
        {"home", AxisCommandKind::Home}, {"move", AxisCommandKind::MoveAbsolute}, {"velocity", AxisCommandKind::Velocity},
        {"jog", AxisCommandKind::Jog}, {"stop", AxisCommandKind::Stop}};
    for (const auto& row : Words) {
        if (word == QLatin1String(row.word))
            return row.kind;
    }
    return std::nullopt;
}

bool readNumber(Invocation& call, const char* option, double& out)
{
    if (!call.has(option))
        return true;
    bool ok = false;
    out = call.value(option).replace(QLatin1Char(','), QLatin1Char('.')).toDouble(&ok);
    return ok;
}

std::optional<QString> readMotion(Invocation& call, AxisCommandKind kind, Motion& out)
{
    out.command.kind = kind;
    if (!readNumber(call, "to", out.command.position) || !readNumber(call, "by", out.command.position)
        || !readNumber(call, "velocity", out.command.velocity) || !readNumber(call, "acceleration", out.command.acceleration))
        return QStringLiteral("--to, --by, --velocity and --acceleration want a number.");
    if (kind == AxisCommandKind::MoveAbsolute) {
        if (call.has("to") == call.has("by"))
            return QStringLiteral("a move wants either --to POSITION or --by DISTANCE.");
        if (call.has("by"))
            out.command.kind = AxisCommandKind::MoveRelative;
    }
    const bool needsVelocity = kind == AxisCommandKind::MoveAbsolute || kind == AxisCommandKind::Jog || kind == AxisCommandKind::Velocity;
    if (needsVelocity && !call.has("velocity"))
        return QStringLiteral("'axis %1' wants --velocity in user units per second.").arg(call.words[0]);
    if (call.has("for")) {
        const auto span = parseTime(call.value("for"));
        if (!span)
            return QStringLiteral("--for wants a time like 2s, not '%1'.").arg(call.value("for"));
        out.span = *span;
    }
    return std::nullopt;
}

const AxisStatus* findAxis(const ControllerStatus& status, const QString& name)
{
    const std::string wanted = name.toStdString();
    for (const AxisStatus& axis : status.axes) {
        if (axis.name == wanted || std::to_string(axis.number) == wanted)
            return &axis;
    }
    return nullptr;
}

Result<void> send(Connection& connection, AxisCommand command, AxisCommandKind kind)
{
    command.kind = kind;
    return connection.ask<void>([&](auto reply) { connection.link().command(command, reply); });
}

/// Holds until the time is over or Ctrl+C, then stops the axis and waits for it to stand.
Result<void> hold(Connection& connection, const Motion& motion)
{
    // Without a time it is held until Ctrl+C; a nanosecond less than none would round to no time at all.
    const auto span = motion.span < Time{} ? std::chrono::milliseconds(-1) : std::chrono::duration_cast<std::chrono::milliseconds>(motion.span);
    if (!connection.wait(span))
        return connection.whyLost();
    return send(connection, motion.command, AxisCommandKind::Stop);
}

bool isMoving(Connection& connection, const QString& name)
{
    const AxisStatus* axis = findAxis(connection.link().status(), name);
    return axis && axis->moving;
}

Result<void> waitForStandstill(Connection& connection, const QString& name)
{
    // A move shows in the next status at the earliest; then the axis is watched until it stands.
    const std::uint64_t sent = connection.link().status().cycle;
    const bool alive = connection.wait(std::chrono::milliseconds(-1), [&] {
        return connection.link().status().cycle > sent + 200 && !isMoving(connection, name);
    });
    return alive ? Result<void>() : Result<void>(connection.whyLost());
}

/// Arms, gives the command, stays for as long as the motion needs a dead-man, disarms.
Result<void> moveUnderDeadMan(Connection& connection, const Motion& motion, const QString& name)
{
    if (const auto armed = send(connection, motion.command, AxisCommandKind::Arm); !armed)
        return armed.error();
    const Heart heart(connection.link());
    Result<void> done = send(connection, motion.command, motion.command.kind);
    if (done && (motion.command.kind == AxisCommandKind::Jog || motion.command.kind == AxisCommandKind::Velocity))
        done = hold(connection, motion);
    if (done)
        done = waitForStandstill(connection, name);
    if (done && interrupted())
        done = send(connection, motion.command, AxisCommandKind::Stop);
    const auto disarmed = send(connection, motion.command, AxisCommandKind::Disarm);
    return done ? disarmed : done;
}

int report(Invocation& call, Connection& connection, const QString& name, const Result<void>& done)
{
    if (!done)
        return refused(call, done.error());
    if (const AxisStatus* axis = findAxis(connection.link().status(), name)) {
        ControllerStatus one = connection.link().status();
        one.axes = {*axis};
        describeStatus(call, one);
        return axis->error != 0 && call.words[0] != QLatin1String("stop") ? AnswerIsNo : Done;
    }
    return Done;
}

/// Right after a start or a download the master is still booting the drives; a command given then would only be refused.
void waitForBus(Connection& connection, const QString& name)
{
    connection.wait(BootTime, [&] {
        const AxisStatus* axis = findAxis(connection.link().status(), name);
        return !axis || axis->online;
    });
}

/// Enabling, disabling and resetting take the drive a moment; the verb ends when the axis says so.
Result<void> doAndWait(Connection& connection, const Motion& motion, const QString& name)
{
    const AxisCommandKind kind = motion.command.kind;
    if (const auto sent = send(connection, motion.command, kind); !sent)
        return sent.error();
    const bool alive = connection.wait(BootTime, [&] {
        const AxisStatus* axis = findAxis(connection.link().status(), name);
        return !axis || (kind == AxisCommandKind::Reset ? axis->error == 0 : axis->enabled == (kind == AxisCommandKind::Enable));
    });
    return alive ? Result<void>() : Result<void>(connection.whyLost());
}

int stopAll(Invocation& call, Connection& connection)
{
    const auto done = connection.ask<void>([&](auto reply) { connection.link().stopAllAxes(reply); });
    return done ? int(Done) : refused(call, done.error());
}

} // namespace

int runAxis(Invocation& call)
{
    const QString word = call.words[0];
    const auto kind = kindOf(word);
    if (!kind && word != QLatin1String("status"))
        return wrongUsage(QStringLiteral("'axis %1' is not known: enable, disable, reset, home, move, velocity, jog, stop, status.").arg(word));
    if (call.words.size() < 2 && word != QLatin1String("stop") && word != QLatin1String("status"))
        return wrongUsage(QStringLiteral("'axis %1' wants the name or number of an axis.").arg(word));
    Motion motion;
    if (kind) {
        if (const auto wrong = readMotion(call, *kind, motion))
            return wrongUsage(*wrong);
    }
    auto opened = Connection::open(call);
    if (!opened)
        return refused(call, opened.error());
    Connection& connection = **opened;
    if (!kind)
        return describeStatus(call, connection.link().status()), Done;
    if (call.words.size() < 2)
        return stopAll(call, connection);

    const AxisStatus* axis = findAxis(connection.link().status(), call.words[1]);
    if (!axis)
        return refused(call, diagnostic(Code::AxisUnknown, {call.words[1].toStdString()}));
    motion.command.axis = axis->name;
    const QString name = QString::fromStdString(axis->name);
    if (*kind == AxisCommandKind::Stop)
        return report(call, connection, name, send(connection, motion.command, AxisCommandKind::Stop));
    if (const auto control = connection.takeControl(); !control)
        return refused(call, control.error());
    waitForBus(connection, name);
    const bool plain = *kind == AxisCommandKind::Enable || *kind == AxisCommandKind::Disable || *kind == AxisCommandKind::Reset;
    return report(call, connection, name,
        plain ? doAndWait(connection, motion, name) : moveUnderDeadMan(connection, motion, name));
}

void addAxisOptions(QCommandLineParser& options)
{
    addConnectionOptions(options);
    options.addOption({QStringLiteral("to"), QStringLiteral("Target of a move, in mm or degrees."), QStringLiteral("POSITION")});
    options.addOption({QStringLiteral("by"), QStringLiteral("Distance of a move, in mm or degrees."), QStringLiteral("DISTANCE")});
    options.addOption({QStringLiteral("velocity"), QStringLiteral("In mm/s or degrees/s; the sign is the direction of a jog."), QStringLiteral("V")});
    options.addOption({QStringLiteral("acceleration"), QStringLiteral("In mm/s2 or degrees/s2; the drive's own without it."), QStringLiteral("A")});
    options.addOption({QStringLiteral("for"), QStringLiteral("How long a jog or velocity is held; until Ctrl+C without it."), QStringLiteral("TIME")});
}

} // namespace camwright::cli
