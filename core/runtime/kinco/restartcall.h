#pragma once

#include "core/runtime/kinco/call.h"

namespace camwright::kinco {

/// MC_RESTART: pre-operational, guarding, PDO mapping, PDO communication, start, for one node while the others run
/// (KS-MC-21). Its ERRID is a table of its own. A motion running on the axis ends with ERRID 1.
class RestartCall final : public Call {
public:
    using Call::Call;

private:
    void begin(CallContext& context) override;
    void proceed(CallContext& context) override;
    void dropped() override;
    void end(RestartError error) { finish(static_cast<std::uint32_t>(error)); }
};

} // namespace camwright::kinco
