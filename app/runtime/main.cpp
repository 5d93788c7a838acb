// camwright-runtime: the controller as a process.
#include "app/runtime/runtime.h"
#include "app/runtime/signals.h"

#include <QCommandLineParser>
#include <QCoreApplication>

#include <cstdio>
#include <optional>

#include <sys/stat.h>

namespace {

using namespace camwright;

constexpr int Done = 0, Refused = 1, WrongUsage = 2;

int fail(const std::string& message, int status)
{
    std::fprintf(stderr, "camwright-runtime: %s\n", message.c_str());
    return status;
}

void addOptions(QCommandLineParser& parser)
{
    parser.setApplicationDescription(QStringLiteral("The Camwright controller: virtual, with simulated drives, for tools of this machine."));
    parser.addHelpOption();
    parser.addVersionOption();
    parser.addOptions({
        {QStringLiteral("listen"), QStringLiteral("Listen on HOST:PORT of this machine (127.0.0.1, ::1); port 0 takes a free one."),
         QStringLiteral("HOST:PORT")},
        {QStringLiteral("local"), QStringLiteral("Listen on a socket file that only this user can open; end after ten minutes without a client."),
         QStringLiteral("SOCKETFILE")},
        {QStringLiteral("data"), QStringLiteral("Keep program and retained values in this folder. Without it nothing is kept."),
         QStringLiteral("DIR")},
        {QStringLiteral("seed"), QStringLiteral("Seed of the simulated plants; 1 if not given."), QStringLiteral("N"), QStringLiteral("1")},
        {QStringLiteral("idle"), QStringLiteral("With --local: end after SECONDS without a client instead of 600."), QStringLiteral("SECONDS"),
         QStringLiteral("600")},
    });
}

std::optional<RuntimeOptions> readOptions(const QCommandLineParser& parser, std::string& error)
{
    RuntimeOptions out;
    out.listen = parser.value(QStringLiteral("listen")).toStdString();
    out.local = parser.value(QStringLiteral("local")).toStdString();
    out.data = parser.value(QStringLiteral("data")).toStdString();
    bool seedGood = false, idleGood = false;
    out.seed = parser.value(QStringLiteral("seed")).toULongLong(&seedGood);
    const uint idle = parser.value(QStringLiteral("idle")).toUInt(&idleGood);
    out.idle = std::chrono::seconds(idle);
    const QStringList strays = parser.positionalArguments();
    if (!strays.isEmpty())
        error = "\"" + strays.first().toStdString() + "\" is no option. --help tells the options.";
    else if (out.listen.empty() && out.local.empty())
        error = "nobody could connect. Give --listen HOST:PORT or --local SOCKETFILE.";
    else if (!seedGood)
        error = "--seed wants a whole number.";
    else if (!idleGood || idle == 0 || idle > 1'000'000)
        error = "--idle wants a number of seconds, 1 to 1000000.";
    if (!error.empty())
        return std::nullopt;
    return out;
}

} // namespace

int main(int argc, char** argv)
{
    ::umask(0077);
    QCoreApplication application(argc, argv);
    QCoreApplication::setApplicationName(QStringLiteral("camwright-runtime"));
    QCoreApplication::setApplicationVersion(QStringLiteral(CAMWRIGHT_VERSION));
    QCommandLineParser parser;
    addOptions(parser);
    if (!parser.parse(QCoreApplication::arguments()))
        return fail(parser.errorText().toStdString(), WrongUsage);
    if (parser.isSet(QStringLiteral("help"))) {
        std::fputs(parser.helpText().toUtf8().constData(), stdout);
        return Done;
    }
    if (parser.isSet(QStringLiteral("version"))) {
        std::printf("camwright-runtime %s\n", CAMWRIGHT_VERSION);
        return Done;
    }
    std::string error;
    const auto options = readOptions(parser, error);
    if (!options)
        return fail(error, WrongUsage);

    onTermination([] { QCoreApplication::quit(); });
    Runtime runtime(*options);
    if (const auto started = runtime.start(); !started)
        return fail(englishText(started.error()), started.error().code == Code::ListenNotLocal ? WrongUsage : Refused);
    // A first line for whoever started it: now it can be reached, and where.
    if (options->listen.empty())
        std::printf("Listening on %s\n", options->local.c_str());
    else
        std::printf("Listening on %s:%u\n", options->listen.substr(0, options->listen.rfind(':')).c_str(), runtime.port());
    std::fflush(stdout);
    const int status = QCoreApplication::exec();
    runtime.stop();
    return status;
}
