#include "core/language/check/checksources.h"
#include "core/language/lowering/lowerprograms.h"
#include "core/language/lowering/memorylayout.h"
#include "core/runtime/executor/executor.h"
#include "tests/bench/ilgenerator.h"

#include <benchmark/benchmark.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>

using namespace camwright;

namespace {

constexpr unsigned Rungs = 10000;

/// A KS101M without the limit of its program memory.
LanguageContext bigContext()
{
    static ControllerModel model = [] {
        ControllerModel out = *findFamily("kinco")->findModel("KS101M-04DX");
        out.programInstructionsMax = 0;
        return out;
    }();
    LanguageContext context;
    context.family = findFamily("kinco");
    context.model = &model;
    context.dialect = dialectOfFamily("kinco");
    context.programs.push_back({"Main", ProgramRole::Main});
    context.index();
    return context;
}

ControllerImage compileText(const std::string& text, const LanguageContext& context)
{
    const ProgramSource source{{ObjectKind::Program, "Main"}, ProgramRole::Main, text};
    const CheckedSources checked = checkSources({&source, 1}, context);
    if (!checked.programs) {
        for (const Diagnostic& diagnostic : checked.diagnostics)
            std::fputs((englishLine(diagnostic) + "\n").c_str(), stderr);
        std::abort();
    }
    LoweredPrograms lowered = lowerPrograms(*context.family, *context.model, *checked.programs, Job(), {}, context.variableBytes);
    ControllerImage image;
    image.layout = memoryLayout(*context.family, *context.model, lowered.variableBytes, 1);
    image.program = std::move(lowered.program);
    image.debug = std::move(lowered.debug);
    return image;
}

void compile(benchmark::State& state)
{
    const std::string text = bench::generateIl(Rungs);
    const LanguageContext context = bigContext();
    for (auto _ : state)
        benchmark::DoNotOptimize(write(compileText(text, context)));
    state.counters["rungs"] = Rungs;
}

void check(benchmark::State& state)
{
    const std::string text = bench::generateIl(static_cast<unsigned>(state.range(0)));
    const LanguageContext context = bigContext();
    for (auto _ : state)
        benchmark::DoNotOptimize(checkSource({{ObjectKind::Program, "Main"}, ProgramRole::Main, text}, context));
}

void readAndLoad(benchmark::State& state)
{
    const Bytes bytes = write(compileText(bench::generateIl(Rungs), bigContext()));
    for (auto _ : state)
        benchmark::DoNotOptimize(ScanExecutor::load(std::make_shared<const ControllerImage>(readImage(bytes).value())));
    state.counters["imageKB"] = static_cast<double>(bytes.size()) / 1024;
}

void scan(benchmark::State& state)
{
    auto image = std::make_shared<const ControllerImage>(compileText(bench::generateIl(Rungs), bigContext()));
    ScanExecutor executor = ScanExecutor::load(image).value();
    executor.memory().write(bitAddress(5, 0), Value::ofBool(true));
    for (auto _ : state)
        benchmark::DoNotOptimize(executor.scan({}));
    state.counters["ns/rung"] = benchmark::Counter(Rungs * 1e-9, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

/// What cannot be beaten by any interpreter: the same mix of work in one loop whose operations are known beforehand.
void plainLoop(benchmark::State& state)
{
    bench::Sequence random;
    std::vector<std::uint8_t> memory(16384);
    std::vector<std::uint32_t> places(Rungs * 5);
    for (std::uint32_t& place : places)
        place = random.next(4000) * 4;
    for (auto _ : state) {
        for (unsigned r = 0; r < Rungs; ++r) {
            const std::uint32_t* p = &places[std::size_t{5} * r];
            if (r % 20 < 13) {
                const std::uint8_t result = (memory[p[0]] & ~memory[p[1]] & memory[p[2]]) | memory[p[3]];
                memory[p[4]] = result & 1;
            } else {
                std::uint32_t a, b;
                std::memcpy(&a, &memory[p[0]], 4);
                std::memcpy(&b, &memory[p[1]], 4);
                a += b;
                std::memcpy(&memory[p[2]], &a, 4);
            }
        }
        benchmark::ClobberMemory();
    }
    state.counters["ns/rung"] = benchmark::Counter(Rungs * 1e-9, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

BENCHMARK(compile)->Unit(benchmark::kMillisecond);
BENCHMARK(check)->Arg(200)->Arg(2000)->Arg(Rungs)->Unit(benchmark::kMillisecond);
BENCHMARK(readAndLoad)->Unit(benchmark::kMillisecond);
BENCHMARK(scan)->Unit(benchmark::kMicrosecond);
BENCHMARK(plainLoop)->Unit(benchmark::kMicrosecond);

} // namespace

BENCHMARK_MAIN();
