#include "devices/protocol/codec.h"
#include "devices/protocol/framing.h"
#include "tests/core/storage/memoryfilesystem.h"
#include "tests/support/testcontroller.h"
#include "tests/support/waituntil.h"

#include <QTcpSocket>
#include <QtTest>

#include <memory>
#include <random>

using namespace camwright;
using test::TestController;

namespace {

/// A client written by hand: raw bytes and frames over a real socket.
struct RawClient {
    QTcpSocket socket;
    FrameReader frames{message::MaximumFrame};

    explicit RawClient(std::uint16_t port) { socket.connectToHost(QHostAddress::LocalHost, port); }
    void raw(const QByteArray& bytes) { socket.write(bytes); }
    void send(const Envelope& envelope)
    {
        const Bytes frame = frameOf(encode(envelope));
        socket.write(reinterpret_cast<const char*>(frame.data()), qint64(frame.size()));
    }
    std::optional<Envelope> next()
    {
        const QByteArray bytes = socket.readAll();
        frames.feed({reinterpret_cast<const std::uint8_t*>(bytes.constData()), std::size_t(bytes.size())});
        auto body = frames.next();
        if (!body || !*body)
            return std::nullopt;
        auto envelope = decode(**body);
        return envelope ? std::optional(*envelope) : std::nullopt;
    }
    /// The answer to a request, with everything pushed before it dropped.
    std::optional<Envelope> answer(std::uint32_t request)
    {
        std::optional<Envelope> found;
        (void)test::waitUntil([&] {
            while (auto envelope = next())
                if (envelope->request == request) {
                    found = envelope;
                    return true;
                }
            return false;
        });
        return found;
    }
    bool isClosed() { return test::waitUntil([&] { return socket.state() == QAbstractSocket::UnconnectedState; }); }
    bool shakeHands()
    {
        send({1, message::Hello{1, 0, "raw"}});
        if (!answer(1))
            return false;
        send({2, message::Authenticate{}});
        return answer(2).has_value();
    }
};

QByteArray lengthOf(quint32 length)
{
    QByteArray out(4, '\0');
    for (int i = 0; i < 4; ++i)
        out[i] = char(length >> (24 - 8 * i));
    return out;
}

} // namespace

/// The server against clients that break every rule.
class ServerTest : public QObject {
    Q_OBJECT

private:
    std::unique_ptr<MemoryFileSystem> files;
    std::unique_ptr<TestController> controller;

    void open(ServerOptions options = {})
    {
        files = std::make_unique<MemoryFileSystem>();
        controller = std::make_unique<TestController>(*files, "", std::move(options));
        QVERIFY(controller->server.listen("127.0.0.1:0").ok());
    }
    bool logged(Code code)
    {
        return test::waitUntil([&] {
            for (const LogEntry& entry : controller->host.log(0).entries)
                if (entry.message.code == code)
                    return true;
            return false;
        });
    }

private slots:
    void init() { open(); }
    void cleanup() { controller.reset(); }

    void listensOnThisMachineOnly()
    {
        Server& server = controller->server;
        for (const char* address : {"0.0.0.0:0", "192.168.1.2:17402", "[::]:0"})
            QCOMPARE(server.listen(address).error().code, Code::ListenNotLocal);
        for (const char* address : {"", "17402", "nonsense:1", "127.0.0.1:99999"})
            QCOMPARE(server.listen(address).error().code, Code::ListenFailed);
        QVERIFY(server.listen("[::1]:0").ok() || true); // a machine without IPv6 may refuse
    }

    void strangersAreClosedWithAReasonInTheLog_data()
    {
        QTest::addColumn<QByteArray>("bytes");
        QTest::newRow("HTTP") << QByteArray("GET / HTTP/1.1\r\nHost: x\r\n\r\n");
        QTest::newRow("TLS hello") << QByteArray::fromHex("1603010200010001fc0303");
        QTest::newRow("huge length") << lengthOf(0xFFFFFFFF);
        QTest::newRow("beyond the handshake's limit") << lengthOf(2000) + QByteArray(2000, 'x');
        QTest::newRow("length 0") << lengthOf(0);
        QTest::newRow("no CBOR") << lengthOf(4) + QByteArray("\xff\xff\xff\xff", 4);
        QTest::newRow("unknown message") << lengthOf(6) + QByteArray::fromHex("831903e701a0");
    }

    void strangersAreClosedWithAReasonInTheLog()
    {
        QFETCH(QByteArray, bytes);
        RawClient client(controller->server.port());
        client.raw(bytes);
        QVERIFY(client.isClosed());
        QVERIFY(logged(Code::PeerDropped));
        QTRY_COMPARE(controller->server.clientCount(), std::size_t(0));
    }

    void messagesBeforeTheHandshakeAreAViolationButStopIsNot()
    {
        RawClient client(controller->server.port());
        client.send({5, message::StopAll{}});
        const auto stopped = client.answer(5);
        QVERIFY(stopped && std::holds_alternative<message::Done>(stopped->message));
        client.send({6, message::Run{}});
        QVERIFY(client.isClosed());
    }

    void anotherMajorVersionIsToldWhy()
    {
        RawClient client(controller->server.port());
        client.send({1, message::Hello{9, 0, "future"}});
        const auto reply = client.answer(0);
        QVERIFY(reply);
        QCOMPARE(std::get<message::Failed>(reply->message).reason.code, Code::ProtocolVersion);
        QVERIFY(client.isClosed());
    }

    void silenceInTheHandshakeIsClosed()
    {
        ServerOptions options;
        options.handshakeTime = 200ms;
        controller.reset();
        open(options);
        RawClient mute(controller->server.port());
        RawClient half(controller->server.port());
        half.raw(lengthOf(100) + QByteArray(10, '\x83'));
        QVERIFY(mute.isClosed());
        QVERIFY(half.isClosed());
    }

    void halfAFrameAfterTheHandshakeIsClosedToo()
    {
        ServerOptions options;
        options.silence = 300ms;
        controller.reset();
        open(options);
        RawClient client(controller->server.port());
        QVERIFY(client.shakeHands());
        client.raw(lengthOf(60'000) + QByteArray(10, '\x83'));
        QVERIFY(client.isClosed());
        QVERIFY(logged(Code::PeerDropped));
    }

    void messagesOfAControllerAreRefused()
    {
        RawClient client(controller->server.port());
        QVERIFY(client.shakeHands());
        client.send({9, message::Beat{1}});
        QVERIFY(client.isClosed());
    }

    void moreClientsThanAllowedAreToldWhy()
    {
        ServerOptions options;
        options.maximumClients = 2;
        controller.reset();
        open(options);
        RawClient a(controller->server.port()), b(controller->server.port());
        QVERIFY(a.shakeHands() && b.shakeHands());
        RawClient c(controller->server.port());
        const auto reply = c.answer(0);
        QVERIFY(reply);
        QCOMPARE(std::get<message::Failed>(reply->message).reason.code, Code::TooManyClients);
    }

    void everyMessageWithoutControlIsRefusedWhenItNeedsIt()
    {
        RawClient client(controller->server.port());
        QVERIFY(client.shakeHands());
        std::uint32_t request = 10;
        const Value value = Value::ofBool(true);
        for (const Message& message : std::vector<Message>{message::Run{}, message::Stop{}, message::Exit{}, message::Write{{}, "a", value},
                 message::Force{{}, "a", value}, message::Release{{}, "a"}, message::BeginDownload{10, {}, {}},
                 message::Axis{{"Feed", AxisCommandKind::Jog, 0, 1, 0}}}) {
            client.send({++request, message});
            const auto reply = client.answer(request);
            QVERIFY(reply);
            QCOMPARE(std::get<message::Failed>(reply->message).reason.code, Code::ControlNeeded);
        }
    }

    void piecesOutOfOrderOrBeyondTheSizeDropTheDownload()
    {
        RawClient client(controller->server.port());
        QVERIFY(client.shakeHands());
        std::uint32_t request = 10;
        const auto ask = [&](Message message) {
            client.send({++request, std::move(message)});
            const auto reply = client.answer(request);
            const auto* failed = reply ? std::get_if<message::Failed>(&reply->message) : nullptr;
            return failed ? failed->reason.code : Code::InternalError;
        };
        const auto begin = [&] {
            client.send({++request, message::BeginDownload{100, {}, {}}});
            return std::get<message::DownloadBegun>(client.answer(request)->message).transfer;
        };
        QCOMPARE(ask(message::TakeControl{}), Code::InternalError);
        QCOMPARE(ask(message::BeginDownload{std::uint64_t(1) << 40, {}, {}}), Code::ImageTooLarge);
        QCOMPARE(ask(message::Piece{begin(), 5, Bytes(10, 1)}), Code::PieceMisplaced);
        QCOMPARE(ask(message::Piece{begin(), 0, Bytes(101, 1)}), Code::PieceMisplaced);
        const std::uint32_t transfer = begin();
        QCOMPARE(ask(message::Piece{transfer, 0, Bytes(50, 1)}), Code::InternalError);
        QCOMPARE(ask(message::CommitDownload{transfer}), Code::PieceMisplaced);
        const std::uint32_t whole = begin();
        QCOMPARE(ask(message::Piece{whole, 0, Bytes(100, 1)}), Code::InternalError);
        client.send({0, message::RenewControl{}});
        QCOMPARE(ask(message::CommitDownload{whole}), Code::ImageDamaged);
        QCOMPARE(ask(message::CommitDownload{whole}), Code::TransferUnknown);
    }

    void aFloodIsServedSlowlyAndTheOthersAtOnce()
    {
        ServerOptions options;
        options.messagesPerSecond = 200;
        controller.reset();
        open(options);
        RawClient flooder(controller->server.port()), honest(controller->server.port());
        QVERIFY(flooder.shakeHands() && honest.shakeHands());
        for (std::uint32_t i = 0; i < 5000; ++i)
            flooder.send({100 + i, message::Ping{}});
        const std::uint64_t before = std::uint64_t(controller->now / 1ms);
        honest.send({7, message::Ping{}});
        QVERIFY(honest.answer(7));
        const std::uint64_t cycles = std::uint64_t(controller->now / 1ms) - before;
        int served = 0;
        while (auto envelope = flooder.next())
            served += std::holds_alternative<message::Pong>(envelope->message) ? 1 : 0;
        QVERIFY2(served < 3000, qPrintable(QString("%1 in %2 cycles").arg(served).arg(cycles)));
        QCOMPARE(controller->server.clientCount(), std::size_t(2));
    }

    void hostileClientsNeverDisturbAnHonestOne()
    {
        RawClient honest(controller->server.port());
        QVERIFY(honest.shakeHands());
        std::mt19937 random(5);
        for (std::uint32_t round = 0; round < 60; ++round) {
            RawClient hostile(controller->server.port());
            if (round % 2 == 0)
                QVERIFY(hostile.shakeHands());
            QByteArray bytes(1 + int(random() % 3000), '\0');
            for (char& byte : bytes)
                byte = char(random());
            if (round % 3 == 0) // framed, so that the decoder gets it
                bytes = lengthOf(quint32(bytes.size() % 1000 + 1)) + bytes;
            hostile.raw(bytes);
            honest.send({1000 + round, message::Ping{}});
            QVERIFY(honest.answer(1000 + round));
        }
    }

    void aLongManifestInPartsGetsOnePlan()
    {
        RawClient client(controller->server.port());
        QVERIFY(client.shakeHands());
        Manifest manifest;
        manifest.program.bytes.fill(1);
        for (int i = 0; i < 300; ++i)
            manifest.parts.push_back({PartKind::Program, "P" + std::to_string(i), {}});
        client.send({0, message::PlanDownload{manifest, true}});
        manifest.parts.resize(10);
        client.send({20, message::PlanDownload{manifest, false}});
        const auto reply = client.answer(20);
        QVERIFY(reply);
        QCOMPARE(std::get<message::Plan>(reply->message).plan.lines.size(), message::PlanLines);
    }
};

QTEST_GUILESS_MAIN(ServerTest)
#include "tst_server.moc"
