#pragma once

#include "core/runtime/kinco/motioncall.h"

namespace camwright::kinco {

/// MC_JOG: turns with the signed VEL, looked at all the time, until EXEC falls; the axis stays locked (KS-MC-20).
class JogCall final : public MotionCall {
public:
    using MotionCall::MotionCall;

private:
    void begin(CallContext& context) override;
    void move(CallContext& context) override;
};

} // namespace camwright::kinco
