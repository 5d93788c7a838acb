#include "core/runtime/log/controllerlog.h"

#include <gtest/gtest.h>

namespace camwright {
namespace {

TEST(ControllerLogTest, NumbersEntriesAndKeepsTheirMoment)
{
    ControllerLog log;
    log.setMoment(7, 7ms);
    log.add(Code::ProgramStarted);
    log.setMoment(9, 9ms);
    log.add(Code::AxisLost, {"Feed"});
    const auto entries = log.since(0);
    ASSERT_EQ(entries.size(), 2u);
    EXPECT_EQ(entries[0].sequence, 1u);
    EXPECT_EQ(entries[0].cycle, 7u);
    EXPECT_EQ(entries[1].time, 9ms);
    EXPECT_EQ(log.since(2).size(), 1u);
}

TEST(ControllerLogTest, DropsTheOldestWhenFull)
{
    ControllerLog log;
    for (std::size_t i = 0; i < ControllerLog::kCapacity + 3; ++i)
        log.add(Code::ProgramStopped);
    EXPECT_EQ(log.since(0).size(), ControllerLog::kCapacity);
    EXPECT_EQ(log.since(0).front().sequence, 4u);
}

TEST(ControllerLogTest, RestoresEveryField)
{
    ControllerLog log;
    log.setMoment(3, 3ms);
    Diagnostic message = diagnostic(Code::WatchdogFired, {"500", "Main, line 3"}, {{ObjectKind::Program, "Main"}, "source", {3, 1, 3, 9}, "Main.il"});
    message.related = message.place;
    log.add(message);
    ByteWriter writer;
    log.save(writer);
    ControllerLog other;
    ByteReader reader(writer.bytes());
    other.restore(reader);
    EXPECT_TRUE(reader.ok() && reader.atEnd());
    EXPECT_EQ(other.since(0), log.since(0));
    EXPECT_EQ(other.nextSequence(), log.nextSequence());
}

TEST(ControllerLogTest, RefusesDamagedBytes)
{
    ControllerLog log;
    log.add(Code::AxisLost, {"Feed"});
    ByteWriter writer;
    log.save(writer);
    for (std::size_t size = 0; size < writer.bytes().size(); ++size) {
        ByteReader reader({writer.bytes().data(), size});
        ControllerLog other;
        other.restore(reader);
        EXPECT_FALSE(reader.ok()) << size;
    }
}

} // namespace
} // namespace camwright
