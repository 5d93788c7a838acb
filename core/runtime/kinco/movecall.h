#pragma once

#include "core/runtime/kinco/motioncall.h"

namespace camwright::kinco {

/// Positioning: speed is looked at all the time, 0 pauses (KS-MC-19, -20); so does EXEC going to 0, a new edge goes on.
class MoveCall : public MotionCall {
public:
    using MotionCall::MotionCall;

protected:
    /// Sends target and speed if they differ from what was sent.
    void command(std::int32_t target, float velocity);
    /// True while paused or ended by an illegal speed.
    bool rests(CallContext& context);
    void saveMore(ByteWriter& writer) const override;
    void restoreMore(ByteReader& reader) override;
    void forgetCommand() { m_sent = false; }

private:
    bool m_sent = false;
    std::int32_t m_target = 0;
    std::uint32_t m_speed = 0;
};

/// MC_MABS. MODE 0 ends at the target; MODE 1 stays and follows every new POS, DONE showing that it stands there (ours).
class AbsoluteCall final : public MoveCall {
public:
    using MoveCall::MoveCall;

private:
    void begin(CallContext& context) override;
    void again(CallContext& context) override { m_mode = context.inputs.mode; }
    void move(CallContext& context) override;
    void saveMore(ByteWriter& writer) const override;
    void restoreMore(ByteReader& reader) override;

    std::int16_t m_mode = 0;
};

/// MC_MREL. The distance counts from where the axis stands when the instruction starts; a paused one goes on to the target
/// it had.
class RelativeCall final : public MoveCall {
public:
    using MoveCall::MoveCall;

private:
    void begin(CallContext& context) override;
    void move(CallContext& context) override;
    void saveMore(ByteWriter& writer) const override;
    void restoreMore(ByteReader& reader) override;

    float m_distance = 0;
    bool m_known = false;          ///< the target has been computed
    std::int32_t m_target = 0;
};

} // namespace camwright::kinco
