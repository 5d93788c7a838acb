#include "devices/protocol/codec.h"
#include "tests/devices/protocol/samples.h"

#include <QtTest>

#include <random>

using namespace camwright;

/// The encoder and the decoder, against each other and against bytes written by hand.
class CodecTest : public QObject {
    Q_OBJECT

private slots:
    void eachMessageComesBackWhole()
    {
        const std::vector<Message> all = samples::all();
        QCOMPARE(all.size(), std::variant_size_v<Message>);
        for (std::size_t i = 0; i < all.size(); ++i) {
            QCOMPARE(all[i].index(), i);
            const Envelope sent{static_cast<std::uint32_t>(i + 1), all[i]};
            const auto back = decode(encode(sent));
            QVERIFY2(back.ok(), back.ok() ? "" : back.error().c_str());
            QVERIFY2(*back == sent, messageRules()[i].name);
        }
    }

    void eachMessageCutAnywhereIsRefused()
    {
        for (const Message& message : samples::all()) {
            const Bytes whole = encode({1, message});
            for (std::size_t size = 0; size < whole.size(); ++size)
                QVERIFY2(!decode(ByteSpan(whole).first(size)).ok(),
                         qPrintable(QString("%1 %2 of %3").arg(messageRules()[message.index()].name).arg(size).arg(whole.size())));
        }
    }

    void damagedBytesNeverDoHarm()
    {
        std::mt19937 random(1);
        for (const Message& message : samples::all()) {
            const Bytes whole = encode({1, message});
            for (std::size_t i = 0; i < whole.size(); ++i) {
                for (const std::uint8_t byte : {0x00, 0x1B, 0x3B, 0x5B, 0x7B, 0x7F, 0x9B, 0x9F, 0xBB, 0xBF, 0xFB, 0xFF}) {
                    Bytes damaged = whole;
                    damaged[i] = byte;
                    (void)decode(damaged);
                }
                Bytes damaged = whole;
                damaged[i] = static_cast<std::uint8_t>(random());
                if (const auto back = decode(damaged))
                    (void)decode(encode(*back));
            }
        }
    }

    void malformedBodiesAreRefused_data()
    {
        QTest::addColumn<QByteArray>("hex");
        QTest::addColumn<QString>("reason");
        QTest::newRow("empty") << QByteArray("") << "a message of no length or beyond the limit";
        QTest::newRow("no array") << QByteArray("01") << "no list of the right length where one is due";
        QTest::newRow("array of two") << QByteArray("820700") << "no list of the right length where one is due";
        QTest::newRow("array of unknown length") << QByteArray("9f0700a0ff") << "no list of the right length where one is due";
        QTest::newRow("unknown number") << QByteArray("831903e700a0") << "a message with the unknown number 999";
        QTest::newRow("number too large") << QByteArray("831a0001000000a0") << "a number out of range";
        QTest::newRow("negative request") << QByteArray("830720a0") << "no whole number where one is due";
        QTest::newRow("text for a request") << QByteArray("83076130a0") << "no whole number where one is due";
        QTest::newRow("list for a map") << QByteArray("83070080") << "no map of known length where one is due, in message 7";
        QTest::newRow("map of unknown length") << QByteArray("830700bfff") << "no map of known length where one is due, in message 7";
        QTest::newRow("bytes left over") << QByteArray("830700a000") << "bytes after message 7";
        QTest::newRow("missing field") << QByteArray("83181c00a10101") << "a missing field, in message 28";
        QTest::newRow("field twice") << QByteArray("83181f00a201010102") << "a field that stands twice, in message 31";
        QTest::newRow("text with a huge length") << QByteArray("830300a1017bffffffffffffffff")
                                                 << "a text that is longer than the message, in message 3";
        QTest::newRow("bytes with a huge length") << QByteArray("83181c00a3010102000" "35b7fffffffffffffff")
                                                  << "bytes that are longer than the message, in message 28";
        QTest::newRow("list with a huge length") << QByteArray("83183000a2014002" "9b7fffffffffffffff")
                                                 << "a list that is too long, in message 48";
        QTest::newRow("list longer than the message") << QByteArray("83183000a2014002" "9903e8")
                                                      << "a list that is too long, in message 48";
        QTest::newRow("no UTF-8") << QByteArray("830300a10162c328") << "a text that is no UTF-8, in message 3";
        QTest::newRow("digest of 3 bytes") << QByteArray("83183000a20143010203" "0280")
                                           << "a digest that has neither 0 nor 32 bytes, in message 48";
        QTest::newRow("unknown axis command") << QByteArray("83184800a101a2016141" "020b")
                                              << "a choice that does not exist, in message 72";
        QTest::newRow("BOOL of 2") << QByteArray("83183200a3014002614103820102") << "a value wider than its type, in message 50";
        QTest::newRow("data type 0") << QByteArray("83183200a3014002614103820000") << "a choice that does not exist, in message 50";
    }

    void malformedBodiesAreRefused()
    {
        QFETCH(QByteArray, hex);
        QFETCH(QString, reason);
        const QByteArray raw = QByteArray::fromHex(hex);
        const auto result = decode(Bytes(raw.begin(), raw.end()));
        QVERIFY(!result.ok());
        QCOMPARE(QString::fromStdString(result.error()), reason);
    }

    void deepNestingIsRefused()
    {
        Bytes body{0x83, 0x07, 0x00, 0xA1, 0x18, 0x32};
        body.insert(body.end(), 1000, 0x81);
        body.push_back(0x00);
        QVERIFY(!decode(body).ok());
    }

    void fieldsOfALaterReleaseAreSkipped()
    {
        // abortDownload with field 40 = [1, {2: "x"}] besides field 1
        const QByteArray raw = QByteArray::fromHex("83181f05a2" "182882" "01a1026178" "0107");
        const auto result = decode(Bytes(raw.begin(), raw.end()));
        QVERIFY(result.ok());
        QCOMPARE(std::get<message::AbortDownload>(result->message).transfer, 7u);
        QCOMPARE(result->request, 5u);
    }

    void aCodeOfALaterReleaseKeepsItsNumberAndArguments()
    {
        const QByteArray raw = QByteArray::fromHex("830601a101a2" "0166435739393939" "028261616162");
        const auto result = decode(Bytes(raw.begin(), raw.end()));
        QVERIFY(result.ok());
        QCOMPARE(englishText(std::get<message::Failed>(result->message).reason), std::string("The controller reports CW9999: a, b"));
    }

    void theExampleOfTheDocumentIsTrue()
    {
        const Bytes body = encode({4, message::Axis{{"Feed", AxisCommandKind::Jog, 0, -10, 0}}});
        const QByteArray hex = QByteArray(reinterpret_cast<const char*>(body.data()), qsizetype(body.size())).toHex(' ');
        QFile file(CAMWRIGHT_SOURCE_DIR "/docs/protocol.md");
        QVERIFY(file.open(QIODevice::ReadOnly));
        QVERIFY2(file.readAll().contains(hex), hex.constData());
    }

    void theDocumentNamesEveryMessageWithItsNumber()
    {
        QFile file(CAMWRIGHT_SOURCE_DIR "/docs/protocol.md");
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray text = file.readAll();
        for (const MessageRule& rule : messageRules()) {
            const QByteArray row = "| " + QByteArray::number(int(rule.type)) + " | `" + rule.name + "` |";
            QVERIFY2(text.contains(row), row.constData());
        }
    }
};

QTEST_GUILESS_MAIN(CodecTest)
#include "tst_codec.moc"
