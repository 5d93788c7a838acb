#include "core/storage/objecttext.h"
#include "core/storage/projectstore.h"
#include "tests/core/storage/memoryfilesystem.h"
#include "tests/core/storage/sampleproject.h"

#include <gtest/gtest.h>

using namespace camwright;

namespace {

const ObjectKey FeedKey{ObjectKind::Axis, "Feed"};

LoadedProject open(FileSystem& files, const char* path = "/p")
{
    auto loaded = openProject(files, path);
    EXPECT_TRUE(loaded.ok()) << (loaded.ok() ? "" : englishLine(loaded.error().front()));
    return loaded ? *loaded : LoadedProject{};
}

std::string openError(FileSystem& files)
{
    const auto loaded = openProject(files, "/p");
    return loaded ? "none" : englishLine(loaded.error().front());
}

MemoryFileSystem sampleFolder()
{
    MemoryFileSystem out;
    EXPECT_TRUE(createProject(out, "/p", sampleProject()).ok());
    return out;
}

Project edited(const Project& project)
{
    Axis axis = *project.content<Axis>(FeedKey);
    axis.lifeFactor = 9;
    return project.withContent(FeedKey, axis);
}

/// The project's own files, without the private folder.
std::map<std::string, std::string> visible(const MemoryFileSystem& files)
{
    auto out = files.files;
    std::erase_if(out, [](const auto& file) { return file.first.find("/.camwright/") != std::string::npos; });
    return out;
}

TEST(ProjectStoreTest, whatIsWrittenIsRead)
{
    MemoryFileSystem files = sampleFolder();
    EXPECT_EQ(open(files).project, sampleProject());
    EXPECT_EQ(hashOf(open(files).project), hashOf(sampleProject()));
}

TEST(ProjectStoreTest, openingAndSavingWithoutAnEditTouchesNoFile)
{
    MemoryFileSystem files = sampleFolder();
    const LoadedProject loaded = open(files);
    const auto before = files.files;
    files.log.clear();
    ASSERT_TRUE(saveProject(files, "/p", loaded.files, loaded.project).ok());
    EXPECT_EQ(files.files, before);
    EXPECT_TRUE(files.log.empty());
}

TEST(ProjectStoreTest, oneEditChangesOneFile)
{
    MemoryFileSystem files = sampleFolder();
    const LoadedProject loaded = open(files);
    const auto before = visible(files);
    const auto known = saveProject(files, "/p", loaded.files, edited(loaded.project));
    ASSERT_TRUE(known.ok());
    unsigned changed = 0;
    for (const auto& [path, text] : visible(files))
        changed += before.at(path) != text;
    EXPECT_EQ(changed, 1u);
    EXPECT_TRUE(filesChangedOutside(files, "/p", *known).empty());
    EXPECT_EQ(open(files).project, edited(loaded.project));
}

TEST(ProjectStoreTest, nothingStaysBehindInThePrivateFolder)
{
    MemoryFileSystem files = sampleFolder();
    const LoadedProject loaded = open(files);
    ASSERT_TRUE(saveProject(files, "/p", loaded.files, edited(loaded.project)).ok());
    EXPECT_FALSE(files.folders.contains("/p/.camwright/save"));
    EXPECT_EQ(files.files.at("/p/.camwright/.gitignore"), "*\n");
}

TEST(ProjectStoreTest, aRemovedObjectsFileGoesAndARenamedOneKeepsItsComments)
{
    MemoryFileSystem files = sampleFolder();
    files.files["/p/axes/Feed.toml"] = "# mind the gap\n" + files.files["/p/axes/Feed.toml"];
    const LoadedProject loaded = open(files);
    Object renamed = *loaded.project.find(FeedKey);
    renamed.key.name = "Infeed";
    const Project now = loaded.project.with(FeedKey, nullptr).with(renamed.key, std::make_shared<const Object>(renamed));
    ASSERT_TRUE(saveProject(files, "/p", loaded.files, now).ok());
    EXPECT_FALSE(files.files.contains("/p/axes/Feed.toml"));
    EXPECT_TRUE(files.files.at("/p/axes/Infeed.toml").starts_with("# mind the gap\n"));
    EXPECT_EQ(open(files).project, now);
}

TEST(ProjectStoreTest, aCopyIsEqualByteForByteAlsoWhereItWasWrittenByHand)
{
    MemoryFileSystem files = sampleFolder();
    files.files["/p/axes/Feed.toml"] = "# by hand\r\nnumber=3\r\n";
    const LoadedProject loaded = open(files);
    ASSERT_TRUE(createProject(files, "/q", loaded.project, loaded.files).ok());
    for (const auto& [path, text] : visible(files)) {
        if (path.starts_with("/p/")) {
            EXPECT_EQ(files.files.at("/q" + path.substr(2)), text) << path;
        }
    }
}

TEST(ProjectStoreTest, refusesToCreateOverAProject)
{
    MemoryFileSystem files = sampleFolder();
    const auto before = files.files;
    const auto created = createProject(files, "/p", Project().withName("x"));
    ASSERT_FALSE(created.ok());
    EXPECT_EQ(created.error().code, Code::AlreadyAProject);
    EXPECT_EQ(files.files, before);
}

TEST(ProjectStoreTest, aFileChangedOutsideIsNeverOverwrittenUnlessAsked)
{
    MemoryFileSystem files = sampleFolder();
    const LoadedProject loaded = open(files);
    files.files["/p/axes/Feed.toml"] += "# theirs\n";
    EXPECT_EQ(filesChangedOutside(files, "/p", loaded.files), std::vector<std::string>{"axes/Feed.toml"});
    const auto before = visible(files);
    const auto refused = saveProject(files, "/p", loaded.files, edited(loaded.project));
    ASSERT_FALSE(refused.ok());
    EXPECT_EQ(refused.error().code, Code::ChangedOutside);
    EXPECT_EQ(visible(files), before);
    EXPECT_TRUE(saveProject(files, "/p", loaded.files, edited(loaded.project), Overwrite::Allow).ok());
    EXPECT_EQ(open(files).project, edited(loaded.project));
}

TEST(ProjectStoreTest, aForeignFileInThePlaceOfANewOneIsNotOverwritten)
{
    MemoryFileSystem files = sampleFolder();
    const LoadedProject loaded = open(files);
    files.files["/p/axes/New.toml"] = "number = 5\n";
    EXPECT_EQ(filesChangedOutside(files, "/p", loaded.files), std::vector<std::string>{"axes/New.toml"});
    const auto saved = saveProject(files, "/p", loaded.files, loaded.project.withContent({ObjectKind::Axis, "New"}, Axis{}));
    ASSERT_FALSE(saved.ok());
    EXPECT_EQ(saved.error().code, Code::ChangedOutside);
    EXPECT_EQ(files.files["/p/axes/New.toml"], "number = 5\n");
}

TEST(ProjectStoreTest, longAndHostileNamesSurvive)
{
    MemoryFileSystem files;
    Project project = Project().withName("names");
    for (const std::string& name : {std::string(300, 'x'), std::string(4096, '/'), std::string("CON"), std::string("../up"), std::string(),
                                    std::string("a\0b", 3), std::string("\xE2\x80\xAEx"), std::string("\xFF")}) {
        project = project.withContent({ObjectKind::Axis, name}, Axis{});
        project = project.withContent({ObjectKind::Program, name}, Program{});
        project = project.withContent({ObjectKind::VariableTable, name}, VariableTable{});
        project = project.withContent({ObjectKind::WatchTable, name}, WatchTable{});
    }
    ASSERT_TRUE(createProject(files, "/p", project).ok());
    EXPECT_EQ(open(files).project, project);
    for (const auto& [path, text] : files.files)
        EXPECT_TRUE(path.starts_with("/p/") && path.find("..") == std::string::npos) << path;
}

TEST(ProjectStoreTest, saysWhatIsNoProject)
{
    MemoryFileSystem files;
    EXPECT_EQ(openError(files), "error CW1001: \"/p\" is not there.");
    files.folders.insert("/p");
    EXPECT_EQ(openError(files).substr(0, 13), "error CW1005:");
}

TEST(ProjectStoreTest, refusesANewerFormatBeforeLookingAtTheRest)
{
    MemoryFileSystem files = sampleFolder();
    files.files["/p/project.toml"] = "format = 2\nname = 3\n";
    files.files["/p/axes/Feed.toml"] = "not toml";
    const auto loaded = openProject(files, "/p");
    ASSERT_FALSE(loaded.ok());
    ASSERT_EQ(loaded.error().size(), 1u);
    EXPECT_EQ(englishLine(loaded.error().front()),
              "project.toml:1:10: error CW1006: This project has format 2, written by a newer Camwright. This one reads formats up to 1. "
              "Open the project with the newer one.");
}

TEST(ProjectStoreTest, namesEveryDamagedFile)
{
    MemoryFileSystem files = sampleFolder();
    files.files["/p/axes/Feed.toml"] = "number = ";
    files.files["/p/programs/Main.il"] = "";
    const auto loaded = openProject(files, "/p");
    ASSERT_FALSE(loaded.ok());
    ASSERT_EQ(loaded.error().size(), 2u);
    EXPECT_EQ(loaded.error()[0].place.file, "axes/Feed.toml");
    EXPECT_EQ(loaded.error()[1].place.file, "programs/Main.il");
}

TEST(ProjectStoreTest, twoFilesForOneObjectAndBadNamesAreErrors)
{
    MemoryFileSystem files = sampleFolder();
    files.files["/p/axes/%46eed.toml"] = "number = 1\n";
    EXPECT_EQ(openError(files).substr(0, 34), "axes/Feed.toml: error CW1014: \"axe");
    files.files.erase("/p/axes/%46eed.toml");
    files.files["/p/axes/50%.toml"] = "number = 1\n";
    EXPECT_EQ(openError(files).substr(0, 29), "axes/50%.toml: error CW1015: ");
}

TEST(ProjectStoreTest, aFileUnderAnotherSpellingOfItsNameStaysThere)
{
    MemoryFileSystem files;
    ASSERT_TRUE(createProject(files, "/p", Project().withName("x")).ok());
    files.folders.insert("/p/axes");
    files.files["/p/axes/%46eed.toml"] = "number = 1\n";
    const LoadedProject loaded = open(files);
    ASSERT_TRUE(saveProject(files, "/p", loaded.files, edited(loaded.project)).ok());
    EXPECT_EQ(files.files.at("/p/axes/%46eed.toml"), "number = 1\nlife_factor = 9\n");
    EXPECT_FALSE(files.files.contains("/p/axes/Feed.toml"));
}

TEST(ProjectStoreTest, filesOfOthersAreLeftAlone)
{
    MemoryFileSystem files = sampleFolder();
    files.files["/p/README.md"] = "mine";
    files.files["/p/axes/notes.txt"] = "mine";
    files.files["/p/axes/.Feed.toml"] = "an editor's";
    const LoadedProject loaded = open(files);
    EXPECT_EQ(loaded.project, sampleProject());
    ASSERT_TRUE(saveProject(files, "/p", loaded.files, edited(loaded.project)).ok());
    EXPECT_EQ(files.files.at("/p/axes/.Feed.toml"), "an editor's");
}

TEST(ProjectStoreTest, aProjectCutAtAnyByteOfAnyFileLoadsOrSaysWhere)
{
    const MemoryFileSystem whole = sampleFolder();
    for (const auto& [path, text] : visible(whole)) {
        for (std::size_t length = 0; length < text.size(); ++length) {
            MemoryFileSystem files = whole;
            files.files[path].resize(length);
            const auto loaded = openProject(files, "/p");
            if (loaded)
                continue;
            const Diagnostic& error = loaded.error().front();
            ASSERT_EQ("/p/" + error.place.file, path) << englishLine(error);
            ASSERT_TRUE(error.place.range.isValid() || error.code == Code::FileNameWrong) << englishLine(error) << " cut at " << length;
        }
    }
}

TEST(ProjectStoreTest, aMissingFileOrFolderLoadsOrSaysWhat)
{
    const MemoryFileSystem whole = sampleFolder();
    for (const auto& [path, text] : visible(whole)) {
        MemoryFileSystem files = whole;
        files.files.erase(path);
        const auto loaded = openProject(files, "/p");
        EXPECT_EQ(loaded.ok(), path != "/p/project.toml") << path;
    }
}

TEST(ProjectStoreTest, onlyOneMayEditAProject)
{
    MemoryFileSystem files = sampleFolder();
    auto first = lockProject(files, "/p");
    ASSERT_TRUE(first.ok());
    const auto second = lockProject(files, "/p");
    ASSERT_FALSE(second.ok());
    EXPECT_EQ(second.error().code, Code::LockHeld);
    EXPECT_TRUE(openProject(files, "/p").ok()); // reading is open to all
    first->reset();
    EXPECT_TRUE(lockProject(files, "/p").ok());
}

} // namespace
