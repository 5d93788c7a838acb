#include "app/cli/connection.h"
#include "app/cli/exitcode.h"
#include "app/cli/quantities.h"
#include "app/cli/verbs.h"

namespace camwright::cli {

namespace {

std::vector<std::string> toNames(const QStringList& words)
{
    std::vector<std::string> out;
    for (const QString& word : words)
        out.push_back(word.toStdString());
    return out;
}

std::optional<NumberBase> baseOf(const QString& text)
{
    if (text == QLatin1String("dec"))
        return NumberBase::Decimal;
    if (text == QLatin1String("hex"))
        return NumberBase::Hexadecimal;
    if (text == QLatin1String("bin"))
        return NumberBase::Binary;
    if (text == QLatin1String("oct"))
        return NumberBase::Octal;
    return std::nullopt;
}

Json toJson(const MonitoredValue& value)
{
    return {{"name", value.name}, {"type", name(value.value.type)}, {"value", formatValue(value.value)}, {"forced", value.forced}};
}

void print(Invocation& call, const std::vector<MonitoredValue>& values, NumberBase base)
{
    for (const MonitoredValue& value : values) {
        if (call.out.asJson())
            call.out.json()["values"].push_back(toJson(value));
        else
            call.out.line(QStringLiteral("%1 = %2%3").arg(QString::fromStdString(value.name), QString::fromStdString(formatValue(value.value, base)),
                value.forced ? QStringLiteral(" F") : QString()));
    }
}

/// Reads the typed text with the type the running program gives the name.
Result<Value> typedValue(Connection& connection, const std::string& name, const QString& text)
{
    const auto types = connection.ask<std::vector<DataType>>([&](auto reply) { connection.link().describe({name}, reply); });
    if (!types)
        return types.error();
    return parseValue(types->front(), text.toStdString());
}

template <class Change>
int change(Invocation& call, Change&& apply)
{
    auto connection = Connection::open(call);
    if (!connection)
        return refused(call, connection.error());
    if (const auto control = (*connection)->takeControl(); !control)
        return refused(call, control.error());
    return apply(**connection);
}

using Setter = RequestId (ControllerLink::*)(std::string, Value, ControllerLink::Reply<void>);

int setValue(Invocation& call, Setter setter)
{
    return change(call, [&](Connection& connection) -> int {
        const std::string name = call.words[0].toStdString();
        const auto value = typedValue(connection, name, call.words[1]);
        if (!value) {
            call.out.diagnostic(value.error());
            return value.error().code == Code::NotAValue || value.error().code == Code::ValueOutOfRange ? AnswerIsNo : ControllerRefuses;
        }
        const auto done = connection.ask<void>([&](auto reply) { (connection.link().*setter)(name, *value, reply); });
        return done ? int(Done) : refused(call, done.error());
    });
}

} // namespace

int runRead(Invocation& call)
{
    const auto base = baseOf(call.value("base"));
    if (!base)
        return wrongUsage(QStringLiteral("--base wants dec, hex, bin or oct, not '%1'.").arg(call.value("base")));
    auto connection = Connection::open(call);
    if (!connection)
        return refused(call, connection.error());
    const auto values = (*connection)->ask<std::vector<MonitoredValue>>([&](auto reply) { (*connection)->link().read(toNames(call.words), reply); });
    if (!values)
        return refused(call, values.error());
    print(call, *values, *base);
    return Done;
}

int runWrite(Invocation& call) { return setValue(call, &ControllerLink::write); }
int runForce(Invocation& call) { return setValue(call, &ControllerLink::force); }

int runRelease(Invocation& call)
{
    return change(call, [&](Connection& connection) -> int {
        const std::string name = call.words.value(0).toStdString();
        const auto done = connection.ask<void>([&](auto reply) { connection.link().release(name, reply); });
        return done ? int(Done) : refused(call, done.error());
    });
}

int runMonitor(Invocation& call)
{
    const auto base = baseOf(call.value("base"));
    if (!base)
        return wrongUsage(QStringLiteral("--base wants dec, hex, bin or oct, not '%1'.").arg(call.value("base")));
    const auto period = parseTime(call.value("every"));
    const auto span = call.has("for") ? parseTime(call.value("for")) : std::optional<Time>(Time(-1));
    if (!period || !span)
        return wrongUsage(QStringLiteral("--every and --for want a time like 100ms or 5s."));
    auto connection = Connection::open(call);
    if (!connection)
        return refused(call, connection.error());
    ControllerLink& link = (*connection)->link();
    const auto names = toNames(call.words);
    // Asked once first, so that a name the program does not know is an answer and not silence.
    if (const auto known = (*connection)->ask<std::vector<DataType>>([&](auto reply) { link.describe(names, reply); }); !known)
        return refused(call, known.error());
    const SubscriptionId subscription = link.subscribe(names, *period, [&](const MonitorUpdate& update) {
        if (call.out.asJson()) {
            Json row{{"cycle", update.cycle}, {"values", Json::object()}};
            for (const MonitoredValue& value : update.values)
                row["values"][value.name] = formatValue(value.value);
            call.out.json()["updates"].push_back(std::move(row));
            return;
        }
        QString line = QStringLiteral("%1").arg(update.cycle);
        for (const MonitoredValue& value : update.values)
            line += QStringLiteral("  %1 = %2%3").arg(QString::fromStdString(value.name), QString::fromStdString(formatValue(value.value, *base)),
                value.forced ? QStringLiteral(" F") : QString());
        call.out.line(line);
    });
    const bool alive = (*connection)->wait(std::chrono::duration_cast<std::chrono::milliseconds>(*span));
    link.unsubscribe(subscription);
    return alive ? int(Done) : refused(call, (*connection)->whyLost());
}

void addReadOptions(QCommandLineParser& options)
{
    addConnectionOptions(options);
    options.addOption({QStringLiteral("base"), QStringLiteral("How integers are shown: dec, hex, bin, oct."), QStringLiteral("BASE"), QStringLiteral("dec")});
}

void addMonitorOptions(QCommandLineParser& options)
{
    addReadOptions(options);
    options.addOption({QStringLiteral("every"), QStringLiteral("Distance between updates."), QStringLiteral("TIME"), QStringLiteral("100ms")});
    options.addOption({QStringLiteral("for"), QStringLiteral("How long; until Ctrl+C without it."), QStringLiteral("TIME")});
}

} // namespace camwright::cli
