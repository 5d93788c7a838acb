#pragma once

#include "core/base/bytes.h"
#include "core/base/time.h"
#include "core/runtime/kinco/axis.h"
#include "core/runtime/kinco/callsite.h"
#include "core/runtime/kinco/exchange.h"

#include <deque>
#include <memory>

namespace camwright::kinco {

/// The axes of the network, by number - 1.
using Axes = std::deque<Axis>;

/// What a call sees of one motion cycle.
struct CallContext {
    const CallInputs& inputs;
    ParameterList* commanded = nullptr; ///< the list as it stood at the edge; null for calls without one
    ParameterList* reported = nullptr;
    Axes& axes;
    Time now{};
};

/// The motion task's half of one triggered MC_* call. An execution begins with an edge and ends by finish(); between them
/// proceed() runs each motion cycle. One class per instruction family.
class Call {
public:
    explicit Call(Axis::Owner self) : m_self(self) {}
    virtual ~Call() = default;
    Call(const Call&) = delete;
    Call& operator=(const Call&) = delete;

    void cycle(CallContext& context);
    /// The program has stopped: the call lets its axis go without a word, and takes `execution` for answered.
    void abandon(std::uint32_t execution);
    const CallResult& result() const { return m_result; }
    bool isRunning() const { return m_running; }

    void save(ByteWriter& writer) const;
    void restore(ByteReader& reader, Axes& axes);

protected:
    /// The edge. finish() here ends the execution at once.
    virtual void begin(CallContext& context) = 0;
    virtual void proceed(CallContext& context) = 0;
    /// A new edge while the call runs; by default the old execution is dropped and a new one begins.
    virtual void beginAgain(CallContext& context);
    virtual void dropped() {} ///< the execution ends without finish(): give back what was taken

    virtual void saveMore(ByteWriter&) const {}
    virtual void restoreMore(ByteReader&) {}

    /// The configured axis of the AXIS pin, online or not; null for a wrong number.
    Axis* axisOf(CallContext& context) const;
    void use(Axis& axis) { m_axis = &axis; }
    Axis& axis() { return *m_axis; }
    Axis::Owner self() const { return m_self; }
    Time since() const { return m_since; }
    void restartClock(Time now) { m_since = now; }

    void finish(std::uint32_t errorId = 0);
    void finish(ErrorId error) { finish(static_cast<std::uint32_t>(error)); }
    CallResult& output() { return m_result; }

private:
    Axis::Owner m_self;
    Axis* m_axis = nullptr;
    bool m_running = false;
    Time m_since{};
    CallResult m_result;
};

/// The call for a site; null where the instruction has no motion half.
std::unique_ptr<Call> makeCall(const CallSite& site, Axis::Owner self);

/// How an SDO transfer's end reads as an ERRID (KS-MC-10). Not for Pending.
ErrorId errorOf(SdoStatus status);

} // namespace camwright::kinco
