#pragma once

#include "core/runtime/native/loadexecutor.h"

#include <algorithm>
#include <optional>
#include <string>

namespace camwright::test {

/// Writes down how it is called, and leaves something at its output pins.
class RecordingHost : public BlockHost {
public:
    void call(InstructionId instruction, const BlockInstance& instance, PinValues& pins) override
    {
        m_calls += std::to_string(static_cast<unsigned>(instruction)) + (instance.enabled ? "+" : "-") + std::to_string(instance.now.count());
        for (std::size_t pin = 0; pin < pins.count(); ++pin)
            m_calls += "," + std::to_string(pins.read(pin).bits);
        for (std::size_t pin = 0; pin < pins.count(); ++pin) {
            const Value value = pins.read(pin);
            if (!pins.isConstant(pin) && pin % 2 == instance.enabled)
                pins.write(pin, Value{value.type, value.type == DataType::Bool ? value.bits ^ 1 : value.bits + 0x101});
        }
    }
    const std::string& calls() const { return m_calls; }

private:
    std::string m_calls;
};

/// One image in the interpreter and in machine code, side by side.
class BothExecutors {
public:
    explicit BothExecutors(std::shared_ptr<const ControllerImage> image)
        : m_interpreter(loadExecutor(image, ExecutorChoice::Interpreter).value()), m_native(loadExecutor(image, ExecutorChoice::Native).value())
    {
    }

    bool isNative() const { return m_native.isTranslated(); }

    /// Does the same to the memory of both.
    template <class Function>
    void change(Function function)
    {
        function(m_interpreter.memory());
        function(m_native.memory());
    }

    /// Scans both; tells the first difference.
    std::optional<std::string> scan(ScanInput input)
    {
        return run(input, [](ScanExecutor& executor, const ScanInput& in) { return executor.scan(in); });
    }
    std::optional<std::string> run(std::uint32_t routine, ScanInput input)
    {
        return run(input, [routine](ScanExecutor& executor, const ScanInput& in) { return executor.run(routine, in); });
    }

    ScanExecutor& interpreter() { return m_interpreter; }
    const ScanReport& report() const { return m_report; }

private:
    template <class Function>
    std::optional<std::string> run(ScanInput input, Function function)
    {
        input.host = &m_hostOfInterpreter;
        m_report = function(m_interpreter, input);
        input.host = &m_hostOfNative;
        return difference(m_report, function(m_native, input));
    }

    std::optional<std::string> difference(const ScanReport& a, const ScanReport& b) const
    {
        const auto compared = [](const char* what, auto x, auto y) {
            return std::string(what) + " " + std::to_string(static_cast<std::uint64_t>(x)) + " / " + std::to_string(static_cast<std::uint64_t>(y));
        };
        if (a.end != b.end)
            return compared("end", a.end, b.end);
        if (a.operations != b.operations)
            return compared("operations", a.operations, b.operations);
        if (a.faults != b.faults)
            return compared("faults", a.faults, b.faults);
        if (a.routine != b.routine || a.instruction != b.instruction)
            return compared("routine", a.routine, b.routine) + compared(", instruction", a.instruction, b.instruction);
        if (m_hostOfInterpreter.calls() != m_hostOfNative.calls())
            return "blocks " + m_hostOfInterpreter.calls() + " / " + m_hostOfNative.calls();
        const Memory& x = m_interpreter.memory();
        const Memory& y = m_native.memory();
        for (std::uint32_t k = 0; k < x.scratchOffset(); ++k) {
            if (x.data()[k] != y.data()[k])
                return compared("byte", k, k) + compared(":", x.data()[k], y.data()[k]);
        }
        return std::nullopt;
    }

    ScanExecutor m_interpreter;
    ScanExecutor m_native;
    RecordingHost m_hostOfInterpreter;
    RecordingHost m_hostOfNative;
    ScanReport m_report;
};

} // namespace camwright::test
