#include "core/storage/filesystem.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <dirent.h>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace camwright {

namespace {

Diagnostic refusal(const std::string& path, int error)
{
    if (error == ENOENT)
        return diagnostic(Code::FileNotFound, {path});
    char buffer[256] = {};
    // The GNU form gives the text back, which may or may not lie in the buffer; unlike strerror it is safe in threads.
    return diagnostic(Code::FileSystemRefused, {path, strerror_r(error, buffer, sizeof buffer)});
}

/// A path with a NUL would be cut by the operating system and mean another file.
bool hasNul(const std::string& path)
{
    return path.find('\0') != std::string::npos;
}

class Descriptor {
public:
    Descriptor(const std::string& path, int flags, mode_t mode = 0)
    {
        if (hasNul(path)) {
            errno = EINVAL;
            return;
        }
        do {
            m_fd = ::open(path.c_str(), flags | O_CLOEXEC, mode);
        } while (m_fd < 0 && errno == EINTR);
    }
    ~Descriptor()
    {
        if (m_fd >= 0)
            ::close(m_fd);
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;

    bool isOpen() const { return m_fd >= 0; }
    int fd() const { return m_fd; }

private:
    int m_fd = -1;
};

bool writeAll(int fd, ByteSpan bytes)
{
    while (!bytes.empty()) {
        const ssize_t written = ::write(fd, bytes.data(), bytes.size());
        if (written < 0 && errno != EINTR)
            return false;
        if (written > 0)
            bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
    return true;
}

bool syncAll(int fd)
{
    int result;
    do {
        result = ::fsync(fd);
    } while (result != 0 && errno == EINTR);
    return result == 0;
}

EntryKind kindOf(mode_t mode)
{
    return S_ISREG(mode) ? EntryKind::File : S_ISDIR(mode) ? EntryKind::Directory : EntryKind::Other;
}

class PosixAppendFile final : public AppendFile {
public:
    explicit PosixAppendFile(std::string path)
        : m_path(std::move(path)), m_file(m_path, O_WRONLY | O_APPEND | O_CREAT, 0666)
    {
    }
    bool isOpen() const { return m_file.isOpen(); }
    Result<void> append(ByteSpan bytes) override
    {
        return writeAll(m_file.fd(), bytes) ? Result<void>() : refusal(m_path, errno);
    }
    Result<std::uint64_t> size() override
    {
        struct stat info = {};
        if (::fstat(m_file.fd(), &info) != 0)
            return refusal(m_path, errno);
        return static_cast<std::uint64_t>(info.st_size);
    }
    Result<void> truncate(std::uint64_t size) override
    {
        return ::ftruncate(m_file.fd(), static_cast<off_t>(size)) == 0 ? Result<void>() : refusal(m_path, errno);
    }
    Result<void> sync() override { return syncAll(m_file.fd()) ? Result<void>() : refusal(m_path, errno); }

private:
    std::string m_path;
    Descriptor m_file;
};

class PosixFileLock final : public FileLock {
public:
    explicit PosixFileLock(const std::string& path) : m_file(path, O_RDWR | O_CREAT, 0666) {}
    bool isOpen() const { return m_file.isOpen(); }
    bool take(LockWait wait)
    {
        int result;
        do {
            result = ::flock(m_file.fd(), LOCK_EX | (wait == LockWait::No ? LOCK_NB : 0));
        } while (result != 0 && errno == EINTR);
        return result == 0;
    }

private:
    Descriptor m_file;
};

} // namespace

Result<std::string> PosixFileSystem::read(const std::string& path, std::uint64_t limit)
{
    // O_NONBLOCK: a named pipe in the project's folder must not hold the reader.
    const Descriptor file(path, O_RDONLY | O_NONBLOCK);
    if (!file.isOpen())
        return refusal(path, errno);
    struct stat info = {};
    if (::fstat(file.fd(), &info) != 0)
        return refusal(path, errno);
    if (!S_ISREG(info.st_mode))
        return refusal(path, S_ISDIR(info.st_mode) ? EISDIR : EINVAL);
    std::string out;
    char buffer[65536];
    for (;;) {
        const ssize_t got = ::read(file.fd(), buffer, sizeof buffer);
        if (got < 0 && errno == EINTR)
            continue;
        if (got < 0)
            return refusal(path, errno);
        if (got == 0)
            return out;
        out.append(buffer, static_cast<std::size_t>(got));
        if (out.size() > limit)
            return diagnostic(Code::FileTooLarge, {path, std::to_string(limit)});
    }
}

Result<std::vector<DirectoryEntry>> PosixFileSystem::list(const std::string& path)
{
    const std::unique_ptr<DIR, int (*)(DIR*)> folder(hasNul(path) ? nullptr : ::opendir(path.c_str()), ::closedir);
    if (!folder)
        return refusal(path, hasNul(path) ? EINVAL : errno);
    std::vector<DirectoryEntry> out;
    for (;;) {
        errno = 0;
        const dirent* entry = ::readdir(folder.get());
        if (!entry) {
            if (errno != 0)
                return refusal(path, errno);
            break;
        }
        if (std::strcmp(entry->d_name, ".") == 0 || std::strcmp(entry->d_name, "..") == 0)
            continue;
        struct stat info = {};
        if (::fstatat(::dirfd(folder.get()), entry->d_name, &info, 0) == 0)
            out.push_back({entry->d_name, kindOf(info.st_mode)});
        else
            out.push_back({entry->d_name, EntryKind::Other}); // a link to nowhere, or removed meanwhile
    }
    std::sort(out.begin(), out.end(), [](const auto& a, const auto& b) { return a.name < b.name; });
    return out;
}

Result<FileStamp> PosixFileSystem::stamp(const std::string& path)
{
    struct stat info = {};
    if (hasNul(path))
        return refusal(path, EINVAL);
    if (::stat(path.c_str(), &info) != 0)
        return refusal(path, errno == ENOTDIR ? ENOENT : errno);
    FileStamp out;
    out.kind = kindOf(info.st_mode);
    out.size = static_cast<std::uint64_t>(info.st_size);
    out.modifiedNs = static_cast<std::int64_t>(info.st_mtim.tv_sec) * 1'000'000'000 + info.st_mtim.tv_nsec;
    out.fileId = info.st_ino;
    return out;
}

Result<void> PosixFileSystem::makeDirectory(const std::string& path)
{
    if (hasNul(path))
        return refusal(path, EINVAL);
    if (::mkdir(path.c_str(), 0777) == 0)
        return {};
    const int error = errno;
    struct stat info = {};
    if (error == EEXIST && ::stat(path.c_str(), &info) == 0 && S_ISDIR(info.st_mode))
        return {};
    return refusal(path, error);
}

Result<void> PosixFileSystem::writeSynced(const std::string& path, ByteSpan bytes)
{
    const Descriptor file(path, O_WRONLY | O_CREAT | O_TRUNC, 0666);
    if (!file.isOpen() || !writeAll(file.fd(), bytes) || !syncAll(file.fd()))
        return refusal(path, errno);
    return {};
}

Result<void> PosixFileSystem::rename(const std::string& from, const std::string& to)
{
    if (hasNul(from) || hasNul(to))
        return refusal(to, EINVAL);
    return ::rename(from.c_str(), to.c_str()) == 0 ? Result<void>() : refusal(to, errno);
}

Result<void> PosixFileSystem::remove(const std::string& path)
{
    if (hasNul(path))
        return refusal(path, EINVAL);
    if (::unlink(path.c_str()) == 0)
        return {};
    const int error = errno;
    if ((error == EISDIR || error == EPERM) && ::rmdir(path.c_str()) == 0)
        return {};
    return refusal(path, error == EISDIR || error == EPERM ? errno : error);
}

Result<void> PosixFileSystem::syncDirectory(const std::string& path)
{
    const Descriptor folder(path, O_RDONLY | O_DIRECTORY);
    // Some file systems (network drives) cannot sync a folder and say EINVAL; renaming is durable there by itself or never.
    if (!folder.isOpen() || (!syncAll(folder.fd()) && errno != EINVAL))
        return refusal(path, errno);
    return {};
}

Result<std::unique_ptr<AppendFile>> PosixFileSystem::openAppend(const std::string& path)
{
    auto file = std::make_unique<PosixAppendFile>(path);
    if (!file->isOpen())
        return refusal(path, errno);
    return std::unique_ptr<AppendFile>(std::move(file));
}

Result<std::unique_ptr<FileLock>> PosixFileSystem::lock(const std::string& path, LockWait wait)
{
    auto lock = std::make_unique<PosixFileLock>(path);
    if (!lock->isOpen())
        return refusal(path, errno);
    if (!lock->take(wait))
        return errno == EWOULDBLOCK ? diagnostic(Code::LockHeld, {path}) : refusal(path, errno);
    return std::unique_ptr<FileLock>(std::move(lock));
}

} // namespace camwright
