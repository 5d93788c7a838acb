#include "core/storage/projectstore.h"
#include "core/storage/savetransaction.h"
#include "tests/core/storage/memoryfilesystem.h"
#include "tests/core/storage/sampleproject.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <filesystem>
#include <random>
#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace camwright;

namespace {

const ObjectKey FeedKey{ObjectKind::Axis, "Feed"};

/// Touches old, new and removed files in several folders, the new one of a kind that had none.
struct Change {
    Project before = sampleProject().with({ObjectKind::Network, "CANopen"}, nullptr);
    Project after;

    Change()
    {
        Axis axis = *before.content<Axis>(FeedKey);
        axis.lifeFactor = 9;
        after = before.withContent(FeedKey, axis).withName("renamed").with({ObjectKind::Program, "INT_0"}, nullptr);
        after = after.withContent({ObjectKind::Network, "CANopen"}, Network{250000, 99});
        after = after.withContent({ObjectKind::Program, "Main"}, Program{ProgramRole::Main, ProgramLanguage::InstructionList, "LD %M1.0\n"});
    }
};

MemoryFileSystem folderOf(const Project& project)
{
    MemoryFileSystem out;
    EXPECT_TRUE(createProject(out, "/p", project).ok());
    out.log.clear();
    return out;
}

/// Which of the two states a project folder opens as; "mixed" is the one that must never come.
std::string stateOf(FileSystem& files, const std::string& path, const Change& change)
{
    const auto loaded = openProject(files, path);
    if (!loaded)
        return "unreadable: " + englishLine(loaded.error().front());
    return loaded->project == change.before ? "old" : loaded->project == change.after ? "new" : "mixed";
}

TEST(SaveTest, anErrorAtAnyCallLeavesTheOldOrTheNewProject)
{
    const Change change;
    const MemoryFileSystem start = folderOf(change.before);
    MemoryFileSystem opened = start;
    const LoadedProject loaded = *openProject(opened, "/p");
    for (const bool lasting : {false, true}) {
        bool sawOld = false, sawNew = false;
        for (unsigned call = 1;; ++call) {
            MemoryFileSystem files = start;
            files.calls = 0;
            files.failAt = call;
            files.failAfterwardsToo = lasting;
            const auto saved = saveProject(files, "/p", loaded.files, change.after);
            const bool reached = files.calls >= call;
            files.failAt = 0;
            const std::string state = stateOf(files, "/p", change);
            ASSERT_TRUE(state == "old" || state == "new") << state << " after an error at call " << call;
            if (saved)
                ASSERT_EQ(state, "new");
            else
                ASSERT_EQ(state == "new", saved.error().code == Code::SaveUnfinished) << englishText(saved.error());
            ASSERT_FALSE(files.folders.contains("/p/.camwright/save")) << "stale staging after call " << call;
            sawOld = sawOld || state == "old";
            sawNew = sawNew || (state == "new" && !saved);
            if (!reached)
                break;
        }
        EXPECT_TRUE(sawOld && sawNew);
    }
}

TEST(SaveTest, afterAnErrorTheSameSaveCanBeRepeated)
{
    const Change change;
    const MemoryFileSystem start = folderOf(change.before);
    MemoryFileSystem opened = start;
    const LoadedProject loaded = *openProject(opened, "/p");
    for (unsigned call = 1;; ++call) {
        MemoryFileSystem files = start;
        files.calls = 0;
        files.failAt = call;
        const bool failed = !saveProject(files, "/p", loaded.files, change.after).ok();
        const bool reached = files.calls >= call;
        files.failAt = 0;
        if (failed) {
            const auto again = saveProject(files, "/p", loaded.files, change.after);
            ASSERT_TRUE(again.ok()) << englishText(again.error()) << " after an error at call " << call;
            ASSERT_TRUE(filesChangedOutside(files, "/p", *again).empty());
        }
        ASSERT_EQ(stateOf(files, "/p", change), "new");
        if (!reached)
            break;
    }
}

/// What a power cut after the first `count` operations may leave: a name is certain only after its folder was synced, and
/// of those that are not, each folder keeps some first part.
MemoryFileSystem afterPowerCut(const MemoryFileSystem& start, const std::vector<FileOperation>& log, std::size_t count, std::mt19937& random)
{
    const auto folderOf = [](const std::string& path) { return path.substr(0, path.rfind('/')); };
    std::vector<bool> certain(count, false);
    for (std::size_t n = 0; n < count; ++n) {
        if (log[n].kind != FileOperation::Kind::SyncDirectory)
            continue;
        for (std::size_t m = 0; m < n; ++m)
            certain[m] = certain[m] || folderOf(log[m].path) == log[n].path;
    }
    MemoryFileSystem out = start;
    std::map<std::string, bool> cut;
    for (std::size_t n = 0; n < count; ++n) {
        bool& lost = cut[folderOf(log[n].path)];
        lost = lost || (!certain[n] && random() % 2 == 0);
        if (certain[n] || !lost)
            out.apply(log[n]);
    }
    return out;
}

TEST(SaveTest, aPowerCutAfterAnyOperationLeavesTheOldOrTheNewProject)
{
    const Change change;
    const MemoryFileSystem start = folderOf(change.before);
    MemoryFileSystem run = start;
    const LoadedProject loaded = *openProject(run, "/p");
    run.log.clear();
    ASSERT_TRUE(saveProject(run, "/p", loaded.files, change.after).ok());
    ASSERT_GT(run.log.size(), 20u);
    std::mt19937 random(11);
    std::map<std::string, int> seen;
    for (std::size_t count = 0; count <= run.log.size(); ++count) {
        for (int turn = 0; turn < 20; ++turn) {
            MemoryFileSystem files = afterPowerCut(start, run.log, count, random);
            const std::string state = stateOf(files, "/p", change);
            ASSERT_TRUE(state == "old" || state == "new") << state << " after operation " << count;
            ++seen[state];
            ASSERT_TRUE(count < run.log.size() || state == "new") << "a save that has returned is lost";
        }
    }
    EXPECT_EQ(seen.size(), 2u);
}

TEST(SaveTest, finishingItselfMayBeInterruptedAnywhere)
{
    const Change change;
    const MemoryFileSystem start = folderOf(change.before);
    MemoryFileSystem run = start;
    const LoadedProject loaded = *openProject(run, "/p");
    run.log.clear();
    ASSERT_TRUE(saveProject(run, "/p", loaded.files, change.after).ok());
    std::size_t committed = 0;
    while (!(run.log[committed].kind == FileOperation::Kind::Rename && run.log[committed].path.ends_with("/commit")))
        ++committed;
    for (unsigned call = 1;; ++call) {
        MemoryFileSystem files = start;
        for (std::size_t n = 0; n <= committed; ++n)
            files.apply(run.log[n]);
        files.calls = 0;
        files.failAt = call;
        (void)openProject(files, "/p");
        const bool reached = files.calls >= call;
        files.failAt = 0;
        ASSERT_EQ(stateOf(files, "/p", change), "new") << "call " << call;
        if (!reached)
            break;
    }
}

TEST(SaveTest, theOpenerSaysThatItFinishedASave)
{
    const Change change;
    const MemoryFileSystem start = folderOf(change.before);
    MemoryFileSystem files = start;
    const LoadedProject loaded = *openProject(files, "/p");
    for (files.failAt = files.calls + 1; ; ++files.failAt) {
        MemoryFileSystem attempt = files;
        attempt.failAfterwardsToo = true;
        const auto saved = saveProject(attempt, "/p", loaded.files, change.after);
        if (saved || saved.error().code != Code::SaveUnfinished)
            continue;
        attempt.failAt = 0;
        const auto opened = openProject(attempt, "/p");
        ASSERT_TRUE(opened.ok());
        ASSERT_EQ(opened->notes.size(), 1u);
        EXPECT_EQ(opened->notes.front().code, Code::SaveFinished);
        return;
    }
}

/// A folder whose save stopped right after its record was in place.
MemoryFileSystem committedFolder(const Change& change)
{
    const MemoryFileSystem start = folderOf(change.before);
    MemoryFileSystem run = start;
    const LoadedProject loaded = *openProject(run, "/p");
    run.log.clear();
    EXPECT_TRUE(saveProject(run, "/p", loaded.files, change.after).ok());
    MemoryFileSystem out = start;
    for (const FileOperation& operation : run.log) {
        out.apply(operation);
        if (operation.kind == FileOperation::Kind::Rename && operation.path.ends_with("/commit"))
            break;
    }
    return out;
}

TEST(SaveTest, aFileSomebodyChangedDuringTheInterruptionIsSetAsideNotLost)
{
    const Change change;
    MemoryFileSystem files = committedFolder(change);
    files.files["/p/axes/Feed.toml"] = "number = 77\n";
    const auto opened = openProject(files, "/p");
    ASSERT_TRUE(opened.ok());
    EXPECT_EQ(opened->project, change.after);
    ASSERT_EQ(opened->notes.size(), 2u);
    EXPECT_EQ(opened->notes[1].code, Code::FileSetAside);
    EXPECT_EQ(files.files.at("/p/" + opened->notes[1].arguments[1]), "number = 77\n");
}

TEST(SaveTest, aDamagedRecordIsDroppedWithWhatWasStaged)
{
    const Change change;
    const MemoryFileSystem whole = committedFolder(change);
    const std::string record = whole.files.at("/p/.camwright/save/commit");
    for (std::size_t length = 0; length < record.size(); ++length) {
        MemoryFileSystem files = whole;
        files.files["/p/.camwright/save/commit"].resize(length);
        ASSERT_EQ(stateOf(files, "/p", change), "old") << "record cut at " << length;
        ASSERT_FALSE(files.folders.contains("/p/.camwright/save"));
    }
}

TEST(SaveTest, aRecordFromAStrangerNeverMovesAFileOutOfTheProject)
{
    for (const char* target : {"../../etc/passwd", "axes/../../x.toml", "/etc/x.toml", ".camwright/../x", "programs/a/b.il", "notes.txt"}) {
        MemoryFileSystem files = folderOf(Change().before);
        files.folders.insert("/p/.camwright/save");
        files.files["/p/.camwright/save/0"] = "evil";
        std::string record = "camwright-save 1\n0 - - \"" + std::string(target) + "\"\n";
        const auto* bytes = reinterpret_cast<const std::uint8_t*>(record.data());
        record += "end " + toHex(hashOf(ByteSpan(bytes, record.size()))) + '\n';
        files.files["/p/.camwright/save/commit"] = record;
        EXPECT_EQ(stateOf(files, "/p", Change()), "old") << target;
        for (const auto& [path, text] : files.files)
            EXPECT_NE(text, "evil") << path;
    }
}

class ScratchFolder {
public:
    ScratchFolder()
    {
        std::string pattern = (std::filesystem::temp_directory_path() / "camwright-save-XXXXXX").string();
        m_path = ::mkdtemp(pattern.data());
    }
    ~ScratchFolder() { std::filesystem::remove_all(m_path); }
    std::string operator/(const char* name) const { return m_path + '/' + name; }

private:
    std::string m_path;
};

/// Saves the two states in turn until it is killed; writes a byte when it is in the middle of it.
[[noreturn]] void saveForEver(const std::string& path, const Change& change, int ready)
{
    PosixFileSystem files;
    auto loaded = openProject(files, path);
    if (!loaded)
        ::_exit(1);
    KnownFiles known = loaded->files;
    bool toAfter = loaded->project == change.before;
    for (unsigned turn = 0;; ++turn, toAfter = !toAfter) {
        auto saved = saveProject(files, path, known, toAfter ? change.after : change.before);
        if (!saved)
            ::_exit(2);
        known = *saved;
        if (turn == 0 && ::write(ready, "r", 1) != 1)
            ::_exit(3);
    }
}

TEST(SaveTest, killedInTheMiddleOfASaveTheProjectIsOldOrNew)
{
    const Change change;
    const ScratchFolder folder;
    const std::string path = folder / "project";
    PosixFileSystem files;
    ASSERT_TRUE(createProject(files, path, change.before).ok());
    std::mt19937 random(5);
    for (int kill = 0; kill < 100; ++kill) {
        int ends[2];
        ASSERT_EQ(::pipe(ends), 0);
        const pid_t child = ::fork();
        ASSERT_GE(child, 0);
        if (child == 0)
            saveForEver(path, change, ends[1]);
        ::close(ends[1]);
        char byte = 0;
        ASSERT_EQ(::read(ends[0], &byte, 1), 1);
        ::close(ends[0]);
        std::atomic<unsigned> spin = 1 + static_cast<unsigned>(random() % 1000000); // a random instant without a clock
        while (spin.fetch_sub(1) > 1)
            continue;
        ::kill(child, SIGKILL);
        int status = 0;
        ASSERT_EQ(::waitpid(child, &status, 0), child);
        ASSERT_TRUE(WIFSIGNALED(status)) << "the child ended by itself with " << WEXITSTATUS(status);
        const std::string state = stateOf(files, path, change);
        ASSERT_TRUE(state == "old" || state == "new") << state << " after kill " << kill;
        ASSERT_FALSE(std::filesystem::exists(path + "/.camwright/save"));
    }
}

TEST(PosixFileSystemTest, aProjectSurvivesARealDisk)
{
    const ScratchFolder folder;
    const std::string path = folder / "project";
    PosixFileSystem files;
    ASSERT_TRUE(createProject(files, path, sampleProject()).ok());
    const auto loaded = openProject(files, path);
    ASSERT_TRUE(loaded.ok()) << englishLine(loaded.error().front());
    EXPECT_EQ(loaded->project, sampleProject());
    EXPECT_TRUE(filesChangedOutside(files, path, loaded->files).empty());
}

TEST(PosixFileSystemTest, saysInWordsWhatIsWrong)
{
    const ScratchFolder folder;
    PosixFileSystem files;
    EXPECT_EQ(files.read(folder / "none", 10).error().code, Code::FileNotFound);
    EXPECT_EQ(files.read(folder / ".", 10).error().code, Code::FileSystemRefused);
    EXPECT_EQ(files.read(std::string("/tmp/a\0b", 8), 10).error().code, Code::FileSystemRefused);
    const std::string path = folder / "big";
    const Bytes eleven(11, 'x');
    ASSERT_TRUE(files.writeSynced(path, eleven).ok());
    EXPECT_EQ(files.read(path, 10).error().code, Code::FileTooLarge);
    EXPECT_EQ(files.read(path, 11).value().size(), 11u);
    ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
    EXPECT_FALSE(files.read(folder / "pipe", 10).ok());
}

TEST(PosixFileSystemTest, aLockEndsWithItsHolder)
{
    const ScratchFolder folder;
    PosixFileSystem files;
    auto first = files.lock(folder / "lock", LockWait::No);
    ASSERT_TRUE(first.ok());
    EXPECT_EQ(files.lock(folder / "lock", LockWait::No).error().code, Code::LockHeld);
    first->reset();
    EXPECT_TRUE(files.lock(folder / "lock", LockWait::No).ok());
}

} // namespace
