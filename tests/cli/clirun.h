#pragma once

#include <QByteArray>
#include <QProcess>
#include <QString>
#include <QStringList>

namespace camwright::test {

/// What a run of the command line left.
struct CliRun {
    int status = -1;
    QString out;
    QString err;
};

/// Runs camwright-cli with its own runtime directory, so that `local` controllers of other tests are not met.
class Cli {
public:
    explicit Cli(const QString& runtimeDirectory) : m_runtimeDirectory(runtimeDirectory) {}

    QProcessEnvironment environment() const
    {
        QProcessEnvironment out = QProcessEnvironment::systemEnvironment();
        out.insert(QStringLiteral("XDG_RUNTIME_DIR"), m_runtimeDirectory);
        out.insert(QStringLiteral("XDG_DATA_HOME"), m_runtimeDirectory);
        return out;
    }

    CliRun run(const QStringList& arguments, int timeoutMs = 120000) const
    {
        QProcess process;
        process.setProcessEnvironment(environment());
        process.start(program(), arguments);
        CliRun out;
        if (!process.waitForFinished(timeoutMs)) {
            process.kill();
            process.waitForFinished();
            out.err = QStringLiteral("timed out: ") + arguments.join(QLatin1Char(' '));
            return out;
        }
        out.status = process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -2;
        out.out = QString::fromUtf8(process.readAllStandardOutput());
        out.err = QString::fromUtf8(process.readAllStandardError());
        return out;
    }

    static QString program() { return QStringLiteral(CAMWRIGHT_BIN_DIR "/camwright-cli"); }
    static QString example(const QString& name) { return QStringLiteral(CAMWRIGHT_SOURCE_DIR "/examples/") + name; }

private:
    QString m_runtimeDirectory;
};

} // namespace camwright::test
