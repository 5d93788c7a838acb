#pragma once

#include "core/base/bytes.h"
#include "core/base/diagnostic.h"
#include "core/base/hash.h"
#include "core/base/result.h"
#include "core/base/time.h"
#include "core/base/value.h"
#include "core/online/controllerlink.h"
#include "core/online/sampleblock.h"
#include "core/runtime/engineinput.h"
#include "core/runtime/native/loadexecutor.h"
#include "core/runtime/valueref.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace camwright {

struct EngineOptions {
    std::uint64_t seed = 1; ///< of the simulated plants' small disturbances
    ExecutorChoice executor = ExecutorChoice::Automatic; ///< both give the same bytes; not part of a saved state
};

/// Length of a motion cycle, on every family.
inline constexpr Time kMotionCycle = 1ms;

/// One terminal point of the virtual controller, for a panel of inputs and outputs.
struct Terminal {
    std::string name;     ///< "%I0.0", "Y2"
    bool isInput = false;
    ValueRef ref;
};

/// The controller: tasks, motion, simulated bus and drives, advanced by step(). It owns no time, no thread and no file; one
/// thread at a time may use it. Same image, seed and inputs give the same bytes (CONTRACTS 10 to 12).
///
/// Cycle k of the motion task is at k ms; step(1ms) does exactly one. In one instant the order is: inputs stamped for the
/// cycle, end of the running scan, motion task, start of the next scan, trace.
class ControllerEngine {
public:
    explicit ControllerEngine(EngineOptions options = {});
    ~ControllerEngine();
    ControllerEngine(ControllerEngine&&) noexcept;
    ControllerEngine& operator=(ControllerEngine&&) noexcept;

    /// apply(input::LoadImage) for callers who have only bytes.
    Result<void> load(ByteSpan image);
    bool hasImage() const;
    /// Counts image switches; a ValueRef is good for one number.
    std::uint32_t imageNumber() const;
    /// True between an accepted load and its switch, while axes come to rest.
    bool switchPending() const;
    /// The running image as it was loaded; empty without one.
    ByteSpan imageBytes() const;

    /// Does an input now, before the next cycle, and says why it is refused. Recorded inputs replay by the same function.
    Result<void> apply(const EngineInputContent& content);
    /// Queues an input for its cycle and returns that cycle. A refusal then goes to the log.
    std::uint64_t post(EngineInput input);

    /// Advances virtual time. Cycles at times in (now, now + span] are done.
    void step(Time span);
    Time now() const;
    std::uint64_t cycle() const;  ///< the last motion cycle done

    /// State, axes, forces, times; control fields are left empty. Late cycles are those told by countLateCycles().
    ControllerStatus status() const;
    /// In STOP with every axis released: an image can be switched at once.
    bool isQuiet() const;
    /// The clock's owner tells how many motion cycles came late; they are counted and logged, never made up for.
    void countLateCycles(std::uint64_t count);

    /// Addresses, variables, "axis.Feed.position", "axis.1.state", `axis."Long name".velocity`, "plant.Feed.position".
    Result<ValueRef> resolve(std::string_view name) const;
    /// The value at the end of the last scan or motion cycle. A stale reference gives an error.
    Result<Value> read(const ValueRef& ref) const;
    bool isForced(const ValueRef& ref) const;
    std::string unitOf(const ValueRef& ref) const; ///< "mm", "mm/s", "" for memory
    /// Every name that resolves: variables first, then axis values; addresses are not listed.
    std::vector<std::string> names() const;
    std::vector<Terminal> terminals() const;
    std::vector<std::string> forced() const; ///< names of forced values, sorted by address

    /// Replaces a running trace. The channels are resolved now.
    Result<void> startTrace(const TraceSetup& setup);
    void stopTrace();
    /// The oldest block of samples not taken yet. Call until empty.
    std::optional<SampleBlock> takeSamples();

    /// Entries with a sequence number of at least `from`, oldest first, as far as the ring still holds them.
    std::vector<LogEntry> logSince(std::uint64_t from) const;
    std::uint64_t nextLogSequence() const;

    /// The whole state in versioned bytes, image included, trace and log included.
    Bytes saveState() const;
    Result<void> restoreState(ByteSpan state);

    /// Retained data by key (CONTRACTS 13), for whoever keeps it over a loss of power.
    Bytes retained() const;
    Result<void> restoreRetained(ByteSpan retained);

private:
    struct Impl;
    std::unique_ptr<Impl> m_impl;
};

} // namespace camwright
