#pragma once

#include "core/base/bytes.h"
#include "core/base/result.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace camwright {

enum class EntryKind : std::uint8_t { File, Directory, Other };

struct DirectoryEntry {
    std::string name; ///< one path segment, bytes as the file system gives them
    EntryKind kind = EntryKind::File;
};

/// What tells cheaply that a file may have changed.
struct FileStamp {
    EntryKind kind = EntryKind::File;
    std::uint64_t size = 0;
    std::int64_t modifiedNs = 0;
    std::uint64_t fileId = 0; ///< inode

    bool operator==(const FileStamp&) const = default;
};

/// A held lock; destruction releases it, and so does the end of the process.
class FileLock {
public:
    virtual ~FileLock() = default;
};

enum class LockWait : std::uint8_t { No, UntilFree };

/// A file open for appending; closed by destruction.
class AppendFile {
public:
    virtual ~AppendFile() = default;
    virtual Result<void> append(ByteSpan bytes) = 0; ///< all or an error; after an error part of them may be there
    virtual Result<std::uint64_t> size() = 0;
    virtual Result<void> truncate(std::uint64_t size) = 0; ///< cuts off what lies behind
    virtual Result<void> sync() = 0;                 ///< what was appended survives a power cut
};

/// All that `core/storage` asks of the operating system, so that tests can make the k-th call fail. Paths use '/'.
/// An error is FileNotFound when the file or folder is not there, LockHeld for a lock somebody else has, else
/// FileSystemRefused with the operating system's words; the path is argument 1 of each.
class FileSystem {
public:
    virtual ~FileSystem() = default;

    /// The whole file; a file larger than `limit` bytes is refused with FileTooLarge.
    virtual Result<std::string> read(const std::string& path, std::uint64_t limit) = 0;
    virtual Result<std::vector<DirectoryEntry>> list(const std::string& path) = 0; ///< sorted by name; without . and ..
    virtual Result<FileStamp> stamp(const std::string& path) = 0;
    virtual Result<void> makeDirectory(const std::string& path) = 0;               ///< one level; an existing one is success
    /// Creates or replaces the file, writes and syncs its data. Not atomic: only for files nobody looks at yet.
    virtual Result<void> writeSynced(const std::string& path, ByteSpan bytes) = 0;
    virtual Result<void> rename(const std::string& from, const std::string& to) = 0; ///< atomic, replaces `to`
    virtual Result<void> remove(const std::string& path) = 0;                      ///< a file or an empty folder
    virtual Result<void> syncDirectory(const std::string& path) = 0;               ///< names made in it survive a power cut
    virtual Result<std::unique_ptr<AppendFile>> openAppend(const std::string& path) = 0; ///< created when missing
    /// An exclusive lock on the file, created when missing.
    virtual Result<std::unique_ptr<FileLock>> lock(const std::string& path, LockWait wait) = 0;
};

/// The real one. Has no state; may be used from any thread.
class PosixFileSystem final : public FileSystem {
public:
    Result<std::string> read(const std::string& path, std::uint64_t limit) override;
    Result<std::vector<DirectoryEntry>> list(const std::string& path) override;
    Result<FileStamp> stamp(const std::string& path) override;
    Result<void> makeDirectory(const std::string& path) override;
    Result<void> writeSynced(const std::string& path, ByteSpan bytes) override;
    Result<void> rename(const std::string& from, const std::string& to) override;
    Result<void> remove(const std::string& path) override;
    Result<void> syncDirectory(const std::string& path) override;
    Result<std::unique_ptr<AppendFile>> openAppend(const std::string& path) override;
    Result<std::unique_ptr<FileLock>> lock(const std::string& path, LockWait wait) override;
};

} // namespace camwright
