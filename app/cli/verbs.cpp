#include "app/cli/verbs.h"

#include "app/cli/connection.h"

namespace camwright::cli {

namespace {

void noOptions(QCommandLineParser&) {}

constexpr Verb Verbs[] = {
    {"new", "PROJECT", 1, 1, "Makes a project folder.", addNewOptions, runNew},
    {"check", "PROJECT|FILE.st", 1, 1, "Applies every rule to a project and its programs, or to one file of Structured Text.", noOptions, runCheck},
    {"build", "PROJECT", 1, 1, "Compiles a project to a controller image.", addBuildOptions, runBuild},
    {"convert", "PROJECT DIR", 2, 2, "Writes a project anew into an empty folder.", addConvertOptions, runConvert},
    {"simulate", "PROJECT", 1, 1, "Runs a project on the virtual controller in virtual time.", addSimulateOptions, runSimulate},
    {"download", "PROJECT", 1, 1, "Sends a project to a controller, all or nothing.", addDownloadOptions, runDownload},
    {"start", "", 0, 0, "Starts the controller's program.", addConnectionOptions, runStart},
    {"stop", "", 0, 0, "Stops the controller's program.", addStopOptions, runStop},
    {"status", "", 0, 0, "Tells state, program, axes and who has control.", addConnectionOptions, runStatus},
    {"read", "NAME...", 1, -1, "Reads values once.", addReadOptions, runRead},
    {"write", "NAME VALUE", 2, 2, "Writes a value once; switches an input of the virtual controller.", addConnectionOptions, runWrite},
    {"force", "NAME VALUE", 2, 2, "Holds a value until it is released.", addConnectionOptions, runForce},
    {"release", "[NAME]", 0, 1, "Releases a forced value, or all.", addConnectionOptions, runRelease},
    {"monitor", "NAME...", 1, -1, "Shows values as they change.", addMonitorOptions, runMonitor},
    {"trace", "NAME...", 1, -1, "Records values in every motion cycle.", addTraceOptions, runTrace},
    {"axis", "JOB [AXIS]", 1, 2, "Enables, homes, moves, jogs and stops axes.", addAxisOptions, runAxis},
    {"log", "", 0, 0, "Shows the controller's log.", addLogOptions, runLog},
    {"explain", "CODE", 1, 1, "Shows the page about a message: an example and the way out.", noOptions, runExplain},
};

} // namespace

std::span<const Verb> verbs()
{
    return Verbs;
}

} // namespace camwright::cli
