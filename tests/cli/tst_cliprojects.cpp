#include "tests/cli/clirun.h"

#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

using namespace camwright::test;

namespace {

QMap<QString, QByteArray> filesOf(const QString& folder)
{
    QMap<QString, QByteArray> out;
    QDirIterator it(folder, QDir::Files | QDir::NoDotAndDotDot | QDir::Hidden, QDirIterator::Subdirectories);
    while (it.hasNext()) {
        QFile file(it.next());
        const QString name = QDir(folder).relativeFilePath(file.fileName());
        if (!name.startsWith(QStringLiteral(".camwright")) && file.open(QIODevice::ReadOnly))
            out[name] = file.readAll();
    }
    return out;
}

QByteArray read(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

void write(const QString& path, const QByteArray& bytes)
{
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(bytes);
}

/// Columns of a CSV by name.
QMap<QString, QList<double>> columns(const QByteArray& csv)
{
    QMap<QString, QList<double>> out;
    const QList<QByteArray> lines = csv.trimmed().split('\n');
    const QList<QByteArray> names = lines.value(0).split(',');
    for (qsizetype row = 1; row < lines.size(); ++row) {
        const QList<QByteArray> cells = lines[row].split(',');
        for (qsizetype i = 0; i < names.size(); ++i)
            out[QString::fromUtf8(names[i])] << cells.value(i).toDouble();
    }
    return out;
}

} // namespace

class CliProjectsTest : public QObject {
    Q_OBJECT

    QTemporaryDir m_dir;
    Cli m_cli{m_dir.path()};

    QString path(const QString& name) const { return m_dir.filePath(name); }
    /// A copy of an example that a test may damage.
    QString copyOf(const QString& example, const QString& name)
    {
        const QString target = path(name);
        const QMap<QString, QByteArray> files = filesOf(Cli::example(example));
        for (auto it = files.begin(); it != files.end(); ++it) {
            QDir().mkpath(QFileInfo(target + QLatin1Char('/') + it.key()).path());
            write(target + QLatin1Char('/') + it.key(), it.value());
        }
        return target;
    }

private slots:
    void bothExamplesCheckClean()
    {
        for (const char* example : {"kinco-feeder", "ts600-marquee"}) {
            const CliRun run = m_cli.run({"check", Cli::example(example)});
            QVERIFY2(run.status == 0, qPrintable(run.out + run.err));
        }
    }

    void checkNamesFileLineAndCode()
    {
        const QString project = copyOf(QStringLiteral("kinco-feeder"), QStringLiteral("broken"));
        const QString file = project + QStringLiteral("/programs/Main.il");
        const QByteArray text = read(file);
        const qsizetype at = text.indexOf("GE      %VW308, 0");
        QVERIFY(at > 0);
        write(file, QByteArray(text).replace(at, 2, "BN"));
        const int line = static_cast<int>(text.left(at).count('\n')) + 1;
        const CliRun run = m_cli.run({"check", project});
        QCOMPARE(run.status, 1);
        QVERIFY2(run.out.contains(QStringLiteral("programs/Main.il:%1:1: error CW3").arg(line)), qPrintable(run.out));
        QVERIFY2(run.out.contains(QStringLiteral("BN")), qPrintable(run.out));
    }

    void aLooseFileOfStructuredTextIsChecked()
    {
        const QString file = copyOf(QStringLiteral("kinco-feeder"), QStringLiteral("loose")) + QStringLiteral("/loose.st");
        write(file, "FUNCTION f : INT\nf := 1;\nEND_FUNCTION\n");
        const CliRun good = m_cli.run({"check", file});
        QVERIFY2(good.status == 0, qPrintable(good.out + good.err));
        write(file, "FUNCTION f : INT\nf := TRUE;\nEND_FUNCTION\n");
        const CliRun bad = m_cli.run({"check", file});
        QCOMPARE(bad.status, 1);
        QVERIFY2(bad.out.contains(QStringLiteral("loose.st:2:6: error CW8302")), qPrintable(bad.out));
    }

    void jsonIsOneDocument()
    {
        const CliRun run = m_cli.run({"check", "--json", Cli::example("kinco-feeder")});
        QCOMPARE(run.status, 0);
        QJsonParseError error;
        const QJsonDocument document = QJsonDocument::fromJson(run.out.toUtf8(), &error);
        QCOMPARE(error.error, QJsonParseError::NoError);
        QCOMPARE(document.object()["errors"].toInt(-1), 0);
    }

    void wrongUsageIsTwo_data()
    {
        QTest::addColumn<QStringList>("arguments");
        QTest::newRow("nothing") << QStringList{};
        QTest::newRow("unknown verb") << QStringList{"frobnicate"};
        QTest::newRow("too few words") << QStringList{"check"};
        QTest::newRow("too many words") << QStringList{"check", "a", "b"};
        QTest::newRow("unknown option") << QStringList{"check", "--bogus", "a"};
        QTest::newRow("bad time") << QStringList{"simulate", Cli::example("kinco-feeder"), "--for", "soon"};
        QTest::newRow("bad every") << QStringList{"simulate", Cli::example("kinco-feeder"), "--every", "1us"};
        QTest::newRow("bad executor") << QStringList{"simulate", Cli::example("kinco-feeder"), "--executor", "fast"};
        QTest::newRow("bad set") << QStringList{"simulate", Cli::example("kinco-feeder"), "--set", "X0"};
        QTest::newRow("unknown language") << QStringList{"check", "--lang", "xx", Cli::example("kinco-feeder")};
        QTest::newRow("unknown family") << QStringList{"new", "--family", "acme", "/nonexistent/x"};
        QTest::newRow("unknown axis job") << QStringList{"axis", "fly", "Feed"};
    }
    void wrongUsageIsTwo()
    {
        QFETCH(QStringList, arguments);
        const CliRun run = m_cli.run(arguments);
        QCOMPARE(run.status, 2);
        QVERIFY(!run.err.isEmpty() || !run.out.isEmpty());
    }

    void explainPrintsThePage()
    {
        const CliRun run = m_cli.run({"explain", "cw3001"});
        QCOMPARE(run.status, 0);
        QCOMPARE(run.out.toUtf8(), read(QStringLiteral(CAMWRIGHT_SOURCE_DIR "/resources/diagnostics/en/CW3001.md")).trimmed() + '\n');
    }

    void explainSpeaksTheLanguageAskedFor()
    {
        const CliRun run = m_cli.run({"explain", "CW5010", "--lang", "zh", "--json"});
        QCOMPARE(run.status, 0);
        const QJsonObject answer = QJsonDocument::fromJson(run.out.toUtf8()).object();
        QCOMPARE(answer["code"].toString(), QString("CW5010"));
        QCOMPARE(answer["severity"].toString(), QString("error"));
        QCOMPARE(answer["language"].toString(), QString("zh"));
        QVERIFY(answer["text"].toString().contains(QStringLiteral("驱动器报警 %2")));
        QVERIFY(answer["page"].toString().contains(QStringLiteral("**解决办法。**")));
    }

    void unknownCodeIsTwoAndNamesANearOne()
    {
        const CliRun near = m_cli.run({"explain", "CW30001"});
        QCOMPARE(near.status, 2);
        QCOMPARE(near.err, QString("camwright-cli: there is no message 'CW30001'. Did you mean CW3001?\n"));
        const CliRun far = m_cli.run({"explain", "everything"});
        QCOMPARE(far.status, 2);
        QCOMPARE(far.err, QString("camwright-cli: there is no message 'everything'. Codes are written like CW3001.\n"));
    }

    void filesThatCannotBeReadAreThree_data()
    {
        QTest::addColumn<QString>("file");
        QTest::addColumn<QByteArray>("text");
        QTest::newRow("no project") << QStringLiteral("project.toml") << QByteArray();
        QTest::newRow("newer format") << QStringLiteral("project.toml") << QByteArray("format = 99\nname = \"x\"\n");
        QTest::newRow("not toml") << QStringLiteral("axes/Feed.toml") << QByteArray("number = = 1\n");
        QTest::newRow("not utf-8") << QStringLiteral("axes/Feed.toml") << QByteArray("comment = \"\xff\xfe\"\n");
    }
    void filesThatCannotBeReadAreThree()
    {
        QFETCH(QString, file);
        QFETCH(QByteArray, text);
        const QString project = copyOf(QStringLiteral("kinco-feeder"), QStringLiteral("unreadable-%1").arg(QLatin1String(QTest::currentDataTag())).replace(' ', '-'));
        if (text.isEmpty())
            QVERIFY(QFile::remove(project + '/' + file));
        else
            write(project + '/' + file, text);
        const CliRun run = m_cli.run({"check", project});
        QCOMPARE(run.status, 3);
        QVERIFY2(run.out.contains(QStringLiteral("CW1")), qPrintable(run.out));
    }

    void anIllegalValueIsOneNotThree()
    {
        const QString project = copyOf(QStringLiteral("kinco-feeder"), QStringLiteral("illegal"));
        const QString file = project + QStringLiteral("/axes/Turn.toml");
        write(file, read(file).replace("number = 2", "number = 4"));
        const CliRun run = m_cli.run({"check", project});
        QCOMPARE(run.status, 1);
        QVERIFY2(run.out.contains(QStringLiteral("axes/Turn.toml:")), qPrintable(run.out)); // KS-MCN-06
    }

    void convertWritesTheSameBytes()
    {
        for (const char* example : {"kinco-feeder", "ts600-marquee"}) {
            const QString target = path(QStringLiteral("converted-") + example);
            const CliRun run = m_cli.run({"convert", Cli::example(example), target});
            QVERIFY2(run.status == 0, qPrintable(run.out + run.err));
            QCOMPARE(filesOf(target), filesOf(Cli::example(example)));
        }
        QCOMPARE(m_cli.run({"convert", Cli::example("ts600-marquee"), path("converted-ts600-marquee")}).status, 1);
    }

    void aNewProjectChecksClean_data()
    {
        QTest::addColumn<QString>("family");
        QTest::newRow("kinco") << "kinco";
        QTest::newRow("invt") << "invt";
        QTest::newRow("koyo") << "koyo";
    }
    void aNewProjectChecksClean()
    {
        QFETCH(QString, family);
        const QString project = path(QStringLiteral("new-") + family);
        const CliRun made = m_cli.run({"new", project, "--family", family});
        QVERIFY2(made.status == 0, qPrintable(made.out + made.err));
        const CliRun checked = m_cli.run({"check", project});
        QVERIFY2(checked.status == 0, qPrintable(checked.out + checked.err));
    }

    void buildingTwiceGivesTheSameImage()
    {
        const QString a = path("a.cwimg"), b = path("b.cwimg");
        QCOMPARE(m_cli.run({"build", Cli::example("kinco-feeder"), "--out", a}).status, 0);
        QCOMPARE(m_cli.run({"build", Cli::example("kinco-feeder"), "--out", b}).status, 0);
        QVERIFY(!read(a).isEmpty());
        QCOMPARE(read(a), read(b));
    }

    void simulatingTwiceGivesTheSameFileInEitherExecutor()
    {
        const QStringList base{"simulate", Cli::example("kinco-feeder"), "--for", "20s", "--trace", "axis.Feed.position,axis.Feed.setPosition,axis.Turn.position,Pieces", "--out"};
        const QString a = path("a.csv"), b = path("b.csv");
        const CliRun first = m_cli.run(base + QStringList{a});
        QVERIFY2(first.status == 0, qPrintable(first.out + first.err));
        QCOMPARE(m_cli.run(base + QStringList{b, "--executor", "interpreter"}).status, 0);
        const QByteArray csv = read(a);
        QCOMPARE(csv, read(b));
        QVERIFY(csv.startsWith("time_s,axis.Feed.position,axis.Feed.setPosition,axis.Turn.position,Pieces\n"));
        const auto values = columns(csv);
        QCOMPARE(values["time_s"].size(), 20000);
        // The commanded positions of the program: 200 mm and 90 degrees are reached within the drive's window.
        const auto feed = values["axis.Feed.position"], turn = values["axis.Turn.position"];
        QVERIFY(std::any_of(feed.begin(), feed.end(), [](double p) { return std::abs(p - 200.0) < 0.1; }));
        QVERIFY(std::any_of(turn.begin(), turn.end(), [](double p) { return std::abs(p - 90.0) < 0.1; }));
        QVERIFY(*std::max_element(feed.begin(), feed.end()) < 260.0);
        QVERIFY(values["Pieces"].last() >= 1);
    }

    void anotherSeedOrInputIsAnotherRunButEverySetTakesEffectInTime()
    {
        const CliRun run = m_cli.run({"simulate", Cli::example("ts600-marquee"), "--for", "14s", "--set", "X0=1@1s", "--set", "X0=0@13s", "--trace", "X0,Y0,Y1,Y2", "--out", path("lamps.csv")});
        QVERIFY2(run.status == 0, qPrintable(run.out + run.err));
        const auto lamps = columns(read(path("lamps.csv")));
        const auto time = lamps["time_s"];
        const auto lit = [&](const char* lamp, double at) { return lamps[QLatin1String(lamp)][static_cast<qsizetype>(at * 1000) - 1] != 0; };
        // X0 at 1 s; then each lamp alone for 2 s, in turn.
        QVERIFY(!lit("Y0", 0.9) && !lit("Y1", 0.9) && !lit("Y2", 0.9));
        for (const double start : {1.0, 7.0}) {
            QVERIFY(lit("Y0", start + 1.0) && !lit("Y1", start + 1.0) && !lit("Y2", start + 1.0));
            QVERIFY(!lit("Y0", start + 3.0) && lit("Y1", start + 3.0) && !lit("Y2", start + 3.0));
            QVERIFY(!lit("Y0", start + 5.0) && !lit("Y1", start + 5.0) && lit("Y2", start + 5.0));
        }
        QVERIFY(!lit("Y0", 13.5) && !lit("Y1", 13.5) && !lit("Y2", 13.5));
    }

    /// A Koyo project from nothing: I-boxes are checked and built with a word about them, everything else runs.
    void aKoyoProgramIsCheckedBuiltAndSimulated()
    {
        const QString project = path("koyo");
        QCOMPARE(m_cli.run({"new", project, "--family", "koyo", "--model", "DL-265"}).status, 0);
        const QString file = project + QStringLiteral("/programs/Main.il");
        const QByteArray head = read(file).split('\n').value(0);
        write(file, head + "\nSTRN T0\nTMR T0 K10\nSTR T0\nSTR X1\nCNT CT0 K9999\nSTR SP1\nLD CTA0\nADD K98\nOUT V1400\nSTR X0\nOUT Y0\n");
        const CliRun checked = m_cli.run({"check", project});
        QVERIFY2(checked.status == 0, qPrintable(checked.out + checked.err));
        const CliRun run = m_cli.run({"simulate", project, "--for", "6s", "--set", "X0=1@3s", "--trace", "Y0,V1400,SP1", "--out", path("koyo.csv")});
        QVERIFY2(run.status == 0, qPrintable(run.out + run.err));
        const auto values = columns(read(path("koyo.csv")));
        QCOMPARE(values["Y0"][2900], 0.0);
        QCOMPARE(values["Y0"][3100], 1.0);
        QCOMPARE(values["SP1"].last(), 1.0);
        QCOMPARE(int(values["V1400"][2500]), 0x100); // two seconds counted, in BCD: 2 + 98
        write(file, head + "\nSTRN B10003.1\nAND M1002\nIB-2021 R5000 R5001 R5040 M100 M101 R5002 R5003\n");
        QCOMPARE(m_cli.run({"check", project}).status, 0);
        const CliRun built = m_cli.run({"build", project, "--out", path("koyo.cwimg")});
        QVERIFY2(built.status == 0 && (built.out + built.err).contains(QStringLiteral("ML_SVON")), qPrintable(built.out + built.err));
    }

    void aNameTheProgramDoesNotKnowIsNamed()
    {
        const CliRun run = m_cli.run({"simulate", Cli::example("kinco-feeder"), "--for", "1s", "--trace", "axis.Nobody.position"});
        QCOMPARE(run.status, 1);
        QVERIFY2(run.out.contains(QStringLiteral("Nobody")), qPrintable(run.out));
    }

    void messagesSpeakTheLanguageAsked()
    {
        const QString project = copyOf(QStringLiteral("kinco-feeder"), QStringLiteral("sprachen"));
        const QString file = project + QStringLiteral("/axes/Turn.toml");
        write(file, read(file).replace("number = 2", "number = 1"));
        const QString english = m_cli.run({"check", project}).out;
        const QString chinese = m_cli.run({"check", "--lang", "zh", project}).out;
        const QString russian = m_cli.run({"check", "--lang", "ru", project}).out;
        QVERIFY(english != chinese && english != russian && chinese != russian);
    }
};

QTEST_GUILESS_MAIN(CliProjectsTest)
#include "tst_cliprojects.moc"
