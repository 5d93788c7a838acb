#include "core/runtime/kinco/parametercall.h"

#include "core/runtime/kinco/parametervalue.h"

namespace camwright::kinco {

void ParameterCall::begin(CallContext& context)
{
    m_transfer = 0;
    m_entry = 0;
    m_failed = 0;
    Axis* const target = axisOf(context);
    const int count = context.inputs.count;
    if (!target || !target->isOnline() || count < 1 || count > static_cast<int>(kMaxParameters))
        return finish(kNothingExecuted);
    use(*target);
    if (!axis().claim(self()))
        return finish(kNothingExecuted);
    m_count = static_cast<std::uint8_t>(count);
    next(context);
}

void ParameterCall::proceed(CallContext& context)
{
    if (!axis().isOnline()) {
        dropped();
        m_failed |= ~0u << m_entry;
        return end();
    }
    if (!goesOn(context.inputs)) {
        dropped();
        return end();
    }
    const SdoResult result = axis().master().takeSdo(m_transfer);
    if (result.status == SdoStatus::Pending)
        return;
    m_transfer = 0;
    const unsigned number = context.commanded->numbers[m_entry];
    if (result.status != SdoStatus::Done || !accept(context, number, result))
        fail();
    ++m_entry;
    next(context);
}

/// Starts the next transfer that can start; without one the call has ended.
void ParameterCall::next(CallContext& context)
{
    for (; m_entry < m_count; ++m_entry) {
        if (transfer(context, context.commanded->numbers[m_entry]))
            return;
        fail();
    }
    end();
}

void ParameterCall::end()
{
    const std::uint32_t listed = m_count == kMaxParameters ? ~0u : (1u << m_count) - 1;
    finish(m_failed & listed);
}

void ParameterCall::dropped()
{
    if (m_transfer)
        axis().master().cancelSdo(m_transfer);
    m_transfer = 0;
}

void ParameterCall::saveMore(ByteWriter& writer) const
{
    writer.put(m_transfer);
    writer.put(m_entry);
    writer.put(m_count);
    writer.put(m_failed);
}

void ParameterCall::restoreMore(ByteReader& reader)
{
    m_transfer = reader.get<CanopenMaster::SdoHandle>();
    m_entry = reader.get<std::uint8_t>();
    m_count = reader.get<std::uint8_t>();
    m_failed = reader.get<std::uint32_t>();
    if (m_count > kMaxParameters || m_entry > m_count)
        reader.fail();
}

bool ReadParametersCall::transfer(CallContext& context, unsigned number)
{
    const DriveParameter* const parameter = parameterOf(number);
    if (!parameter)
        return false;
    setTransfer(axis().master().readSdo(axis().node(), {parameter->index, parameter->subindex}, context.now));
    return true;
}

bool ReadParametersCall::accept(CallContext& context, unsigned number, const SdoResult& result)
{
    const auto cell = cellOf(*parameterOf(number), axis().scale(), result);
    if (!cell)
        return false;
    context.reported->values[entry()] = *cell;
    output().valid |= 1u << entry();
    return true;
}

bool WriteParametersCall::transfer(CallContext& context, unsigned number)
{
    const DriveParameter* const parameter = parameterOf(number);
    if (!parameter)
        return false;
    const auto value = driveValueOf(*parameter, axis().scale(), context.commanded->values[entry()]);
    if (!value)
        return false;
    const ObjectId object{parameter->index, parameter->subindex};
    setTransfer(axis().master().writeSdo(axis().node(), object, *value, parameter->objectBits / 8u, context.now));
    return true;
}

bool WriteParametersCall::accept(CallContext&, unsigned, const SdoResult&)
{
    return true;
}

} // namespace camwright::kinco
