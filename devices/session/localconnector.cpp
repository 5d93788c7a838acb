#include "core/base/hash.h"
#include "devices/session/connectors.h"
#include "devices/transport/socketstream.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QLocalSocket>
#include <QProcess>

#include <sys/stat.h>
#include <unistd.h>

namespace camwright {

namespace {

constexpr int RetryMs = 25;
constexpr int PatienceMs = 10'000;
constexpr qsizetype LongestSocketPath = 100; // of sockaddr_un, with room for a suffix

/// A folder only this user can look into; made if it is not there.
bool makePrivate(const QString& path)
{
    const QByteArray name = QFile::encodeName(path);
    if (::mkdir(name.constData(), 0700) != 0 && errno != EEXIST)
        return false;
    struct stat found {};
    return ::lstat(name.constData(), &found) == 0 && S_ISDIR(found.st_mode) && found.st_uid == ::geteuid()
        && (found.st_mode & 0077) == 0;
}

QString environment(const char* name, const QString& otherwise)
{
    const QString value = qEnvironmentVariable(name);
    return value.startsWith(u'/') ? value : otherwise;
}

QString socketFolder()
{
    const QString runtime = environment("XDG_RUNTIME_DIR", {});
    if (!runtime.isEmpty() && runtime.size() < LongestSocketPath - 40 && makePrivate(runtime + QStringLiteral("/camwright")))
        return runtime + QStringLiteral("/camwright");
    const QString fallback = QStringLiteral("/tmp/camwright-%1").arg(::geteuid());
    return makePrivate(fallback) ? fallback : QString();
}

QString lastLine(const QString& file)
{
    QFile log(file);
    if (!log.open(QIODevice::ReadOnly))
        return QString::fromLatin1(CW_TEXT("Arguments", "it left no message"));
    const QList<QByteArray> lines = log.readAll().trimmed().split('\n');
    return lines.last().isEmpty() ? QString::fromLatin1(CW_TEXT("Arguments", "it left no message")) : QString::fromUtf8(lines.last());
}

} // namespace

Result<LocalConnector::Paths> LocalConnector::pathsFor(const std::string& projectPath)
{
    const QFileInfo project(QString::fromStdString(projectPath));
    const QString real = project.exists() ? project.canonicalFilePath() : QDir::cleanPath(project.absoluteFilePath());
    const QByteArray utf8 = real.toUtf8();
    const Hash hash = hashOf({reinterpret_cast<const std::uint8_t*>(utf8.constData()), static_cast<std::size_t>(utf8.size())});
    const QString name = QString::fromStdString(toHex(hash).substr(0, 16));
    const QString folder = socketFolder();
    if (folder.isEmpty())
        return diagnostic(Code::CannotConnect, {"local", CW_TEXT("Arguments", "there is no private folder for its socket")});
    const QString state = environment("XDG_STATE_HOME", QDir::homePath() + QStringLiteral("/.local/state"));
    Paths out{folder + u'/' + name + QStringLiteral(".socket"), state + QStringLiteral("/camwright/controllers/") + name};
    if (!QDir().mkpath(out.data))
        return diagnostic(Code::StoreFailed, {out.data.toStdString(), CW_TEXT("Arguments", "the folder cannot be made")});
    return out;
}

LocalConnector::LocalConnector(Paths paths, QString program) : m_paths(std::move(paths)), m_program(std::move(program))
{
    m_retry.setSingleShot(true);
    QObject::connect(&m_retry, &QTimer::timeout, &m_context, [this] { attempt(); });
}

LocalConnector::~LocalConnector() = default;

void LocalConnector::open(Opened opened)
{
    m_opened = std::move(opened);
    m_attemptsLeft = m_started ? 1 : PatienceMs / RetryMs;
    m_retry.start(0);
}

void LocalConnector::attempt()
{
    m_socket = std::make_unique<QLocalSocket>();
    QLocalSocket* socket = m_socket.get();
    QObject::connect(socket, &QLocalSocket::connected, &m_context, [this] {
        if (!m_socket)
            return;
        m_started = true;
        QObject::disconnect(m_socket.get(), nullptr, &m_context, nullptr);
        end(std::unique_ptr<ByteStream>(std::make_unique<SocketStream>(std::move(m_socket))));
    }, Qt::QueuedConnection);
    QObject::connect(socket, &QLocalSocket::errorOccurred, &m_context, [this] { failed(); }, Qt::QueuedConnection);
    socket->connectToServer(m_paths.socket);
}

void LocalConnector::failed()
{
    if (!m_socket)
        return;
    const QString reason = m_socket->errorString();
    m_socket.release()->deleteLater();
    if (!m_started) {
        m_started = true;
        QProcess process;
        process.setProgram(m_program);
        process.setArguments({QStringLiteral("--local"), m_paths.socket, QStringLiteral("--data"), m_paths.data});
        process.setStandardInputFile(QProcess::nullDevice());
        process.setStandardOutputFile(QProcess::nullDevice());
        process.setStandardErrorFile(m_paths.data + QStringLiteral("/runtime.log"));
        process.setWorkingDirectory(QStringLiteral("/"));
        if (!process.startDetached()) {
            m_started = false;
            return end(diagnostic(Code::RuntimeNotFound, {m_program.toStdString()}));
        }
    }
    if (--m_attemptsLeft > 0) {
        m_retry.start(RetryMs);
    } else if (PatienceMs > RetryMs) {
        const QString why = lastLine(m_paths.data + QStringLiteral("/runtime.log"));
        end(diagnostic(Code::RuntimeNotReady, {std::to_string(PatienceMs / 1000), reason.toStdString() + "; " + why.toStdString()}));
    }
}

void LocalConnector::end(Result<std::unique_ptr<ByteStream>> result)
{
    const Opened opened = std::move(m_opened);
    m_opened = nullptr;
    if (opened)
        opened(std::move(result));
}

} // namespace camwright
