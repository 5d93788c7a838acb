#include "core/language/check/checksources.h"
#include "core/language/lowering/lowerprograms.h"
#include "core/language/lowering/memorylayout.h"
#include "core/runtime/native/loadexecutor.h"
#include "core/runtime/native/nativeprogram.h"
#include "tests/bench/cprogram.h"
#include "tests/bench/ilgenerator.h"

#include <benchmark/benchmark.h>

#include <cstring>
#include <map>

using namespace camwright;

// The same generated program in the interpreter, in machine code, and in C by gcc -O2, in one run.

namespace {

ControllerImage compileText(const std::string& text)
{
    static ControllerModel model = [] { // without the limit of its program memory
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
    const ProgramSource source{{ObjectKind::Program, "Main"}, ProgramRole::Main, text};
    const CheckedSources checked = checkSources({&source, 1}, context);
    LoweredPrograms lowered = lowerPrograms(*context.family, model, *checked.programs, Job());
    ControllerImage image;
    image.target = {"kinco", "KS101M-04DX", {}};
    image.layout = memoryLayout(*context.family, model, 0, 1);
    image.program = std::move(lowered.program);
    return image;
}

const std::shared_ptr<const ControllerImage>& imageOf(unsigned rungs)
{
    static std::map<unsigned, std::shared_ptr<const ControllerImage>> images;
    auto& image = images[rungs];
    if (!image)
        image = std::make_shared<const ControllerImage>(compileText(bench::generateIl(rungs)));
    return image;
}

/// Bits and numbers that make rungs differ, the same for everybody; %SM0.0 is on.
void prepare(Memory& memory)
{
    bench::Sequence random;
    for (const ImageArea& area : imageOf(1000)->layout.areas) {
        for (std::uint8_t& byte : memory.area(area.id))
            byte = static_cast<std::uint8_t>(random.next(64));
    }
    memory.write(bitAddress(5, 0), Value::ofBool(true));
}

void perRung(benchmark::State& state)
{
    state.counters["ns/rung"] = benchmark::Counter(static_cast<double>(state.range(0)) * 1e-9,
                                                   benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void scanWith(benchmark::State& state, ExecutorChoice choice)
{
    ScanExecutor executor = loadExecutor(imageOf(static_cast<unsigned>(state.range(0))), choice).value();
    prepare(executor.memory());
    for (auto _ : state)
        benchmark::DoNotOptimize(executor.scan({}));
    perRung(state);
}

void scanInterpreter(benchmark::State& state) { scanWith(state, ExecutorChoice::Interpreter); }
void scanNative(benchmark::State& state) { scanWith(state, ExecutorChoice::Native); }

/// The C does what the machine code does.
bool agree(const std::shared_ptr<const ControllerImage>& image)
{
    ScanExecutor native = loadExecutor(image, ExecutorChoice::Native).value();
    ScanExecutor plain = loadExecutor(image, ExecutorChoice::Interpreter).value();
    const bench::CProgram::Scan scan = bench::CProgram::compile(*image, plain.memory(), true);
    prepare(native.memory());
    prepare(plain.memory());
    for (int k = 0; scan && k < 10; ++k) {
        native.scan({});
        scan(plain.memory().data());
    }
    return scan && std::memcmp(native.memory().data(), plain.memory().data(), plain.memory().stateOffset()) == 0;
}

void scanGcc(benchmark::State& state)
{
    const auto& image = imageOf(static_cast<unsigned>(state.range(0)));
    static const bool isSame = agree(imageOf(1000));
    if (!isSame)
        return state.SkipWithError("gcc is not there, or its code does something else");
    ScanExecutor executor = loadExecutor(image, ExecutorChoice::Interpreter).value();
    static std::map<std::int64_t, bench::CProgram::Scan> compiled;
    if (!compiled.contains(state.range(0)))
        compiled[state.range(0)] = bench::CProgram::compile(*image, executor.memory(), false);
    const bench::CProgram::Scan scan = compiled[state.range(0)];
    prepare(executor.memory());
    for (auto _ : state)
        scan(executor.memory().data());
    perRung(state);
}

void load(benchmark::State& state, Translate translate)
{
    const auto& image = imageOf(static_cast<unsigned>(state.range(0)));
    for (auto _ : state)
        benchmark::DoNotOptimize(ScanExecutor::load(image, translate));
    perRung(state);
}

/// Verification and memory included.
void loadInterpreter(benchmark::State& state) { load(state, nullptr); }
void loadNative(benchmark::State& state) { load(state, translateToNative); }

BENCHMARK(loadInterpreter)->Arg(1000)->Arg(10000)->Arg(100000)->Unit(benchmark::kMillisecond);
BENCHMARK(loadNative)->Arg(1000)->Arg(10000)->Arg(100000)->Unit(benchmark::kMillisecond);
BENCHMARK(scanInterpreter)->Arg(1000)->Arg(10000)->Arg(100000)->Unit(benchmark::kMicrosecond);
BENCHMARK(scanNative)->Arg(1000)->Arg(10000)->Arg(100000)->Unit(benchmark::kMicrosecond);
BENCHMARK(scanGcc)->Arg(1000)->Arg(10000)->Arg(100000)->Unit(benchmark::kMicrosecond);

} // namespace

BENCHMARK_MAIN();
