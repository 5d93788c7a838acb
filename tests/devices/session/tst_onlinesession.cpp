#include "tests/devices/session/sessionrig.h"

#include <QTcpServer>
#include <QTcpSocket>

using namespace camwright;
using namespace camwright::test;
using camwright::message::StopAll;

/// Sessions over real sockets against a real server and the real engine.
class OnlineSessionTest : public QObject {
    Q_OBJECT

private:
    std::unique_ptr<MemoryFileSystem> files;
    std::unique_ptr<TestController> controller;
    QtExecutor executor;
    const ControllerImage image = feederImage();

    std::string address() const { return "tcp://127.0.0.1:" + std::to_string(controller->server.port()); }
    std::unique_ptr<OnlineSession> open(const std::string& name, bool reconnect = true)
    {
        ConnectOptions options;
        options.client = name;
        options.reconnect = reconnect;
        auto session = connectTo(address(), "", executor, options);
        return session ? std::move(*session) : nullptr;
    }
    std::unique_ptr<OnlineSession> online(const std::string& name)
    {
        auto session = open(name);
        return session && waitUntil([&] { return session->state() == LinkState::Online; }) ? std::move(session) : nullptr;
    }
    bool take(OnlineSession& session)
    {
        return good(answerOf<void>([&](auto reply) { session.takeControl(reply); }));
    }
    bool download(OnlineSession& session, const ControllerImage& next)
    {
        return good(answerOf<void>([&](auto reply) { session.download(packageOf(next), {}, reply); }))
            && waitUntil([&] { return session.status().program == programHash(next); });
    }
    /// In control, with the program, its drives on the bus, and running if asked.
    std::unique_ptr<OnlineSession> ready(bool run)
    {
        auto session = online("anna");
        if (!session || !take(*session) || !download(*session, image))
            return nullptr;
        controller->skip(1500); // the drives come up on the bus
        if (!waitUntil([&] { return session->status().axes.size() == 2 && session->status().axes[0].online; }))
            return nullptr;
        if (run && !good(answerOf<void>([&](auto reply) { session->run(reply); })))
            return nullptr;
        return session;
    }

private slots:
    void init()
    {
        files = std::make_unique<MemoryFileSystem>();
        controller = std::make_unique<TestController>(*files);
        QVERIFY(controller->server.listen("127.0.0.1:0").ok());
    }
    void cleanup() { controller.reset(); }

    void addressesAreUnderstoodOrRefusedWithASentence_data()
    {
        QTest::addColumn<QString>("address");
        QTest::addColumn<QString>("code");
        for (const char* bad : {"", "tcp://", "tcp://:17402", "tcp://host:0", "tcp://host:99999", "tcp://host:17x", "tcp://a/b", "Local", "17402"})
            QTest::newRow(bad) << bad << "CW7002";
        for (const char* later : {"tls://host", "serial:/dev/ttyS0", "modbus-tcp://h?unit=1", "can:socketcan/can0", "ethercat:eth0"})
            QTest::newRow(later) << later << "CW7003";
    }
    void addressesAreUnderstoodOrRefusedWithASentence()
    {
        QFETCH(QString, address);
        QFETCH(QString, code);
        const auto session = connectTo(address.toStdString(), "", executor);
        QVERIFY(!session.ok());
        QCOMPARE(QString::fromUtf8(codeInfo(session.error().code).id.data()).left(6), code);
    }

    void nobodyAnsweringIsOfflineWithTheReason()
    {
        const std::string nowhere = address();
        controller.reset();
        auto session = connectTo(nowhere, "", executor);
        QVERIFY(session.ok());
        QCOMPARE((*session)->state(), LinkState::Connecting);
        Diagnostic why;
        (*session)->onStateChanged([&](LinkState, const Diagnostic& reason) { why = reason; });
        QVERIFY(waitUntil([&] { return (*session)->state() == LinkState::Offline; }));
        QTRY_COMPARE(why.code, Code::CannotConnect);
    }

    void itComesOnlineWithStatusAndCapabilities()
    {
        auto session = online("anna");
        QVERIFY(session);
        QVERIFY(session->capabilities().download && session->capabilities().simulated);
        QVERIFY(session->status().program.isNull());
        std::uint64_t pushed = 0;
        session->onStatus([&](const ControllerStatus& status) { pushed = status.cycle; });
        QVERIFY(waitUntil([&] { return pushed > 100; }));
    }

    void downloadRunReadWriteForce()
    {
        auto session = ready(true);
        QVERIFY(session);
        QVERIFY(waitUntil([&] { return session->status().state == RunState::Run; }));
        const auto types = answerOf<std::vector<DataType>>([&](auto r) { session->describe({"%VD0", "axis.Feed.position", "%Q0.0"}, r); });
        QVERIFY(types && types->ok());
        QCOMPARE(**types, (std::vector{DataType::Dint, DataType::Lreal, DataType::Bool}));
        QVERIFY(good(answerOf<void>([&](auto r) { session->write("%I0.0", Value::ofBool(true), r); })));
        const auto lamp = [&] {
            const auto read = answerOf<std::vector<MonitoredValue>>([&](auto r) { session->read({"%Q0.0"}, r); });
            return read && read->ok() && (**read)[0].value.asBool();
        };
        QVERIFY2(waitUntil(lamp), "the terminal that was switched reaches the output");
        QVERIFY(good(answerOf<void>([&](auto r) { session->force("%Q0.0", Value::ofBool(false), r); })));
        QVERIFY(waitUntil([&] { return session->status().forces == 1 && !lamp(); }));
        const auto forced = answerOf<std::vector<MonitoredValue>>([&](auto r) { session->forced(r); });
        QVERIFY(forced && forced->ok() && (*forced)->size() == 1 && (**forced)[0].forced);
        QVERIFY(good(answerOf<void>([&](auto r) { session->release("", r); })));
        QVERIFY(waitUntil([&] { return session->status().forces == 0 && lamp(); }));
        const auto terminals = answerOf<std::vector<TerminalInfo>>([&](auto r) { session->terminals(r); });
        QVERIFY(terminals && terminals->ok() && !(*terminals)->empty());
        const auto unknown = answerOf<std::vector<MonitoredValue>>([&](auto r) { session->read({"%NOTHING1"}, r); });
        QVERIFY(unknown && !unknown->ok());
        QVERIFY(englishText(unknown->error()).find("NOTHING") != std::string::npos);
    }

    void aSecondClientIsRefusedControlAndMayWatch()
    {
        auto anna = ready(true);
        QVERIFY(anna);
        auto bert = online("bert");
        QVERIFY(bert);
        const auto refused = answerOf<void>([&](auto r) { bert->takeControl(r); });
        QCOMPARE(codeOf(refused), Code::ControlHeld);
        QCOMPARE(refused->error().arguments.at(0), std::string("anna"));
        QCOMPARE(codeOf(answerOf<void>([&](auto r) { bert->run(r); })), Code::ControlHeld);
        QVERIFY(waitUntil([&] { return bert->status().control == ControlHolder::Somebody && bert->status().controlOwner == "anna"; }));
        QVERIFY(waitUntil([&] { return anna->status().control == ControlHolder::You; }));
        int updates = 0;
        bert->subscribe({"%VD0", "axis.Feed.position"}, 20ms, [&](const MonitorUpdate& update) { updates += update.values.size() == 2; });
        QVERIFY(waitUntil([&] { return updates > 5; }));
        QVERIFY(good(answerOf<void>([&](auto r) { bert->stopAllAxes(r); }))); // stop is for everyone
        anna.reset();
        QVERIFY(waitUntil([&] { return bert->status().control == ControlHolder::Nobody; }));
        QVERIFY(take(*bert));
    }

    void monitoredValuesAreOfOneScanAndFollowTheProgram()
    {
        auto session = ready(true);
        QVERIFY(session);
        int updates = 0, torn = 0;
        session->subscribe({"%VD0", "%VD4", "%UNKNOWN1"}, 10ms, [&](const MonitorUpdate& update) {
            ++updates;
            torn += update.values.size() != 2 || update.values[0].value != update.values[1].value;
        });
        QVERIFY(waitUntil([&] { return updates > 100; }));
        QVERIFY(download(*session, feederImage(7)));
        updates = 0;
        QVERIFY2(waitUntil([&] { return updates > 3; }), "the subscription goes on against the new program");
        QCOMPARE(torn, 0);
    }

    void aRequestForAnotherProgramIsRefused()
    {
        auto anna = ready(true);
        auto bert = online("bert");
        QVERIFY(anna && bert);
        QVERIFY(waitUntil([&] { return bert->status().program == programHash(image); }));
        // Bert asks with the hash he knows while Anna's download is already through on the controller.
        std::optional<Result<void>> downloaded;
        anna->download(packageOf(feederImage(3)), {}, [&](Result<void> r) { downloaded.emplace(std::move(r)); });
        bool refused = false;
        QVERIFY(waitUntil([&] {
            bert->read({"%VD0"}, [&](Result<std::vector<MonitoredValue>> r) { refused = refused || (!r && r.error().code == Code::OtherProgram); });
            return downloaded.has_value();
        }));
        QVERIFY(downloaded->ok());
        QVERIFY(waitUntil([&] { return bert->status().program == programHash(feederImage(3)); }));
        // Whether the race was hit depends on the moment; that the hash decides is shown by the host's tests.
    }

    void everyRequestEndsOnceAndNeverAfterCancelOrDestruction()
    {
        auto session = online("anna");
        QVERIFY(session);
        int ended = 0, wrong = 0;
        for (int i = 0; i < 200; ++i) {
            const RequestId id = session->log(0, [&, i](Result<std::vector<LogEntry>>) { ++(i % 2 == 0 ? ended : wrong); });
            if (i % 2 == 1)
                session->cancel(id);
        }
        QVERIFY(waitUntil([&] { return ended == 100; }));
        session->log(0, [&](Result<std::vector<LogEntry>>) { ++wrong; });
        session.reset();
        QTest::qWait(50); // nothing to wait for: it must not happen
        QCOMPARE(ended, 100);
        QCOMPARE(wrong, 0);
    }

    void aControllerThatStandsStillGivesATimeOut()
    {
        auto stream = std::make_unique<MemoryConnector>(*controller, 0);
        SessionOptions options;
        options.requestTimeout = 400ms;
        OnlineSession session(std::move(stream), executor, options);
        QVERIFY(waitUntil([&] { return session.state() == LinkState::Online; }));
        controller->pause(); // sockets still answer, the engine does not
        const auto result = answerOf<void>([&](auto r) { session.takeControl(r); });
        QCOMPARE(codeOf(result), Code::RequestTimedOut);
        QCOMPARE(session.state(), LinkState::Online);
    }

    void aLostLinkFailsRequestsComesBackAndRestoresOnlyWhatIsSafe()
    {
        auto session = ready(true);
        QVERIFY(session);
        int updates = 0;
        session->subscribe({"%VD0"}, 20ms, [&](const MonitorUpdate&) { ++updates; });
        QVERIFY(waitUntil([&] { return updates > 0; }));
        std::vector<LinkState> states;
        session->onStateChanged([&](LinkState state, const Diagnostic&) { states.push_back(state); });
        controller->pause();
        std::optional<Result<void>> waiting;
        session->run([&](Result<void> r) { waiting.emplace(std::move(r)); });
        controller->server.closeAll();
        QVERIFY(waitUntil([&] { return waiting.has_value(); }));
        QCOMPARE(codeOf(waiting), Code::LinkLost);
        QCOMPARE(session->state(), LinkState::Lost);
        QCOMPARE(codeOf(answerOf<void>([&](auto r) { session->run(r); })), Code::NotConnected);
        controller->resume();
        updates = 0;
        QVERIFY(waitUntil([&] { return session->state() == LinkState::Online && updates > 0; }));
        QVERIFY(waitUntil([&] { return session->status().control == ControlHolder::Nobody; }));
        QCOMPARE(codeOf(answerOf<void>([&](auto r) { session->run(r); })), Code::ControlNeeded);
        QCOMPARE(states, (std::vector{LinkState::Lost, LinkState::Online}));
    }

    void traceIsCompleteAndInOrder()
    {
        auto session = ready(true);
        QVERIFY(session);
        TraceSetup setup;
        setup.channels = {"%VD0", "axis.Feed.position"};
        setup.samples = 2000;
        std::vector<SampleBlock> blocks;
        QVERIFY(good(answerOf<void>([&](auto r) {
            session->startTrace(setup, [&](const SampleBlock& block) { blocks.push_back(block); }, r);
        })));
        QVERIFY(waitUntil([&] { return !blocks.empty() && blocks.back().last; }));
        std::size_t rows = 0;
        for (std::size_t i = 0; i < blocks.size(); ++i) {
            QCOMPARE(blocks[i].sequence, std::uint64_t(i));
            QCOMPARE(blocks[i].lostRows, std::uint64_t(0));
            QCOMPARE(blocks[i].firstCycle, blocks[0].firstCycle + rows);
            rows += blocks[i].columns.at(0).size();
        }
        QCOMPARE(rows, std::size_t(2000));
        QCOMPARE(blocks[0].channels.at(1).unit, std::string("mm"));
        auto bert = online("bert");
        QVERIFY(good(answerOf<void>([&](auto r) { bert->startTrace(setup, {}, r); })));
        QCOMPARE(codeOf(answerOf<void>([&](auto r) { session->startTrace(setup, {}, r); })), Code::TraceBusy);
    }

    void aJogRunsWithHeartbeatsAndStopsByTheRuleWhenTheSocketDrops()
    {
        auto watcher = online("watcher");
        auto session = ready(false);
        QVERIFY(watcher && session);
        std::vector<LogEntry> log;
        watcher->onLog([&](const LogEntry& entry) { log.push_back(entry); });
        const auto command = [&](AxisCommandKind kind, double velocity = 0) {
            return good(answerOf<void>([&](auto r) { session->command({"Feed", kind, 0, velocity, 0}, r); }));
        };
        QTimer beats; // as a held button would: alive as long as this event loop is
        QObject::connect(&beats, &QTimer::timeout, &beats, [&] { session->heartbeat(); });
        beats.start(5);
        const auto feed = [&]() -> const AxisStatus& { return watcher->status().axes.at(0); };
        QVERIFY(command(AxisCommandKind::Arm));
        QVERIFY(command(AxisCommandKind::Enable));
        QVERIFY(waitUntil([&] { return watcher->status().axes.size() == 2 && feed().enabled; }));
        QVERIFY(command(AxisCommandKind::Jog, 40));
        QVERIFY(waitUntil([&] { return feed().moving && std::abs(feed().velocity - 40) < 2; }));
        QVERIFY2(waitUntil([&] { return feed().position > 30; }), "it goes on while heartbeats come");
        beats.stop();
        session.reset(); // the process is gone
        const LogEntry* stop = nullptr;
        QVERIFY(waitUntil([&] {
            for (const LogEntry& entry : log)
                if (entry.message.code == Code::DeadManStop)
                    stop = &entry;
            return stop != nullptr;
        }));
        const std::uint64_t last = std::stoull(stop->message.arguments.at(1)), at = std::stoull(stop->message.arguments.at(2));
        QVERIFY2(at - last <= 101, qPrintable(QString("%1 cycles").arg(at - last)));
        QVERIFY(waitUntil([&] { return !feed().moving && !feed().panelArmed; }));
        QVERIFY2(feed().enabled, "power stays on");
    }

    void strangersThatAnswerAreNamedAndNeverCrashUs_data()
    {
        QTest::addColumn<QByteArray>("answer");
        QTest::newRow("HTTP") << QByteArray("HTTP/1.1 400 Bad Request\r\n\r\n");
        QTest::newRow("huge length") << QByteArray::fromHex("ffffffff");
        QTest::newRow("no CBOR") << QByteArray::fromHex("00000002ffff");
        QTest::newRow("deep nesting") << QByteArray::fromHex("00000400") + QByteArray(1024, '\x81');
        QTest::newRow("the wrong answer") << QByteArray::fromHex("00000004830501a0");
    }
    void strangersThatAnswerAreNamedAndNeverCrashUs()
    {
        QFETCH(QByteArray, answer);
        QTcpServer stranger;
        QVERIFY(stranger.listen(QHostAddress::LocalHost));
        QObject::connect(&stranger, &QTcpServer::newConnection, &stranger, [&] { stranger.nextPendingConnection()->write(answer); });
        auto session = connectTo("tcp://127.0.0.1:" + std::to_string(stranger.serverPort()), "", executor);
        QVERIFY(session.ok());
        Diagnostic why;
        (*session)->onStateChanged([&](LinkState, const Diagnostic& reason) { why = reason; });
        QVERIFY(waitUntil([&] { return (*session)->state() == LinkState::Offline; }));
        QTRY_COMPARE(why.code, Code::ProtocolBroken);
    }
};

QTEST_GUILESS_MAIN(OnlineSessionTest)
#include "tst_onlinesession.moc"
