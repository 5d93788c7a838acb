#include "devices/protocol/codec.h"
#include "devices/transport/memorystream.h"
#include "devices/transport/messagechannel.h"
#include "devices/transport/socketstream.h"

#include <QTcpServer>
#include <QTcpSocket>
#include <QtTest>

using namespace camwright;

namespace {

/// A stream whose system takes bytes only when told to.
class SlowStream final : public ByteStream {
    Q_OBJECT
public:
    void write(ByteSpan bytes) override { m_held.insert(m_held.end(), bytes.begin(), bytes.end()); }
    std::size_t waiting() const override { return m_held.size(); }
    Bytes read(std::size_t) override { return {}; }
    void close() override {}
    QString peer() const override { return {}; }
    Bytes takeAll()
    {
        Bytes out = std::move(m_held);
        m_held.clear();
        emit written();
        return out;
    }

private:
    Bytes m_held;
};

struct Side {
    std::vector<Envelope> got;
    std::string reason;
    bool ended = false, broken = false;
    std::unique_ptr<MessageChannel> channel;

    void open(std::unique_ptr<ByteStream> stream, std::size_t limit = message::MaximumFrame)
    {
        channel = std::make_unique<MessageChannel>(std::move(stream), MessageChannel::Listener{
            [this](const Envelope& e) { got.push_back(e); },
            [this](const std::string& why, bool b) { ended = true; reason = why; broken = b; }, {}}, limit);
    }
};

} // namespace

class MessageChannelTest : public QObject {
    Q_OBJECT

private slots:
    void messagesArriveInOrder()
    {
        auto [a, b] = MemoryStream::pair();
        Side left, right;
        left.open(std::move(a));
        right.open(std::move(b));
        for (std::uint32_t i = 1; i <= 500; ++i)
            left.channel->send({i, message::Ping{}});
        QTRY_COMPARE(right.got.size(), std::size_t(500));
        for (std::uint32_t i = 1; i <= 500; ++i)
            QCOMPARE(right.got[i - 1].request, i);
    }

    void urgentMessagesOvertakeBulk()
    {
        auto stream = std::make_unique<SlowStream>();
        SlowStream& slow = *stream;
        Side side;
        side.open(std::move(stream));
        for (int i = 0; i < 10; ++i)
            side.channel->send({0, message::Piece{1, 0, Bytes(16 * 1024, 5)}});
        side.channel->send({77, message::StopAll{}});
        FrameReader frames(message::MaximumFrame);
        frames.feed(slow.takeAll()); // what the system had already
        frames.feed(slow.takeAll()); // the next bytes
        auto first = frames.next();
        QVERIFY(std::holds_alternative<message::Piece>(decode(**first)->message));
        auto second = frames.next();
        QVERIFY2(std::holds_alternative<message::StopAll>(decode(**second)->message), "stop was not next");
    }

    void bytesThatAreNoMessageEndTheChannelWithTheReason()
    {
        auto [a, b] = MemoryStream::pair();
        Side right;
        right.open(std::move(b));
        a->write(Bytes{'G', 'E', 'T', ' ', '/', '\r', '\n'});
        QTRY_VERIFY(right.ended);
        QVERIFY(right.broken);
        QCOMPARE(right.reason, std::string("a frame of 1195725856 bytes, where 1 to 65536 are allowed"));
    }

    void whatCameBeforeTheEndStillCounts()
    {
        auto [a, b] = MemoryStream::pair();
        Side left, right;
        left.open(std::move(a));
        right.open(std::move(b));
        left.channel->send({1, message::Ping{}});
        left.channel.reset();
        QTRY_VERIFY(right.ended);
        QCOMPARE(right.got.size(), std::size_t(1));
        QVERIFY(!right.broken);
    }

    void aPausedChannelReadsNothing()
    {
        auto [a, b] = MemoryStream::pair();
        Side left, right;
        left.open(std::move(a));
        right.open(std::move(b));
        right.channel->setPaused(true);
        left.channel->send({1, message::Ping{}});
        QCoreApplication::processEvents();
        QVERIFY(right.got.empty());
        right.channel->setPaused(false);
        QTRY_COMPARE(right.got.size(), std::size_t(1));
    }

    void realSocketsCarryIt()
    {
        QTcpServer server;
        QVERIFY(server.listen(QHostAddress::LocalHost));
        auto client = std::make_unique<QTcpSocket>();
        client->connectToHost(QHostAddress::LocalHost, server.serverPort());
        QTRY_VERIFY(server.hasPendingConnections() && client->state() == QAbstractSocket::ConnectedState);
        std::unique_ptr<QTcpSocket> accepted(server.nextPendingConnection());
        accepted->setParent(nullptr);
        Side left, right;
        left.open(std::make_unique<SocketStream>(std::move(client)));
        right.open(std::make_unique<SocketStream>(std::move(accepted)));
        for (std::uint32_t i = 1; i <= 200; ++i)
            left.channel->send({i, message::Piece{1, i, Bytes(16 * 1024, 1)}});
        QTRY_COMPARE_WITH_TIMEOUT(right.got.size(), std::size_t(200), 20000);
        left.channel.reset();
        QTRY_VERIFY(right.ended);
    }
};

QTEST_GUILESS_MAIN(MessageChannelTest)
#include "tst_messagechannel.moc"
