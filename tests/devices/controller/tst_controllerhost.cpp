#include "tests/devices/controller/hostfixture.h"

#include <gtest/gtest.h>

using namespace camwright;
using namespace camwright::test;

namespace {

Code codeOf(const Result<void>& result) { return result ? Code::InternalError : result.error().code; }

struct Running : HostFixture {
    ControllerImage image = feederImage();
    Hash program = programHash(image);

    explicit Running(bool run = true)
    {
        EXPECT_TRUE(take(1));
        EXPECT_TRUE(download(1, image));
        EXPECT_TRUE(until([&] { return status.axes.size() == 2 && feed().online; })) << "drives on the bus";
        if (run) {
            EXPECT_TRUE(wait([&](auto done) { keepControl(); host.run(1, done); }));
        }
    }
    void keepControl() { EXPECT_TRUE(take(1)); }
    /// Cycles with control renewed and a heartbeat every 20 ms, as a panel sends them.
    void withPanel(int count)
    {
        for (int i = 0; i < count; ++i) {
            if (i % 20 == 0) {
                host.heartbeat(1, std::max(beat, status.cycle));
                host.renewControl(1);
            }
            cycles(1);
        }
    }
    void startJog(double velocity)
    {
        keepControl();
        EXPECT_TRUE(axis(1, {"Feed", AxisCommandKind::Arm}));
        EXPECT_TRUE(axis(1, {"Feed", AxisCommandKind::Enable}));
        for (int i = 0; i < 100 && !(status.axes.at(0).enabled); ++i)
            withPanel(20);
        EXPECT_TRUE(feed().enabled);
        const auto jog = axis(1, {"Feed", AxisCommandKind::Jog, 0, velocity, 0});
        EXPECT_TRUE(jog) << englishText(jog.error());
        withPanel(300);
        EXPECT_TRUE(feed().moving);
        EXPECT_NEAR(feed().velocity, velocity, 0.05 * std::abs(velocity));
    }
};

TEST(ControllerHostTest, withoutAProgramEverythingThatNeedsOneSaysSo)
{
    HostFixture rig;
    ASSERT_TRUE(rig.take(1));
    EXPECT_EQ(codeOf(rig.wait([&](auto done) { rig.host.run(1, done); })), Code::NoProgram);
    EXPECT_EQ(rig.read({}, {"%VD0"}).error().code, Code::NoProgram);
    EXPECT_EQ(codeOf(rig.axis(1, {"Feed", AxisCommandKind::Arm})), Code::AxisUnknown);
}

TEST(ControllerHostTest, aDownloadLeavesItInStopWithTheNewProgram)
{
    Running rig(false);
    EXPECT_EQ(rig.status.program, rig.program);
    EXPECT_EQ(rig.status.state, RunState::Stop);
    EXPECT_NE(rig.find(Code::ProgramTaken), nullptr);
}

TEST(ControllerHostTest, aDownloadInRunStopsFirstAndKeepsRetainedValues)
{
    Running rig;
    rig.keepControl();
    ASSERT_TRUE(rig.wait([&](auto done) { rig.host.write(1, rig.program, "Pieces", Value::ofInteger(DataType::Dint, 77), done); }));
    rig.cycles(10);
    const ControllerImage other = feederImage(5);
    rig.keepControl();
    ASSERT_TRUE(rig.download(1, other));
    EXPECT_EQ(rig.status.state, RunState::Stop);
    EXPECT_EQ(rig.status.program, programHash(other));
    EXPECT_EQ(rig.read(programHash(other), {"Pieces"})->at(0).value.asInteger(), 77);
}

TEST(ControllerHostTest, anotherProgramThanAnnouncedIsRefusedAndTheOldOneStays)
{
    Running rig;
    rig.keepControl();
    const auto done = rig.wait([&](auto d) { rig.host.commit(1, "x", write(feederImage(1)), programHash(feederImage(2)), d); });
    EXPECT_EQ(codeOf(done), Code::ImageDamaged);
    EXPECT_EQ(rig.status.program, rig.program);
    EXPECT_EQ(rig.status.state, RunState::Run) << "a refused download does not stop the program";
}

TEST(ControllerHostTest, everyByteOfAnImageDamagedIsRefused)
{
    Running rig(false);
    const Bytes whole = write(feederImage(3));
    for (std::size_t i = 0; i < whole.size(); i += 7) {
        Bytes damaged = whole;
        damaged[i] ^= 0x10;
        rig.keepControl();
        const auto done = rig.wait([&](auto d) { rig.host.commit(1, "x", damaged, programHash(feederImage(3)), d); });
        ASSERT_FALSE(done.ok()) << "byte " << i;
        ASSERT_EQ(rig.status.program, rig.program);
    }
}

TEST(ControllerHostTest, aSecondDownloadMeanwhileIsRefused)
{
    Running rig(false);
    rig.keepControl();
    rig.runBackground = false;
    std::optional<Result<void>> first, second;
    rig.host.commit(1, "x", write(feederImage(1)), programHash(feederImage(1)), rig.keep<void>(first));
    rig.host.commit(1, "x", write(feederImage(2)), programHash(feederImage(2)), rig.keep<void>(second));
    rig.cycles(5);
    ASSERT_TRUE(second.has_value());
    EXPECT_EQ(codeOf(*second), Code::DownloadBusy);
    rig.runBackground = true;
    ASSERT_TRUE(rig.until([&] { return first.has_value(); }));
    EXPECT_TRUE(first->ok());
}

TEST(ControllerHostTest, readsNameTheProgramTheyAreFor)
{
    Running rig;
    EXPECT_TRUE(rig.read(rig.program, {"%VD0", "Count", "axis.Feed.position"}).ok());
    EXPECT_EQ(rig.read(programHash(feederImage(9)), {"%VD0"}).error().code, Code::OtherProgram);
    EXPECT_EQ(rig.read(rig.program, {"%VD0", "%ZZ9"}).ok(), false);
}

TEST(ControllerHostTest, writesNeedControlAndTheRightProgram)
{
    Running rig;
    rig.keepControl();
    const auto write = [&](ClientId client, Hash program, std::string name, Value value) {
        return rig.wait([&](auto done) { rig.host.write(client, program, name, value, done); });
    };
    EXPECT_TRUE(write(1, rig.program, "%VD100", Value::ofInteger(DataType::Dint, -5)));
    EXPECT_EQ(codeOf(write(2, rig.program, "%VD100", Value::ofInteger(DataType::Dint, 1))), Code::ControlHeld);
    EXPECT_EQ(codeOf(write(1, {}, "%VD100", Value::ofInteger(DataType::Dint, 1))), Code::OtherProgram);
    EXPECT_EQ(codeOf(write(1, rig.program, "%VB100", Value::ofInteger(DataType::Dint, 256))), Code::NotAValue);
    rig.cycles(5);
    EXPECT_EQ(rig.read(rig.program, {"%VD100"})->at(0).value.asInteger(), -5);
}

TEST(ControllerHostTest, everyUpdateComesFromOneScan)
{
    Running rig;
    std::optional<Result<std::vector<std::uint32_t>>> unknown;
    message::Subscribe wanted{rig.program, 7, {"%VD0", "%NO1", "%VD4"}, 10ms};
    rig.host.subscribe(1, wanted, rig.keep<std::vector<std::uint32_t>>(unknown));
    rig.cycles(2000);
    ASSERT_TRUE(unknown && unknown->ok());
    EXPECT_EQ(**unknown, (std::vector<std::uint32_t>{1}));
    ASSERT_GE(rig.updates.size(), 190u);
    for (const message::Update& update : rig.updates) {
        ASSERT_EQ(update.values.size(), 2u);
        EXPECT_EQ(update.values[0].value.bits, update.values[1].value.bits) << "torn between two scans";
        EXPECT_EQ(update.values[1].index, 2u);
    }
}

TEST(ControllerHostTest, traceRowsFollowWithoutAHole)
{
    Running rig;
    TraceSetup setup;
    setup.channels = {"axis.Feed.position", "%VD0"};
    ASSERT_TRUE(rig.wait([&](auto done) { rig.host.startTrace(1, "x", rig.program, setup, done); }));
    EXPECT_EQ(codeOf(rig.wait([&](auto done) { rig.host.startTrace(2, "y", rig.program, setup, done); })), Code::TraceBusy);
    rig.cycles(3000);
    ASSERT_FALSE(rig.samples.empty());
    std::uint64_t sequence = 0, cycle = rig.samples.front().firstCycle;
    for (const SampleBlock& block : rig.samples) {
        EXPECT_EQ(block.sequence, sequence++);
        EXPECT_EQ(block.firstCycle, cycle);
        EXPECT_EQ(block.lostRows, 0u);
        cycle += block.columns.at(0).size();
    }
    EXPECT_GT(cycle - rig.samples.front().firstCycle, 2500u);
}

TEST(ControllerHostTest, aJogWhoseHolderDisappearsStopsWithin100MsAndOneCycle)
{
    Running rig(false);
    rig.startJog(50);
    const std::uint64_t gone = rig.status.cycle;
    rig.host.clientGone(1);
    ASSERT_TRUE(rig.until([&] { return rig.find(Code::DeadManStop) != nullptr; }, 200));
    const auto& arguments = rig.find(Code::DeadManStop)->message.arguments;
    const std::uint64_t last = std::stoull(arguments.at(1)), stop = std::stoull(arguments.at(2));
    EXPECT_LE(last, gone + 50);
    EXPECT_LE(stop - last, 101u);
    ASSERT_TRUE(rig.until([&] { return !rig.feed().moving && !rig.feed().panelArmed; }));
    EXPECT_TRUE(rig.feed().enabled) << "power stays on";
    EXPECT_EQ(rig.holder, 0u);
}

TEST(ControllerHostTest, aJogWhoseControlLapsesStopsThoughHeartbeatsGoOn)
{
    Running rig(false);
    rig.startJog(50);
    for (int i = 0; i < 800; ++i) { // heartbeats, but no renewal
        if (i % 20 == 0)
            rig.host.heartbeat(1, std::max(rig.beat, rig.status.cycle));
        rig.cycles(1);
    }
    EXPECT_NE(rig.find(Code::ControlLapsed), nullptr);
    EXPECT_NE(rig.find(Code::DeadManStop), nullptr);
    ASSERT_TRUE(rig.until([&] { return !rig.feed().moving && !rig.feed().panelArmed; }));
    EXPECT_TRUE(rig.feed().enabled);
}

TEST(ControllerHostTest, theNextHolderDoesNotKeepTheOldJogAlive)
{
    Running rig(false);
    rig.startJog(50);
    rig.host.clientGone(1);
    rig.cycles(2);
    ASSERT_TRUE(rig.take(2));
    for (int i = 0; i < 40; ++i) {
        rig.host.heartbeat(2, std::max(rig.beat, rig.status.cycle));
        rig.host.renewControl(2);
        rig.cycles(20);
    }
    EXPECT_FALSE(rig.feed().moving);
    EXPECT_FALSE(rig.feed().panelArmed);
}

TEST(ControllerHostTest, lateHeartbeatsDoNotKeepAJogAlive)
{
    Running rig(false);
    rig.startJog(50);
    const std::uint64_t stale = rig.status.cycle;
    for (int i = 0; i < 300; ++i) {
        rig.host.heartbeat(1, stale); // arrives on time, but has seen nothing new
        rig.host.renewControl(1);
        rig.cycles(1);
    }
    EXPECT_NE(rig.find(Code::DeadManStop), nullptr);
}

TEST(ControllerHostTest, anyoneStopsAllAxesAndTheNextCycleStopsThem)
{
    Running rig(false);
    rig.startJog(50);
    ASSERT_TRUE(rig.wait([&](auto done) { rig.host.stopAll(done); }));
    rig.withPanel(300);
    EXPECT_FALSE(rig.feed().moving);
    EXPECT_TRUE(rig.feed().enabled);
}

TEST(ControllerHostTest, stopOfOneAxisNeedsNoControlAndOtherCommandsDo)
{
    Running rig(false);
    rig.startJog(50);
    EXPECT_EQ(codeOf(rig.axis(2, {"Feed", AxisCommandKind::Jog, 0, 10, 0})), Code::ControlHeld);
    EXPECT_TRUE(rig.axis(2, {"Feed", AxisCommandKind::Stop}));
    rig.withPanel(300);
    EXPECT_FALSE(rig.feed().moving);
}

TEST(ControllerHostTest, aRestartFindsTheProgramAndRetainedValues)
{
    auto disk = std::make_shared<MemoryFileSystem>();
    disk->folders.insert("/data");
    const ControllerImage image = feederImage();
    {
        HostFixture rig(disk, "/data");
        ASSERT_TRUE(rig.take(1));
        ASSERT_TRUE(rig.download(1, image));
        ASSERT_TRUE(rig.take(1));
        ASSERT_TRUE(rig.wait([&](auto d) { rig.host.write(1, programHash(image), "Pieces", Value::ofInteger(DataType::Dint, 12), d); }));
        rig.cycles(250);
    } // gone without a word, as by kill -9
    HostFixture again(disk, "/data");
    again.cycles(60);
    EXPECT_EQ(again.status.program, programHash(image));
    EXPECT_EQ(again.status.state, RunState::Stop);
    EXPECT_EQ(again.read(programHash(image), {"Pieces"})->at(0).value.asInteger(), 12);
}

TEST(ControllerHostTest, aDamagedProgramOnDiskFallsBackAndSaysSo)
{
    auto disk = std::make_shared<MemoryFileSystem>();
    disk->folders.insert("/data");
    {
        HostFixture rig(disk, "/data");
        for (const std::uint32_t variant : {1u, 2u}) {
            ASSERT_TRUE(rig.take(1));
            ASSERT_TRUE(rig.download(1, feederImage(variant)));
        }
    }
    for (auto& [path, bytes] : disk->files)
        if (path.ends_with("image.b"))
            bytes[bytes.size() / 2] ^= 1;
    HostFixture again(disk, "/data");
    again.cycles(60);
    EXPECT_EQ(again.status.program, programHash(feederImage(1)));
    EXPECT_NE(again.find(Code::StoredProgramUnusable), nullptr);
    ASSERT_TRUE(again.take(1));
    EXPECT_TRUE(again.download(1, feederImage(3)));
}

TEST(ControllerHostTest, aFullDiskRefusesTheDownloadAndTheOldProgramGoesOn)
{
    auto disk = std::make_shared<MemoryFileSystem>();
    disk->folders.insert("/data");
    HostFixture rig(disk, "/data");
    ASSERT_TRUE(rig.take(1));
    ASSERT_TRUE(rig.download(1, feederImage(1)));
    ASSERT_TRUE(rig.take(1));
    ASSERT_TRUE(rig.wait([&](auto done) { rig.host.run(1, done); }));
    rig.cycles(300);
    disk->failAt = disk->calls + 1;
    disk->failAfterwardsToo = true;
    ASSERT_TRUE(rig.take(1));
    EXPECT_EQ(codeOf(rig.download(1, feederImage(2))), Code::StoreFailed);
    EXPECT_EQ(rig.status.program, programHash(feederImage(1)));
    EXPECT_EQ(rig.status.state, RunState::Run);
}

TEST(ControllerHostTest, shutDownStoresRetainedValues)
{
    auto disk = std::make_shared<MemoryFileSystem>();
    disk->folders.insert("/data");
    const ControllerImage image = feederImage();
    HostFixture rig(disk, "/data");
    ASSERT_TRUE(rig.take(1));
    ASSERT_TRUE(rig.download(1, image));
    ASSERT_TRUE(rig.take(1));
    ASSERT_TRUE(rig.wait([&](auto d) { rig.host.write(1, programHash(image), "Pieces", Value::ofInteger(DataType::Dint, 3), d); }));
    rig.cycles(2);
    rig.host.shutDown();
    rig.background.runAll();
    HostFixture again(disk, "/data");
    EXPECT_EQ(again.read(programHash(image), {"Pieces"})->at(0).value.asInteger(), 3);
}

TEST(ControllerHostTest, theLogComesInPagesWithoutAHole)
{
    HostFixture rig;
    for (int i = 0; i < 200; ++i)
        rig.host.note(diagnostic(Code::ClientCame, {std::to_string(i)}));
    rig.cycles(2);
    std::uint64_t from = 0;
    std::vector<LogEntry> all;
    for (bool more = true; more;) {
        const auto page = rig.host.log(from);
        all.insert(all.end(), page.entries.begin(), page.entries.end());
        more = page.more;
        from = all.back().sequence + 1;
    }
    ASSERT_EQ(all.size(), 200u);
    for (std::size_t i = 0; i < all.size(); ++i)
        EXPECT_EQ(all[i].sequence, i + 1);
}

TEST(ControllerHostTest, whoeverAsksForMuchWaitsNotTheScan)
{
    Running rig;
    const std::vector<std::string> names(256, "%VD0");
    int answers = 0;
    for (int i = 0; i < 100; ++i)
        rig.host.read(rig.program, names, [&](Result<ControllerHost::Values>) { ++answers; });
    std::optional<Result<void>> stopped;
    rig.host.stopAll(rig.keep<void>(stopped));
    rig.cycles(1);
    EXPECT_LE(answers, 3) << "the budget of one cycle";
    EXPECT_TRUE(stopped.has_value()) << "stop overtakes";
    rig.cycles(100);
    EXPECT_EQ(answers, 100);
}

} // namespace
