#pragma once

#include "app/cli/verb.h"
#include "core/base/bytes.h"
#include "core/online/controllerlink.h"

namespace camwright::cli {

// Each verb of the table in verbs.cpp; the file is named after the verb or its group.
int runNew(Invocation&);
int runCheck(Invocation&);
int runBuild(Invocation&);
int runConvert(Invocation&);
int runSimulate(Invocation&);
int runDownload(Invocation&);
int runStart(Invocation&);
int runStop(Invocation&);
int runStatus(Invocation&);
int runRead(Invocation&);
int runWrite(Invocation&);
int runForce(Invocation&);
int runRelease(Invocation&);
int runMonitor(Invocation&);
int runTrace(Invocation&);
int runAxis(Invocation&);
int runLog(Invocation&);
int runExplain(Invocation&);

void addNewOptions(QCommandLineParser&);
void addBuildOptions(QCommandLineParser&);
void addConvertOptions(QCommandLineParser&);
void addSimulateOptions(QCommandLineParser&);
void addDownloadOptions(QCommandLineParser&);
void addStopOptions(QCommandLineParser&);
void addReadOptions(QCommandLineParser&);
void addMonitorOptions(QCommandLineParser&);
void addTraceOptions(QCommandLineParser&);
void addAxisOptions(QCommandLineParser&);
void addLogOptions(QCommandLineParser&);

/// Prints a controller's status as lines, or as "status" of the JSON document; `quiet` keeps standard output for data.
void describeStatus(Invocation&, const ControllerStatus&, bool quiet = false);
Json toJson(const ControllerStatus&);

} // namespace camwright::cli
