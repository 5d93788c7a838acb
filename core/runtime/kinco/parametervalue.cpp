#include "core/runtime/kinco/parametervalue.h"

#include <bit>
#include <cmath>

namespace camwright::kinco {

namespace {

DataType objectType(const DriveParameter& parameter)
{
    switch (parameter.objectBits) {
    case 8: return parameter.minimum < 0 ? DataType::Sint : DataType::Usint;
    case 16: return parameter.minimum < 0 ? DataType::Int : DataType::Uint;
    default: return parameter.minimum < 0 ? DataType::Dint : DataType::Udint;
    }
}

} // namespace

const DriveParameter* parameterOf(unsigned number)
{
    static const std::span<const DriveParameter> parameters = findFamily("kinco")->driveParameters();
    return number < parameters.size() ? &parameters[number] : nullptr;
}

std::optional<std::int64_t> driveValueOf(const DriveParameter& parameter, const AxisScale& scale, std::uint32_t cell)
{
    if (parameter.onlyValue)
        return cell == *parameter.onlyValue ? std::optional<std::int64_t>(cell) : std::nullopt;
    std::int64_t value = parameter.isSigned ? static_cast<std::int32_t>(cell) : static_cast<std::int64_t>(cell);
    if (parameter.isReal) {
        const float real = std::bit_cast<float>(cell);
        if (!std::isfinite(real))
            return std::nullopt;
        value = processToDrive(kincoParameterQuantity(parameter.number), real, scale);
    }
    if (value < parameter.minimum || value > parameter.maximum)
        return std::nullopt;
    return value;
}

std::optional<std::uint32_t> cellOf(const DriveParameter& parameter, const AxisScale& scale, const SdoResult& result)
{
    std::int64_t value = 0;
    if (!result.number(objectType(parameter), value))
        return std::nullopt;
    if (!parameter.isReal)
        return static_cast<std::uint32_t>(value);
    const double process = driveToProcess(kincoParameterQuantity(parameter.number), static_cast<double>(value), scale);
    return std::bit_cast<std::uint32_t>(static_cast<float>(process));
}

} // namespace camwright::kinco
