#pragma once

#include "core/runtime/kinco/call.h"

namespace camwright::kinco {

/// What MC_HOME, MC_MABS, MC_MREL and MC_JOG have in common: they need a locked axis (KS-MC-04), own it while they run, end
/// with an error when it is lost, alarmed, released or stopped from outside, and on EN = 0 stop it and end when it stands,
/// locked (KS-MC-18 … 20).
class MotionCall : public Call {
public:
    using Call::Call;

protected:
    /// Moves; called each cycle while nothing is wrong and the call is not ending.
    virtual void move(CallContext& context) = 0;

    /// A new edge of EXEC while the axis is paused or moves.
    virtual void again(CallContext&) {}

    /// Checks and claims the axis; false if the execution has ended. `wrong`: an input that C28 refuses.
    bool take(CallContext& context, bool wrong, AxisState state);
    /// Brings the axis to rest; the execution ends then, with this ERRID.
    void stopAndFinish(ErrorId error);
    /// Halts or resumes as `pause` says (KS-MC-18, -19).
    void setPaused(bool pause);
    bool isPaused() const { return m_paused; }

    void saveMore(ByteWriter& writer) const override;
    void restoreMore(ByteReader& reader) override;

private:
    void proceed(CallContext& context) final;
    void beginAgain(CallContext& context) final;
    bool isLost();

    bool m_paused = false;
    bool m_ending = false;
    ErrorId m_ends = ErrorId::None;
    std::uint32_t m_stops = 0;
};

} // namespace camwright::kinco
