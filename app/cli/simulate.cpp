#include "app/cli/csv.h"
#include "app/cli/exitcode.h"
#include "app/cli/projects.h"
#include "app/cli/quantities.h"
#include "app/cli/verbs.h"
#include "core/online/valuename.h"
#include "core/runtime/engine.h"
#include "core/runtime/native/nativeprogram.h"
#include "editors/words/words.h"

namespace camwright::cli {

namespace {

struct TimedWrite {
    QString name;
    QString value;
    std::uint64_t cycle = 0;
};

struct Plan {
    Time span{};
    Time every = kMotionCycle;
    std::uint64_t seed = 1;
    ExecutorChoice executor = ExecutorChoice::Automatic;
    std::vector<TimedWrite> writes;
    TraceSetup trace;
};

/// "NAME=VALUE@TIME"; the time may be left out and is 0 then.
std::optional<TimedWrite> parseWrite(const QString& text)
{
    const qsizetype equals = text.indexOf(QLatin1Char('='));
    if (equals <= 0)
        return std::nullopt;
    const qsizetype at = text.lastIndexOf(QLatin1Char('@'));
    TimedWrite out;
    out.name = text.left(equals).trimmed();
    out.value = (at > equals ? text.mid(equals + 1, at - equals - 1) : text.mid(equals + 1)).trimmed();
    if (at > equals) {
        const auto time = parseTime(text.mid(at + 1));
        if (!time)
            return std::nullopt;
        out.cycle = static_cast<std::uint64_t>(*time / kMotionCycle);
    }
    return out;
}

std::optional<QString> readPlan(Invocation& call, Plan& plan)
{
    const auto span = parseTime(call.value("for"));
    if (!span || *span <= Time::zero())
        return QStringLiteral("--for wants a time like 10s or 500ms, not '%1'.").arg(call.value("for"));
    plan.span = *span;
    const auto every = parseTime(call.value("every"));
    if (!every || *every < kMotionCycle || *every % kMotionCycle != Time::zero())
        return QStringLiteral("--every wants whole milliseconds like 1ms or 10ms, not '%1'.").arg(call.value("every"));
    plan.every = *every;
    bool ok = false;
    plan.seed = call.value("seed").toULongLong(&ok);
    if (!ok)
        return QStringLiteral("--seed wants a whole number, not '%1'.").arg(call.value("seed"));
    const auto executor = executorChoiceByName(call.value("executor").toStdString());
    if (!executor)
        return QStringLiteral("--executor wants interpreter, native or auto, not '%1'.").arg(call.value("executor"));
    if (*executor == ExecutorChoice::Native && !hasNativeTranslation())
        return QStringLiteral("This build makes no machine code for the processor; leave --executor native out.");
    plan.executor = *executor;
    for (const QString& text : call.options.values(QStringLiteral("set"))) {
        const auto write = parseWrite(text);
        if (!write)
            return QStringLiteral("--set wants NAME=VALUE@TIME like X0=1@2s, not '%1'.").arg(text);
        plan.writes.push_back(*write);
    }
    for (const QString& list : call.options.values(QStringLiteral("trace"))) {
        for (std::string& name : splitValueNames(list.toStdString()))
            plan.trace.channels.push_back(std::move(name));
    }
    plan.trace.stride = static_cast<std::uint32_t>(plan.every / kMotionCycle);
    return std::nullopt;
}

Result<void> postWrites(ControllerEngine& engine, const Plan& plan)
{
    for (const TimedWrite& write : plan.writes) {
        const auto ref = engine.resolve(write.name.toStdString());
        if (!ref)
            return ref.error();
        const auto value = parseValue(ref->type, write.value.toStdString());
        if (!value)
            return value.error();
        engine.post({engine.cycle() + 1 + write.cycle, input::Write{*ref, *value}});
    }
    return {};
}

void reportLog(Invocation& call, const ControllerEngine& engine)
{
    for (const LogEntry& entry : engine.logSince(0)) {
        if (call.out.asJson()) {
            Json line = toJson(entry.message);
            line["time_s"] = seconds(entry.time);
            call.out.json()["log"].push_back(std::move(line));
        } else if (entry.message.severity() != Severity::Information) {
            call.out.progress(QStringLiteral("%1 s: ").arg(seconds(entry.time), 0, 'f', 3) + words::sentence(entry.message));
        }
    }
}

/// Steps to the end, draining samples so that none is lost.
void runAll(ControllerEngine& engine, const Plan& plan, CsvTable& table)
{
    const auto drain = [&] {
        while (const auto block = engine.takeSamples())
            table.append(*block);
    };
    for (Time left = plan.span; left > Time::zero();) {
        const Time piece = std::min<Time>(left, 100ms);
        engine.step(piece);
        left -= piece;
        drain();
    }
    engine.stopTrace();
    drain();
}

int simulate(Invocation& call)
{
    Plan plan;
    if (const auto wrong = readPlan(call, plan))
        return wrongUsage(*wrong);
    const auto built = buildProject(call, call.words[0]);
    if (!built)
        return built.status;

    ControllerEngine engine(EngineOptions{plan.seed, plan.executor});
    const auto fail = [&](const Diagnostic& why) { return call.out.diagnostic(why), AnswerIsNo; };
    if (const auto loaded = engine.load(built.image); !loaded)
        return fail(loaded.error());
    if (const auto posted = postWrites(engine, plan); !posted)
        return fail(posted.error());
    if (!plan.trace.channels.empty()) {
        if (const auto started = engine.startTrace(plan.trace); !started)
            return fail(started.error());
    }
    if (const auto running = engine.apply(input::Run{}); !running)
        return fail(running.error());

    CsvTable table(plan.trace.channels);
    runAll(engine, plan, table);
    const bool tracing = !plan.trace.channels.empty();
    const bool toStandardOutput = tracing && call.value("out").isEmpty();
    if (tracing && !(call.out.asJson() && toStandardOutput) && !table.writeTo(call.value("out")))
        return cannotWrite(call.value("out"));

    const ControllerStatus status = engine.status();
    reportLog(call, engine);
    describeStatus(call, status, toStandardOutput);
    return status.state == RunState::Error ? AnswerIsNo : Done;
}

} // namespace

void addSimulateOptions(QCommandLineParser& options)
{
    options.addOption({QStringLiteral("for"), QStringLiteral("How long, in controller time (10s, 500ms)."), QStringLiteral("TIME"), QStringLiteral("10s")});
    options.addOption({QStringLiteral("seed"), QStringLiteral("Seed of the simulated plants."), QStringLiteral("N"), QStringLiteral("1")});
    options.addOption({QStringLiteral("executor"), QStringLiteral("What runs the program: interpreter, native (machine code) or auto. The results are the same."), QStringLiteral("WHICH"), QStringLiteral("auto")});
    options.addOption({QStringLiteral("set"), QStringLiteral("Writes a value at a time; for an input: sets its terminal. May be repeated."), QStringLiteral("NAME=VALUE@TIME")});
    options.addOption({QStringLiteral("trace"), QStringLiteral("Records these values, separated by commas."), QStringLiteral("NAME,...")});
    options.addOption({QStringLiteral("every"), QStringLiteral("Distance between recorded rows."), QStringLiteral("TIME"), QStringLiteral("1ms")});
    options.addOption({QStringLiteral("out"), QStringLiteral("CSV file to write; standard output without it."), QStringLiteral("FILE")});
}

int runSimulate(Invocation& call)
{
    return simulate(call);
}

} // namespace camwright::cli
