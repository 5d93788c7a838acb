#pragma once

#include "core/language/st/check/checker.h"
#include "core/language/st/lowering/lowerst.h"
#include "core/runtime/executor/executor.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>

namespace camwright::test {

/// A text in ST from source to numbers: checked, lowered, sent through the bytes of an image, and run.
class StBench {
public:
    explicit StBench(std::string text) : m_text(std::move(text))
    {
        st::Environment environment;
        m_compilation = st::check({{{ObjectKind::Program, "Main"}, m_text, true}}, environment);
        if (m_compilation->hasErrors())
            return;
        LoweredPrograms lowered;
        st::lowerSt(*m_compilation, nullptr, [](std::string_view) { return 0u; }, lowered);
        ControllerImage image;
        image.target = {"kinco", "KS101M-04DX", {}};
        image.layout.areas.push_back({VariablesArea, "", m_compilation->variableBytes + 8, 0, 0});
        for (const st::StartValue& start : m_compilation->startValues) {
            const bool isBool = start.value.type == DataType::Bool;
            image.layout.initialValues.push_back({isBool ? bitAddress(VariablesArea, start.offset) : valueAddress(VariablesArea, start.offset, start.value.type), start.value});
        }
        image.program = std::move(lowered.program);
        image.debug = std::move(lowered.debug);
        const auto read = readImage(write(image));
        EXPECT_TRUE(read.ok()) << englishText(read.error());
        if (!read.ok())
            return;
        auto executor = ScanExecutor::load(std::make_shared<const ControllerImage>(*read));
        EXPECT_TRUE(executor.ok());
        if (executor.ok())
            m_executor = std::make_unique<ScanExecutor>(std::move(*executor));
    }

    bool runs() const { return m_executor != nullptr; }
    const Diagnostics& diagnostics() const { return m_compilation->diagnostics[0]; }
    std::string messages() const
    {
        std::string out;
        for (const Diagnostics& list : m_compilation->diagnostics) {
            for (const Diagnostic& d : list)
                out += std::to_string(d.place.range.line) + ":" + std::to_string(d.place.range.column) + " " + englishLine(d) + "\n";
        }
        return out;
    }

    /// One scan; the controller's time goes on by 1 ms with each.
    ScanReport scan(unsigned times = 1)
    {
        ScanReport report;
        for (unsigned i = 0; i < times; ++i) {
            ScanInput input;
            input.now = m_now;
            input.operations = 50'000'000;
            report = m_executor->scan(input);
            m_now += 1ms;
        }
        return report;
    }

    /// A variable of the program.
    Value value(std::string_view name) const
    {
        for (const st::PouInfo& pou : m_compilation->pous) {
            if (pou.tree->kind != st::PouKind::Program)
                continue;
            for (const st::Symbol* symbol : pou.variables) {
                if (st::isSameName(m_compilation->names.text(symbol->name), name))
                    return read(*symbol);
            }
        }
        for (const st::Symbol* symbol : m_compilation->globals) {
            if (st::isSameName(m_compilation->names.text(symbol->name), name))
                return read(*symbol);
        }
        ADD_FAILURE() << "no variable " << name;
        return {};
    }
    std::int64_t integer(std::string_view name) const { return value(name).asInteger(); }
    double real(std::string_view name) const { return value(name).asDouble(); }
    const ScanExecutor& executor() const { return *m_executor; }

private:
    Value read(const st::Symbol& symbol) const
    {
        const DataType type = symbol.type->data;
        const bool isBool = type == DataType::Bool;
        if (!m_executor)
            return {};
        return m_executor->memory().read(isBool ? bitAddress(VariablesArea, symbol.offset) : valueAddress(VariablesArea, symbol.offset, type));
    }

    std::string m_text;
    std::unique_ptr<st::Compilation> m_compilation;
    std::unique_ptr<ScanExecutor> m_executor;
    Time m_now{};
};

/// The declarations and statements of a program, run once.
inline StBench runOnce(const std::string& declarations, const std::string& statements)
{
    StBench bench("PROGRAM Main\nVAR\n" + declarations + "\nEND_VAR\n" + statements + "\nEND_PROGRAM\n");
    EXPECT_TRUE(bench.runs()) << bench.messages();
    if (bench.runs())
        bench.scan();
    return bench;
}

} // namespace camwright::test
