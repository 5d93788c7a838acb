#pragma once

#include "core/runtime/kinco/call.h"

namespace camwright::kinco {

/// MC_RESET: clears the drive's alarm within 2 s (KS-MC-17). After success the axis is released and MC_POWER needs a new
/// edge (KS-MC-05; the choice KS-MC-28 leaves open). Outputs of other calls stay as they are.
class ResetCall final : public Call {
public:
    using Call::Call;

private:
    void begin(CallContext& context) override;
    void proceed(CallContext& context) override;
    void dropped() override { axis().endReset(false); }
};

} // namespace camwright::kinco
