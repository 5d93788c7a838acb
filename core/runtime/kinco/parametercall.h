#pragma once

#include "core/runtime/kinco/call.h"

namespace camwright::kinco {

/// MC_RPARAS and MC_WPARAS: NUM drive parameters, one SDO transfer after the other; what fails sets its bit of ERRID, the rest
/// goes on (KS-MC-11 … 15).
class ParameterCall : public Call {
public:
    using Call::Call;

protected:
    /// Whether EXEC (read) or EN (write) wants it to go on.
    virtual bool goesOn(const CallInputs& inputs) const = 0;
    /// Starts the transfer of entry m_entry; false: it failed without one.
    virtual bool transfer(CallContext& context, unsigned number) = 0;
    /// Takes what came back.
    virtual bool accept(CallContext& context, unsigned number, const SdoResult& result) = 0;

    void setTransfer(CanopenMaster::SdoHandle handle) { m_transfer = handle; }
    unsigned entry() const { return m_entry; }

private:
    void begin(CallContext& context) final;
    void proceed(CallContext& context) final;
    void dropped() final;
    void fail() { m_failed |= 1u << m_entry; }
    void next(CallContext& context);
    void end();
    void saveMore(ByteWriter& writer) const final;
    void restoreMore(ByteReader& reader) final;

    CanopenMaster::SdoHandle m_transfer = 0;
    std::uint8_t m_entry = 0;
    std::uint8_t m_count = 0;
    std::uint32_t m_failed = 0;
};

class ReadParametersCall final : public ParameterCall {
public:
    using ParameterCall::ParameterCall;

private:
    bool goesOn(const CallInputs& inputs) const override { return inputs.exec; }
    bool transfer(CallContext& context, unsigned number) override;
    bool accept(CallContext& context, unsigned number, const SdoResult& result) override;
};

class WriteParametersCall final : public ParameterCall {
public:
    using ParameterCall::ParameterCall;

private:
    bool goesOn(const CallInputs& inputs) const override { return inputs.enabled; }
    bool transfer(CallContext& context, unsigned number) override;
    bool accept(CallContext& context, unsigned number, const SdoResult& result) override;
};

} // namespace camwright::kinco
