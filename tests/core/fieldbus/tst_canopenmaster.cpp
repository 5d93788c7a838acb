#include "core/fieldbus/canopenmaster.h"

#include "tests/core/fieldbus/slavefixture.h"

#include <gtest/gtest.h>

using namespace camwright;

namespace {

MasterConfig oneNode(Time guardTime = 100ms)
{
    MasterNodeConfig node;
    node.node = 5;
    node.guardTime = guardTime;
    node.inhibitTime = 10ms;
    node.eventTimer = 200ms;
    MasterConfig config;
    config.nodes.push_back(node);
    return config;
}

/// The master against hand-made answers.
class CanopenMasterTest : public testing::Test {
protected:
    /// Answers every SDO write of the boot and returns what was written, in order.
    std::vector<std::pair<ObjectId, std::uint32_t>> boot()
    {
        master.start(now);
        std::vector<std::pair<ObjectId, std::uint32_t>> written;
        for (auto frames = port.take(); !frames.empty(); frames = port.take()) {
            for (const CanFrame& frame : frames) {
                all.push_back(frame);
                if (frame.id != 0x605)
                    continue;
                const ObjectId id{static_cast<std::uint16_t>(frame.data[1] | frame.data[2] << 8), frame.data[3]};
                std::uint32_t value = 0;
                for (unsigned i = 0; i < 4; ++i)
                    value |= std::uint32_t{frame.data[4 + i]} << (8 * i);
                written.push_back({id, value});
                answer(id);
            }
        }
        return written;
    }
    void answer(ObjectId id)
    {
        master.receive(dataFrame(0x585, {0x60, static_cast<std::uint8_t>(id.index), static_cast<std::uint8_t>(id.index >> 8), id.sub, 0, 0, 0, 0}), now);
    }
    std::vector<CanFrame> stepAt(Time at)
    {
        now = at;
        master.step(now);
        return port.take();
    }
    static std::size_t count(const std::vector<CanFrame>& frames, std::uint32_t id)
    {
        return static_cast<std::size_t>(std::count_if(frames.begin(), frames.end(), [id](const CanFrame& frame) { return frame.id == id; }));
    }
    RecordingPort port;
    CanopenMaster master{oneNode(), port};
    Time now{0};
    std::vector<CanFrame> all;
};

} // namespace

TEST_F(CanopenMasterTest, bootsByTheStepsOfTheManualInTheirOrder)
{
    const auto written = boot();
    EXPECT_EQ(all.front(), nmtFrame(NmtCommand::EnterPreOperational, 0));
    EXPECT_EQ(all.back(), nmtFrame(NmtCommand::Start, 5));
    ASSERT_EQ(written.size(), 46U);
    EXPECT_EQ(written[0], (std::pair<ObjectId, std::uint32_t>{{0x100C, 0}, 100}));
    EXPECT_EQ(written[1], (std::pair<ObjectId, std::uint32_t>{{0x100D, 0}, 3}));
    // The first PDO's mapping: off, count 0, entries, count.
    EXPECT_EQ(written[2], (std::pair<ObjectId, std::uint32_t>{{0x1400, 1}, 0x80000205}));
    EXPECT_EQ(written[3], (std::pair<ObjectId, std::uint32_t>{{0x1600, 0}, 0}));
    EXPECT_EQ(written[4], (std::pair<ObjectId, std::uint32_t>{{0x1600, 1}, 0x60400010}));
    EXPECT_EQ(written[7], (std::pair<ObjectId, std::uint32_t>{{0x1600, 0}, 3}));
    // The last one's communication: type, inhibit time, event timer, on.
    EXPECT_EQ(written[42], (std::pair<ObjectId, std::uint32_t>{{0x1802, 2}, 255}));
    EXPECT_EQ(written[43], (std::pair<ObjectId, std::uint32_t>{{0x1802, 3}, 100}));
    EXPECT_EQ(written[44], (std::pair<ObjectId, std::uint32_t>{{0x1802, 5}, 200}));
    EXPECT_EQ(written[45], (std::pair<ObjectId, std::uint32_t>{{0x1802, 1}, 0x385}));
    EXPECT_TRUE(master.isOnline(5));
}

TEST_F(CanopenMasterTest, reportsWhereABootFailed)
{
    master.start(now);
    answer({0x100C, 0});
    answer({0x100D, 0});
    master.receive(sdoAbortFrame(0x585, 0x1400, 1, SdoAbort::NoSuchObject), now);
    EXPECT_EQ(master.nodeState(5), NodeState::BootFailed);
    const BootReport report = master.bootReport(5);
    EXPECT_EQ(report.step, BootStep::Mapping);
    EXPECT_EQ(report.status, SdoStatus::Aborted);
    EXPECT_EQ(report.object, (ObjectId{0x1400, 1}));
    EXPECT_EQ(englishText(bootDiagnostic(5, report)),
        "Axis node 5 refuses object 0x1400:01 with abort code 0x06020000: object does not exist in the object dictionary. "
        "Check whether the drive has this object and the value is in its range.");
}

TEST_F(CanopenMasterTest, asksEveryGuardTimeAndFindsTheSilentNode)
{
    boot();
    std::size_t asked = 0;
    Time lostAt{0};
    bool toggle = false;
    for (Time at = 1ms; at < 2s && lostAt == Time{0}; at += 1ms) {
        const std::size_t now_ = count(stepAt(at), 0x705);
        asked += now_;
        if (now_ > 0 && at < 1s) {
            master.receive(dataFrame(0x705, {static_cast<std::uint8_t>(0x05 | (toggle ? 0x80 : 0))}), at);
            toggle = !toggle;
        }
        if (master.nodeState(5) == NodeState::Lost)
            lostAt = at;
    }
    EXPECT_EQ(asked, 12U); // at 1, 101 … 1101 ms; the last answer came at 901
    EXPECT_EQ(lostAt, 1201ms);
}

TEST_F(CanopenMasterTest, aStuckToggleCountsAsSilence)
{
    boot();
    for (Time at = 1ms; at < 1s; at += 1ms) {
        if (count(stepAt(at), 0x705) > 0)
            master.receive(dataFrame(0x705, {0x05}), at);
    }
    EXPECT_EQ(master.nodeState(5), NodeState::Lost);
}

TEST_F(CanopenMasterTest, aNodeThatLeftOperationalIsLost)
{
    boot();
    stepAt(1ms);
    master.receive(dataFrame(0x705, {0x05}), now);
    stepAt(101ms);
    master.receive(dataFrame(0x705, {0xFF}), now);
    EXPECT_EQ(master.nodeState(5), NodeState::Lost);
}

TEST_F(CanopenMasterTest, withoutGuardTimeNothingIsAskedAndNothingLost)
{
    CanopenMaster unguarded(oneNode(0ms), port);
    unguarded.start(now);
    while (!unguarded.isOnline(5)) {
        const auto frames = port.take();
        ASSERT_FALSE(frames.empty());
        const CanFrame request = frames.back();
        unguarded.receive(dataFrame(0x585, {0x60, request.data[1], request.data[2], request.data[3], 0, 0, 0, 0}), now);
    }
    port.take();
    for (Time at = 1ms; at < 5s; at += 1ms)
        unguarded.step(at);
    EXPECT_EQ(count(port.take(), 0x705), 0U);
    EXPECT_TRUE(unguarded.isOnline(5));
}

TEST_F(CanopenMasterTest, aControlWordGoesAtOnceBehindItsSpeeds)
{
    boot();
    stepAt(1ms);
    master.setOutputs(5, {0x1F, 1, 1000, 500, 0});
    const auto frames = stepAt(2ms);
    ASSERT_EQ(count(frames, 0x205), 1U);
    EXPECT_EQ(frames[0], dataFrame(0x305, {0xF4, 1, 0, 0, 0, 0, 0, 0}));
    EXPECT_EQ(frames[1], dataFrame(0x205, {0x1F, 0, 1, 0xE8, 3, 0, 0}));
}

TEST_F(CanopenMasterTest, targetsAloneWaitForTheInhibitTimeAndStopDoesNot)
{
    boot();
    master.setOutputs(5, {0x0F, 3, 0, 0, 0});
    stepAt(1ms);
    std::size_t sent = 0;
    for (int i = 2; i <= 51; ++i) {
        master.setOutputs(5, {0x0F, 3, 0, 0, i});
        sent += count(stepAt(i * 1ms), 0x305);
    }
    EXPECT_EQ(sent, 5U); // at 11, 21 … 51 ms
    master.setOutputs(5, {0x0F, 3, 0, 0, 0}, true);
    EXPECT_EQ(count(stepAt(52ms), 0x305), 1U);
    EXPECT_FALSE(master.outputsPending(5));
    master.setOutputs(5, {0x0F, 3, 0, 0, 9});
    stepAt(53ms);
    EXPECT_TRUE(master.outputsPending(5));
}

TEST_F(CanopenMasterTest, aFullBufferIsReportedAndTriedAgain)
{
    boot();
    stepAt(1ms);
    port.full = true;
    master.setOutputs(5, {0x06, 1, 0, 7, 0});
    stepAt(2ms);
    EXPECT_TRUE(master.sendBlocked(5));
    EXPECT_EQ(master.takeSdo(master.readSdo(5, {0x6041, 0}, now)).status, SdoStatus::BufferFull);
    port.full = false;
    EXPECT_EQ(stepAt(3ms).size(), 2U);
    EXPECT_FALSE(master.sendBlocked(5));
}

TEST_F(CanopenMasterTest, takesProcessDataFromItsPdos)
{
    boot();
    master.receive(dataFrame(0x185, {0x37, 0x06, 1, 0xFF, 0xFF, 0xFF, 0xFF}), now);
    master.receive(dataFrame(0x285, {1, 0, 0, 0, 2, 0, 0, 0}), now);
    master.receive(dataFrame(0x385, {0x9C, 0xFF, 5, 0, 1, 0, 0x11, 0x86}), now);
    EXPECT_EQ(master.inputs(5), (DriveInputs{0x0637, 1, -1, 1, 2, -100, 0x00010005, 0x8611}));
    master.receive(dataFrame(0x185, {0, 0}), now); // too short: not taken
    EXPECT_EQ(master.inputs(5).statusWord, 0x0637);
}

TEST_F(CanopenMasterTest, endsEveryRequestOnce)
{
    boot();
    const auto first = master.readSdo(5, {0x6041, 0}, now);
    EXPECT_TRUE(master.sdoBusy(5));
    EXPECT_EQ(master.takeSdo(first).status, SdoStatus::Pending);
    EXPECT_EQ(master.takeSdo(master.readSdo(5, {0x6064, 0}, now)).status, SdoStatus::Busy);
    EXPECT_EQ(master.takeSdo(master.readSdo(6, {0x6064, 0}, now)).status, SdoStatus::NoNode);
    master.receive(dataFrame(0x585, {0x4B, 0x41, 0x60, 0, 0x37, 0x02, 0, 0}), now);
    const SdoResult result = master.takeSdo(first);
    std::int64_t value = 0;
    EXPECT_TRUE(result.number(DataType::Uint, value));
    EXPECT_EQ(value, 0x237);
    EXPECT_FALSE(result.number(DataType::Dint, value));
    EXPECT_EQ(master.takeSdo(first).status, SdoStatus::Cancelled);
}

TEST_F(CanopenMasterTest, timesARequestOut)
{
    boot();
    stepAt(1ms);
    const auto handle = master.readSdo(5, {0x6041, 0}, now, 30ms);
    stepAt(30ms);
    EXPECT_EQ(master.takeSdo(handle).status, SdoStatus::Pending);
    port.take();
    const auto frames = stepAt(31ms);
    EXPECT_EQ(count(frames, 0x605), 1U); // the abort
    EXPECT_EQ(master.takeSdo(handle).status, SdoStatus::TimedOut);
    EXPECT_FALSE(master.sdoBusy(5));
}

TEST_F(CanopenMasterTest, aRestartTakesTheChannelFromARequest)
{
    boot();
    const auto handle = master.readSdo(5, {0x6041, 0}, now);
    port.take();
    EXPECT_TRUE(master.restart(5, 50ms, now));
    EXPECT_FALSE(master.restart(5, 50ms, now));
    EXPECT_EQ(port.take().at(0), nmtFrame(NmtCommand::EnterPreOperational, 5));
    EXPECT_EQ(master.takeSdo(handle).status, SdoStatus::Cancelled);
    EXPECT_EQ(master.takeSdo(master.readSdo(5, {0x6041, 0}, now)).status, SdoStatus::Busy);
    master.cancelRestart(5);
    EXPECT_EQ(master.bootReport(5).status, SdoStatus::Cancelled);
    EXPECT_EQ(master.nodeState(5), NodeState::BootFailed);
}

TEST_F(CanopenMasterTest, remembersTheLastEmergencies)
{
    boot();
    for (int i = 0; i < 100; ++i)
        master.receive(dataFrame(0x085, {static_cast<std::uint8_t>(i), 0x86, 0x21, 0, 0, 0, 0, 0}), i * 1ms);
    EXPECT_EQ(master.emergencyCount(), 100U);
    ASSERT_EQ(master.emergencies().size(), CanopenMaster::kEmergencyHistory);
    EXPECT_EQ(master.emergencies().back().errorCode, 0x8663);
    EXPECT_EQ(englishText(emergencyDiagnostic(master.emergencies().back())),
        "Axis node 5 reports error 16#8663 (error register 16#21). Look the number up in the drive's manual.");
}

TEST_F(CanopenMasterTest, sendsSyncInItsPeriod)
{
    MasterConfig config;
    config.syncPeriod = 5ms;
    CanopenMaster clocked(config, port);
    clocked.start(Time{0});
    port.take();
    for (int i = 1; i <= 20; ++i)
        clocked.step(i * 1ms);
    EXPECT_EQ(count(port.take(), 0x080), 4U);
}

TEST_F(CanopenMasterTest, survivesAnyFrame)
{
    boot();
    std::uint64_t state = 99;
    for (int i = 0; i < 50000; ++i) {
        state = state * 6364136223846793005ULL + 1442695040888963407ULL;
        CanFrame frame;
        const std::uint32_t ids[] = {0x585, 0x585, 0x185, 0x285, 0x385, 0x085, 0x705, 0x586};
        frame.id = ids[state >> 61];
        frame.length = static_cast<std::uint8_t>((state >> 44) % 3 == 0 ? (state >> 50) % 9 : 8);
        for (unsigned byte = 0; byte < 8; ++byte)
            frame.data[byte] = static_cast<std::uint8_t>((state * (byte + 3)) >> 41);
        if (i % 50 == 0)
            master.takeSdo(master.readSdo(5, {0x1008, 0}, i * 1ms));
        if (i % 500 == 0)
            master.restart(5, 20ms, i * 1ms);
        master.receive(frame, i * 1ms);
        master.step(i * 1ms);
        port.take();
    }
    SUCCEED();
}
