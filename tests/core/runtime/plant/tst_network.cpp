#include "tests/core/runtime/plant/networkfixture.h"

#include "core/fieldbus/canbits.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>

using namespace camwright;

// The whole chain: master, frames on the wire, slaves, drives, plants.

TEST(NetworkTest, twoNodesBootInTheOrderOfTheManual)
{
    Network network(2);
    ASSERT_TRUE(network.boot());
    EXPECT_LT(network.now, 300ms);
    for (unsigned axis = 1; axis <= 2; ++axis) {
        EXPECT_EQ(network.drive(axis).slave().state(), NmtState::Operational);
        EXPECT_EQ(network.drive(axis).objects().number({0x100C, 0}), 1000);
        EXPECT_EQ(network.drive(axis).objects().number({0x100D, 0}), 3);
        EXPECT_EQ(network.drive(axis).objects().number({0x1A00, 1}), 0x60410010);
        EXPECT_EQ(network.drive(axis).objects().number({0x1800, 3}), 100); // 10 ms
        EXPECT_EQ(network.drive(axis).objects().number({0x1801, 1}), 0x280 + axis);
        EXPECT_EQ(network.master->bootReport(static_cast<std::uint8_t>(axis)).status, SdoStatus::Done);
    }
}

TEST(NetworkTest, aProfilePositionMoveReachesItsTarget)
{
    Network network(2);
    ASSERT_TRUE(network.boot());
    ASSERT_TRUE(network.enable(1, 1));
    ASSERT_TRUE(network.enable(2, 1));
    ASSERT_TRUE(network.setPoint(1, 25000, 20000));
    ASSERT_TRUE(network.setPoint(2, -5000, 10000));
    EXPECT_FALSE(network.reached(1));
    ASSERT_TRUE(network.until([&] { return network.reached(1) && network.reached(2); }, 5s));
    EXPECT_LE(std::abs(network.in(1).position - 25000), 10);
    EXPECT_EQ(network.in(1).demandPosition, 25000);
    EXPECT_LE(std::abs(network.in(2).position + 5000), 10);
    network.run(300ms);
    EXPECT_EQ(network.in(1).position, 25000);
    EXPECT_EQ(network.in(1).velocity, 0);
}

TEST(NetworkTest, theLoadEqualsTheCountedBits)
{
    Network network(2);
    std::uint64_t bits = 0;
    std::uint64_t frames = 0;
    network.bus.powerOn(network.now);
    network.master->start(network.now);
    for (int i = 0; i < 1000; ++i) {
        network.now += 1ms;
        network.bus.wire().advance(network.now, [&](unsigned node, const CanFrame& frame, Time at) {
            bits += frameBits(frame); // of each frame once at both of the others
            ++frames;
            if (node == 0)
                network.master->receive(frame, at);
            else
                network.bus.drive(node - 1).receive(frame, at);
        });
        network.bus.drive(0).step(network.now);
        network.bus.drive(1).step(network.now);
        network.master->step(network.now);
    }
    ASSERT_TRUE(network.allOnline());
    EXPECT_EQ(bits / 2, network.bus.wire().counters().bits);
    EXPECT_EQ(frames / 2, network.bus.wire().counters().frames);
    EXPECT_NEAR(network.bus.wire().load(), static_cast<double>(network.bus.wire().counters().bits) / 1e6, 1e-9);
}

TEST(NetworkTest, aLostNodeIsFoundWithinGuardTimeTimesLifeFactor)
{
    MasterNodeConfig node;
    node.guardTime = 100ms;
    for (const Time moment : {0ms, 13ms, 50ms, 99ms}) {
        Network network(2, 1'000'000, {}, node);
        ASSERT_TRUE(network.boot());
        network.run(1s + moment);
        network.bus.setConnected(1, false);
        const Time lost = network.now;
        ASSERT_TRUE(network.until([&] { return !network.master->isOnline(2); }, 1s));
        EXPECT_LE(network.now - lost, 300ms);
        EXPECT_EQ(network.master->nodeState(2), NodeState::Lost);
        EXPECT_TRUE(network.master->isOnline(1));
        // Its own life guarding has acted by 0x6007: fault.
        network.run(400ms);
        EXPECT_TRUE(network.drive(2).slave().lifeLost());
        EXPECT_EQ(network.drive(2).state(), DriveState::Fault);
        // KS-MC-08: nothing reconnects by itself.
        network.bus.setConnected(1, true);
        network.run(3s);
        EXPECT_EQ(network.master->nodeState(2), NodeState::Lost);
        // MC_RESTART does.
        ASSERT_TRUE(network.master->restart(2, 0ms, network.now));
        ASSERT_TRUE(network.until([&] { return network.master->isOnline(2); }, 1s));
        ASSERT_TRUE(network.until([&] { return network.status(2, 0x08, 0x08); }, 100ms));
        network.out(2).controlWord = 0x80;
        ASSERT_TRUE(network.until([&] { return network.status(2, 0x4F, 0x40); }, 1s));
    }
}

TEST(NetworkTest, aQuietNetworkStaysOnline)
{
    Network network(3);
    ASSERT_TRUE(network.boot());
    network.run(20s);
    EXPECT_TRUE(network.allOnline());
    EXPECT_EQ(network.master->bufferFullCount(), 0U);
}

TEST(NetworkTest, aNodeThatRestartsByItselfIsOffline)
{
    Network network(1);
    ASSERT_TRUE(network.boot());
    network.drive(1).powerOff();
    network.run(10ms);
    network.drive(1).powerOn(network.now);
    ASSERT_TRUE(network.until([&] { return network.master->nodeState(1) == NodeState::Lost; }, 200ms));
}

TEST(NetworkTest, anAbsentNodeFailsItsBootAndBootsWhenItAppears)
{
    Network network(2);
    network.master->start(network.now);
    network.bus.drive(0).powerOn(network.now);
    network.run(400ms);
    EXPECT_TRUE(network.master->isOnline(1));
    EXPECT_EQ(network.master->nodeState(2), NodeState::BootFailed);
    const BootReport report = network.master->bootReport(2);
    EXPECT_EQ(report.status, SdoStatus::TimedOut);
    EXPECT_EQ(report.step, BootStep::Guarding);
    EXPECT_EQ(bootDiagnostic(2, report).code, Code::NodeDoesNotAnswer);
    network.bus.drive(1).powerOn(network.now);
    EXPECT_TRUE(network.until([&] { return network.master->isOnline(2); }, 500ms));
}

TEST(NetworkTest, aCutCableFillsTheSendBuffer)
{
    Network network(1);
    ASSERT_TRUE(network.boot());
    network.bus.setConnected(0, false);
    std::uint16_t word = 0;
    ASSERT_TRUE(network.until([&] {
        network.out(1).controlWord = word++;
        return network.master->sendBlocked(1);
    }, 500ms));
    const auto handle = network.master->readSdo(1, {0x6041, 0}, network.now);
    EXPECT_EQ(network.master->takeSdo(handle).status, SdoStatus::BufferFull);
    EXPECT_GT(network.bus.wire().counters().repeated, 100U);
}

TEST(NetworkTest, stateSavedInTheMiddleOfTrafficGoesOnWithTheSameBytes)
{
    Network first(2);
    ASSERT_TRUE(first.boot());
    ASSERT_TRUE(first.enable(1, 1));
    ASSERT_TRUE(first.enable(2, 3));
    ASSERT_TRUE(first.setPoint(1, 90000, 30000));
    first.out(2).targetVelocity = 12345;
    first.run(137ms);
    const auto handle = first.master->readSdo(1, {0x1008, 0}, first.now); // a segmented read is on its way
    const Bytes saved = first.save();

    Network second(2);
    ASSERT_TRUE(second.restore(saved));
    second.outputs = first.outputs;
    EXPECT_EQ(second.save(), saved);
    for (int i = 0; i < 4000; ++i) {
        first.cycle();
        second.cycle();
        if (i % 500 == 0) {
            ASSERT_EQ(first.save(), second.save()) << "after " << i << " ms";
        }
    }
    const SdoResult name = second.master->takeSdo(handle);
    EXPECT_EQ(std::string(name.data.begin(), name.data.end()), "Camwright simulated drive");
    first.master->takeSdo(handle);
    EXPECT_EQ(first.save(), second.save());
    EXPECT_TRUE(first.reached(1));
}

TEST(NetworkTest, cutStateIsRefused)
{
    Network network(1);
    ASSERT_TRUE(network.boot());
    const Bytes saved = network.save();
    for (std::size_t size = 0; size < saved.size(); size += 7) {
        Network other(1);
        EXPECT_FALSE(other.restore(Bytes(saved.begin(), saved.begin() + static_cast<std::ptrdiff_t>(size))));
    }
}

TEST(NetworkTest, drivesOfThirtyTwoAxesBoot)
{
    Network network(32);
    ASSERT_TRUE(network.boot());
    EXPECT_EQ(network.master->bufferFullCount(), 0U);
}

TEST(NetworkTest, aSlowBusBootsToo)
{
    MasterNodeConfig node;
    Network network(2, 20'000, {}, node);
    network.powerOn();
    EXPECT_TRUE(network.until([&] { return network.allOnline(); }, 5s));
}

// The figure of the plan: 60 machine-seconds of two moving axes well under half a second, in an optimised build.
TEST(NetworkTest, sixtySecondsOfTwoAxesAreQuick)
{
    Network network(2);
    ASSERT_TRUE(network.boot());
    ASSERT_TRUE(network.enable(1, 1));
    ASSERT_TRUE(network.enable(2, 3));
    network.out(2).targetVelocity = 5000;
    const auto start = std::chrono::steady_clock::now();
    for (int i = 0; i < 30; ++i) {
        ASSERT_TRUE(network.setPoint(1, i % 2 == 0 ? 40000 : 0, 30000));
        network.run(2s);
        EXPECT_TRUE(network.reached(1));
    }
    const double took = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    RecordProperty("seconds", std::to_string(took));
    std::printf("%.3f s for %.1f machine-seconds, %llu frames\n", took, seconds(network.now),
        static_cast<unsigned long long>(network.bus.wire().counters().frames));
    EXPECT_LT(took, 20);
}
