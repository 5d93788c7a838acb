#pragma once

#include "core/runtime/engine.h"
#include "core/runtime/loadedprogram.h"
#include "core/runtime/log/controllerlog.h"
#include "core/runtime/trace/tracerecorder.h"

#include <optional>
#include <vector>

namespace camwright {

/// The engine's state and its work, spread over engine.cpp (what callers see), enginecycle.cpp (time), engineinputs.cpp
/// (inputs) and enginestate.cpp (saved state).
struct ControllerEngine::Impl {
    explicit Impl(EngineOptions engineOptions) : options(engineOptions) {}
    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;

    // Time.
    void doCycle();
    void applyDueInputs();
    void watchTransitions();
    void runInterrupts();
    void runScan();
    void sampleTrace();

    // Inputs; each says why it is refused.
    Result<void> apply(const input::Run&);
    Result<void> apply(const input::Stop&);
    Result<void> apply(const input::RunSwitch& in);
    Result<void> apply(const input::Write& in);
    Result<void> apply(const input::Force& in);
    Result<void> apply(const input::Release& in);
    Result<void> apply(const input::ReleaseAll&);
    Result<void> apply(const input::Panel& in);
    Result<void> apply(const input::Heartbeat& in);
    Result<void> apply(const input::StopAllAxes&);
    Result<void> apply(const input::LoadImage& in);
    Result<void> apply(const input::PowerCycle&);
    Result<void> apply(const input::InjectFault& in);

    bool isQuiet() const;
    void requestStart();
    void startProgram();
    void stopProgram(Code why);
    void switchImage();
    void watchdogFired(const ScanReport& report);
    Result<void> checkMemory(const ValueRef& ref) const;
    double number(const ValueRef& ref) const;

    void save(ByteWriter& writer) const;
    bool restore(ByteReader& reader);
    bool hasUsableTrace() const;

    EngineOptions options;
    ControllerLog log;
    Time now{};
    std::uint64_t cycle = 0;
    std::vector<EngineInput> queue;          ///< by cycle, then as posted

    RunState state = RunState::Stop;
    bool runSwitch = true;
    bool runCommand = false;                 ///< the last command was RUN (KS-CPU-06)
    bool startPending = false;               ///< RUN waits for the bus and for axes that are still being released
    std::unique_ptr<LoadedProgram> program;
    std::optional<PreparedImage> pending;    ///< accepted, waits for axes to be released
    std::uint32_t imageNumber = 0;

    std::uint64_t lateCycles = 0;
    std::uint64_t lateLogged = 0;
    Time lateLoggedAt{};

    TraceRecorder trace;
    std::vector<ValueRef> traceRefs;
    std::optional<ValueRef> triggerRef;
    std::vector<double> traceRow;
};

} // namespace camwright
