#include "app/cli/connection.h"
#include "app/cli/csv.h"
#include "app/cli/exitcode.h"
#include "app/cli/projects.h"
#include "app/cli/quantities.h"
#include "app/cli/verbs.h"
#include "core/online/valuename.h"

namespace camwright::cli {

namespace {

struct Recording {
    TraceSetup setup;
    Time limit{};
};

std::optional<TriggerKind> edgeOf(const QString& text)
{
    if (text == QLatin1String("rising"))
        return TriggerKind::RisingEdge;
    if (text == QLatin1String("falling"))
        return TriggerKind::FallingEdge;
    if (text == QLatin1String("above"))
        return TriggerKind::Above;
    if (text == QLatin1String("below"))
        return TriggerKind::Below;
    return std::nullopt;
}

std::optional<QString> readTrigger(Invocation& call, TraceSetup& setup)
{
    if (!call.has("trigger"))
        return std::nullopt;
    const auto edge = edgeOf(call.value("edge"));
    if (!edge)
        return QStringLiteral("--edge wants rising, falling, above or below, not '%1'.").arg(call.value("edge"));
    bool levelOk = false, preOk = false;
    setup.trigger = *edge;
    setup.triggerChannel = call.value("trigger").toStdString();
    setup.triggerLevel = call.value("level").toDouble(&levelOk);
    setup.preTrigger = call.value("pre").toDouble(&preOk);
    if (!levelOk || !preOk || setup.preTrigger < 0 || setup.preTrigger > 1)
        return QStringLiteral("--level wants a number and --pre a fraction from 0 to 1.");
    return std::nullopt;
}

std::optional<QString> readRecording(Invocation& call, Recording& out)
{
    for (const QString& word : call.words) {
        for (std::string& name : splitValueNames(word.toStdString()))
            out.setup.channels.push_back(std::move(name));
    }
    const auto every = parseTime(call.value("every"));
    const auto span = parseTime(call.value("for"));
    const auto limit = parseTime(call.value("timeout"));
    if (!every || !span || !limit || *every < 1ms || *every % 1ms != Time::zero() || *span < *every)
        return QStringLiteral("--every wants whole milliseconds, --for and --timeout a time like 2s.");
    out.setup.stride = static_cast<std::uint32_t>(*every / 1ms);
    out.setup.samples = static_cast<std::uint32_t>(*span / *every);
    out.limit = *limit + *span;
    return readTrigger(call, out.setup);
}

void reportJson(Invocation& call, const CsvTable& table, std::int64_t triggerCycle)
{
    call.out.json()["rows"] = table.rows();
    if (triggerCycle >= 0)
        call.out.json()["triggerCycle"] = triggerCycle;
}

} // namespace

int runTrace(Invocation& call)
{
    Recording recording;
    if (const auto wrong = readRecording(call, recording))
        return wrongUsage(*wrong);
    auto opened = Connection::open(call);
    if (!opened)
        return refused(call, opened.error());
    Connection& connection = **opened;

    CsvTable table(recording.setup.channels);
    bool complete = false;
    std::int64_t triggerCycle = -1;
    const auto started = connection.ask<void>([&](auto reply) {
        connection.link().startTrace(recording.setup, [&](const SampleBlock& block) {
            table.append(block);
            triggerCycle = std::max(triggerCycle, block.triggerCycle);
            complete = complete || block.last;
        }, reply);
    });
    if (!started)
        return refused(call, started.error());
    const bool alive = connection.wait(std::chrono::duration_cast<std::chrono::milliseconds>(recording.limit), [&] { return complete; });
    if (!alive)
        return refused(call, connection.whyLost());
    if (!table.writeTo(call.value("out").isEmpty() && call.out.asJson() ? QStringLiteral("/dev/null") : call.value("out")))
        return cannotWrite(call.value("out"));
    reportJson(call, table, triggerCycle);
    if (!complete) {
        call.out.progress(QStringLiteral("The trigger did not come within the time of --timeout; %1 rows were recorded.").arg(table.rows()));
        return AnswerIsNo;
    }
    return Done;
}

void addTraceOptions(QCommandLineParser& options)
{
    addConnectionOptions(options);
    options.addOption({QStringLiteral("for"), QStringLiteral("Length of the recording."), QStringLiteral("TIME"), QStringLiteral("1s")});
    options.addOption({QStringLiteral("every"), QStringLiteral("Distance between rows."), QStringLiteral("TIME"), QStringLiteral("1ms")});
    options.addOption({QStringLiteral("trigger"), QStringLiteral("Value that starts the recording; at once without it."), QStringLiteral("NAME")});
    options.addOption({QStringLiteral("edge"), QStringLiteral("rising, falling, above or below the level."), QStringLiteral("EDGE"), QStringLiteral("rising")});
    options.addOption({QStringLiteral("level"), QStringLiteral("Level of the trigger."), QStringLiteral("LEVEL"), QStringLiteral("0.5")});
    options.addOption({QStringLiteral("pre"), QStringLiteral("Part of the recording before the trigger, 0 to 1."), QStringLiteral("FRACTION"), QStringLiteral("0.2")});
    options.addOption({QStringLiteral("timeout"), QStringLiteral("How long to wait for the trigger."), QStringLiteral("TIME"), QStringLiteral("30s")});
    options.addOption({QStringLiteral("out"), QStringLiteral("CSV file to write; standard output without it."), QStringLiteral("FILE")});
}

} // namespace camwright::cli
