#pragma once

#include "core/storage/filesystem.h"

#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace camwright {

/// One change of a MemoryFileSystem, in order: what a power cut may or may not have let through.
struct FileOperation {
    enum class Kind { MakeDirectory, Write, Rename, Remove, SyncDirectory };
    Kind kind;
    std::string path;
    std::string from{};
    std::string bytes{};
};

/// Files and folders in memory. Every call is counted; `failAt` makes the k-th (from 1) fail, alone or with all behind it.
class MemoryFileSystem final : public FileSystem {
public:
    std::map<std::string, std::string> files;
    std::set<std::string> folders{""};
    std::vector<FileOperation> log;
    unsigned calls = 0;
    unsigned failAt = 0;
    bool failAfterwardsToo = false;

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

    /// Does the operation without counting or failing; one that cannot be done is left out.
    void apply(const FileOperation& operation);
    bool fails();

    std::set<std::string> heldLocks;

private:
    Result<void> act(FileOperation operation);
};

} // namespace camwright
