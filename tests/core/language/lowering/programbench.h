#pragma once

#include "core/language/check/checksources.h"
#include "core/language/lowering/lowerprograms.h"
#include "core/language/lowering/memorylayout.h"
#include "core/runtime/blocks/programblocks.h"
#include "core/runtime/executor/executor.h"

#include <gtest/gtest.h>

#include <map>
#include <memory>
#include <string>

namespace camwright::test {

/// Source text in, program run, numbers out.
class ProgramBench {
public:
    using Programs = std::map<std::string, std::pair<ProgramRole, std::string>>;

    ProgramBench(const char* family, const char* model, const std::string& text, const Programs& others = {})
    {
        ControllerSettings settings;
        settings.family = family;
        settings.model = model;
        add(controllerKey(), settings);
        m_sources["Main"] = {ProgramRole::Main, text};
        m_sources.insert(others.begin(), others.end());
        for (const auto& [name, source] : m_sources)
            add({ObjectKind::Program, name}, Program{source.first, ProgramLanguage::InstructionList, source.second});
        Axis axis;
        add({ObjectKind::Axis, "Feed"}, axis);
    }

    void add(const ObjectKey& key, ObjectContent content)
    {
        m_project = m_project.with(key, std::make_shared<const Object>(Object{key, 0, std::move(content), {}}));
    }

    /// Compiles; the diagnostics as text, empty when there are none.
    std::string build()
    {
        m_context = contextOf(m_project);
        if (!m_context)
            return "error: no family";
        std::vector<ProgramSource> sources{{{ObjectKind::Program, "Main"}, ProgramRole::Main, m_sources["Main"].second}};
        for (const auto& [name, source] : m_sources) {
            if (name != "Main")
                sources.push_back({{ObjectKind::Program, name}, source.first, source.second});
        }
        const CheckedSources checked = checkSources(sources, *m_context);
        std::string out;
        for (const Diagnostic& diagnostic : checked.diagnostics)
            out += englishLine(diagnostic) + "\n";
        if (!checked.programs)
            return out + "not built\n";
        LoweredPrograms lowered = lowerPrograms(*m_context->family, *m_context->model, *checked.programs, Job(), {}, m_context->variableBytes);
        auto image = std::make_shared<ControllerImage>();
        image->target.family = m_context->family->id();
        image->layout = memoryLayout(*m_context->family, *m_context->model, lowered.variableBytes, lowered.program.routines.size());
        image->configuration.interrupts = std::move(lowered.interrupts);
        image->program = std::move(lowered.program);
        image->debug = std::move(lowered.debug);
        m_image = image;
        Result<ScanExecutor> executor = ScanExecutor::load(m_image);
        if (!executor)
            return out + englishText(executor.error());
        m_executor = std::make_unique<ScanExecutor>(std::move(executor).value());
        m_blocks = std::make_unique<ProgramBlocks>(*m_image, m_noMotion);
        return out;
    }

    ScanReport scan(Time after = 1ms)
    {
        m_now += after;
        ScanInput input;
        input.now = m_now;
        input.host = m_host ? m_host : m_blocks.get();
        input.operations = 1'000'000;
        return m_executor->scan(input);
    }

    /// "%M0.0=1 %VW2=-5": writes each.
    void set(const std::string& assignments)
    {
        forEach(assignments, [&](const std::string& name, const std::string& text) {
            const Address address = addressOf(name);
            const Result<Value> value = parseValue(address.type, text);
            ASSERT_TRUE(value.ok()) << name << "=" << text;
            m_executor->memory().write(address, *value);
        });
    }

    /// What of "%M0.0=1 %VW2=-5" is not so; empty when all is.
    std::string differences(const std::string& expected)
    {
        std::string out;
        forEach(expected, [&](const std::string& name, const std::string& text) {
            const Address address = addressOf(name);
            const Value is = m_executor->memory().read(address);
            const Result<Value> value = parseValue(address.type, text);
            if (!value.ok() || !(*value == is))
                out += name + " is " + formatValue(is) + ", not " + text + "; ";
        });
        return out;
    }

    Address addressOf(const std::string& name) const
    {
        // "D100:REAL" takes a place as another type.
        const std::size_t colon = name.find(':');
        Result<Address> address = m_context->family->parseAddress(name.substr(0, colon), *m_context->model);
        EXPECT_TRUE(address.ok()) << name;
        if (!address)
            return {};
        const bool isElement = m_context->family->valueOf(*address).has_value();
        if (colon == std::string::npos)
            return isElement && !address->isBit ? m_context->family->bitOf(*address).value_or(*address) : *address;
        const std::string wanted = name.substr(colon + 1);
        const Address place = isElement ? *m_context->family->valueOf(*address) : *address;
        const Result<Address> typed = m_context->family->withType(place, *dataTypeByName(wanted), *m_context->model);
        EXPECT_TRUE(typed.ok()) << name;
        return typed ? *typed : place;
    }

    ScanExecutor& executor() { return *m_executor; }
    const ControllerImage& image() const { return *m_image; }
    void setHost(BlockHost* host) { m_host = host; }

private:
    template <class Each>
    static void forEach(const std::string& list, Each each)
    {
        std::size_t at = 0;
        while (at < list.size()) {
            const std::size_t end = std::min(list.find(' ', at), list.size());
            const std::string item = list.substr(at, end - at);
            if (const std::size_t equals = item.find('='); equals != std::string::npos)
                each(item.substr(0, equals), item.substr(equals + 1));
            at = end + 1;
        }
    }

    struct NoMotionBlocks : BlockHost {
        void call(InstructionId, const BlockInstance&, PinValues&) override {}
    };

    Project m_project;
    Programs m_sources;
    std::optional<LanguageContext> m_context;
    std::shared_ptr<const ControllerImage> m_image;
    std::unique_ptr<ScanExecutor> m_executor;
    NoMotionBlocks m_noMotion;
    std::unique_ptr<ProgramBlocks> m_blocks;
    BlockHost* m_host = nullptr;
    Time m_now{};
};

/// One row of a table of programs: what is set before the first scan, the scans, and what must come out.
struct ProgramRow {
    const char* what;
    const char* text;
    const char* before;
    int scans;
    const char* after;
};

} // namespace camwright::test
