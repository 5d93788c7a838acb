#include "tests/devices/session/sessionrig.h"

#include <random>

using namespace camwright;
using namespace camwright::test;

/// Downloads whose line is cut: the controller has exactly the old program or exactly the new one.
class DownloadTest : public QObject {
    Q_OBJECT

private:
    static constexpr int Cuts = 200;

    std::unique_ptr<MemoryFileSystem> files;
    std::unique_ptr<TestController> controller;
    QtExecutor executor;
    ControllerImage oldImage = feederImage(1);
    ControllerImage newImage = feederImage(2, 40'000);

    std::unique_ptr<OnlineSession> open(std::uint64_t cutAfter)
    {
        SessionOptions options;
        options.reconnect = false;
        return std::make_unique<OnlineSession>(std::make_unique<MemoryConnector>(*controller, cutAfter), executor, options);
    }
    bool isOnline(OnlineSession& session)
    {
        return waitUntil([&] { return session.state() == LinkState::Online || session.state() == LinkState::Offline; })
            && session.state() == LinkState::Online;
    }
    bool take(OnlineSession& session) { return good(answerOf<void>([&](auto r) { session.takeControl(r); })); }

private slots:
    void init()
    {
        files = std::make_unique<MemoryFileSystem>();
        files->folders.insert("/data");
        controller = std::make_unique<TestController>(*files, "/data");
    }
    void cleanup() { controller.reset(); }

    void thePlanComesBeforeTheFirstByteAndProgressReachesTheEnd()
    {
        auto session = open(0);
        QVERIFY(isOnline(*session));
        QVERIFY(take(*session));
        QVERIFY(good(answerOf<void>([&](auto r) { session->download(packageOf(oldImage), {}, r); })));
        QVERIFY(good(answerOf<void>([&](auto r) { session->run(r); })));
        QVERIFY(waitUntil([&] { return session->status().state == RunState::Run; }));
        const auto plan = answerOf<DownloadPlan>([&](auto r) { session->planDownload(packageOf(newImage), r); });
        QVERIFY(plan && plan->ok());
        QVERIFY((*plan)->mustStop && !(*plan)->sameProgram);
        std::vector<Code> codes;
        for (const PlanLine& line : (*plan)->lines)
            codes.push_back(line.message.code);
        QCOMPARE(codes, (std::vector{Code::PlanStops, Code::PlanProgramChanged}));
        std::vector<double> progress;
        QVERIFY(good(answerOf<void>([&](auto r) {
            session->download(packageOf(newImage), [&](double share) { progress.push_back(share); }, r);
        })));
        QVERIFY(std::is_sorted(progress.begin(), progress.end()));
        QCOMPARE(progress.back(), 1.0);
        QCOMPARE(session->status().program, programHash(newImage));
        QCOMPARE(session->status().state, RunState::Stop);
    }

    void aCancelledDownloadLeavesTheOldProgram()
    {
        auto session = open(0);
        QVERIFY(isOnline(*session) && take(*session));
        QVERIFY(good(answerOf<void>([&](auto r) { session->download(packageOf(oldImage), {}, r); })));
        bool called = false;
        RequestId id{};
        id = session->download(packageOf(newImage), [&](double) { session->cancel(id); }, [&](Result<void>) { called = true; });
        QVERIFY(waitUntil([&] {
            for (const LogEntry& entry : controller->host.log(0).entries)
                if (entry.message.code == Code::AbandonedDownload)
                    return true;
            return false;
        }));
        QVERIFY(!called);
        QCOMPARE(session->status().program, programHash(oldImage));
    }

    void aCutAtAnyByteLeavesTheOldProgramRunningOrTheNewOneWhole()
    {
        std::uint64_t before = 0, all = 0; // bytes this side sends until the first piece, and in all
        {
            auto session = open(0);
            QVERIFY(isOnline(*session) && take(*session));
            QVERIFY(good(answerOf<void>([&](auto r) { session->download(packageOf(oldImage), {}, r); })));
            QVERIFY(good(answerOf<void>([&](auto r) { session->run(r); })));
        }
        controller->ticker.setInterval(0); // as fast as the loop
        before = 100;
        all = write(newImage).size() + 6000;
        std::mt19937 random(11);
        int kept = 0, switched = 0;
        for (int i = 0; i < Cuts; ++i) {
            const bool late = i % 3 == 0; // around the commit
            const std::uint64_t cut = late ? all - 6500 + random() % 6500 : before + random() % (all - before);
            auto session = open(cut);
            bool ended = !isOnline(*session);
            if (!ended)
                session->takeControl([&](Result<void> taken) {
                    if (!taken) {
                        ended = true;
                        return;
                    }
                    session->download(packageOf(newImage), {}, [&](Result<void>) { ended = true; });
                });
            QVERIFY(waitUntil([&] { return ended; }));
            session.reset();
            auto watcher = open(0);
            QVERIFY(isOnline(*watcher));
            // A commit that had arrived is carried out: give it the cycles it needs.
            controller->skip(150);
            const std::uint64_t seen = std::uint64_t(controller->now / 1ms);
            QVERIFY(waitUntil([&] { return watcher->status().cycle >= seen; }));
            const Hash found = watcher->status().program;
            QVERIFY2(found == programHash(oldImage) || found == programHash(newImage), "neither old nor new");
            if (found == programHash(oldImage)) {
                ++kept;
                QCOMPARE(watcher->status().state, RunState::Run);
                continue;
            }
            ++switched;
            QCOMPARE(watcher->status().state, RunState::Stop);
            QVERIFY(waitUntil([&] { return watcher->status().control == ControlHolder::Nobody; }));
            QVERIFY(take(*watcher));
            QVERIFY(good(answerOf<void>([&](auto r) { watcher->download(packageOf(oldImage), {}, r); })));
            QVERIFY(good(answerOf<void>([&](auto r) { watcher->run(r); })));
        }
        qInfo("%d kept the old program, %d had the new one", kept, switched);
        QVERIFY(kept >= Cuts / 3 && switched >= 1);
    }

    void aControllerKilledAfterAnyDiskWriteRestartsWithOldOrNew()
    {
        {
            auto session = open(0);
            QVERIFY(isOnline(*session) && take(*session));
            QVERIFY(good(answerOf<void>([&](auto r) { session->download(packageOf(oldImage), {}, r); })));
            files->log.clear();
        }
        const auto before = files->files;
        {
            auto session = open(0);
            QVERIFY(isOnline(*session) && waitUntil([&] { return session->status().control == ControlHolder::Nobody; }) && take(*session));
            QVERIFY(good(answerOf<void>([&](auto r) { session->download(packageOf(newImage), {}, r); })));
        }
        const auto operations = files->log;
        for (std::size_t steps = 0; steps <= operations.size(); ++steps) {
            MemoryFileSystem disk;
            disk.folders.insert("/data");
            disk.files = before;
            for (std::size_t i = 0; i < steps; ++i)
                disk.apply(operations[i]);
            TestController::Tasks tasks;
            ControllerHost again(HostOptions{"/data", 1}, disk, tasks);
            const Hash found = [&] {
                struct Keeper final : HostListener {
                    Hash program;
                    void onStatus(const ControllerStatus& status, ClientId) override { program = status.program; }
                    void onUpdate(ClientId, const message::Update&) override {}
                    void onSamples(ClientId, SampleBlock) override {}
                    void onBeat(ClientId, std::uint64_t) override {}
                    void onLog(const LogEntry&) override {}
                } keeper;
                again.setListener(&keeper);
                again.deliver();
                again.setListener(nullptr);
                return keeper.program;
            }();
            QVERIFY2(found == programHash(oldImage) || found == programHash(newImage), qPrintable(QString::number(steps)));
        }
    }
};

QTEST_GUILESS_MAIN(DownloadTest)
#include "tst_download.moc"
