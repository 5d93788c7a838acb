#include "core/storage/journal.h"
#include "core/storage/projectstore.h"
#include "tests/core/storage/memoryfilesystem.h"
#include "tests/core/storage/sampleproject.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace camwright;

namespace {

const ObjectKey FeedKey{ObjectKind::Axis, "Feed"};
const ObjectKey MainKey{ObjectKind::Program, "Main"};
const ObjectKey TableKey{ObjectKind::VariableTable, "Globals"};

MemoryFileSystem savedFolder()
{
    MemoryFileSystem out;
    EXPECT_TRUE(createProject(out, "/p", sampleProject()).ok());
    return out;
}

/// Makes edits as a document does: each one replaces an object and is appended.
class Editing {
public:
    Editing(FileSystem& files, const Project& saved) : now(saved), journal(std::move(*Journal::begin(files, "/p", saved))) {}

    Result<void> set(const ObjectKey& key, const ObjectPtr& object, const std::string& label = "edit")
    {
        const ObjectDelta delta{key, now.find(key), object};
        now = now.with(key, object);
        return journal->append(label, {delta});
    }
    Result<void> setContent(const ObjectKey& key, ObjectContent content, const std::string& label = "edit")
    {
        return set(key, now.withContent(key, std::move(content)).find(key), label);
    }

    Project now;
    std::unique_ptr<Journal> journal;
};

Axis axisWithLife(std::int64_t factor)
{
    Axis out;
    out.lifeFactor = factor;
    return out;
}

TEST(JournalTest, replaysEveryEditSinceTheSave)
{
    MemoryFileSystem files = savedFolder();
    Editing editing(files, sampleProject());
    ASSERT_TRUE(editing.setContent(FeedKey, axisWithLife(7), "Change life factor").ok());
    ASSERT_TRUE(editing.set(MainKey, nullptr, "Delete program").ok());
    ASSERT_TRUE(editing.setContent({ObjectKind::Axis, "New"}, Axis{}, "Add axis").ok());
    EXPECT_TRUE(editing.journal->hasEntries());
    const auto content = readJournal(files, "/p", sampleProject());
    ASSERT_TRUE(content.ok() && content->has_value());
    EXPECT_EQ((*content)->project, editing.now);
    EXPECT_EQ((*content)->labels, (std::vector<std::string>{"Change life factor", "Delete program", "Add axis"}));
    EXPECT_FALSE((*content)->torn);
}

TEST(JournalTest, randomEditsOfSourcesAndTablesReplayToTheSameProject)
{
    MemoryFileSystem files = savedFolder();
    Editing editing(files, sampleProject());
    std::mt19937 random(2);
    for (int turn = 0; turn < 300; ++turn) {
        if (random() % 2) {
            Program program = *editing.now.content<Program>(MainKey);
            const std::size_t at = random() % (program.source.size() + 1);
            program.source.replace(at, random() % 5, random() % 3 ? "LD %M0.0\n" : "");
            ASSERT_TRUE(editing.setContent(MainKey, program).ok());
        } else {
            const VariableTable& table = *editing.now.content<VariableTable>(TableKey);
            const std::size_t at = random() % (table.rowCount() + 1);
            const std::size_t removed = std::min<std::size_t>(random() % 2, table.rowCount() - at);
            std::vector<Variable> rows(random() % 3, Variable{"V" + std::to_string(turn), DataType::Int, "", "", random() % 2 == 0, ""});
            ASSERT_TRUE(editing.setContent(TableKey, table.replaced(at, removed, rows)).ok());
        }
    }
    const auto content = readJournal(files, "/p", sampleProject());
    ASSERT_TRUE(content.ok() && content->has_value());
    EXPECT_EQ((*content)->project, editing.now);
}

TEST(JournalTest, aKeystrokeInALongProgramIsAShortRecord)
{
    MemoryFileSystem files = savedFolder();
    Program program;
    program.source = std::string(1000000, 'x');
    const Project saved = sampleProject().withContent(MainKey, program);
    Editing editing(files, saved);
    const std::size_t before = files.files.at("/p/.camwright/journal.1").size();
    program.source.insert(500000, "y");
    ASSERT_TRUE(editing.setContent(MainKey, program, "Typing").ok());
    EXPECT_LT(files.files.at("/p/.camwright/journal.1").size() - before, 100u);
}

TEST(JournalTest, tornAtAnyByteItGivesTheEditsBefore)
{
    MemoryFileSystem files = savedFolder();
    Editing editing(files, sampleProject());
    const std::string path = "/p/.camwright/journal.1";
    std::vector<std::pair<std::size_t, Project>> states{{files.files.at(path).size(), editing.now}};
    for (int n = 0; n < 4; ++n) {
        ASSERT_TRUE(editing.setContent(FeedKey, axisWithLife(20 + n)).ok());
        states.emplace_back(files.files.at(path).size(), editing.now);
    }
    const std::string whole = files.files.at(path);
    for (std::size_t length = 0; length <= whole.size(); ++length) {
        files.files[path] = whole.substr(0, length);
        Project expected = sampleProject();
        for (const auto& [size, project] : states) {
            if (size <= length)
                expected = project;
        }
        const auto content = readJournal(files, "/p", sampleProject());
        ASSERT_TRUE(content.ok()) << "cut at " << length;
        ASSERT_EQ(content->has_value() ? (*content)->project : sampleProject(), expected) << "cut at " << length;
    }
}

TEST(JournalTest, aChangedByteIsNeverReplayedAsSomethingElse)
{
    MemoryFileSystem files = savedFolder();
    Editing editing(files, sampleProject());
    std::vector<Project> states{editing.now};
    for (int n = 0; n < 3; ++n) {
        ASSERT_TRUE(editing.setContent(FeedKey, axisWithLife(30 + n)).ok());
        states.push_back(editing.now);
    }
    const std::string whole = files.files.at("/p/.camwright/journal.1");
    for (std::size_t at = 0; at < whole.size(); ++at) {
        std::string& damaged = files.files["/p/.camwright/journal.1"] = whole;
        damaged[at] = static_cast<char>(damaged[at] ^ 0x41);
        const auto content = readJournal(files, "/p", sampleProject());
        const Project got = content.ok() && content->has_value() ? (*content)->project : sampleProject();
        ASSERT_NE(std::find(states.begin(), states.end(), got), states.end()) << "byte " << at;
    }
}

TEST(JournalTest, aJournalOfAnotherStateIsRefused)
{
    MemoryFileSystem files = savedFolder();
    Editing editing(files, sampleProject());
    ASSERT_TRUE(editing.setContent(FeedKey, axisWithLife(7)).ok());
    const auto content = readJournal(files, "/p", sampleProject().withName("changed by git"));
    ASSERT_FALSE(content.ok());
    EXPECT_EQ(content.error().code, Code::JournalOfAnotherBase);
    EXPECT_TRUE(readJournal(files, "/p", sampleProject()).ok());
}

TEST(JournalTest, aForeignFileInItsPlaceIsCalledDamaged)
{
    MemoryFileSystem files = savedFolder();
    files.files["/p/.camwright/journal.1"] = std::string(200, 'x');
    const auto content = readJournal(files, "/p", sampleProject());
    ASSERT_FALSE(content.ok());
    EXPECT_EQ(content.error().code, Code::JournalDamaged);
}

TEST(JournalTest, withoutEditsThereIsNothingToOffer)
{
    MemoryFileSystem files = savedFolder();
    Editing editing(files, sampleProject());
    const auto content = readJournal(files, "/p", sampleProject());
    ASSERT_TRUE(content.ok());
    EXPECT_FALSE(content->has_value());
    EXPECT_FALSE(editing.journal->hasEntries());
}

TEST(JournalTest, aSaveTakesItsSegmentAwayAndEditsMadeMeanwhileStay)
{
    MemoryFileSystem files = savedFolder();
    const LoadedProject loaded = *openProject(files, "/p");
    Editing editing(files, loaded.project);
    ASSERT_TRUE(editing.setContent(FeedKey, axisWithLife(7)).ok());
    const Project snapshot = editing.now;
    ASSERT_TRUE(editing.journal->rotate(snapshot).ok());
    ASSERT_TRUE(editing.setContent(FeedKey, axisWithLife(8)).ok()); // while the save runs on another thread
    {
        const auto content = readJournal(files, "/p", loaded.project); // killed before the save
        ASSERT_TRUE(content.ok() && content->has_value());
        EXPECT_EQ((*content)->project, editing.now);
    }
    ASSERT_TRUE(saveProject(files, "/p", loaded.files, snapshot, Overwrite::Refuse, editing.journal->finished()).ok());
    const auto reopened = openProject(files, "/p");
    ASSERT_TRUE(reopened.ok());
    EXPECT_EQ(reopened->project, snapshot);
    const auto content = readJournal(files, "/p", reopened->project); // killed after the save
    ASSERT_TRUE(content.ok() && content->has_value());
    EXPECT_EQ((*content)->project, editing.now);
    EXPECT_FALSE(files.files.contains("/p/.camwright/journal.1"));
}

TEST(JournalTest, atAnyErrorOfTheSaveNoEditIsLost)
{
    const MemoryFileSystem start = savedFolder();
    for (unsigned call = 1;; ++call) {
        MemoryFileSystem files = start;
        const LoadedProject loaded = *openProject(files, "/p");
        Editing editing(files, loaded.project);
        ASSERT_TRUE(editing.setContent(FeedKey, axisWithLife(7)).ok());
        ASSERT_TRUE(editing.journal->rotate(editing.now).ok());
        files.calls = 0;
        files.failAt = call;
        files.failAfterwardsToo = true;
        (void)saveProject(files, "/p", loaded.files, editing.now, Overwrite::Refuse, editing.journal->finished());
        const bool reached = files.calls >= call;
        files.failAt = 0;
        files.heldLocks.clear();
        const auto reopened = openProject(files, "/p");
        ASSERT_TRUE(reopened.ok());
        const auto content = readJournal(files, "/p", reopened->project);
        ASSERT_TRUE(content.ok()) << englishText(content.error()) << " after an error at call " << call;
        ASSERT_EQ(content->has_value() ? (*content)->project : reopened->project, editing.now) << "call " << call;
        if (!reached)
            break;
    }
}

TEST(JournalTest, aFullDiskDelaysRecordsButLosesNone)
{
    MemoryFileSystem files = savedFolder();
    Editing editing(files, sampleProject());
    ASSERT_TRUE(editing.setContent(FeedKey, axisWithLife(1)).ok());
    files.failAt = files.calls + 1;
    files.failAfterwardsToo = true;
    EXPECT_FALSE(editing.setContent(FeedKey, axisWithLife(2)).ok());
    EXPECT_FALSE(editing.setContent(FeedKey, axisWithLife(3)).ok());
    files.failAt = 0;
    ASSERT_TRUE(editing.journal->sync().ok());
    const auto content = readJournal(files, "/p", sampleProject());
    ASSERT_TRUE(content.ok() && content->has_value());
    EXPECT_EQ((*content)->project, editing.now);
    EXPECT_EQ((*content)->labels.size(), 3u);
}

TEST(JournalTest, pagesNotAppliedAreKeptAndMoveAlongWithASave)
{
    MemoryFileSystem files = savedFolder();
    Editing editing(files, sampleProject());
    const auto draft = std::make_shared<const Object>(Object{FeedKey, 1, axisWithLife(44), {}});
    ASSERT_TRUE(editing.journal->setDraft(FeedKey, draft).ok());
    ASSERT_TRUE(editing.journal->setDraft(TableKey, sampleProject().find(TableKey)).ok());
    ASSERT_TRUE(editing.journal->setDraft(TableKey, nullptr).ok());
    ASSERT_TRUE(editing.journal->rotate(editing.now).ok());
    const auto content = readJournal(files, "/p", sampleProject());
    ASSERT_TRUE(content.ok() && content->has_value());
    ASSERT_EQ((*content)->drafts.size(), 1u);
    EXPECT_EQ(*(*content)->drafts.at(FeedKey), *draft);
    EXPECT_EQ((*content)->project, sampleProject());
}

TEST(JournalTest, discardingRemovesEverySegment)
{
    MemoryFileSystem files = savedFolder();
    Editing editing(files, sampleProject());
    ASSERT_TRUE(editing.setContent(FeedKey, axisWithLife(7)).ok());
    ASSERT_TRUE(editing.journal->rotate(editing.now).ok());
    ASSERT_TRUE(discardJournal(files, "/p").ok());
    const auto content = readJournal(files, "/p", sampleProject());
    ASSERT_TRUE(content.ok());
    EXPECT_FALSE(content->has_value());
}

} // namespace
