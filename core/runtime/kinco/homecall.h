#pragma once

#include "core/runtime/kinco/motioncall.h"

namespace camwright::kinco {

/// MC_HOME: writes POS as the drive's home offset (0x607C) by SDO, then homes by the drive's own method and speeds, within
/// TIME ms (KS-MC-18). A paused homing starts over, its time too (ours); TIME 0 supervises nothing (ours).
class HomeCall final : public MotionCall {
public:
    using MotionCall::MotionCall;

private:
    void begin(CallContext& context) override;
    void again(CallContext& context) override { restartClock(context.now); }
    void move(CallContext& context) override;
    void dropped() override;
    void saveMore(ByteWriter& writer) const override;
    void restoreMore(ByteReader& reader) override;

    CanopenMaster::SdoHandle m_transfer = 0;
    std::uint32_t m_timeMs = 0;
};

} // namespace camwright::kinco
