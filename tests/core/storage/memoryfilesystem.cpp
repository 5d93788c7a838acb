#include "tests/core/storage/memoryfilesystem.h"

#include "core/storage/crc.h"

namespace camwright {

namespace {

Diagnostic missing(const std::string& path) { return diagnostic(Code::FileNotFound, {path}); }
Diagnostic refused(const std::string& path) { return diagnostic(Code::FileSystemRefused, {path, "Input/output error"}); }

std::string parentOf(const std::string& path)
{
    const std::size_t slash = path.rfind('/');
    return slash == std::string::npos ? std::string() : path.substr(0, slash);
}

class MemoryAppendFile final : public AppendFile {
public:
    MemoryAppendFile(MemoryFileSystem& files, std::string path) : m_files(files), m_path(std::move(path)) {}
    Result<void> append(ByteSpan bytes) override
    {
        const bool failed = m_files.fails();
        const std::size_t count = failed ? bytes.size() / 2 : bytes.size(); // a disk that fills up takes a part
        m_files.files[m_path].append(reinterpret_cast<const char*>(bytes.data()), count);
        return failed ? Result<void>(refused(m_path)) : Result<void>();
    }
    Result<std::uint64_t> size() override { return std::uint64_t{m_files.files[m_path].size()}; }
    Result<void> truncate(std::uint64_t size) override
    {
        if (m_files.fails())
            return refused(m_path);
        m_files.files[m_path].resize(size);
        return {};
    }
    Result<void> sync() override { return m_files.fails() ? Result<void>(refused(m_path)) : Result<void>(); }

private:
    MemoryFileSystem& m_files;
    std::string m_path;
};

class MemoryLock final : public FileLock {
public:
    MemoryLock(MemoryFileSystem& files, std::string path) : m_files(files), m_path(std::move(path)) { m_files.heldLocks.insert(m_path); }
    ~MemoryLock() override { m_files.heldLocks.erase(m_path); }

private:
    MemoryFileSystem& m_files;
    std::string m_path;
};

} // namespace

bool MemoryFileSystem::fails()
{
    ++calls;
    return failAt != 0 && (failAfterwardsToo ? calls >= failAt : calls == failAt);
}

Result<std::string> MemoryFileSystem::read(const std::string& path, std::uint64_t limit)
{
    if (fails())
        return refused(path);
    const auto found = files.find(path);
    if (found == files.end())
        return missing(path);
    if (found->second.size() > limit)
        return diagnostic(Code::FileTooLarge, {path, std::to_string(limit)});
    return found->second;
}

Result<std::vector<DirectoryEntry>> MemoryFileSystem::list(const std::string& path)
{
    if (fails())
        return refused(path);
    if (!folders.contains(path))
        return missing(path);
    std::map<std::string, EntryKind> names;
    for (const auto& [file, bytes] : files) {
        if (parentOf(file) == path)
            names.emplace(file.substr(path.size() + 1), EntryKind::File);
    }
    for (const std::string& folder : folders) {
        if (!folder.empty() && parentOf(folder) == path)
            names.emplace(folder.substr(path.size() + 1), EntryKind::Directory);
    }
    std::vector<DirectoryEntry> out;
    for (const auto& [name, kind] : names)
        out.push_back({name, kind});
    return out;
}

Result<FileStamp> MemoryFileSystem::stamp(const std::string& path)
{
    if (fails())
        return refused(path);
    if (folders.contains(path))
        return FileStamp{EntryKind::Directory, 0, 0, 0};
    const auto found = files.find(path);
    if (found == files.end())
        return missing(path);
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(found->second.data());
    return FileStamp{EntryKind::File, found->second.size(), crc32({bytes, found->second.size()}), 0};
}

Result<void> MemoryFileSystem::act(FileOperation operation)
{
    if (fails())
        return refused(operation.path);
    apply(operation);
    log.push_back(std::move(operation));
    return {};
}

void MemoryFileSystem::apply(const FileOperation& operation)
{
    switch (operation.kind) {
    case FileOperation::Kind::MakeDirectory: folders.insert(operation.path); break;
    case FileOperation::Kind::Write:
        if (folders.contains(parentOf(operation.path)))
            files[operation.path] = operation.bytes;
        break;
    case FileOperation::Kind::Rename:
        if (const auto found = files.find(operation.from); found != files.end() && folders.contains(parentOf(operation.path))) {
            std::string bytes = std::move(found->second);
            files.erase(found);
            files[operation.path] = std::move(bytes);
        }
        break;
    case FileOperation::Kind::Remove:
        files.erase(operation.path);
        folders.erase(operation.path);
        break;
    case FileOperation::Kind::SyncDirectory: break;
    }
}

Result<void> MemoryFileSystem::makeDirectory(const std::string& path)
{
    return act({FileOperation::Kind::MakeDirectory, path});
}

Result<void> MemoryFileSystem::writeSynced(const std::string& path, ByteSpan bytes)
{
    if (!folders.contains(parentOf(path)))
        return missing(path);
    const std::string text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    auto done = act({FileOperation::Kind::Write, path, {}, text});
    if (!done)
        files[path] = text.substr(0, text.size() / 2);
    return done;
}

Result<void> MemoryFileSystem::rename(const std::string& from, const std::string& to)
{
    return files.contains(from) ? act({FileOperation::Kind::Rename, to, from}) : Result<void>(missing(from));
}

Result<void> MemoryFileSystem::remove(const std::string& path)
{
    return files.contains(path) || folders.contains(path) ? act({FileOperation::Kind::Remove, path}) : Result<void>(missing(path));
}

Result<void> MemoryFileSystem::syncDirectory(const std::string& path)
{
    return folders.contains(path) ? act({FileOperation::Kind::SyncDirectory, path}) : Result<void>(missing(path));
}

Result<std::unique_ptr<AppendFile>> MemoryFileSystem::openAppend(const std::string& path)
{
    if (fails())
        return refused(path);
    files.try_emplace(path);
    return std::unique_ptr<AppendFile>(std::make_unique<MemoryAppendFile>(*this, path));
}

Result<std::unique_ptr<FileLock>> MemoryFileSystem::lock(const std::string& path, LockWait)
{
    if (fails())
        return refused(path);
    if (heldLocks.contains(path))
        return diagnostic(Code::LockHeld, {path});
    return std::unique_ptr<FileLock>(std::make_unique<MemoryLock>(*this, path));
}

} // namespace camwright
