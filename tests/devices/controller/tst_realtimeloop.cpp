#include "devices/controller/realtimeloop.h"
#include "devices/controller/taskthread.h"
#include "tests/devices/controller/hostfixture.h"

#include <gtest/gtest.h>

#include <future>

using namespace camwright;

namespace {

std::uint64_t cyclesDone(ControllerHost& host, std::optional<ControllerStatus>& out, HostListener& listener)
{
    (void)listener;
    host.deliver();
    return out ? out->cycle : 0;
}

/// Keeps the newest status; deliver() is called by the test's thread, as a server would.
class StatusKeeper final : public HostListener {
public:
    std::optional<ControllerStatus> newest;
    void onStatus(const ControllerStatus& status, ClientId) override { newest = status; }
    void onUpdate(ClientId, const message::Update&) override {}
    void onSamples(ClientId, SampleBlock) override {}
    void onBeat(ClientId, std::uint64_t) override {}
    void onLog(const LogEntry&) override {}
};

struct Rig {
    MemoryFileSystem files;
    TaskThread background;
    ControllerHost host{HostOptions{}, files, background};
    StatusKeeper keeper;
    ManualClock clock;
    RealTimeLoop loop{host, clock};

    Rig() { host.setListener(&keeper); }
    ~Rig()
    {
        loop.stop();
        host.setListener(nullptr);
    }
    std::uint64_t cycle() { return cyclesDone(host, keeper.newest, keeper); }
};

TEST(RealTimeLoopTest, oneCycleAMillisecond)
{
    Rig rig;
    rig.loop.start();
    for (int i = 0; i < 1000; ++i)
        rig.clock.advance(1ms);
    EXPECT_EQ(rig.cycle(), 1000u); // published every 50
    EXPECT_EQ(rig.keeper.newest->lateCycles, 0u);
}

TEST(RealTimeLoopTest, lateCyclesAreCountedAndNeverMadeUpFor)
{
    Rig rig;
    rig.loop.start();
    for (int i = 0; i < 49; ++i)
        rig.clock.advance(1ms);
    rig.clock.advance(11ms); // ten cycles late: one is done, ten have slipped
    for (int i = 0; i < 50; ++i)
        rig.clock.advance(1ms);
    EXPECT_EQ(rig.cycle(), 100u);
    EXPECT_EQ(rig.keeper.newest->lateCycles, 10u);
}

TEST(RealTimeLoopTest, requestsFromAnotherThreadAreAnsweredWhileItRuns)
{
    Rig rig;
    rig.loop.start();
    int answers = 0;
    for (ClientId client = 1; client <= 200; ++client) {
        rig.host.takeControl(client, "x", [&](Result<void>) { ++answers; });
        rig.host.heartbeat(client, 1);
        rig.host.releaseControl(client, [&](Result<void>) { ++answers; });
        rig.clock.advance(1ms);
        rig.host.deliver();
    }
    for (int i = 0; i < 10 && answers < 400; ++i) {
        rig.clock.advance(1ms);
        rig.host.deliver();
    }
    EXPECT_EQ(answers, 400);
}

TEST(RealTimeLoopTest, aDownloadOverAllThreeThreadsEndsWithTheNewProgram)
{
    Rig rig;
    rig.loop.start();
    const ControllerImage image = test::feederImage();
    std::optional<Result<void>> result;
    rig.host.takeControl(1, "x", [](Result<void>) {});
    rig.host.commit(1, "x", write(image), programHash(image), [&](Result<void> r) { result.emplace(std::move(r)); });
    for (int i = 0; i < 400 && !result; ++i) { // the lease lasts 500 cycles
        rig.clock.advance(1ms);
        rig.host.deliver();
        std::this_thread::yield();
    }
    for (int i = 0; i < 100'000 && !result; ++i) {
        rig.host.renewControl(1);
        rig.clock.advance(1ms);
        rig.host.deliver();
    }
    ASSERT_TRUE(result.has_value());
    EXPECT_TRUE(result->ok()) << englishText(result->error());
    EXPECT_EQ(rig.keeper.newest->program, programHash(image));
}

} // namespace
