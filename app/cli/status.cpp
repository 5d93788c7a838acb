#include "app/cli/connection.h"
#include "app/cli/exitcode.h"
#include "app/cli/verbs.h"

namespace camwright::cli {

namespace {

const char* stateWord(RunState state)
{
    switch (state) {
    case RunState::Stop: return "STOP";
    case RunState::Run: return "RUN";
    case RunState::Error: return "ERROR";
    }
    return "";
}

const char* controlWord(ControlHolder holder)
{
    switch (holder) {
    case ControlHolder::Nobody: return "nobody";
    case ControlHolder::You: return "you";
    case ControlHolder::Somebody: return "somebody";
    }
    return "";
}

QString axisLine(const AxisStatus& axis)
{
    QString line = QStringLiteral("axis %1 (%2): %3, %4 %5, %6 %5/s")
        .arg(QString::fromStdString(axis.name)).arg(axis.number).arg(QString::fromStdString(axis.stateName))
        .arg(axis.position, 0, 'f', 3).arg(QString::fromStdString(axis.unit)).arg(axis.velocity, 0, 'f', 3);
    if (axis.homed)
        line += QStringLiteral(", homed");
    if (!axis.online)
        line += QStringLiteral(", offline");
    if (axis.panelArmed)
        line += QStringLiteral(", panel armed");
    if (axis.error != 0)
        line += QStringLiteral(", error 16#%1").arg(axis.error, 0, 16);
    return line;
}

Json toJson(const AxisStatus& axis)
{
    return {{"name", axis.name}, {"number", axis.number}, {"state", axis.state}, {"stateName", axis.stateName}, {"error", axis.error},
            {"enabled", axis.enabled}, {"homed", axis.homed}, {"moving", axis.moving}, {"online", axis.online},
            {"panelArmed", axis.panelArmed}, {"position", axis.position}, {"setPosition", axis.setPosition},
            {"velocity", axis.velocity}, {"followingError", axis.followingError}, {"torque", axis.torque}, {"unit", axis.unit}};
}

} // namespace

Json toJson(const ControllerStatus& status)
{
    Json out{{"state", stateWord(status.state)}, {"family", status.family}, {"model", status.model}, {"project", status.projectName},
             {"program", status.program.isNull() ? std::string() : toHex(status.program)}, {"cycle", status.cycle},
             {"time_s", seconds(status.time)}, {"scan_ms", status.scanMs}, {"scanMax_ms", status.scanMaxMs},
             {"busLoad_percent", status.busLoadPercent}, {"forces", status.forces}, {"lateCycles", status.lateCycles},
             {"control", controlWord(status.control)}, {"controlOwner", status.controlOwner}, {"axes", Json::array()}};
    for (const AxisStatus& axis : status.axes)
        out["axes"].push_back(toJson(axis));
    return out;
}

void describeStatus(Invocation& call, const ControllerStatus& status, bool quiet)
{
    if (call.out.asJson()) {
        call.out.json()["status"] = toJson(status);
        return;
    }
    const auto print = [&](const QString& text) { quiet ? call.out.progress(text) : call.out.line(text); };
    print(QStringLiteral("%1, %2, program %3").arg(QLatin1String(stateWord(status.state)), QString::fromStdString(status.model),
        status.program.isNull() ? QStringLiteral("none") : QString::fromStdString(status.projectName + " " + shortHex(status.program))));
    print(QStringLiteral("cycle %1, scan %2 ms (longest %3 ms), bus load %4 %, forces %5, late cycles %6")
        .arg(status.cycle).arg(status.scanMs, 0, 'f', 3).arg(status.scanMaxMs, 0, 'f', 3).arg(status.busLoadPercent, 0, 'f', 1)
        .arg(status.forces).arg(status.lateCycles));
    for (const AxisStatus& axis : status.axes)
        print(axisLine(axis));
}

int runStatus(Invocation& call)
{
    const auto connection = Connection::open(call);
    if (!connection)
        return refused(call, connection.error());
    describeStatus(call, (*connection)->link().status());
    if (!call.out.asJson()) {
        const ControllerStatus& status = (*connection)->link().status();
        call.out.line(status.control == ControlHolder::Nobody ? QStringLiteral("control: nobody")
                      : QStringLiteral("control: %1").arg(QString::fromStdString(status.controlOwner)));
    }
    return Done;
}

} // namespace camwright::cli
