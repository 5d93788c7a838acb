#include "core/base/codes.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <vector>

using namespace camwright;

namespace {

/// A language of the pages: its folder, the words that begin the two parts, and the first bytes of its letters in UTF-8.
struct PageLanguage {
    const char* folder;
    const char* example;
    const char* wayOut;
    const char* leads; ///< empty: any
};

constexpr PageLanguage Languages[] = {
    {"en", "**Example.**", "**Way out.**", ""},
    {"zh", "**示例。**", "**解决办法。**", "\xE3\xE4\xE5\xE6\xE7\xE8\xE9"},
    {"ru", "**Пример.**", "**Как исправить.**", "\xD0\xD1"},
};

std::filesystem::path folderOf(const PageLanguage& language)
{
    return std::filesystem::path(CAMWRIGHT_SOURCE_DIR "/resources/diagnostics") / language.folder;
}

std::string pageOf(const PageLanguage& language, std::string_view id)
{
    std::ifstream in(folderOf(language) / (std::string(id) + ".md"), std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

std::string titleOf(const std::string& page)
{
    return page.substr(0, page.find('\n'));
}

std::size_t runOfBackticks(std::string_view text, std::size_t at)
{
    const std::size_t end = text.find_first_not_of('`', at);
    return (end == std::string_view::npos ? text.size() : end) - at;
}

/// What stands between backticks, in sentences and in blocks. A run of backticks ends with the next run of its length.
std::set<std::string> snippetsOf(std::string_view page)
{
    std::set<std::string> out;
    std::size_t at = 0;
    while ((at = page.find('`', at)) != std::string_view::npos) {
        const std::size_t length = runOfBackticks(page, at);
        const std::size_t begin = at + length;
        std::size_t end = begin;
        while ((end = page.find('`', end)) != std::string_view::npos && runOfBackticks(page, end) != length)
            end += runOfBackticks(page, end);
        if (end == std::string_view::npos) {
            out.insert("not closed: " + std::string(page.substr(at)));
            break;
        }
        out.insert(std::string(page.substr(begin, end - begin)));
        at = end + length;
    }
    return out;
}

/// The text from `mark` to the next mark or the end is more than blanks.
bool hasPart(const std::string& page, const std::string& mark)
{
    const std::size_t at = page.find(mark);
    if (at == std::string::npos)
        return false;
    const std::size_t begin = at + mark.size();
    const std::string part = page.substr(begin, page.find("\n**", begin) - begin);
    return part.find_first_not_of(" \n") != std::string::npos;
}

} // namespace

class DiagnosticPagesTest : public testing::TestWithParam<PageLanguage> {};

TEST_P(DiagnosticPagesTest, everyCodeHasAPageWithTitleExampleAndWayOut)
{
    const PageLanguage& language = GetParam();
    for (const CodeInfo& info : allCodes()) {
        const std::string page = pageOf(language, info.id);
        const std::string title = titleOf(page);
        const std::string begin = "# " + std::string(info.id) + ": ";
        EXPECT_EQ(title.substr(0, begin.size()), begin) << language.folder << "/" << info.id << ".md begins \"" << title << '"';
        EXPECT_GT(title.size(), begin.size()) << info.id << " has no title";
        EXPECT_TRUE(hasPart(page, language.example)) << language.folder << "/" << info.id << ".md has no " << language.example;
        EXPECT_TRUE(hasPart(page, language.wayOut)) << language.folder << "/" << info.id << ".md has no " << language.wayOut;
    }
}

TEST_P(DiagnosticPagesTest, titlesAreInTheLanguage)
{
    const PageLanguage& language = GetParam();
    if (*language.leads == '\0')
        return;
    for (const CodeInfo& info : allCodes())
        EXPECT_NE(titleOf(pageOf(language, info.id)).find_first_of(language.leads), std::string::npos) << language.folder << "/" << info.id;
}

TEST_P(DiagnosticPagesTest, snippetsAreThoseOfTheEnglishPage)
{
    const PageLanguage& language = GetParam();
    for (const CodeInfo& info : allCodes())
        EXPECT_EQ(snippetsOf(pageOf(language, info.id)), snippetsOf(pageOf(Languages[0], info.id))) << language.folder << "/" << info.id;
}

TEST_P(DiagnosticPagesTest, everyPageBelongsToACode)
{
    std::set<std::string> ids, files;
    for (const CodeInfo& info : allCodes())
        ids.insert(std::string(info.id) + ".md");
    for (const auto& entry : std::filesystem::directory_iterator(folderOf(GetParam())))
        files.insert(entry.path().filename().string());
    EXPECT_EQ(files, ids);
}

INSTANTIATE_TEST_SUITE_P(Languages, DiagnosticPagesTest, testing::ValuesIn(Languages), [](const auto& language) { return std::string(language.param.folder); });

TEST(SnippetsTest, blocksAndWordsAreFound)
{
    EXPECT_EQ(snippetsOf("a `LD X0` b\n````\n```\n````\n`%M0.0`"), (std::set<std::string>{"LD X0", "\n```\n", "%M0.0"}));
    EXPECT_EQ(snippetsOf("`LD").size(), 1u);
    EXPECT_NE(snippetsOf("`LD"), snippetsOf("LD"));
}
