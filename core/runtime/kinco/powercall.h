#pragma once

#include "core/runtime/kinco/call.h"

namespace camwright::kinco {

/// MC_POWER: the rising edge of EXEC locks the axis, the falling edge releases it, each supervised for 5 s (KS-MC-16). The
/// release works whoever runs; locking does not interrupt a running instruction.
class PowerCall final : public Call {
public:
    using Call::Call;

private:
    void begin(CallContext& context) override;
    void proceed(CallContext& context) override;
    void saveMore(ByteWriter& writer) const override { writer.put(m_lock); }
    void restoreMore(ByteReader& reader) override { m_lock = reader.getBool(); }

    bool m_lock = false;
};

} // namespace camwright::kinco
