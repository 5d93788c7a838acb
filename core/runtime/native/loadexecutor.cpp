#include "core/runtime/native/loadexecutor.h"

#include "core/runtime/native/nativeprogram.h"

namespace camwright {

std::optional<ExecutorChoice> executorChoiceByName(std::string_view name)
{
    if (name == "auto")
        return ExecutorChoice::Automatic;
    if (name == "interpreter")
        return ExecutorChoice::Interpreter;
    if (name == "native")
        return ExecutorChoice::Native;
    return std::nullopt;
}

Result<ScanExecutor> loadExecutor(std::shared_ptr<const ControllerImage> image, ExecutorChoice choice)
{
    return ScanExecutor::load(std::move(image), choice == ExecutorChoice::Interpreter ? nullptr : translateToNative);
}

} // namespace camwright
