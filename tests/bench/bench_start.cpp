// Start to idle of the window beside a bare QMainWindow: whole processes, from spawn to exit, offscreen.
// build/release/bin/bench_start (the goals: under 1 s, and at most 3 times the bare window to the first paint).
#include <benchmark/benchmark.h>

#include <cstdlib>
#include <filesystem>
#include <spawn.h>
#include <string>
#include <sys/wait.h>
#include <vector>

extern char** environ;

namespace {

std::string beside(const char* program)
{
    return (std::filesystem::read_symlink("/proc/self/exe").parent_path() / program).string();
}

void run(benchmark::State& state, std::vector<std::string> words)
{
    std::vector<char*> arguments;
    for (std::string& word : words)
        arguments.push_back(word.data());
    arguments.push_back(nullptr);
    for (auto _ : state) {
        pid_t child = 0;
        int status = 0;
        if (posix_spawn(&child, arguments[0], nullptr, nullptr, arguments.data(), environ) != 0 || waitpid(child, &status, 0) != child || status != 0) {
            state.SkipWithError("the program did not start or did not end well");
            return;
        }
    }
}

void startPage(benchmark::State& state)
{
    run(state, {beside("camwright"), "--until-idle"});
}

void exampleProject(benchmark::State& state)
{
    run(state, {beside("camwright"), "--until-idle", CAMWRIGHT_SOURCE_DIR "/examples/kinco-feeder"});
}

void bareWindow(benchmark::State& state)
{
    run(state, {beside("bench_barewindow")});
}

} // namespace

BENCHMARK(bareWindow)->UseRealTime()->Unit(benchmark::kMillisecond)->Iterations(10);
BENCHMARK(startPage)->UseRealTime()->Unit(benchmark::kMillisecond)->Iterations(10);
BENCHMARK(exampleProject)->UseRealTime()->Unit(benchmark::kMillisecond)->Iterations(10);

int main(int argc, char** argv)
{
    setenv("QT_QPA_PLATFORM", "offscreen", 0);
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
