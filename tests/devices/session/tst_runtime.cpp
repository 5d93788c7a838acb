#include "devices/session/connect.h"
#include "devices/session/qtexecutor.h"
#include "tests/support/feederimage.h"
#include "tests/support/runtimeprocess.h"
#include "tests/support/waituntil.h"

#include <QTemporaryDir>
#include <QtTest>

#include <optional>

using namespace camwright;
using namespace camwright::test;

/// camwright-runtime as a process, in real time.
class RuntimeTest : public QObject {
    Q_OBJECT

private:
    QtExecutor executor;
    const ControllerImage image = feederImage();

    template <class Ask>
    static Code ask(Ask request)
    {
        std::optional<Result<void>> kept;
        request([&](Result<void> result) { kept.emplace(std::move(result)); });
        if (!waitUntil([&] { return kept.has_value(); }))
            return Code::RequestTimedOut;
        return kept->ok() ? Code::Cancelled : kept->error().code;
    }
    static constexpr Code Good = Code::Cancelled; // "nothing was refused"
    std::unique_ptr<OnlineSession> online(const QString& address, const std::string& project = {}, ConnectOptions options = {})
    {
        auto session = connectTo(address.toStdString(), project, executor, options);
        if (!session)
            return nullptr;
        std::string why;
        const int token = (*session)->onStateChanged([&](LinkState, const Diagnostic& reason) { why = englishText(reason); });
        (void)waitUntil([&] { return (*session)->state() == LinkState::Online || (*session)->state() == LinkState::Offline; });
        (*session)->forget(token);
        if ((*session)->state() == LinkState::Online)
            return std::move(*session);
        qWarning("%s", why.c_str());
        return nullptr;
    }
    int run(const QStringList& arguments, QString* errors = nullptr)
    {
        QProcess process;
        process.start(QStringLiteral(CAMWRIGHT_BIN_DIR "/camwright-runtime"), arguments);
        process.waitForFinished(30'000);
        if (errors != nullptr)
            *errors = QString::fromUtf8(process.readAllStandardError());
        return process.exitCode();
    }

private slots:
    void refusesOtherAddressesWithTheReason()
    {
        QString errors;
        QCOMPARE(run({"--listen", "0.0.0.0:17402"}, &errors), 2);
        QVERIFY(errors.contains("127.0.0.1"));
        QCOMPARE(run({}), 2);
        QCOMPARE(run({"--listen", "127.0.0.1:0", "--nonsense"}), 2);
        QCOMPARE(run({"--help"}), 0);
        QCOMPARE(run({"--version"}), 0);
    }

    void itKeepsTheProgramOverSigterm()
    {
        QTemporaryDir data;
        {
            RuntimeProcess runtime(data.path());
            QVERIFY(runtime.isRunning());
            auto session = online(runtime.address());
            QVERIFY(session);
            QCOMPARE(ask([&](auto r) { session->takeControl(r); }), Good);
            QCOMPARE(ask([&](auto r) { session->download({write(image), programHash(image)}, {}, r); }), Good);
            QString errors;
            QCOMPARE(run({"--listen", "127.0.0.1:0", "--data", data.path()}, &errors), 1);
            QVERIFY(errors.contains("in use"));
            runtime.process().terminate();
            QVERIFY(runtime.process().waitForFinished(20'000));
            QCOMPARE(runtime.process().exitCode(), 0);
            QCOMPARE(runtime.process().exitStatus(), QProcess::NormalExit);
        }
        RuntimeProcess again(data.path());
        auto session = online(again.address());
        QVERIFY(session);
        QCOMPARE(session->status().program, programHash(image));
    }

    void itKeepsTheProgramOverKill()
    {
        QTemporaryDir data;
        {
            RuntimeProcess runtime(data.path());
            auto session = online(runtime.address());
            QVERIFY(session);
            QCOMPARE(ask([&](auto r) { session->takeControl(r); }), Good);
            QCOMPARE(ask([&](auto r) { session->download({write(image), programHash(image)}, {}, r); }), Good);
            runtime.process().kill();
            QVERIFY(runtime.process().waitForFinished(20'000));
        }
        RuntimeProcess again(data.path());
        auto session = online(again.address());
        QVERIFY(session);
        QCOMPARE(session->status().program, programHash(image));
    }

    void localStartsOnceIsSharedAndEndsOnRequest()
    {
        QTemporaryDir home;
        qputenv("XDG_RUNTIME_DIR", home.path().toUtf8());
        qputenv("XDG_STATE_HOME", (home.path() + "/state").toUtf8());
        ConnectOptions options;
        options.runtimeProgram = CAMWRIGHT_BIN_DIR "/camwright-runtime";
        options.reconnect = false;
        const std::string project = home.path().toStdString();
        auto first = online("local", project, options);
        QVERIFY(first);
        auto second = online("local", project, options);
        QVERIFY(second);
        QCOMPARE(ask([&](auto r) { first->takeControl(r); }), Good);
        QVERIFY2(waitUntil([&] { return second->status().control == ControlHolder::Somebody; }), "both see one controller");
        QCOMPARE(ask([&](auto r) { first->exitController(r); }), Good);
        QVERIFY(waitUntil([&] { return second->state() == LinkState::Offline; }));
    }

    void localWithoutARuntimeSaysWhatIsMissing()
    {
        QTemporaryDir home;
        qputenv("XDG_RUNTIME_DIR", home.path().toUtf8());
        qputenv("XDG_STATE_HOME", (home.path() + "/state").toUtf8());
        ConnectOptions options;
        options.runtimeProgram = "/nowhere/camwright-runtime";
        auto session = connectTo("local", home.path().toStdString(), executor, options);
        QVERIFY(session.ok());
        Diagnostic why;
        (*session)->onStateChanged([&](LinkState, const Diagnostic& reason) { why = reason; });
        QVERIFY(waitUntil([&] { return (*session)->state() == LinkState::Offline; }));
        QTRY_COMPARE(why.code, Code::RuntimeNotFound);
    }

    void aRemoteControllerDoesNotEndOnRequest()
    {
        RuntimeProcess runtime;
        auto session = online(runtime.address());
        QVERIFY(session);
        QCOMPARE(ask([&](auto r) { session->takeControl(r); }), Good);
        QCOMPARE(ask([&](auto r) { session->exitController(r); }), Code::ExitRefused);
    }
};

QTEST_GUILESS_MAIN(RuntimeTest)
#include "tst_runtime.moc"
