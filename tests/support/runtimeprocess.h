#pragma once

#include <QElapsedTimer>
#include <QProcess>
#include <QString>
#include <QStringList>

#include <cstdint>
#include <string>

namespace camwright::test {

/// A camwright-runtime of this build in a process of its own, on a free port of this machine. For tests of the command line
/// and the window. It ends with this object.
class RuntimeProcess {
public:
    /// `data` empty: it keeps nothing.
    explicit RuntimeProcess(const QString& data = {})
    {
        QStringList arguments{QStringLiteral("--listen"), QStringLiteral("127.0.0.1:0")};
        if (!data.isEmpty())
            arguments << QStringLiteral("--data") << data;
        m_process.setProcessChannelMode(QProcess::SeparateChannels);
        m_process.start(QStringLiteral(CAMWRIGHT_BIN_DIR "/camwright-runtime"), arguments);
        // Its first line says where it listens.
        QElapsedTimer timer;
        timer.start();
        while (!m_process.canReadLine() && m_process.state() != QProcess::NotRunning && timer.elapsed() < 30'000)
            m_process.waitForReadyRead(1000);
        const QByteArray line = m_process.readLine().trimmed();
        m_port = line.mid(line.lastIndexOf(':') + 1).toUShort();
    }
    ~RuntimeProcess()
    {
        m_process.terminate();
        if (!m_process.waitForFinished(10'000))
            m_process.kill();
        m_process.waitForFinished(5'000);
    }
    RuntimeProcess(const RuntimeProcess&) = delete;
    RuntimeProcess& operator=(const RuntimeProcess&) = delete;

    bool isRunning() const { return m_port != 0 && m_process.state() == QProcess::Running; }
    std::uint16_t port() const { return m_port; }
    QString address() const { return QStringLiteral("tcp://127.0.0.1:%1").arg(m_port); }
    QString errors() { return QString::fromUtf8(m_process.readAllStandardError()); }
    QProcess& process() { return m_process; }

private:
    QProcess m_process;
    std::uint16_t m_port = 0;
};

} // namespace camwright::test
