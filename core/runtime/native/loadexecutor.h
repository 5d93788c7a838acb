#pragma once

#include "core/runtime/executor/executor.h"

#include <optional>
#include <string_view>

namespace camwright {

/// Which of the two runs a program. Both give the same bytes and reports.
enum class ExecutorChoice : std::uint8_t {
    Automatic,   ///< machine code where it can be had, else the interpreter
    Interpreter,
    Native,      ///< as Automatic; for those who look at ScanExecutor::isTranslated() afterwards
};

/// "auto", "interpreter", "native"
std::optional<ExecutorChoice> executorChoiceByName(std::string_view name);

Result<ScanExecutor> loadExecutor(std::shared_ptr<const ControllerImage> image, ExecutorChoice choice = ExecutorChoice::Automatic);

} // namespace camwright
